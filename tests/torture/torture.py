#!/usr/bin/env python3
# Fault injection: whatever call of a run fails, the answer is the honest one, or none, and no file is lost.
# SPDX-License-Identifier: MIT
"""Runs some thirty command lines, and lets the n-th allocation, read, write, open … of each fail, once or from then on.
Besides: limits of memory, of file size and of descriptors, descriptors that are closed or full, signals at any moment.

After each fault one of these must hold: exit code, standard output and files are those of the undisturbed run; or the exit
code is 2 or 3, standard error has a message, every file is as it was before, and standard output is a beginning of what it
would have been. A signal may also end the program, before its files are written or after, or its search, which then says
what it has found.
--faults says how many calls fail in all, spread over commands, kinds of call and places, --moments how many limits and
signals are tried; --all lets each call fail. Prints what was tried and each fault that was answered otherwise, as it goes
on; exits 1 where there was one."""

import argparse
import collections
import concurrent.futures
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
KINDS = ("alloc", "open", "read", "write", "sync", "rename", "stat")
SIGNALS = {name: getattr(signal, "SIG" + name) for name in ("TERM", "INT", "HUP", "XFSZ")}
DESCRIPTORS = ("<&-", "</", ">&-", ">/dev/full", "2>&-", "2>/dev/full", "<&- >&- 2>&-", ">&- 2>&-")

COMMANDS = """
rmplc compile mars-entry/mars_entry.rmpl mars-entry/mars_lander.tcca
rmplc compile propulsion/burn.scn -o out.json
rmplc compile power/power.tcca -o old.json
rmplc compile broken.tcca
rmplc compile --format json broken.tcca
rmplc explain RMPL0301
rmplc import circuit.bench -o out.tcca
rmplc --help
rmpl-run scenario mars-entry/mars_entry.scn --only 'nominal flight'
rmpl-run scenario propulsion/burn.scn -q --trace out.jsonl
rmpl-run scenario propulsion/burn.scn -q --trace old.json --trace-detail beliefs
rmpl-run scenario power/power.scn --format junit
rmpl-run estimate propulsion/propulsion.tcca --log log.jsonl
rmpl-run estimate propulsion/propulsion.tcca --log - --estimator exact < log.jsonl
rmpl-run plan propulsion/propulsion.tcca --goal 'engine = firing'
rmpl-run plan propulsion/propulsion.tcca --policy
rmpl-run diagnose propulsion/propulsion.tcca --observe 'engine.thrust = zero' -k 5 --format json
rmpl-run diagnose circuit.tcca --observe 'a = true, b = true, out.o = false' --all-minimal
tcca-check reachability propulsion/propulsion.tcca --target 'engine = firing' --faults 1
tcca-check reachability propulsion/propulsion.tcca --target 'engine = failed' --faults 1 --format json
tcca-check safety propulsion/propulsion.tcca --never 'engine = failed'
tcca-check safety propulsion/propulsion.tcca --never 'engine = failed' --faults 1 --cut-sets 1
tcca-check response power/power.tcca --after 'relay_a = stuck_open' --within 5s 'relay_b = closed'
tcca-check stuck mars-entry/mars_lander.tcca
tcca-check check propulsion/propulsion.tcca propulsion/propulsion.props --format junit
tcca-check program mars-entry/mars_entry.rmpl mars-entry/mars_lander.tcca
tcca-check program propulsion/burn.rmpl propulsion/propulsion.tcca --faults 1 --never 'engine = failed' --scenario out.scn
tcca-check program power/power.rmpl power/power.tcca --each-fault --format json
tcca-check export propulsion/propulsion.tcca --target 'engine = firing' --format tchecker
tcca-check export mars-entry/mars_lander.tcca --target 'engine = failed' --faults 1 --format uppaal
""".strip().splitlines()

BENCH = "INPUT(a)\nINPUT(b)\nOUTPUT(out)\nn = NAND(a, b)\nm = NOT(n)\nout = AND(m, a)\n"
BROKEN = "component Lamp { initial off; mode off; mode on; off -> onn; }\nplant P { lamp : Lamp; }\n"
LOG = "".join(f'{{"time": {t}}}\n' for t in range(1, 6))

MEASURED = re.compile(rb'\btime="[0-9.e-]+"|"(?:seconds|peak_bytes|states_per_second)": ?[-+.0-9e]+')

Seen = collections.namedtuple("Seen", "code out errors files")


def prepare(folder: pathlib.Path, programs: pathlib.Path) -> None:
    for example in ("mars-entry", "propulsion", "power"):
        shutil.copytree(ROOT / "examples" / example, folder / example)
    (folder / "broken.tcca").write_text(BROKEN, encoding="utf-8")
    (folder / "circuit.bench").write_text(BENCH, encoding="utf-8")
    (folder / "log.jsonl").write_text(LOG, encoding="utf-8")
    subprocess.run([programs / "rmplc", "import", "circuit.bench", "-o", "circuit.tcca"], cwd=folder, check=True)


class Torturer:
    """One folder, in which commands run one after another."""

    def __init__(self, folder: pathlib.Path, programs: pathlib.Path, library: pathlib.Path):
        self.folder, self.programs, self.library = folder, programs, library
        prepare(folder, programs)
        self.inputs = {path.relative_to(folder) for path in folder.rglob("*") if path.is_file()}
        self.counts = folder.parent / (folder.name + ".counts")
        self.expected: dict[str, Seen] = {}
        self.calls: dict[str, dict[str, int]] = {}
        self.answered: collections.Counter[str] = collections.Counter()
        for command in COMMANDS:
            self.expected[command] = self.run(command, {"RMPL_FAULT_COUNTS": str(self.counts)})
            lines = self.counts.read_text(encoding="utf-8").splitlines()
            self.calls[command] = {name: int(count) for name, count in (line.split() for line in lines)}

    def run(self, command: str, wish: dict[str, str]) -> Seen:
        """Undisturbed but for what the preloaded library is told."""
        # `exec`, through env, so that the shell itself is not disturbed.
        preload = " ".join(f"{key}={value}" for key, value in {**wish, "LD_PRELOAD": str(self.library)}.items())
        return self.run_shell(f"exec env {preload} {command}")

    def run_shell(self, line: str) -> Seen:
        for path in list(self.folder.rglob("*")):
            if path.is_file() and path.relative_to(self.folder) not in self.inputs:
                path.unlink()
        (self.folder / "old.json").write_text("old", encoding="utf-8")
        environment = {"PATH": f"{self.programs}:/usr/bin:/bin", "LC_ALL": "C.UTF-8"}
        try:
            done = subprocess.run(line, shell=True, cwd=self.folder, env=environment, timeout=60, stdin=subprocess.DEVNULL,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        except subprocess.TimeoutExpired:
            return Seen("hangs", b"", b"", {})
        files = {str(path.relative_to(self.folder)): path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}
        return Seen(done.returncode, MEASURED.sub(b"", done.stdout), done.stderr, files)

    def fault(self, command: str, kind: str, *how) -> str | None:
        """What is wrong with the answer, if anything is; `answered` counts what became of it."""
        honest = self.expected[command]
        if kind in KINDS:
            seen = self.run(command, {"RMPL_FAULT": f"{kind}:{how[0]}:{how[1]}"})
        elif kind == "signal":
            seen = self.run_shell(f"exec timeout --preserve-status -s {how[0]} {how[1]} {command}")
        elif kind == "limit":
            seen = self.run_shell(f"ulimit {how[0]} {how[1]}; exec {command}")
        else:
            seen = self.run_shell(f"exec {command} {how[0]}")
        if (seen.code, seen.out, seen.files) == (honest.code, honest.out, honest.files):
            self.answered["as if nothing had been"] += 1
            return None
        self.answered[f"exit {seen.code}"] += 1
        silent = kind in ("write", "signal", "descriptor")
        codes = {2, 3}
        missing = b"a better trace may exist" in seen.out or b"no scenario is written" in seen.errors
        if kind == "signal" and seen.code == honest.code and missing:
            return None  # the verdict was there before the signal, and it is said what is not
        if kind == "signal":
            codes |= {128 + SIGNALS[how[0]], -SIGNALS[how[0]]}  # before the program has begun
        if kind == "limit":
            codes |= {127, -signal.SIGXFSZ} if seen.errors else {-signal.SIGXFSZ}  # 127: not even the loader has enough
            silent = seen.code == -signal.SIGXFSZ
        if kind == "descriptor" and ">" in how[0] and seen.code == honest.code:
            return None if seen.files == honest.files else "other files"
        if seen.code not in codes:
            return f"exit {seen.code}: {seen.errors.decode(errors='replace')[-200:]!r}"
        if not seen.errors and not silent:
            return f"exit {seen.code} without a message"
        before = {name: data for name, data in honest.files.items() if pathlib.Path(name) in self.inputs} | {"old.json": b"old"}
        whole = kind == "signal" and seen.files == honest.files  # it came when all was written
        if seen.files != before and not whole:
            return f"files: {sorted(name for name in seen.files.keys() | before.keys() if seen.files.get(name) != before.get(name))}"
        reason = "junit" in command and b"errors=\"1\"" in seen.out  # why there is no answer, for services
        if not honest.out.startswith(seen.out) and not (kind == "signal" and seen.code == 3) and not reason:
            return f"other output: {seen.out[:200]!r}"
        return None


def least_memory(programs: pathlib.Path) -> int:
    """The KiB of address space with which the loader can start each of the programs; less is no matter of theirs."""

    def starts(kib: int) -> bool:
        lines = [f"ulimit -v {kib}; exec {programs / name} --version" for name in {command.split()[0] for command in COMMANDS}]
        return all(subprocess.run(line, shell=True, capture_output=True, check=False).returncode == 0 for line in lines)

    kib = 1024
    while not starts(kib):
        kib += 256
    return kib


def moments(draw: random.Random, count: int, least: int) -> list[tuple]:
    """Limits, descriptors and signals, drawn by turns for each command."""
    result = []
    for i in range(count):
        command = COMMANDS[i % len(COMMANDS)]
        kind = draw.choice(("signal", "signal", "memory", "size", "descriptors", "descriptor"))
        if kind == "signal":
            result.append((command, kind, draw.choice(list(SIGNALS)), round(10 ** draw.uniform(-3, -0.3), 4)))
        elif kind == "memory":
            result.append((command, "limit", "-v", int(least * 2 ** draw.uniform(0, 5))))
        elif kind == "size":
            result.append((command, "limit", "-f", int(2 ** draw.uniform(0, 8)) - 1))
        elif kind == "descriptors":
            result.append((command, "limit", "-n", draw.randint(3, 12)))
        else:
            result.append((command, kind, draw.choice(DESCRIPTORS)))
    return result


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path, help="the folder of the programs")
    parser.add_argument("library", type=pathlib.Path, help="the library that is preloaded")
    parser.add_argument("--faults", type=int, default=1000)
    parser.add_argument("--moments", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--all", action="store_true", help="every call of every run, hours")
    options = parser.parse_args()
    jobs = os.cpu_count() or 1
    with tempfile.TemporaryDirectory() as top:
        folders = [pathlib.Path(top, str(j)) for j in range(jobs)]
        torturers = []
        for folder in folders:
            folder.mkdir()
            torturers.append(Torturer(folder, options.programs.resolve(), options.library.resolve()))
        calls = torturers[0].calls
        draw = random.Random(options.seed)
        wishes = []
        if options.all:
            wishes = [(c, k, n, m) for c in COMMANDS for k in KINDS for n in range(1, calls[c][k] + 1) for m in (1, 0)]
        else:
            for i in range(options.faults):
                command = COMMANDS[i % len(COMMANDS)]
                # Half of the faults are of memory; the other calls are few, and soon all tried.
                kinds = [kind for kind in KINDS[1:] if calls[command][kind] > 0]
                kind = "alloc" if draw.random() < 0.5 or not kinds else draw.choice(kinds)
                wishes.append((command, kind, draw.randint(1, calls[command][kind]), draw.choice((1, 1, 0))))
        wishes += moments(draw, options.moments, least_memory(options.programs.resolve()) if options.moments else 0)
        wrong = 0
        tried: collections.Counter[str] = collections.Counter()
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            free = list(torturers)

            def one(wish):
                torturer = free.pop()
                try:
                    return wish, torturer.fault(*wish)
                finally:
                    free.append(torturer)

            for (command, kind, *how), complaint in pool.map(one, wishes):
                tried[kind] += 1
                if complaint:
                    wrong += 1
                    print(f"RMPL_FAULT={kind}:{':'.join(str(part) for part in how)} {command}\n  {complaint}", flush=True)
                if sum(tried.values()) % 10_000 == 0:
                    print(f"{sum(tried.values())} of {len(wishes)} so far, {wrong} answered wrongly", flush=True)
    print(f"{sum(tried.values())} faults over {len(COMMANDS)} commands, {wrong} answered wrongly: "
          + ", ".join(f"{count} of {kind}" for kind, count in sorted(tried.items())))
    answered = sum((torturer.answered for torturer in torturers), collections.Counter())
    print("answered: " + ", ".join(f"{count} {what}" for what, count in sorted(answered.items())))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
