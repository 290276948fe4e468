#!/usr/bin/env python3
# What lint writes as SARIF, before the validator of the standard's own makers.
# SPDX-License-Identifier: MIT
"""Usage: sarif.py RMPLC MODULES EXAMPLES      exits with 77 where @microsoft/sarif-multitool-linux is not in MODULES

The validator holds the schema of the standard (2.1.0) and rules beside it; its errors fail, and its warnings."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

FAULTY = {
    "program.rmpl": "P() :: { x = a; { y = b; z = c, u = d }; always v = e; w = f }\n",
    "plant.tcca": "component C { input cmd : { none, go }; initial idle; mode idle; mode done; fault mode lost; }\n"
                  "plant Ü { c : C; }\n",
    "wrong.tcca": "plant P { a : Nothing; }\n",
}


def main() -> int:
    program, modules, examples = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
    package = modules / "@microsoft/sarif-multitool-linux"
    validator = package / "Sarif.Multitool"
    if not validator.is_file():
        print(f"skipped: @microsoft/sarif-multitool-linux is not in {modules}; cmake/install-packages editors puts it there")
        return 77
    validator.chmod(0o755)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for file, text in FAULTY.items():
            (folder / file).write_text(text, encoding="utf-8")
        logs, results = [], 0
        for source in [*(folder / file for file in FAULTY), examples / "newmaap/newmaap.scn", examples / "propulsion/burn.scn"]:
            told = subprocess.run([program, "lint", "--level", "note", "--format", "sarif", source], stdout=subprocess.PIPE,
                                  stderr=subprocess.DEVNULL, timeout=120, check=False)
            log = folder / (source.name + ".sarif")
            log.write_bytes(told.stdout)
            results += sum(len(run["results"]) for run in json.loads(told.stdout)["runs"])
            logs.append(log)
        # .NET asks for ICU otherwise, which no validation needs.
        environment = os.environ | {"DOTNET_SYSTEM_GLOBALIZATION_INVARIANT": "1"}
        done = subprocess.run([validator, "validate", *logs, "--output", folder / "told.sarif"], env=environment, timeout=240,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        # The validator warns that a tool without a page of its own names none.
        wrong = [line for line in done.stdout.splitlines() if (": error " in line or ": warning " in line) and "SARIF2005" not in line]
        if done.returncode != 0 or "completed successfully" not in done.stdout:
            wrong.append(f"the validator ends with {done.returncode}:\n{done.stdout}")
        print(*wrong, f"{len(logs)} logs, {results} results: {len(wrong)} objections", sep="\n")
        return 1 if wrong or results < 5 else 0


if __name__ == "__main__":
    sys.exit(main())
