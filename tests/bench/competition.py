#!/usr/bin/env python3
"""Times rmpl-run diagnose on the diagnostic competition's scenarios, and compares with the published sets.

SPDX-License-Identifier: MIT

usage: competition.py PROGRAMS DXC [--seconds 60] [--simulate N] [--each] [CIRCUIT...]

PROGRAMS is the folder of rmplc and rmpl-run, DXC the folder with models/ and dxc26/ (see docs/benchmarks.md). Each
scenario is one whole process: read the model, minimise, and count the complete set of minimum-cardinality diagnoses.
Its time is the processor time of that process. Where a set was published it is listed and compared. Listed diagnoses
are simulated (2,000 a scenario), here and from the netlist alone: their faulty gates must be able to give the observation; with --simulate N
those of sets of at most N that were not published, too. Where fewer faults suffice
than were published, a diagnosis is printed with the outputs that explain the observation.
"""
import argparse
import itertools
import json
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

SIMULATED = 2000  # diagnoses of one scenario
FUNCTIONS = {
    "and": lambda bits: all(bits),
    "nand": lambda bits: not all(bits),
    "or": lambda bits: any(bits),
    "nor": lambda bits: not any(bits),
    "xor": lambda bits: sum(bits) % 2 == 1,
    "inverter": lambda bits: not bits[0],
    "buffer": lambda bits: bits[0],
}


class Circuit:
    """A system catalogue: gates in an order in which each comes after those that it reads."""

    def __init__(self, path):
        document = xml.etree.ElementTree.parse(path).getroot()
        for element in document.iter():
            element.tag = element.tag.rpartition("}")[2]  # without the name space
        system = document.find("./systems/system")
        joined = {}

        def root(pin):
            while joined.setdefault(pin, pin) != pin:
                pin = joined[pin]
            return pin

        for connection in system.find("connections"):
            joined[root(connection.find("c1").text)] = root(connection.find("c2").text)
        waiting = []
        for component in system.find("components"):
            name, kind = component.find("name").text, component.find("componentType").text
            function = FUNCTIONS.get(kind.rstrip("0123456789"))
            if function is None:
                continue
            inputs = [root(f"{name}.i{i}") for i in itertools.takewhile(lambda i: f"{name}.i{i}" in joined,
                                                                       itertools.count(1))]
            waiting.append((name, function, inputs, root(name + ".o")))
        self.net = lambda name: root(name if name in joined else name + ".o")
        driven = {output for *_, output in waiting}
        self.gates, done = [], set()
        while waiting:
            ready = [gate for gate in waiting if all(net in done or net not in driven for net in gate[2])]
            assert ready, "a loop"
            self.gates += ready
            done.update(gate[3] for gate in ready)
            waiting = [gate for gate in waiting if gate[3] not in done]
        self.driven = driven

    def explanation(self, readings, faulty):
        """Outputs of the faulty gates with which the circuit shows the readings; None where those that come to mind do not.

        In a diagnosis with the fewest faults each gives the opposite of what its inputs ask for.
        """
        outputs = {}
        nets = {self.net(name): value for name, value in readings.items() if self.net(name) not in self.driven}
        for name, function, inputs, output in self.gates:
            value = function([nets[net] for net in inputs])
            if name in faulty:
                outputs[name] = value = not value
            nets[output] = value
        return outputs if all(nets[self.net(name)] == value for name, value in readings.items()) else None


def readings_of(text):
    line = text[text.rindex("sensors"):]
    return {name: value == "true" for name, value in re.findall(r"(\w+) = (true|false)", line[:line.index("}")])}


def published_set(text):
    """The published set, each diagnosis as a frozenset; None where there is none."""
    group = re.search(r"ambiguityGroup.*?diagnoses\s*=\s*\{(.*)\}\s*;", text, re.S)
    if not group:
        return None
    return {frozenset(re.findall(r"\w+", one)) for one in re.findall(r"\{([^{}]*)\}", group.group(1))} or None


def processor_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


class Tally:
    """Of some scenarios: how many, how fast, how large their sets are."""

    def __init__(self):
        self.scenarios, self.seconds, self.counts = 0, [], []

    def row(self, limit):
        if not self.scenarios:
            return "0 | | | | | |"
        times, counts = sorted(self.seconds), sorted(self.counts)
        sizes = f"{counts[len(counts) // 2]} | {counts[-1]}" if counts else "|"
        speed = f"{times[len(times) // 2] * 1e3:.0f} | {times[-1] * 1e3:.0f}" if times else "|"
        return (f"{self.scenarios} | {sum(t <= 1 for t in times)} | {sum(t <= limit for t in times)} | {sizes} | {speed}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("dxc", type=pathlib.Path)
    parser.add_argument("circuits", nargs="*")
    parser.add_argument("--seconds", type=float, default=60, help="limit of one scenario")
    parser.add_argument("--simulate", type=int, default=0, metavar="N")
    parser.add_argument("--each", action="store_true", help="a line for each scenario, on standard error")
    options = parser.parse_args()
    scratch = pathlib.Path(tempfile.mkdtemp())
    circuits = options.circuits or sorted(p.name for p in (options.dxc / "dxc26").iterdir() if p.is_dir())
    columns = f"scenarios | in 1 s | in {options.seconds:g} s | median set | largest set | median ms | worst ms"
    head = f"| circuit | {columns} | {{}} |\n|---|---|---|---|---|---|---|---|{{}}"
    with_set, without_set, comparisons, proofs, simulated = {}, {}, {}, [], 0
    for name in circuits:
        source = options.dxc / "models" / (name + ".xml")
        model = scratch / (name + ".tcca")
        subprocess.run([options.programs / "rmplc", "import", source, "--faults", "weak", "-o", model], check=True)
        circuit = Circuit(source)
        with_set[name], without_set[name] = Tally(), Tally()
        equal, smaller, larger, other = 0, 0, 0, 0
        for scenario in sorted((options.dxc / "dxc26" / name).glob("*.scn")):
            text = scenario.read_text()
            theirs = published_set(text)
            tally = without_set[name] if theirs is None else with_set[name]
            tally.scenarios += 1
            command = [options.programs / "rmpl-run", "diagnose", model, "--scenario", scenario, "--format", "json"]
            before = processor_seconds()
            try:
                # Another process may hold the processor meanwhile: the limit is of processor time.
                answer = subprocess.run(["sh", "-c", f'ulimit -t {int(options.seconds)}; exec "$@"', "sh", *command, "--count"],
                                        capture_output=True, check=True)
            except subprocess.CalledProcessError:
                if options.each:
                    print(scenario.stem, "not done", file=sys.stderr, flush=True)
                continue
            tally.seconds.append(processor_seconds() - before)
            counted = json.loads(answer.stdout)
            tally.counts.append(counted["count"])
            if options.each:
                print(scenario.stem, counted["cardinality"], counted["count"], f"{tally.seconds[-1]:.3f}",
                      file=sys.stderr, flush=True)
            if theirs is None and counted["count"] > options.simulate:
                continue
            listed = json.loads(subprocess.run(command + ["--all-minimal"], capture_output=True, check=True).stdout)
            ours = {frozenset(d["modes"]) for d in listed["diagnoses"]}
            assert len(ours) == counted["count"], "what was counted is what is listed"
            readings = readings_of(text)
            for faulty in sorted(ours, key=sorted)[:SIMULATED]:
                assert circuit.explanation(readings, faulty), f"{scenario.stem}: {faulty}"
                simulated += 1
            if theirs is None:
                continue
            size = len(next(iter(theirs)))
            if ours == theirs:
                equal += 1
            elif counted["cardinality"] < size:
                smaller += 1
                outputs = circuit.explanation(readings, min(ours, key=sorted))
                gates = ", ".join(f"{gate} gives {'1' if value else '0'}" for gate, value in sorted(outputs.items()))
                proofs.append(f"{scenario.stem}: {counted['cardinality']} faults explain it (published: {size}): {gates}")
            elif theirs < ours:
                larger += 1
                proofs.append(f"{scenario.stem}: {len(ours)} sets of {counted['cardinality']} (published: {len(theirs)}, "
                              f"all among ours)")
            else:
                other += 1
                proofs.append(f"{scenario.stem}: {len(theirs - ours)} published sets are not among ours")
        comparisons[name] = f"{equal} | {smaller} | {larger} | {other}"
    print("Scenarios with a published set:\n")
    print(head.format("equal | fewer faults | more sets | else", "---|---|---|---|"))
    for name in circuits:
        print(f"| {name} | {with_set[name].row(options.seconds)} | {comparisons[name]} |")
    print("\nScenarios whose set had not been computed:\n")
    print(head.format("", "").replace(" |  |", " |"))
    for name in circuits:
        print(f"| {name} | {without_set[name].row(options.seconds)} |")
    print(f"\n{simulated} diagnoses were simulated.\n")
    for proof in proofs:
        print("- " + proof)


if __name__ == "__main__":
    sys.exit(main())
