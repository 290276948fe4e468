#!/usr/bin/env python3
# The exports to PRISM, stepped by a plain reader of their modules, against the exact estimator without observations.
# SPDX-License-Identifier: MIT
"""Usage: prism.py BIN_DIR [PLANTS [SEED]]

Random plants are stepped through random commands by both; every probability of every mode combination must agree.
Prints one line and exits 1 where one does not.
"""

import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

STEPS = 6
CLOSE = 1e-9
COMMAND = re.compile(r"^  \[(\w+)\] (.*) -> (.*);$")
UPDATE = re.compile(r"\((\w+)'=([^()]*(?:\([^()]*\))?[^()]*)\)")


def random_plant(draw):
    """Components that command, feed and delay each other; every bound a multiple of half the period of 1 s, or not."""
    lines, wires, count = [], [], draw.randint(1, 3)
    types = draw.randint(1, count)  # some components may be of one type
    for c in range(types):
        modes = [f"m{m}" for m in range(draw.randint(2, 3))]
        start = ", ".join(f"{mode} {1 / len(modes[:2])}" for mode in modes[:2]) if draw.random() < 0.3 else modes[0]
        lines += [f"component C{c} {{", "  input cmd : { none, go };", "  input feed : { low, high };",
                  "  output out : { low, high };", f"  initial {start};"]
        lines += [f"  mode {mode} {{ {draw.choice(['out = low', 'out = high', 'out = feed', 'true'])} }};"
                  for mode in modes]
        lines.append("  fault broken;")
        for target in draw.sample(modes, len(modes)):
            guard = draw.choice(["cmd = go", "feed = high", "feed = low & cmd = none", "true"])
            lower = draw.choice([0, 0.5, 1, 2, 2.25])
            timing = draw.choice([f"in [{lower} s, {lower + draw.choice([0, 1, 2.5])} s]", f"after {lower} s",
                                  f"in [{lower} s, inf] ~ exponential(2 s)",
                                  f"in [{lower} s, {lower + 3} s] ~ normal(2 s, 1 s)", "with 0.3"])
            lines.append(f"  {draw.choice(modes)} -> {target} when {guard} {timing};")
        if draw.random() < 0.4:
            mode = draw.choice(modes)
            lines.append(f"  {mode} -> {mode} restart when {draw.choice(['cmd = go', 'feed = high', 'true'])};")
        lines += [f"  any -> broken {draw.choice(['with 0.01', 'with rate 0.2 /s', 'with 0'])};", "}"]
    for c in range(count):
        # Only upwards, so that no loop of attributes contradicts itself.
        wires.append(f"  c{c}.feed = c{draw.randrange(c)}.out;" if c else "  c0.feed = low;")
    lines += ["plant P {", *(f"  c{c} : C{c % types};" for c in range(count)), *wires,
              f"  control {', '.join(f'c{c}.cmd' for c in range(count))} default none;", "}"]
    return "\n".join(lines) + "\n"


def expanded(text):
    """The model with its renamed modules written out: `module c1 = c0 [ m0=m1, a2=a3 ] endmodule // name`."""
    bodies = {}

    def write_out(match):
        name, model, pairs, component = match[1], match[2], dict(p.split("=") for p in match[3].split(", ")), match[4]
        _, modes, rest = bodies[model].split("\n", 2)
        return f"module {name} // {component}\n{modes}\n" + re.sub(r"\b[amx]\d+\b", lambda word: pairs.get(word[0], word[0]), rest)

    parts = re.split(r"(?m)^(?=module )", text)
    for i, part in enumerate(parts):
        part = re.sub(r"(?m)^module (c\d+) = (c\d+) \[ (.*) \] endmodule // (.*)\n", write_out, part)
        if name := re.match(r"module (c\d+) ", part):
            bodies[name[1]] = part
        parts[i] = part
    return "".join(parts)


class Module:
    """Its variables with their first values, and its commands: label, guard, outcomes."""

    def __init__(self, text, number=float):
        self.first = {name: int(value) for name, value in re.findall(r"^  (\w+) : \[.*\] init (-?\d+);", text, re.M)}
        self.modes = re.search(r"^  // (.*)$", text, re.M)[1].split(", ")
        self.name = re.search(r"^c\d+ // (.*)$", text, re.M)[1]
        self.commands = []
        for line in text.splitlines():
            match = COMMAND.match(line)
            if not match:
                continue
            guard = re.sub(r"(?<![<>!])=", "==", match[2]).replace("&", " and ").replace("|", " or ")
            outcomes = []
            for part in re.split(r" \+ (?=[\d.e-]+:)", match[3]):
                probability, updates = part.split(":", 1)
                outcomes.append((number(probability), UPDATE.findall(updates)))
            self.commands.append((match[1], guard, outcomes))

    def enabled(self, label, state):
        return [outcomes for name, guard, outcomes in self.commands if name == label and eval(guard, {"true": True}, state)]

    def step(self, label, state):
        """The outcomes of the one command that is enabled."""
        enabled = self.enabled(label, state)
        assert len(enabled) == 1, f"{self.name}: {len(enabled)} commands of {label} in {state}"
        return [(p, {name: eval(value, {"min": min}, state) for name, value in updates})
                for p, updates in enabled[0]]


def stepped(modules, label, belief):
    result = {}
    for key, weight in belief.items():
        outcomes = [(weight, dict(key))]
        for module in modules:
            outcomes = [(w * p, {**to, **change}) for w, to in outcomes for p, change in module.step(label, dict(key))]
        for w, to in outcomes:
            at = tuple(sorted(to.items()))
            result[at] = result.get(at, 0) + w
    return result


def by_modes(modules, belief):
    result = {}
    for key, weight in belief.items():
        state = dict(key)
        modes = tuple(m.modes[state[f"m{i}"]].split(" ", 1)[1] for i, m in enumerate(modules))
        result[modes] = result.get(modes, 0) + weight
    return result


def compare(bin_dir, folder, draw):
    """How many probabilities were compared; None where PRISM cannot say the plant."""
    plant = folder / "plant.tcca"
    plant.write_text(random_plant(draw), encoding="utf-8")
    exported = subprocess.run([bin_dir / "tcca-check", "export", "--format", "prism", "--time", "1s", "--whole", plant, "-q",
                               "--target", "true"], capture_output=True, text=True)
    if exported.returncode != 0:
        return None
    modules = [Module(text) for text in re.split(r"^module ", expanded(exported.stdout), flags=re.M)[1:]]
    labels = re.findall(r"^// (a\d+): (.*)$", exported.stdout, re.M)
    belief = {tuple(sorted((k, v) for m in modules for k, v in m.first.items())): 1.0}
    if "[start]" in exported.stdout:
        belief = stepped(modules, "start", belief)
    log, expected = [], []
    for i in range(STEPS):
        label, text = draw.choice(labels)
        command = dict(part.split(" = ") for part in text.split(", ")) if " = " in text else {}
        log.append(json.dumps({"time": i + 1, "command": command}))
        belief = stepped(modules, label, belief)
        expected.append(by_modes(modules, belief))
    done = subprocess.run([bin_dir / "rmpl-run", "estimate", plant, "--log", "-", "--estimator", "exact", "-q"],
                          input="\n".join(log) + "\n", capture_output=True, text=True, check=True)
    compared = 0
    for line, wanted in zip(done.stdout.splitlines(), expected, strict=True):
        found = {}
        for state in json.loads(line)["belief"]:
            modes = tuple(state["modes"][m.name] for m in modules)
            found[modes] = found.get(modes, 0) + state["probability"]
        for modes in found.keys() | wanted.keys():
            compared += 1
            if abs(found.get(modes, 0) - wanted.get(modes, 0)) > CLOSE:
                raise SystemExit(f"{modes}: PRISM {wanted.get(modes, 0)}, exact {found.get(modes, 0)}\n"
                                 f"{plant.read_text(encoding='utf-8')}{exported.stdout}")
    return compared


def main():
    bin_dir = pathlib.Path(sys.argv[1]).resolve()
    plants = int(sys.argv[2]) if len(sys.argv) > 2 else 60
    draw = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    with tempfile.TemporaryDirectory() as folder:
        results = [compare(bin_dir, pathlib.Path(folder), draw) for _ in range(plants)]
    said = [r for r in results if r is not None]
    print(f"{len(said)} of {plants} plants can be said, {sum(said)} probabilities agree")
    return 0 if len(said) > plants // 4 else 1


if __name__ == "__main__":
    sys.exit(main())
