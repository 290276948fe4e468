#!/usr/bin/env python3
# Random model programs as text, through the command line, against an interpreter of their trees (semantics 8).
# SPDX-License-Identifier: MIT
"""Usage: model_programs.py PROGRAMS [COUNT [SEED]].

Each case is a program, a log and `rmpl-run estimate --estimator exact`. The interpreter below shares nothing with the
tree: it numbers the constructs, marks, draws and steps by the words of the semantics, and enumerates all worlds. Beliefs,
what is entailed, whether readings were explained, and that no start is consistent have to be the same.
"""

import itertools
import json
import pathlib
import random
import subprocess
import sys
import tempfile

VARIABLES = {"x": ["a", "b"], "y": ["a", "b", "c"], "u": ["a", "b"]}  # u is commanded
WORLDS = [dict(zip(VARIABLES, values)) for values in itertools.product(*VARIABLES.values())]


class Draw:
    """A random tree; `silent`: what starts may tell nothing, as in the branches of a choose."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.left = 9
        self.definitions = []

    def formula(self):
        name = self.random.choice(list(VARIABLES))
        atom = (name, self.random.choice(["=", "!="]), self.random.choice(VARIABLES[name]))
        return ("or", atom, self.formula()) if self.random.random() < 0.15 else atom

    def told(self):
        name = self.random.choice(["x", "x", "y", "y", "u"])
        return (name, "=", self.random.choice(VARIABLES[name]))

    def step(self, depth, silent=False):
        self.left -= 1
        kinds = [] if silent else ["tell"] * 3
        if depth > 0 and self.left > 0:
            kinds += ["next", "if", "unless", "when", "choose"]
            kinds += ["seq", "par", "always", "watching", "maintaining", "whenever", "call"]
        if not kinds:
            kinds = ["next"]
        kind = self.random.choice(kinds)
        below = lambda quiet=False: self.step(depth - 1, quiet)
        if kind == "tell":
            return ("tell", self.told())
        if kind == "next":
            return ("next", below() if depth > 0 else ("tell", self.told()))
        if kind == "if":
            other = below() if self.random.random() < 0.5 else None
            return ("if", self.formula(), below(), other)
        if kind in ("unless", "when", "whenever"):
            return (kind, self.formula(), below())
        if kind == "always":
            return ("always", below(silent))
        if kind in ("watching", "maintaining"):
            return (kind, below(silent), self.formula())
        if kind == "choose":
            weight = self.random.choice([1, 2, 3, 4])
            return ("choose", [(below(True), weight / 4), (below(True), 1 - weight / 4)] if weight < 4 else
                    [(below(True), 1.0)])
        if kind == "call":
            self.definitions.append(None)
            place = len(self.definitions) - 1
            inside = below(silent)
            again = ("next", ("back", place))
            if self.random.random() < 0.3:
                again = ("unless", self.formula(), ("back", place))
            self.definitions[place] = ("par", [inside, again]) if self.random.random() < 0.4 else inside
            return ("call", place)
        if kind == "seq":
            return ("seq", [below(silent), below()])
        return ("par", [below(silent), below(silent)])


def formula_text(formula):
    return " | ".join(map(formula_text, formula[1:])) if formula[0] == "or" else " ".join(formula)


def text(step):
    kind = step[0]
    if kind == "tell":
        return formula_text(step[1])
    if kind in ("next", "always"):
        return f"{kind} {braced(step[1])}"
    if kind == "if":
        other = f" elsenext {braced(step[3])}" if step[3] else ""
        return f"if {formula_text(step[1])} thennext {braced(step[2])}{other}"
    if kind == "unless":
        return f"unless {formula_text(step[1])} thennext {braced(step[2])}"
    if kind in ("when", "whenever"):
        return f"{kind} {formula_text(step[1])} donext {braced(step[2])}"
    if kind in ("watching", "maintaining"):
        return f"do {braced(step[1])} {kind} {formula_text(step[2])}"
    if kind == "choose":
        return "choose { " + ", ".join(f"{braced(branch)} with {p}" for branch, p in step[1]) + " }"
    if kind in ("call", "back"):
        return f"D{step[1]}()"
    return (" ; " if kind == "seq" else " , ").join(braced(part) for part in step[1])


def braced(step):
    return text(step) if step[0] in ("call", "back") else "{ " + text(step) + " }"


def holds(formula, world):
    if formula[0] == "or":
        return any(holds(part, world) for part in formula[1:])
    return (world[formula[0]] == formula[2]) == (formula[1] == "=")


class Location:
    def __init__(self, number, parent, kind):
        self.number, self.parent, self.kind = number, parent, kind
        self.told = None
        self.condition = None  # of a composite: (entailed, formula)
        self.starts = []  # of a composite
        self.arcs = []  # (condition or None, targets)
        self.branches = []  # of a choose: (probability, starts)
        self.arms = None  # of an `always`: what it starts at once is marked beside it


class Automaton:
    """Numbers, then arcs. A node is lowered to the list of what starts with it."""

    def __init__(self, main, definitions):
        self.locations = []
        self.definitions = definitions
        self.calls = {}  # the composite of each definition, which is called once
        root = self.new(None, "composite")
        root.starts = self.body(main, root)
        self.root = root

    def new(self, parent, kind):
        self.locations.append(Location(len(self.locations) + 1, parent, kind))
        return self.locations[-1]

    def body(self, step, parent):
        """All that a composite holds; it ends by itself."""
        if step[0] == "par":
            return [start for part in step[1] for start in self.lower(part, parent, [])]
        return self.lower(step, parent, [])

    def lower(self, step, parent, after):
        """`after`: filled in later with what follows; lists are shared."""
        kind = step[0]
        if kind == "seq":
            begins = [[] for _ in step[1]] + [after]
            for i, part in enumerate(step[1]):
                begins[i].extend(self.lower(part, parent, begins[i + 1]))
            return begins[0]
        if kind in ("par", "watching", "maintaining", "call"):
            own = self.new(parent, "composite")
            inside = step if kind == "par" else self.definitions[step[1]] if kind == "call" else step[1]
            if kind == "call":
                self.calls[step[1]] = own
            own.starts = self.body(inside, own)
            if kind in ("watching", "maintaining"):
                own.condition = (kind == "maintaining", step[2])
            own.arcs = [(None, after)]
            return [own]
        if kind == "back":
            return [self.calls[step[1]]]
        own = self.new(parent, kind)
        result = [own]
        if kind == "tell":
            own.told = step[1]
            own.arcs = [(None, after)]
        elif kind == "next":
            own.arcs = [(None, self.lower(step[1], parent, after))]
        elif kind == "if":
            own.arcs = [((True, step[1]), self.lower(step[2], parent, after))]
            own.arcs.append(((False, step[1]), self.lower(step[3], parent, after) if step[3] else after))
        elif kind == "unless":
            own.arcs = [((False, step[1]), self.lower(step[2], parent, after)), ((True, step[1]), after)]
        elif kind == "when":
            own.arcs = [((False, step[1]), [own]), ((True, step[1]), self.lower(step[2], parent, after))]
        elif kind == "whenever":
            own.arcs = [(None, [own]), ((True, step[1]), self.lower(step[2], parent, []))]
        elif kind == "always":
            inside = self.lower(step[1], parent, [])
            own.arcs = [(None, [own]), (None, inside)]
            result = [own] + inside
        elif kind == "choose":
            own.branches = [(p, self.lower(branch, parent, after)) for branch, p in step[1]]
        return result

    def inside(self, location, composite):
        while location.parent:
            location = location.parent
            if location is composite:
                return True
        return False

    def full(self, starts):
        """What is marked when these start, without what holds them."""
        result = set()
        for location in starts:
            result.add(location)
            result |= self.full(location.starts)
        return result

    def around(self, locations):
        result = set(locations)
        for location in locations:
            while location.parent:
                location = location.parent
                result.add(location)
        return result

    def drawn(self, locations):
        """All ways to draw the choices among these, and those that a branch starts: (probability, all that starts)."""
        choices = [location for location in locations if location.kind == "choose"]
        plain = {location for location in locations if location.kind != "choose"}
        ways = [(1.0, plain)]
        for choice in choices:
            branches = [(p * q, more) for p, starts in choice.branches for q, more in self.drawn(self.full(starts))]
            ways = [(p * q, marked | more) for p, marked in ways for q, more in branches]
        return ways

    def initial(self):
        first = self.full([self.root])
        again = set()
        for location in self.locations:
            for _, targets in location.arcs:
                again |= self.full(targets)
        def expand(locations):
            ways = [(1.0, set())]
            for location in locations:
                if location.kind == "choose" and location not in again:
                    own = [(p * q, more) for p, starts in location.branches for q, more in expand(self.full(starts))]
                else:
                    own = [(1.0, {location})]
                ways = [(p * q, marked | more) for p, marked in ways for q, more in own]
            return ways
        return [(p, frozenset(self.around(marked))) for p, marked in expand(first)]

    def store(self, marking, commands):
        told = [location.told for location in marking if location.told]
        told += [(name, "=", value) for name, value in commands.items()]
        return [world for world in WORLDS if all(holds(formula, world) for formula in told)]

    def step(self, marking, commands):
        """{next marking: probability}; none where the commands contradict."""
        store = self.store(marking, commands)
        if not store:
            return {}
        entailed = lambda condition: condition is None or condition[0] == all(holds(condition[1], w) for w in store)
        left = lambda location: any(self.inside(location, c) and not entailed(c.condition) for c in self.locations)
        primitive = [location for location in marking if location.kind != "composite" and not left(location)]
        result = {}
        for p, active in self.drawn(primitive):
            if p == 0:
                continue
            active = self.around(active) | {c for c in marking if c.kind == "composite"}
            taken = []
            for location in sorted(active, key=lambda l: -l.number):
                if left(location):
                    continue
                if location.kind == "composite" and any(
                        self.inside(a, location) and (b is location or self.inside(b, location)) for a, b in taken):
                    continue
                taken += [(location, b) for condition, targets in location.arcs if entailed(condition) for b in targets]
            following = frozenset(self.around(self.full([b for _, b in taken])))
            if self.store(following, {}):
                result[following] = result.get(following, 0) + p
        return result

    def factor(self, marking, seen):
        store = self.store(marking, {})
        if not any(all(world[n] == v for n, v in seen.items()) for world in store):
            return 0
        result = 1
        for name, value in seen.items():
            if not all(world[name] == value for world in store):
                result /= len(VARIABLES[name])
        return result

    def values(self, marking):
        store = self.store(marking, {})
        return {name: store[0][name] for name in VARIABLES if len({world[name] for world in store}) == 1}


def normalised(belief):
    total = sum(belief.values())
    return {marking: p / total for marking, p in belief.items()}


def estimates(automaton, log):
    """(belief, explained) for each line."""
    belief = {}
    for p, marking in automaton.initial():
        if p > 0 and automaton.store(marking, {}):
            belief[marking] = belief.get(marking, 0) + p
    if not belief:
        return None
    belief = normalised(belief)
    result = []
    for line in log:
        prior = {}
        for marking, weight in belief.items():
            for following, p in automaton.step(marking, line["command"]).items():
                prior[following] = prior.get(following, 0) + weight * p
        posterior = {m: p * automaton.factor(m, line["observations"]) for m, p in prior.items()}
        posterior = {m: p for m, p in posterior.items() if p > 0}
        belief = normalised(posterior or prior or belief)
        result.append((belief, bool(posterior)))
    return result


def compare(rmpl_run, seed, folder):
    """What is wrong with a case, or nothing; and whether it was one."""
    draw = Draw(seed)
    main = draw.step(4)
    source = "variable x, u : { a, b };\nvariable y : { a, b, c };\nobserve x, y;\ncontrol u;\n"
    source += "model Main() :: { " + text(main) + " }\n"
    source += "".join(f"model D{i}() :: {{ {text(body)} }}\n" for i, body in enumerate(draw.definitions))
    log = []
    for time in range(1, 6):
        line = {"time": time, "command": {}, "observations": {}}
        if draw.random.random() < 0.6:
            line["command"]["u"] = draw.random.choice("ab")
        for name in "xy":
            if draw.random.random() < 0.25:
                line["observations"][name] = draw.random.choice(VARIABLES[name])
        log.append(line)
    path = folder / "random.rmpl"
    path.write_text(source, encoding="utf-8")
    done = subprocess.run([rmpl_run, "estimate", path, "--log", "-", "--estimator", "exact"], timeout=60, check=False,
                          input="".join(json.dumps(line) + "\n" for line in log), capture_output=True, text=True)
    case = source + "".join(json.dumps(line) + "\n" for line in log)
    if done.returncode == 2 and "error[" in done.stderr:
        return None, False, done.stderr.split("\n")[0]
    expected = estimates(Automaton(main, draw.definitions), log)
    if expected is None or done.returncode != 0:
        wrong = None if expected is None and done.returncode == 2 else f"exit {done.returncode}: {done.stderr}"
        return wrong and case + wrong, True, ""
    for line, (belief, explained) in zip(map(json.loads, done.stdout.splitlines()), expected):
        # Threads that have nothing to do with each other stay or go on apart; the interpreter has one belief of all.
        if any("the belief stays" in event["message"] for event in line.get("events", [])):
            return None if not explained else f"{case}at {line['time']}: found {line}", True, ""
        found = {tuple(entry["marking"]): entry for entry in line["belief"]}
        wanted = {tuple(sorted(l.number for l in marking)): (p, marking) for marking, p in belief.items()}
        same = found.keys() == wanted.keys() and explained == ("events" not in line)
        same = same and all(abs(found[m]["probability"] - wanted[m][0]) < 1e-12 for m in wanted)
        automaton_values = lambda marking: Automaton.values(VALUES, marking)
        if not same or any(found[m]["values"] != automaton_values(wanted[m][1]) for m in wanted):
            shown = {m: (p, automaton_values(marking)) for m, (p, marking) in wanted.items()}
            return f"{case}at {line['time']}: found {line}\nexpected {shown}, explained: {explained}", True, ""
    return None, True, ""


VALUES = Automaton(("tell", ("x", "=", "a")), [])


def main():
    rmpl_run = pathlib.Path(sys.argv[1]) / "rmpl-run"
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 200
    first = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    compared, refused = 0, {}
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(first, first + count):
            wrong, was_case, refusal = compare(rmpl_run, seed, pathlib.Path(folder))
            if wrong:
                sys.exit(f"seed {seed}:\n{wrong}")
            compared += was_case
            if not was_case:
                refused[refusal] = refused.get(refusal, 0) + 1
    for refusal, times in sorted(refused.items(), key=lambda item: -item[1])[:5]:
        print(f"{times} refused: {refusal}")
    print(f"{compared} programs compared")
    if compared < count // 2:
        sys.exit("expected most programs to compile")


if __name__ == "__main__":
    main()
