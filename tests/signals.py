#!/usr/bin/env python3
# Signals that come twice, at random moments: every run gives its answer.
# SPDX-License-Identifier: MIT
"""Usage: signals.py ROOT PROGRAMS [--runs N] [--seed S].

GNU timeout sends its signal to the child and to its process group, so that the child gets it twice; services for
continuous integration send one after another. Runs that would take long get SIGTERM, SIGINT or SIGHUP two to five times in
quick succession at a random moment from the start on: while files are read, searched and answered. Each must end with exit
code 3 and say what was found so far and what was not; or with the whole answer, where that was there first.
"""

import argparse
import json
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

SIGNALS = (signal.SIGTERM, signal.SIGTERM, signal.SIGINT, signal.SIGHUP)

LAMP = """component Lamp {
  input cmd : { none, on };
  initial off;
  mode off;
  mode lit;
  fault broken;
  off -> lit when cmd = on;
  any -> broken with 0.01;
}
plant P {
  lamp : Lamp;
  control lamp.cmd default none;
}
"""


def prepare(root, folder, scenarios=60):
    """Models on which every command below takes longer than the latest signal."""
    (folder / "lamp.tcca").write_text(LAMP, encoding="utf-8")
    (folder / "main.rmpl").write_text("Main() :: { lamp = lit; t = 0; when (t >= 900 h) donext { lamp = lit } }\n", encoding="utf-8")
    for i in range(scenarios):
        (folder / f"s{i:03}.scn").write_text(
            f'scenario "s{i}" {{ program "main.rmpl"; plant "lamp.tcca"; cycle 0.1 s; duration 300 h; expect lamp = lit within 1 s; }}\n',
            encoding="utf-8")
    generated = subprocess.run([sys.executable, root / "examples/classics/generate", "fischer", "8"], capture_output=True,
                               text=True, timeout=60, check=True).stdout
    (folder / "fischer.tcca").write_text(generated, encoding="utf-8")
    never = next(line for line in generated.splitlines() if line.startswith("// never: "))[len("// never: "):]
    (folder / "fischer.props").write_text(
        "".join(f'property "{name}" {{ never {never}; faults {faults}; }}\n' for name, faults in (("a", 0), ("b", 1), ("c", 2))),
        encoding="utf-8")
    (folder / "flight.jsonl").write_text("".join(f'{{"time": {i}}}\n' for i in range(1, 200_000)), encoding="utf-8")
    return never


def told(text, word):
    return None if word in text else f"does not say {word!r}: {text[-300:]!r}"


def of_verdict(out, errors, folder):
    del folder
    return told(out + errors, "undecided") and told(out + errors, "interrupted")


def of_json(out, errors, folder):
    del folder
    if not out:
        return told(errors, "interrupted")
    return None if json.loads(out)["verdict"] == "undecided" else out


def of_scenarios(out, errors, folder):
    """All files are accounted for: in the table and in the JUnit file."""
    del errors
    text = folder / "out.xml"
    if not text.exists():
        return "no JUnit file"
    suites = xml.etree.ElementTree.parse(text).getroot().findall("testsuite")
    count = len(list(folder.glob("*.scn")))
    if len(suites) != count:
        return f"{len(suites)} suites for {count} files"
    if not any(case.find("skipped") is not None or case.find("error") is not None for s in suites for case in s):
        return "nothing is left open"
    return told(out, "scenario")


def of_lines(out, errors, folder):
    del folder
    for line in out.splitlines():
        json.loads(line)
    return told(errors, "interrupted")


def of_campaign(out, errors, folder):
    del out, folder
    return told(errors, "interrupted")


def commands(folder, never):
    """What is run, how late a signal may come, and what looks at the answer."""
    names = sorted(path.name for path in folder.glob("*.scn"))
    return [
        (["tcca-check", "safety", "fischer.tcca", "--never", never, "--no-symmetry"], 0.3, of_verdict),
        (["tcca-check", "safety", "fischer.tcca", "--never", never, "--no-symmetry", "--format", "json"], 0.3, of_json),
        (["tcca-check", "check", "fischer.tcca", "fischer.props"], 0.3, of_verdict),
        (["rmpl-run", "scenario", *names, "--junit", "out.xml", "--jobs", "2"], 0.5, of_scenarios),
        (["rmpl-run", "estimate", "lamp.tcca", "--log", "flight.jsonl"], 0.4, of_lines),
        (["rmpl-run", "campaign", "s000.scn", "--runs", "100000", "--faults", "1", "--db", "runs.sqlite"], 0.4, of_campaign),
    ]


def is_caught(process):
    """Whether the program has come so far that SIGTERM is its own: what comes earlier is the loader's."""
    try:
        status = pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="utf-8")
    except OSError:
        return True
    caught = next((line.split()[1] for line in status.splitlines() if line.startswith("SigCgt:")), "0")
    return int(caught, 16) >> (signal.SIGTERM - 1) & 1 == 1


def run(draw, programs, folder, words, latest, look):
    """What is wrong with the answer; nothing where it is whole."""
    for name in ("out.xml", "runs.sqlite"):
        (folder / name).unlink(missing_ok=True)
    with subprocess.Popen([programs / words[0], *words[1:]], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          start_new_session=True) as process:
        while process.poll() is None and not is_caught(process):
            time.sleep(0.0002)
        time.sleep(draw.uniform(0, latest))
        sent = []
        for _ in range(draw.randint(2, 5)):
            sent.append(draw.choice(SIGNALS))
            to_group = draw.random() < 0.5
            try:
                (os.killpg if to_group else os.kill)(process.pid, sent[-1])
            except ProcessLookupError:
                break
            time.sleep(draw.choice((0, 0, 0.0005, 0.005)))
        try:
            out, errors = process.communicate(timeout=60)
        except subprocess.TimeoutExpired:
            process.kill()
            return f"goes on after {sent}"
    if process.returncode == 0 and out:
        return None
    if process.returncode != 3:
        return f"exit {process.returncode} after {[s.name for s in sent]}"
    return look(out.decode(), errors.decode(), folder)


def breaks_off_by_force(programs, folder, words):
    """A run that hangs in a write: neither many signals at once nor SIGTERM end it, a later Ctrl-C does."""
    reader, writer = os.pipe()
    os.set_blocking(writer, False)
    try:
        while True:
            os.write(writer, b"x" * 4096)
    except BlockingIOError:
        os.set_blocking(writer, True)
    with subprocess.Popen([programs / words[0], *words[1:]], cwd=folder, stdout=writer, stderr=subprocess.DEVNULL) as process:
        time.sleep(1.5)  # until it tells its story
        for number in (signal.SIGINT, signal.SIGINT, signal.SIGINT, signal.SIGTERM):
            process.send_signal(number)
            time.sleep(0.02)
        time.sleep(1.1)
        assert process.poll() is None, f"ended by signals in quick succession: {process.returncode}"
        process.send_signal(signal.SIGTERM)
        time.sleep(0.2)
        assert process.poll() is None, f"SIGTERM breaks off by force: {process.returncode}"
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=30) == -signal.SIGINT, process.returncode
    os.close(reader)
    os.close(writer)


def while_it_waits_for_its_input(programs, folder):
    """A pipe from which nothing comes is no reason to hang."""
    reader, writer = os.pipe()
    with subprocess.Popen([programs / "tcca-check", "stuck", "-"], cwd=folder, stdin=reader, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE) as process:
        time.sleep(0.2)
        process.send_signal(signal.SIGTERM)
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=30)
    os.close(reader)
    os.close(writer)
    assert process.returncode == 3 and b"interrupted" in errors, (process.returncode, errors)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=36)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    draw = random.Random(given.seed)
    lost = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        all_commands = commands(folder, prepare(given.root.resolve(), folder))
        for i in range(given.runs):
            words, latest, look = all_commands[i % len(all_commands)]
            wrong = run(draw, given.programs.resolve(), folder, words, latest, look)
            if wrong:
                lost.append(f"{' '.join(words[:2])}: {wrong}")
                print(lost[-1], flush=True)
        breaks_off_by_force(given.programs.resolve(), folder, ["rmpl-run", "scenario", "s000.scn", "--real-time"])
        while_it_waits_for_its_input(given.programs.resolve(), folder)
    print(f"{given.runs} runs, seed {given.seed}: {len(lost)} answers lost")
    return 1 if lost else 0


if __name__ == "__main__":
    sys.exit(main())
