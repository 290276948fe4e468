#!/usr/bin/env python3
# Every witness flies: random programs and plants are checked, and each violation that is written as a scenario must fail.
# SPDX-License-Identifier: MIT
"""Usage: flights.py PROGRAMS [--cases N] [--seed S] [--keep FOLDER].

Each case is a small plant (timed, untimed and fault transitions, interconnections) and a program over it, drawn from the
seed, and a question to `tcca-check program`. A violation with a scenario must fail in `rmpl-run scenario`, by what was
found; one that no scenario can show must say so. Prints what came of the cases and exits 1 where a flight met what
tcca-check had refuted, or a program ended in another way than with a verdict."""

import argparse
import collections
import concurrent.futures
import os
import pathlib
import random
import subprocess
import sys
import tempfile

CHECKS = {"no-plan": "never no-plan", "endless-wait": "finished", "termination": "finished", "goal-conflict": "never goal-conflict"}


class Case:
    """A plant, a program and a question, as text."""

    def __init__(self, seed: str):
        self.draw = random.Random(seed)
        self.modes = [self.draw.randint(2, 4) for _ in range(self.draw.randint(1, 3))]
        self.commands = [self.draw.randint(1, 2) if self.draw.random() < 0.8 else 0 for _ in self.modes]
        self.plant = "".join(self.component(c) for c in range(len(self.modes))) + self.root()
        self.program = "Main() :: { " + self.body() + " }\n"
        self.options = self.question()

    def chance(self, share: float) -> bool:
        return self.draw.random() < share

    # The plant. Component k has modes m0, m1, …, perhaps a fault f, and tells its mode, or only some of it, by `out`.

    def component(self, c: int) -> str:
        modes, commands = self.modes[c], self.commands[c]
        text = f"component C{c} {{\n"
        if commands:
            text += "  input cmd : { none, " + ", ".join(f"go{k}" for k in range(commands)) + " };\n"
        told = [f"v{m if self.chance(0.8) else 0}" for m in range(modes)]
        text += "  output out : { " + ", ".join(f"v{m}" for m in range(modes)) + ", odd };\n  initial m0;\n"
        text += "".join(f"  mode m{m} {{ out = {told[m]} }};\n" for m in range(modes))
        fault = self.chance(0.6)
        if fault:
            text += "  fault f" + self.draw.choice(["", " { out = odd }", " { out = v0 }"]) + ";\n"
        text += "".join(self.exits(c, m) for m in range(modes))
        if fault:
            text += "  " + self.draw.choice(["any", f"m{self.draw.randrange(modes)}"]) + " -> f with 0.001;\n"
        return text + "}\n"

    def exits(self, c: int, mode: int) -> str:
        text = ""
        for go in self.draw.sample(range(self.commands[c]), self.draw.randint(0, self.commands[c])) if self.commands[c] else []:
            text += f"  m{mode} -> m{self.draw.randrange(self.modes[c])} when cmd = go{go}{self.timing(0.4)};\n"
        if self.chance(0.3 if self.commands[c] else 0.7):
            guard = " when cmd = none" if self.commands[c] else ""
            text += f"  m{mode} -> m{self.draw.randrange(self.modes[c])}{guard}{self.timing(0.8)};\n"
        return text

    def timing(self, share: float) -> str:
        if not self.chance(share):
            return ""
        low = self.draw.randint(0, 6)
        return self.draw.choice([f" after {low + 1} s", f" in [{low} s, {low + self.draw.randint(1, 4)} s]"])

    def root(self) -> str:
        text = "plant P {\n" + "".join(f"  c{c} : C{c};\n" for c in range(len(self.modes)))
        if len(self.modes) > 1 and self.chance(0.2):
            text += f"  !(c0 = m{self.modes[0] - 1} & c1 = m{self.modes[1] - 1});\n"
        commanded = [f"c{c}.cmd" for c in range(len(self.modes)) if self.commands[c]]
        if commanded:
            text += f"  control {', '.join(commanded)} default none;\n"
        return text + "  observe " + ", ".join(f"c{c}.out" for c in range(len(self.modes))) + ";\n}\n"

    # The program.

    def goal(self) -> str:
        c = self.draw.randrange(len(self.modes))
        return f"c{c} = m{self.draw.randrange(self.modes[c])}"

    def condition(self) -> str:
        c = self.draw.randrange(len(self.modes))
        return self.draw.choice([self.goal(), f"c{c}.out = v{self.draw.randrange(self.modes[c])}", f"!({self.goal()})"])

    def step(self, depth: int) -> str:
        kind = self.draw.randrange(8) if depth else 0
        if kind <= 2:
            return self.goal()
        if kind == 3:
            return f"when {self.condition()} donext {self.step(depth - 1)}"
        if kind == 4:
            return f"do {self.step(depth - 1)} watching {self.condition()}"
        if kind == 5:
            return f"if {self.condition()} thennext {self.step(depth - 1)} elsenext {self.step(depth - 1)}"
        if kind == 6:
            return f"{{ t = 0; when t >= {self.draw.randint(1, 8)} s donext {self.step(depth - 1)} }}"
        return "{ " + self.draw.choice(["; ", ", "]).join(self.step(depth - 1) for _ in range(2)) + " }"

    def body(self) -> str:
        text = "; ".join(self.step(2) for _ in range(self.draw.randint(1, 3)))
        return text if text.count("t = 0") < 2 else "; ".join(self.goal() for _ in range(2))

    def question(self) -> list[str]:
        kind = self.draw.randrange(8)
        if kind < 4:
            options = ["--check", list(CHECKS)[kind]]
        elif kind < 6:
            options = ["--never", self.condition()]
        elif kind == 6:
            options = ["--eventually", f"{self.condition()} within {self.draw.randint(2, 12)} s"]
        else:
            options = ["--finally", self.condition()]
        return options + ["--faults", str(self.draw.randrange(2)), "--time", self.draw.choice(["dense", "0.5s", "1s"])]


def run(*command: str) -> tuple[int, str]:
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120, check=False)
    return done.returncode, done.stdout


def fly(programs: pathlib.Path, seed: str, keep: pathlib.Path | None) -> tuple[str, str]:
    """What came of a case, in a word or two, and where it is wrong all there is to say of it."""
    case = Case(seed)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        program, plant, scenario = folder / "main.rmpl", folder / "plant.tcca", folder / "witness.scn"
        program.write_text(case.program, encoding="utf-8")
        plant.write_text(case.plant, encoding="utf-8")
        limits = ["--timeout", "20s", "--max-states", "20000"]
        status, told = run(str(programs / "tcca-check"), "program", str(program), str(plant), *case.options, *limits, "--scenario", str(scenario))
        if status in (0, 3):
            return "holds" if status == 0 else "undecided", ""
        if status == 2 and "RMPL" in told and not scenario.exists():
            return "no model", ""  # what was drawn is refused, with a diagnostic
        if status == 1 and not scenario.exists():
            if "no scenario" in told or "not written" in told:
                return "not to be seen", ""
            what, story = "no scenario and no reason", ""
        elif status == 1:
            flown, story = run(str(programs / "rmpl-run"), "scenario", str(scenario))
            if flown == 1 and "FAILED" in story and "never came true" not in story:
                return "fails as it should", ""
            what = f"flew with exit status {flown}"
        else:
            what, story = f"exit status {status}", ""
        if keep:
            kept = keep / seed.replace(" ", "-")
            kept.mkdir(parents=True, exist_ok=True)
            for file in folder.iterdir():
                (kept / file.name).write_bytes(file.read_bytes())
            (kept / "options").write_text(" ".join(case.options), encoding="utf-8")
        texts = "\n".join(file.read_text(encoding="utf-8") for file in sorted(folder.iterdir()))
    return "WRONG", f"case {seed!r}: {what}\n{case.options}\n{texts}\n{told}\n{story}"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("--cases", type=int, default=200)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--keep", type=pathlib.Path, help="keep the files of the cases that are wrong here")
    options = parser.parse_args()
    counts: collections.Counter[str] = collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for outcome, why in pool.map(lambda k: fly(options.programs, f"{options.seed} {k}", options.keep), range(options.cases)):
            counts[outcome] += 1
            if why:
                print(why)
    print(", ".join(f"{count} {outcome}" for outcome, count in sorted(counts.items())))
    return 1 if counts["WRONG"] or not counts["fails as it should"] else 0


if __name__ == "__main__":
    sys.exit(main())
