#!/usr/bin/env python3
# Rows of `tcca-check fmea` from outside: each detection is flown again, each end effect is asked again by the check it names.
# SPDX-License-Identifier: MIT
"""Usage: fmea.py SOURCE_DIR BIN_DIR [PART]

Of each row that was detected in its flight a scenario with the same draws: the fault happens at its moment, and the estimate
is to have it by the moment that the row tells, and not sooner. Of each row that can happen, each check that it names is asked
of the plant in which no other fault can: `tcca-check program` and `tcca-check check` with one fault are to say what the row
says. What is violated without a fault too tells nothing there.

Of a mission, rows of every n-th component with faults are looked at, in order of declaration. A PART above 1 makes n so many
times as great, and leaves NewMaap out, whose closed loop takes most of the time: so under the sanitizers. Prints one line a mission and exits 1 where something is not as a row says.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

# Program, plant, properties, cycle in seconds, every n-th component, and the first one of them.
MISSIONS = [
    ("power/power.rmpl", "power/power.tcca", "power/power.props", 0.5, 1, 0),
    ("mars-edl/mars_edl.rmpl", "mars-edl/edl_lander.tcca", "mars-edl/mars_edl.props", 0.5, 8, 1),
    ("newmaap/orbit_insertion.rmpl", "newmaap/newmaap.tcca", None, 1, 40, 5),
]
CHECKS = {"terminates": "termination", "never no-plan": "no-plan"}


def scenario(number, program, plant, cycle, row):
    """The two expectations: it is estimated then, and not a cycle before."""
    flight = row["flight"]
    then = flight["happened"] + flight["estimated_after"]
    fault = f"{row['component']} = {row['to']}"
    return f"""scenario "{number}" {{
  program "{program}";
  plant "{plant}";
  cycle {cycle} s;
  duration {then} s;
  seed {flight["seed"]};
  at {flight["happened"]} s fault {fault};
  expect {fault} within {then} s;
}}
scenario "{number}, a cycle sooner" {{
  program "{program}";
  plant "{plant}";
  cycle {cycle} s;
  duration {then - cycle} s;
  seed {flight["seed"]};
  expect never {fault};
  {f"at {flight['happened']} s fault {fault};" if flight["estimated_after"] > 0 else ""}
}}
"""


def unfolded(document):
    """Name and component of each component, in order of declaration, where every instance gets a type of its own."""
    plant = document["plants"][0]
    types = {each["name"]: each for each in plant["types"]}
    plant["types"] = own_types = []
    found = []

    def unfold(instances, path):
        for instance in instances:
            own = json.loads(json.dumps(types[instance["type"]]))
            name = ".".join([*path, instance["name"]])
            for component in own.get("components", []):
                found.append((".".join(part for part in (name, component["name"]) if part), component))
            unfold(own.get("instances", []), [*path, instance["name"]])
            own["name"] = instance["type"] = f"{own['name']}_{len(own_types)}"
            own_types.append(own)  # after those that it reads

    unfold(plant["instances"], [])
    return found


def with_one_fault(text, row):
    """The document in which no fault but that of the row can happen: all others are impossible. None at all: of no row."""
    document = json.loads(text)
    for name, component in unfolded(document):
        faults = {mode["name"] for mode in component["modes"] if mode.get("fault")}
        for t in component["transitions"]:
            this = row and (name, t["from"], t["to"]) == (row["component"], row["from"], row["to"])
            if t["to"] in faults and not this:
                t.update({key: 0 for key in ("rate", "probability") if key in t})
    return json.dumps(document)


def claims(text, cycle):
    """The properties as claims on the program at that cycle, with one fault."""
    found = []
    for block in re.finditer(r'(?:property|hazard)\s+"[^"]*"\s*\{(?:[^{}]|\{[^{}]*\})*\}', re.sub(r"//[^\n]*", "", text)):
        claim = block[0]
        if "probability" in claim or "expect violated" in claim or "reach " in claim:
            continue
        claim = re.sub(r"\b(faults|time)\s+[^;]*;", "", claim)
        if not re.search(r"\{\s*program\b", claim):
            if re.search(r"\{\s*never\s+stuck\b", claim) or not re.search(r"\{\s*(never|after)\b", claim):
                continue
            claim = re.sub(r"\{\s*", "{ program ", claim, count=1)
        found.append(re.sub(r"\}\s*$", f" faults 1; time {cycle} s; }}\n", claim))
    return "".join(found)


class Mission:
    def __init__(self, bin_dir, folder, program, plant, properties, cycle):
        self.bin, self.folder = bin_dir, pathlib.Path(folder)
        self.program, self.plant, self.properties, self.cycle = program, plant, properties, cycle
        compiled = self.folder / "mission.json"
        self.run("rmplc", "compile", program, plant, "-o", compiled)
        self.text = compiled.read_text(encoding="utf-8")

    def run(self, *command, statuses=(0,)):
        done = subprocess.run([self.bin / command[0], *command[1:], "-q"], capture_output=True, text=True, check=False)
        if done.returncode not in statuses:
            sys.exit(f"{' '.join(map(str, command))}: exit status {done.returncode}\n{done.stdout[-4000:]}{done.stderr[-4000:]}")
        return done.stdout

    def rows(self, every, first):
        names = [name for name, component in unfolded(json.loads(self.text))
                 if any(mode.get("fault") for mode in component["modes"])]
        chosen = names[first % len(names)::every]
        mission = ["--props", self.properties] if self.properties else []
        table = self.run("tcca-check", "fmea", self.program, self.plant, "--time", f"{self.cycle}s", "--format", "json",
                         *mission, *(word for name in chosen for word in ("--component", name)))
        return json.loads(table)["rows"]

    def fly(self, rows):
        detected = [row for row in rows if row["flight"] and row["flight"]["estimated_after"] is not None]
        if detected:
            path = self.folder / "rows.scn"
            path.write_text("".join(scenario(i, self.program, self.plant, self.cycle, row)
                                    for i, row in enumerate(detected)), encoding="utf-8")
            self.run("rmpl-run", "scenario", path)
        return len(detected)

    def verdicts(self, row):
        """By name of the check: whether it is violated where only this fault can happen; of no row: where none can."""
        path = self.folder / "one.json"
        path.write_text(with_one_fault(self.text, row), encoding="utf-8")
        found = {}
        for name, check in CHECKS.items():
            answer = json.loads(self.run("tcca-check", "program", path, "--check", check, "--time", f"{self.cycle}s",
                                         "--faults", "1", "--format", "json", statuses=(0, 1)))
            # To get stuck is no end either.
            asked = {check, "stuck"} if check == "termination" else {check}
            found[name] = any(one["verdict"] == "violated" for one in answer["checks"] if one["property"] in asked)
        if self.properties:
            stated = self.folder / "one.props"
            stated.write_text(claims(self.properties.read_text(encoding="utf-8"), self.cycle), encoding="utf-8")
            answer = json.loads(self.run("tcca-check", "check", path, stated, "--format", "json", statuses=(0, 1)))
            for one in answer["properties"]:
                found[one["name"]] = one["verdict"] == "violated"
        return found

    def compare(self, rows):
        """How many checks have been asked again."""
        anyway = self.verdicts(None)
        asked = 0
        for row in rows:
            if row["earliest"] is None:
                continue
            found = self.verdicts(row)
            for check in row["checks"]:
                name = check["check"]
                if name not in found:
                    sys.exit(f"{row['component']} -> {row['to']}: '{name}' was not asked again")
                if check["anyway"] and not anyway[name]:
                    sys.exit(f"{row['component']} -> {row['to']}: '{name}' is not violated without the fault")
                if anyway[name]:
                    continue
                asked += 1
                if found[name] != (check["verdict"] == "violated"):
                    sys.exit(f"{row['component']}: {row['from']} -> {row['to']}: '{name}' {check['verdict']}; with no "
                             f"other fault in the plant it is {'violated' if found[name] else 'not violated'}")
        return asked


def main():
    source, bin_dir = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    part = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    for program, plant, properties, cycle, every, first in MISSIONS:
        if part > 1 and plant.startswith("newmaap/"):
            continue
        folder = source / "examples"
        with tempfile.TemporaryDirectory() as scratch:
            mission = Mission(bin_dir, scratch, folder / program, folder / plant, properties and folder / properties, cycle)
            rows = mission.rows(every * part, first)
            flown = mission.fly(rows)
            asked = mission.compare(rows)
            print(f"{plant}: {len(rows)} rows, {flown} of them detected in a flight as they say; {asked} verdicts again")
            if not rows or (every == 1 and part == 1 and flown == 0):
                return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
