#!/usr/bin/env python3
# The exports to UPPAAL, TChecker and JANI, read by a plain explorer of their processes, against the verifier.
# SPDX-License-Identifier: MIT
"""Usage: networks.py BIN_DIR [PLANTS [SEED]]

Asks of random plants whether a mode can be reached, of the verifier and of the exported models, of all components and
of those that have to do with the question. What the formats demand of a model is checked on the way: of UPPAAL the
order and the contents of the elements that its document type has, of JANI the members that jani-model version 1 has.
Prints one line and exits 1 where the answers differ.
"""

import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from prism import random_plant  # noqa: E402


class Process:
    """Its places, whether time may pass there, its edges by place, and its own clock by the name in expressions."""

    def __init__(self, initial):
        self.initial = initial
        self.progress = {}  # by place, an expression
        self.edges = {}  # by place: guard, target, assignments (name or array and index, expression)

    def add_edge(self, source, target, guard, effects):
        assert source in self.progress and target in self.progress
        self.edges.setdefault(source, []).append((compiled(guard), target, [(w, compiled(v)) for w, v in effects]))


def compiled(expression):
    return compile(expression, expression, "eval")


def explore(processes, variables, clocks, cap):
    """Whether a state in which `reached` holds can be come to: unit by unit, which suffices as all bounds are weak."""
    progress = [{place: compiled(text) for place, text in p.progress.items()} for p in processes]
    names = sorted(variables)
    first = (tuple(p.initial for p in processes), tuple(variables[n] for n in names))
    waiting, seen = [first], {first}

    def add(places, state):
        key = (places, tuple(state[n] for n in names))
        if key not in seen:
            seen.add(key)
            waiting.append(key)

    while waiting:
        places, values = waiting.pop()
        state = dict(zip(names, values))
        if state["reached"]:
            return True
        for number, process in enumerate(processes):
            for guard, target, effects in process.edges.get(places[number], []):
                if not eval(guard, {}, state):
                    continue
                new = dict(state)
                for what, value in effects:
                    new[what] = eval(value, {}, new if process.sequential else state)
                moved = places[:number] + (target,) + places[number + 1:]
                if eval(progress[number][target], {"passing": False}, new):
                    add(moved, new)
        later = {n: min(v + 1, cap) if n in clocks else v for n, v in state.items()}
        if all(eval(one[place], {"passing": True}, later) for one, place in zip(progress, places)):
            add(places, later)
    return False


# UPPAAL.

def python_of(text, arguments, clock):
    """An expression of UPPAAL in Python, with the parameters of the template given."""
    text = re.sub(r"\b(\w+)\b", lambda word: str(arguments.get(word[1], word[1])), text)
    text = re.sub(r"\bx\b", clock, text)
    text = re.sub(r"\b([mnu])\[(\d+)\]", r"\1\2", text)
    text = text.replace("&&", " and ").replace("||", " or ").replace("true", "True").replace("false", "False")
    return re.sub(r"!(?!=)", " not ", text)


def effects_of(text, arguments, clock):
    effects = []
    for part in filter(None, (one.strip() for one in text.split(", "))):
        if part.endswith("++"):
            name = python_of(part[:-2], arguments, clock)
            effects.append((name, name + " + 1"))
        else:
            name, value = part.split(" = ", 1)
            effects.append((python_of(name, arguments, clock), python_of(value, arguments, clock)))
    return effects


def labels(node):
    kinds = [label.get("kind") for label in node.findall("label")]
    assert len(set(kinds)) == len(kinds) and set(kinds) <= {"invariant", "guard", "assignment", "comments"}
    return {label.get("kind"): label.text for label in node.findall("label")}


def instance_of(template, arguments, clock):
    order = [child.tag for child in template]
    ranks = {tag: rank for rank, tag in enumerate(["name", "parameter", "declaration", "location", "init", "transition"])}
    assert [ranks[tag] for tag in order] == sorted(ranks[tag] for tag in order), order
    process = Process(template.find("init").get("ref"))
    process.sequential = True
    names = [location.find("name").text for location in template.findall("location")]
    assert len(set(names)) == len(names) and all(re.fullmatch(r"[A-Za-z]\w*", name) for name in names), names
    for location in template.findall("location"):
        invariant = python_of(labels(location).get("invariant", "true"), arguments, clock)
        urgent = location.find("urgent") is not None
        process.progress[location.get("id")] = "not passing" if urgent else invariant
    for edge in template.findall("transition"):
        assert [child.tag for child in edge][:2] == ["source", "target"]
        text = labels(edge)
        process.add_edge(edge.find("source").get("ref"), edge.find("target").get("ref"),
                         python_of(text.get("guard", "true"), arguments, clock),
                         effects_of(text.get("assignment", ""), arguments, clock))
    return process


def read_uppaal(text):
    nta = xml.fromstring(text.split("dtd'>", 1)[1])
    assert [child.tag for child in nta if child.tag != "template"] == ["declaration", "system", "queries"]
    assert nta.find("queries/query/formula").text == "E<> reached"
    variables = {}
    for line in nta.find("declaration").text.splitlines():
        line = line.split("//")[0].strip()
        if array := re.fullmatch(r"int\[0, \d+\] (\w)\[(\d+)\](?: = \{ (.*) \})?;", line):
            first = [int(v) for v in array[3].split(", ")] if array[3] else [0] * int(array[2])
            assert len(first) == int(array[2])
            variables.update({f"{array[1]}{i}": value for i, value in enumerate(first)})
        elif scalar := re.fullmatch(r"(?:bool|int\[0, \d+\]) (\w+) = (\w+);", line):
            variables[scalar[1]] = {"true": True, "false": False}.get(scalar[2]) if scalar[2] in ("true", "false") else int(scalar[2])
        else:
            assert not line, line
    templates = {t.find("name").text: t for t in nta.findall("template")}
    processes, clocks = [], set()
    lines = nta.find("system").text.splitlines()
    listed = re.fullmatch(r"system (.*);", lines[-1])[1].split(", ")
    assert listed[0] == "Rounds" and len(listed) == len(lines)
    processes.append(instance_of(templates["Rounds"], {}, "x"))
    for name, line in zip(listed[1:], lines[:-1]):
        made = re.fullmatch(r"(\w+) = (\w+)\((.*)\);", line)
        assert made[1] == name
        template = templates[made[2]]
        declared = [one.split()[-1] for one in template.find("parameter").text.split(", ")]
        given = made[3].split(", ")
        assert len(declared) == len(given)
        clock = "x" + given[0]
        if template.find("declaration") is not None:
            clocks.add(clock)
            variables[clock] = 0
        processes.append(instance_of(template, dict(zip(declared, given)), clock))
    cap = max([int(number) for number in re.findall(r"x &[lg]t;= (\d+)", text)] + [0]) + 1
    return explore(processes, variables, clocks, cap), len(templates)


# JANI.

OPERATORS = {"≤": "<=", "≥": ">=", "<": "<", "=": "==", "≠": "!=", "+": "+", "∧": "and", "∨": "or"}


def members(node, needed, others=()):
    assert set(needed) <= set(node) <= set(needed) | set(others) | {"comment"}, node


def expression(node, functions=None):
    """In Python; `functions` are those of the model, by name."""
    if isinstance(node, dict) and node["op"] == "¬":
        members(node, ["op", "exp"])
        return f"(not {expression(node['exp'], functions)})"
    if isinstance(node, dict) and node["op"] == "call":
        members(node, ["op", "function", "args"])
        parameters, body = functions[node["function"]]
        assert len(parameters) == len(node["args"])
        given = dict(zip(parameters, [expression(argument) for argument in node["args"]]))
        return re.sub(r"\bp\d+\b", lambda word: given[word[0]], body)
    if isinstance(node, dict):
        members(node, ["op", "left", "right"])
        return f"({expression(node['left'], functions)} {OPERATORS[node['op']]} {expression(node['right'], functions)})"
    return node if isinstance(node, str) else repr(node)


def constants(node, found):
    if isinstance(node, dict):
        if node.get("op") in ("≤", "≥") and isinstance(node["right"], int):
            found.add(node["right"])
        for inner in node.values():
            constants(inner, found)
    elif isinstance(node, list):
        for inner in node:
            constants(inner, found)
    return found


def read_jani(text):
    model = json.loads(text)
    members(model, ["jani-version", "name", "type", "metadata", "features", "variables", "properties", "automata", "system"],
            ["functions"])
    assert model["jani-version"] == 1 and model["type"] == "pta"
    assert model["features"] == (["functions"] if "functions" in model else [])
    functions = {}
    for one in model.get("functions", []):
        members(one, ["name", "type", "parameters", "body"])
        assert one["type"] == "bool" and all(p["type"] == "int" for p in one["parameters"]) and one["name"] not in functions
        functions[one["name"]] = [p["name"] for p in one["parameters"]], expression(one["body"])
    assert [e["automaton"] for e in model["system"]["elements"]] == [a["name"] for a in model["automata"]]
    [prop] = model["properties"]
    members(prop, ["name", "expression"])
    assert prop["expression"] == {"op": "filter", "fun": "max", "states": {"op": "initial"},
                                  "values": {"op": "Pmax", "exp": {"op": "F", "exp": "reached"}}}
    variables, clocks = {}, set()
    for variable in model["variables"]:
        members(variable, ["name", "type", "initial-value"])
        assert variable["name"] not in variables
        variables[variable["name"]] = variable["initial-value"]
        if variable["type"] == "clock":
            clocks.add(variable["name"])
        elif variable["type"] != "bool":
            members(variable["type"], ["kind", "base", "lower-bound", "upper-bound"])
            assert variable["type"]["lower-bound"] <= variable["initial-value"] <= variable["type"]["upper-bound"]
    processes = []
    for automaton in model["automata"]:
        members(automaton, ["name", "locations", "initial-locations", "edges"])
        [initial] = automaton["initial-locations"]
        process = Process(initial)
        process.sequential = False  # assignments of one edge happen at once
        for location in automaton["locations"]:
            members(location, ["name"], ["time-progress"])
            assert location["name"] not in process.progress
            progress = location.get("time-progress", {"exp": True})["exp"]
            process.progress[location["name"]] = "not passing" if progress is False else expression(progress, functions)
        for edge in automaton["edges"]:
            members(edge, ["location", "destinations"], ["guard"])
            [destination] = edge["destinations"]
            members(destination, ["location"], ["assignments"])
            effects = [(one["ref"], expression(one["value"], functions)) for one in destination.get("assignments", [])]
            assert len({name for name, _ in effects}) == len(effects) and {name for name, _ in effects} <= set(variables)
            process.add_edge(edge["location"], destination["location"], expression(edge.get("guard", {"exp": True})["exp"], functions), effects)
        processes.append(process)
    return explore(processes, variables, clocks, max(constants(model["automata"], {0})) + 1), len(processes)


# TChecker.

WORDS = re.compile(r"\s*(&&|[=!<>]=|[()!<>+]|\w+)")


class Condition:
    """A condition of TChecker in Python: a conjunction of comparisons and conditional terms, and nothing else."""

    def __init__(self, text):
        self.words = WORDS.findall(text)
        assert "".join(self.words) == text.replace(" ", ""), text
        self.at = 0

    def take(self, word=None):
        taken = self.words[self.at]
        assert word is None or taken == word, (word, self.words[self.at:])
        self.at += 1
        return taken

    def ahead(self):
        return self.words[self.at] if self.at < len(self.words) else ""

    def conjunction(self):
        parts = [self.atom()]
        while self.ahead() == "&&":
            self.take()
            parts.append(self.atom())
        return "(" + " and ".join(parts) + ")"

    def atom(self):
        if self.ahead() == "(":
            self.take()
            self.take("if")
            test = self.conjunction()
            self.take("then")
            yes = self.atom()
            self.take("else")
            no = self.atom()
            self.take(")")
            return f"({yes} if {test} else {no})"
        left = self.take()
        assert re.fullmatch(r"\w+", left)
        if self.ahead() in ("==", "!=", "<", "<=", ">", ">="):
            return f"{left} {self.take()} {self.take()}"
        return left

    @staticmethod
    def of(text):
        condition = Condition(text)
        result = condition.conjunction()
        assert condition.at == len(condition.words), text
        return result


def read_tchecker(text):
    lines = [line for line in text.splitlines() if line and not line.startswith("#")]
    assert lines[0] == "system:plant" and lines[1] == "event:tau"
    variables, bounds, clocks, processes, initial, labelled = {}, {}, set(), {}, {}, set()
    constants_found = {0}
    for line in lines[2:]:
        declared, _, attributes = line.partition("{")
        kind, *parts = declared.split(":")
        told = dict(part.strip().split(":", 1) for part in re.split(r" : ?", attributes.rstrip("}")) if part.strip())
        constants_found |= {int(number) for number in re.findall(r"\bx\d+[<>]=(\d+)", attributes)}
        if kind == "int":
            size, low, high, first, name = parts
            assert size == "1" and low == "0" and 0 <= int(first) <= int(high) and name not in variables
            variables[name], bounds[name] = int(first), int(high)
        elif kind == "clock":
            assert parts[0] == "1" and parts[1] not in variables
            variables[parts[1]] = 0
            clocks.add(parts[1])
        elif kind == "process":
            assert parts[0] not in processes
            processes[parts[0]] = Process(None)
            processes[parts[0]].sequential = True
        elif kind == "location":
            process, name = parts
            assert set(told) <= {"initial", "urgent", "labels", "invariant"} and name not in processes[process].progress
            invariant = Condition.of(told["invariant"]) if "invariant" in told else "True"
            processes[process].progress[name] = "not passing" if "urgent" in told else invariant
            if "initial" in told:
                assert processes[process].initial is None
                processes[process].initial = name
            if told.get("labels") == "target":
                labelled.add((process, name))
        else:
            assert kind == "edge" and set(told) <= {"provided", "do"} and parts[3] == "tau", line
            process, source, target, _ = parts
            effects = [tuple(one.split("=", 1)) for one in told.get("do", "").split(";") if one]
            assert all(name in variables for name, _ in effects), line
            if (process, target) in labelled:
                effects.append(("reached", "True"))
            processes[process].add_edge(source, target, Condition.of(told.get("provided", "1")), effects)
    assert len(labelled) == 1 and all(process.initial for process in processes.values())
    variables["reached"] = False
    return explore(list(processes.values()), variables, clocks, max(constants_found) + 1), len(processes)


def main() -> int:
    bin_dir = pathlib.Path(sys.argv[1])
    plants = int(sys.argv[2]) if len(sys.argv) > 2 else 100
    draw = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    met = shared = 0
    with tempfile.TemporaryDirectory() as folder:
        model = pathlib.Path(folder, "plant.tcca")
        for number in range(plants):
            text = random_plant(draw)
            model.write_text(text, encoding="utf-8")
            components = len(re.findall(r"^  c\d+ : C", text, re.M))
            target = f"c{draw.randrange(components)} = {draw.choice(['m0', 'm1', 'broken'])}"
            options = [model, "--target", target, "--faults", str(draw.randint(0, 1)), "--commands", draw.choice(["one", "any"])]
            asked = subprocess.run([bin_dir / "tcca-check", "reachability", *options, "--format", "json"],
                                   capture_output=True, text=True, timeout=60, check=False)
            assert asked.returncode in (0, 1), asked.stderr
            verdict = asked.returncode == 0
            for form, read in (("uppaal", read_uppaal), ("tchecker", read_tchecker), ("jani", read_jani)):
                for whole in ([], ["--whole"]):
                    made = subprocess.run([bin_dir / "tcca-check", "export", "--format", form, *options, *whole],
                                          capture_output=True, text=True, timeout=60, check=True)
                    reached, count = read(made.stdout)
                    if form == "uppaal" and whole:
                        shared += components + 1 - count
                    if reached != verdict:
                        print(f"plant {number}: {target} is {verdict}, and the model for {form} {whole} says otherwise\n{text}")
                        return 1
            met += verdict
    print(f"{plants} plants asked the same of the verifier and of their models for UPPAAL, TChecker and JANI, {met} reach the target, "
          f"{shared} components share a template")
    return 0 if 0 < met < plants and (shared > 0 or plants < 20) else 1


if __name__ == "__main__":
    sys.exit(main())
