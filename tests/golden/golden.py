#!/usr/bin/env python3
# The golden runner: one file holds a command, its input files, and what it must print.
# SPDX-License-Identifier: MIT
"""A golden file is a list of sections, each begun by a line `--- NAME`:

  --- command          the program and its arguments, in shell quoting, over as many lines as one likes
  --- file NAME        an input file, written beside where the command runs
  --- stdin            its standard input (default: none)
  --- mask             regular expressions, one a line: what they match in the output becomes `…`
  --- exit             the exit code
  --- stdout           expected standard output
  --- stderr           expected standard error

Lines before the first section are a comment. `{source}` in command and output stands for the root of the tree.
Expected text that is absent is empty.
"""

import argparse
import difflib
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

SECTION = re.compile(r"^--- (command|file|stdin|mask|exit|stdout|stderr)(?: (\S+))?$")
NO_NEWLINE = "\\ no newline at the end\n"
TIMEOUT = 60  # seconds; a command that takes longer has hung


class Golden:
    """A golden file, as its sections in order."""

    def __init__(self, path: pathlib.Path):
        self.path = path
        self.comment = ""
        self.sections: list[tuple[str, str | None, str]] = []
        for line in path.read_text(encoding="utf-8").splitlines(keepends=True):
            match = SECTION.match(line.rstrip("\n"))
            if match:
                self.sections.append((match[1], match[2], ""))
            elif self.sections:
                name, argument, text = self.sections[-1]
                self.sections[-1] = (name, argument, text + line)
            else:
                self.comment += line
        if not self.text("command"):
            raise SystemExit(f"{path}: expected a section '--- command'")

    def text(self, name: str) -> str:
        return "".join(text for section, _, text in self.sections if section == name)

    def expected(self) -> dict[str, str]:
        return {"exit": self.text("exit").strip() or "0", "stdout": self.text("stdout"), "stderr": self.text("stderr")}

    def rebase(self, found: dict[str, str]) -> None:
        """Rewrites the file with what was found; the rest stays byte by byte."""
        given = [s for s in self.sections if s[0] not in ("exit", "stdout", "stderr")]
        text = self.comment
        for name, argument, body in given:
            text += f"--- {name}{' ' + argument if argument else ''}\n{body}"
        text += f"--- exit\n{found['exit']}\n"
        for stream in ("stdout", "stderr"):
            if found[stream]:
                text += f"--- {stream}\n{found[stream]}"
        self.path.write_text(text, encoding="utf-8")

    def run(self, programs: pathlib.Path, source: pathlib.Path) -> dict[str, str]:
        command = shlex.split(self.text("command").replace("{source}", str(source)), comments=True)
        program = programs / command[0]
        if not program.is_file():
            raise SystemExit(f"{self.path}: there is no program {program}")
        with tempfile.TemporaryDirectory() as directory:
            for name, argument, body in self.sections:
                if name == "file":
                    target = pathlib.Path(directory, argument)
                    target.parent.mkdir(parents=True, exist_ok=True)
                    target.write_text(body, encoding="utf-8")
            result = subprocess.run(
                [program, *command[1:]],
                cwd=directory,
                input=self.text("stdin").encode(),
                capture_output=True,
                timeout=TIMEOUT,
                check=False,
                env={"PATH": os.environ.get("PATH", ""), "LC_ALL": "C.UTF-8", "COLUMNS": "80"},
            )
        return {
            "exit": str(result.returncode),
            "stdout": self.normal(result.stdout, source, directory),
            "stderr": self.normal(result.stderr, source, directory),
        }

    def normal(self, output: bytes, source: pathlib.Path, directory: str) -> str:
        text = output.decode("utf-8", errors="backslashreplace")
        text = text.replace(str(source), "{source}").replace(directory + "/", "")
        for pattern in self.text("mask").splitlines():
            text = re.sub(pattern, "…", text, flags=re.MULTILINE)
        return text if not text or text.endswith("\n") else text + "\n" + NO_NEWLINE


def main() -> int:
    parser = argparse.ArgumentParser(description="Runs golden tests.")
    parser.add_argument("--programs", type=pathlib.Path, required=True, help="where rmplc, tcca-check and rmpl-run are")
    parser.add_argument("--rebase", action="store_true", help="rewrite the files with what is printed now")
    parser.add_argument("files", nargs="*", type=pathlib.Path, help="default: all below this folder")
    arguments = parser.parse_args()
    here = pathlib.Path(__file__).resolve().parent
    source = here.parent.parent
    failures = 0
    files = arguments.files or sorted(here.rglob("*.golden"))
    for path in files:
        golden = Golden(path)
        found = golden.run(arguments.programs.resolve(), source)
        expected = golden.expected()
        if found == expected:
            continue
        if arguments.rebase:
            golden.rebase(found)
            print(f"rebased {path}")
            continue
        failures += 1
        for name in ("exit", "stdout", "stderr"):
            if found[name] != expected[name]:
                sys.stdout.writelines(
                    difflib.unified_diff(
                        expected[name].splitlines(keepends=True),
                        found[name].splitlines(keepends=True),
                        f"{path.name} {name}, expected",
                        f"{path.name} {name}, found",
                    )
                )
                print()
    print(f"{len(files)} golden files, {failures} differ")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
