#!/usr/bin/env python3
# Probabilities of random plants: ours beside those of the exported model, by a plain reader of it and by PRISM.
# SPDX-License-Identifier: MIT
"""Usage: prism_answers.py BIN_DIR [PLANTS [SEED]]

The reader walks the modules of the exported model state by state, and iterates values in fractions of whole numbers.
Where PRISM is in the path, it answers the same questions, and those without an end of time. Prints one line, says there
whether PRISM was asked, and exits 1 where answers differ.
"""

import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
from fractions import Fraction

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from prism import Module, expanded, random_plant  # noqa: E402

MOST_STEPS = 6
# The model has probabilities to the digits of a double, and a step multiplies a few of them.
DIGITS = Fraction(1, 10**12)
# PRISM counts in doubles, and stops by this relative difference.
PRISM_STOPS = 1e-9


class Reader:
    """A Markov decision process, as its text says it."""

    def __init__(self, text):
        text = expanded(text)
        self.modules = [Module(part, Fraction) for part in re.split(r"^module ", text, flags=re.M)[1:]]
        self.labels = sorted(set(re.findall(r"^// (a\d+): ", text, re.M)))
        self.starts = "[start]" in text
        [target] = re.findall(r'^label "target" = (.*);$', text, re.M)
        self.target = compile(re.sub(r"(?<![<>!])=", "==", target).replace("&", " and ").replace("|", " or ")
                              .replace("!(", " not ("), "target", "eval")
        self.first = tuple(sorted((k, v) for m in self.modules for k, v in m.first.items()))
        self.known = {}

    def after(self, state, label):
        """The distribution; none where a module has no command for it."""
        result = {(): Fraction(1)}
        values = dict(state)
        for module in self.modules:
            if not module.enabled(label, values):
                return None
            parts = {}
            for so_far, weight in result.items():
                for p, change in module.step(label, values):
                    at = so_far + tuple(sorted(change.items()))
                    parts[at] = parts.get(at, 0) + weight * p
            result = parts
        merged = {}
        for change, weight in result.items():
            at = tuple(sorted({**values, **dict(change)}.items()))
            merged[at] = merged.get(at, 0) + weight
        return merged

    def value(self, state, steps, best):
        if eval(self.target, {"true": True, "false": False}, dict(state)):
            return Fraction(1)
        if steps == 0:
            return Fraction(0)
        key = (state, steps, best)
        if key not in self.known:
            labels = ["start"] if self.starts and any(m.enabled("start", dict(state)) for m in self.modules) else self.labels
            rows = [row for row in (self.after(state, label) for label in labels) if row is not None]
            values = [sum(p * self.value(to, steps - 1, best) for to, p in row.items()) for row in rows]
            self.known[key] = best(values) if values else Fraction(0)
        return self.known[key]

    def answers(self, steps):
        return [self.value(self.first, steps + self.starts, best) for best in (min, max)]


def run(*command):
    return subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False, timeout=300)


def ours(bin_dir, plant, target, within):
    done = run(bin_dir / "tcca-check", "probability", plant, "--target", target, "--time", "1s", "--within", within,
               "--format", "json", "-q")
    if done.returncode not in (0, 3):
        raise SystemExit(f"{done.stderr}\n{plant.read_text(encoding='utf-8')}")
    answer = json.loads(done.stdout)
    return [answer.get(kind, answer) for kind in ("min", "max")]


def of_prism(prism, model, steps):
    """Its answers: within the steps, and ever."""
    questions = [f'P{best}=? [ F{bound} "target" ]' for bound in (f"<={steps}", "") for best in ("min", "max")]
    done = run(prism, model, "-explicit", "-intervaliter", "-epsilon", PRISM_STOPS, "-pf", ";".join(questions))
    found = re.findall(r"^Result: ([\d.eE+-]+)", done.stdout, re.M)
    if len(found) != len(questions):
        raise SystemExit(f"PRISM: {done.stdout}{done.stderr}\n{model.read_text(encoding='utf-8')}")
    return [Fraction(one) for one in found]


def compare(bin_dir, prism, folder, draw):
    """How many answers were compared; none where PRISM cannot say the plant."""
    plant, model = folder / "plant.tcca", folder / "plant.prism"
    text = random_plant(draw)
    plant.write_text(text, encoding="utf-8")
    component = draw.randrange(text.count("component "))
    target = f"c{component} = {draw.choice(['m1', 'broken'])}"
    if draw.random() < 0.4:
        target += f" & c{draw.randrange(text.count('component '))}.out = high"
    steps = draw.randint(0, MOST_STEPS)
    exported = run(bin_dir / "tcca-check", "export", "--format", "prism", "--time", "1s", plant, "-q", "--target", target)
    if exported.returncode != 0:
        return None
    model.write_text(exported.stdout, encoding="utf-8")
    reader = Reader(exported.stdout)

    def check(bounds, answers, slack):
        for known, answer in zip(bounds, answers, strict=True):
            if not Fraction(known["lower"]) - slack <= answer <= Fraction(known["upper"]) + slack:
                raise SystemExit(f"{target} within {steps} s: ours {known}, the model's {float(answer)}\n{text}\n"
                                 f"{exported.stdout}")

    bounded = ours(bin_dir, plant, target, f"{steps}s")
    check(bounded, reader.answers(steps), DIGITS)
    if prism is None:
        return 2
    answers = of_prism(prism, model, steps + reader.starts)
    check(bounded, answers[:2], DIGITS)
    check(ours(bin_dir, plant, target, "inf"), answers[2:], Fraction(PRISM_STOPS))
    return 6


def main():
    bin_dir = pathlib.Path(sys.argv[1]).resolve()
    plants = int(sys.argv[2]) if len(sys.argv) > 2 else 100
    draw = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    prism = shutil.which("prism")
    said = compared = tried = 0
    with tempfile.TemporaryDirectory() as folder:
        while said < plants and tried < 4 * plants:
            tried += 1
            answers = compare(bin_dir, prism, pathlib.Path(folder), draw)
            said += answers is not None
            compared += answers or 0
    asked = "PRISM agrees" if prism else "PRISM is not installed, and was not asked"
    print(f"{said} of {tried} plants can be said, {compared} answers agree; {asked}")
    return 0 if said == plants else 1


if __name__ == "__main__":
    sys.exit(main())
