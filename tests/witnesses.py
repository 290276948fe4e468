#!/usr/bin/env python3
# Witnesses fly: what tcca-check writes as a scenario fails in rmpl-run, and in the way that was found.
# SPDX-License-Identifier: MIT
"""Usage: witnesses.py ROOT PROGRAMS. Prints one line a witness and exits 1 where one does not fail as it should."""

import pathlib
import subprocess
import sys
import tempfile

MARS = ("mars-entry/mars_entry.rmpl", "mars-entry/mars_lander.tcca")
BURN = ("propulsion/burn.rmpl", "propulsion/propulsion.tcca")
EDL = ("mars-edl/mars_edl.rmpl", "mars-edl/edl_lander.tcca")
POLAR = ("mars-edl/mars_polar_lander.rmpl", "mars-edl/edl_lander.tcca")

# Program and plant, options, and what the story of the flight holds.
WITNESSES = [
    (MARS, ["--faults", "1", "--check", "no-plan"], "FAILED     never no-plan"),
    (MARS, ["--faults", "1", "--check", "endless-wait"], "FAILED     finished"),
    (MARS, ["--faults", "1", "--eventually", "nav = inertial within 16261 s"], "FAILED     nav = inertial"),
    (MARS, ["--finally", "lander = separated"], "FAILED     finished with lander = separated"),
    (MARS, ["--faults", "2", "--never", "lander = failed"], "never lander = failed: the condition became true"),
    (MARS, ["--never", "engine.temp = high"], "never engine.temp = high: the condition became true"),
    (BURN, ["--faults", "1", "--check", "no-plan"], "FAILED     never no-plan"),
    (BURN, ["--faults", "1", "--check", "endless-wait"], "FAILED     finished"),
    (BURN, ["--faults", "1", "--never", "engine = failed"], "never engine = failed: the condition became true"),
    (EDL, ["--faults", "1", "--never", "att = unknown"], "never att = unknown: the condition became true"),
    (EDL, ["--faults", "1", "--check", "no-plan"], "FAILED     never no-plan"),
    (EDL, ["--faults", "1", "--check", "endless-wait"], "FAILED     finished"),
    (EDL, ["--finally", "att = landing-orient"], "FAILED     finished with att = landing-orient"),
    (POLAR, ["--never", "engine = off & alt_12m_trigger = triggered & touchdown_sensor = triggered"],
     "FAILED     never engine = off"),
]


def run(*command: str) -> tuple[int, str]:
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300, check=False)
    return done.returncode, done.stdout


def main() -> int:
    root, programs = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    failures = 0
    for models, options, expected in WITNESSES:
        for time in ("dense", "0.5s"):
            with tempfile.TemporaryDirectory() as folder:
                scenario = pathlib.Path(folder) / "witness.scn"
                inputs = [str(root / "examples" / model) for model in models]
                status, told = run(str(programs / "tcca-check"), "program", *inputs, *options, "--time", time,
                                   "--scenario", str(scenario))
                flown, story = run(str(programs / "rmpl-run"), "scenario", str(scenario)) if scenario.exists() else (2, "")
            # An expectation that waits for `after` is about the witness only if that came.
            right = status == 1 and flown == 1 and expected in story and "never came true" not in story
            print("ok  " if right else "FAIL", models[0], *options, "--time", time)
            if not right:
                failures += 1
                print(told, story, sep="\n")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
