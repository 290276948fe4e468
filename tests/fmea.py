#!/usr/bin/env python3
# Detections that `tcca-check fmea` tells, flown again as scenarios that expect them.
# SPDX-License-Identifier: MIT
"""Usage: fmea.py SOURCE_DIR BIN_DIR

A scenario for each row that was detected in its flight, with the same draws: the fault happens at its moment, and the
estimate is to have it by the moment that the row tells, and not sooner. Prints one line and exits 1 where one is not met.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

MISSIONS = [("power/power.rmpl", "power/power.tcca")]
CYCLE = 0.5


def scenario(number, program, plant, row):
    """The two expectations: it is estimated then, and not a cycle before."""
    flight = row["flight"]
    then = flight["happened"] + flight["estimated_after"]
    fault = f"{row['component']} = {row['to']}"
    return f"""scenario "{number}" {{
  program "{program}";
  plant "{plant}";
  cycle {CYCLE} s;
  duration {then} s;
  seed {flight["seed"]};
  at {flight["happened"]} s fault {fault};
  expect {fault} within {then} s;
}}
scenario "{number}, a cycle sooner" {{
  program "{program}";
  plant "{plant}";
  cycle {CYCLE} s;
  duration {then - CYCLE} s;
  seed {flight["seed"]};
  expect never {fault};
  {f"at {flight['happened']} s fault {fault};" if flight["estimated_after"] > 0 else ""}
}}
"""


def main():
    source, bin_dir = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    rows = flown = 0
    with tempfile.TemporaryDirectory() as folder:
        for program, plant in MISSIONS:
            program, plant = source / "examples" / program, source / "examples" / plant
            done = subprocess.run([bin_dir / "tcca-check", "fmea", program, plant, "--time", f"{CYCLE}s", "--format", "json",
                                   "-q"], capture_output=True, text=True, check=True)
            table = json.loads(done.stdout)["rows"]
            rows += len(table)
            detected = [row for row in table if row["flight"] and row["flight"]["estimated_after"] is not None]
            flown += len(detected)
            path = pathlib.Path(folder) / "rows.scn"
            path.write_text("".join(scenario(i, program, plant, row) for i, row in enumerate(detected)), encoding="utf-8")
            flights = subprocess.run([bin_dir / "rmpl-run", "scenario", path, "-q"], capture_output=True, text=True,
                                     check=False)
            if flights.returncode != 0:
                print(flights.stdout[-4000:] + flights.stderr[-4000:])
                return 1
    print(f"{rows} rows, {flown} of them detected, each as it says")
    return 0 if flown > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
