#!/usr/bin/env python3
# Livingstone2's regression suite: its models imported, its scenarios run, our least candidates beside those that it recorded.
# SPDX-License-Identifier: MIT
"""Usage: livingstone.py BIN_DIR [L2]

L2 is a copy of gpgreen/livingstone2; without it, build/livingstone2. Where it is not there the test is skipped (exit code 77):
the suite is not part of the tree. A recorded candidate is a set of faults with the steps in which they happen. It is carried
through the imported plant, so that it says which modes all components are in now: so are the states of ours that have the least
rank. Prints a row for each answer that was recorded, and one for each model; exits 1 where a row is not as it is known to be.
"""

import json
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

# Recorded output, the script that it answers, the model.
RECORDINGS = [("cb-cbfs.5-1000-0", "cb/cb.scr", "cb/cb.xmpl"), ("cb-cbfs.5-1000-2", "cb/cb.scr", "cb/cb.xmpl"),
              ("cb-cbfs.min-5-1000-0", "cb/cb.scr", "cb/cb.xmpl"), ("cb-cbfs.min-5-1000-2", "cb/cb.scr", "cb/cb.xmpl"),
              ("cb-cover.10-0", "cb/cb.scr", "cb/cb.xmpl"), ("cb-cover.10-2", "cb/cb.scr", "cb/cb.xmpl"),
              ("cb-cover.min-10-0", "cb/cb.scr", "cb/cb.xmpl"), ("cb-cover.min-10-2", "cb/cb.scr", "cb/cb.xmpl"),
              ("cb-cover.dt1-10-2", "cb/dt1.scr", "cb/cb.xmpl"), ("cb-cover.dt1-min-10-2", "cb/dt1.scr", "cb/cb.xmpl"),
              ("cb-cover.dt2-10-2", "cb/dt2.scr", "cb/cb.xmpl"), ("misc.AngleSensor", "misc/AngleSensor.scr", "misc/AngleSensor.l2"),
              ("x37.nominal-full-3", "x37/Nominal.scr", "x37/x37V1p6.l2"), ("x37.nominal-min-3", "x37/Nominal.scr", "x37/x37V1p6.l2"),
              ("x37.rvdtfail-full-1", "x37/RVDTFail.scr", "x37/x37V1p6.l2"), ("x37.rvdtfail-min-0", "x37/RVDTFail.scr", "x37/x37V1p6.l2"),
              ("x37.rvdtfail-min-1", "x37/RVDTFail.scr", "x37/x37V1p6.l2")]
# Models without recordings, and their scenarios.
OTHERS = [("cb/cb.xmpl", ["cutoff.scr"]), ("rt/rt.xmpl", ["rt.scr"]), ("ispp/ispp.xmpl", ["ispp.scr", "ispp-perf.scr"]),
          ("ispp/ispp-frame.xmpl", ["ispp.scr"]),
          ("ispp/ispp-repairable.xmpl", ["ispp-cycle.scr", "ispp-fail-outlet.scr", "ispp-repair.scr", "ispp-repair2.scr", "ispp-repair3.scr",
                                         "ispp-repair-after3.scr", "ispp-repair-after3-continue.scr"]),
          ("valves/valves.xmpl", []), ("rax/rax.xmpl", [])]
# Where Livingstone2 tells other candidates: it tracks five, and has lost those that explain what comes later.
KNOWN = {("cb-cover.10-2", 7)}


def run(*command):
    """What a program says, how it ended, and its processor time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)
    return done, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def answers_of(text):
    """The recorded answers: (step, whether all candidates are told, candidates), a candidate being {(step, component, fault)} and
    its rank."""
    answers = []
    for block in re.split(r"(?m)^Step ", text)[1:]:
        step = int(re.match(r"\d+", block)[0])
        candidates = []
        for part in re.split(r"Candidate \d+\)", block)[1:]:
            found = re.findall(r"(\S+)#(\S+)\.modeTransition=(\S+) :(\d+)", part)
            faults = {(0 if at == "-" else int(at), component, fault) for at, component, fault, _ in found}
            candidates.append((faults, sum(int(rank) for *_, rank in found)))
        answers.append((step, "more possible" not in block, candidates))
    return answers


class Plant:
    """What moves the modes of an imported plant when nothing fails: transitions whose guard is one command, be it handed on."""

    def __init__(self, text):
        kinds = dict(re.findall(r"(?ms)^component (\S+) \{\n(.*?)^\}", text))
        self.same = {}  # attributes that are always equal, each by one of them
        for one, other in re.findall(r"(?m)^  (\S+) = (\S+);$", text.split("\nplant ")[1]):
            first, second = self.first_of(one), self.first_of(other)
            if first != second:
                self.same[first] = second
        self.moves, self.start = {}, {}
        for name, kind, initial in re.findall(r"(?m)^  (\S+) : ([^;{ ]+)(?: \{ initial (\S+); \})?;$", text.split("\nplant ")[1]):
            if kind not in kinds:
                continue  # an attribute
            self.start[name] = initial or re.search(r"initial (\S+);", kinds[kind])[1]
            self.moves[name] = [(source.strip(), to, name + "." + control, value) for sources, to, control, value in
                                re.findall(r"(?m)^  (.+) -> (\S+) when (\S+) = (\S+);$", kinds[kind]) for source in sources.split(",")]

    def first_of(self, attribute):
        while attribute in self.same:
            attribute = self.same[attribute]
        return attribute

    def modes_after(self, commands, faults):
        """`commands`: a dictionary for each step. A fault wins over what is commanded."""
        modes = dict(self.start)
        for step in range(len(commands) + 1):
            told = {self.first_of(control): value for control, value in commands[step - 1].items()} if step else {}
            after = dict(modes)
            for name, moves in self.moves.items():
                for source, to, control, value in moves:
                    if modes[name] == source and told.get(self.first_of(control)) == value:
                        after[name] = to
            for at, name, fault in faults:
                if at == step:
                    after[name] = fault
            modes = after
        return frozenset(modes.items())


def commands_of(script):
    """The commands of each step, and after which of the steps candidates are asked for last before the next."""
    steps, asked = [], []
    for line in script.splitlines():
        words = re.sub(r"\s*=\s*", "=", line.split("//")[0]).split()
        if words and words[0] in ("progress", "min-progress"):
            steps.append(dict(word.split("=") for word in words[1:]))
        if words and words[0] == "fc":
            asked.append(len(steps))
    return steps, asked


def compare(plant, script, recorded, ours):
    """A row for each recorded answer; ours by step."""
    steps, asked = commands_of(script)
    rows = []
    for number, (at, (step, whole, candidates)) in enumerate(zip(asked, recorded)):
        if number + 1 < len(asked) and asked[number + 1] == at:
            rows.append((step, "asked before the last reading of the step", "", ""))
            continue
        best = min((rank for _, rank in candidates), default=None)
        theirs = {plant.modes_after(steps[:at], faults) for faults, rank in candidates if rank == best}
        belief = ours[at]["belief"]
        least = min(entry["rank"] for entry in belief)
        mine = {frozenset(entry["modes"].items()) for entry in belief if entry["rank"] == least}
        missing, more = theirs - mine, mine - theirs
        verdict = "others" if missing else "the same" if not more else "the same, of which it tells some" if not whole else "more"
        rows.append((step, verdict, f"rank {best}, {len(theirs)}", f"rank {least}, {len(mine)}"))
    return rows


def main():
    bin_dir = pathlib.Path(sys.argv[1]).resolve()
    suite = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else bin_dir.parents[1] / "livingstone2")
    if not (suite / "l2-regress").is_dir():
        print(f"skipped: {suite} has no regression suite of Livingstone2")
        return 77
    regress, tests = suite / "l2-regress", suite / "mba/cpp/tests"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def imported(model):
            out = folder / (model.parent.name + "-" + model.name + ".tcca")
            done, _ = run(bin_dir / "rmplc", "import", model, "-o", out)
            return (out, "") if done.returncode == 0 else (None, done.stderr.splitlines()[0])

        wrong = 0
        print("| recording | step | least candidates | Livingstone2 | here |\n|---|---|---|---|---|")
        for recording, script, model in RECORDINGS:
            plant, refused = imported(regress / "tests" / model)
            assert plant, refused
            script = regress / "tests" / script
            done, _ = run(bin_dir / "rmpl-run", "estimate", plant, "--scenario", script, "--ranks", "-k", "16")
            assert done.returncode == 0, done.stderr
            ours = {}
            for line in map(json.loads, done.stdout.splitlines()):
                ours[round(line["time"])] = line
            recorded = answers_of((regress / "base" / (recording + ".out")).read_text(encoding="utf-8"))
            for row in compare(Plant(plant.read_text(encoding="utf-8")), script.read_text(encoding="utf-8"), recorded, ours):
                print("|", recording, "|", " | ".join(map(str, row)), "|", flush=True)
                wrong += (row[1] in ("others", "more")) != ((recording, row[0]) in KNOWN)
        print("\n| model | components | scenario | steps | processor time |\n|---|---|---|---|---|")
        for model, scripts in OTHERS:
            plant, refused = imported(tests / model)
            if not plant:
                print("|", model, "|", refused, "| | | |")
                continue
            components = len(Plant(plant.read_text(encoding="utf-8")).start)
            for script in scripts:
                done, seconds = run(bin_dir / "rmpl-run", "estimate", plant, "--scenario", (tests / model).parent / script, "--ranks", "-k", "5")
                told = len(done.stdout.splitlines()) if done.returncode == 0 else (done.stderr.splitlines() or [""])[0]
                print("|", model, "|", components, "|", script, "|", told, f"| {seconds:.2f} s |", flush=True)
    return int(wrong > 0)


sys.exit(main())
