#!/usr/bin/env python3
# Sessions of `rmpl-run step` by chance: what is saved flies the same run, and going back leads to where one was.
# SPDX-License-Identifier: MIT
"""Usage: step.py ROOT PROGRAMS [--cases N] [--seed N]"""

import argparse
import os
import pathlib
import pty
import random
import re
import signal
import subprocess
import sys
import tempfile

RUNS = [
    (["mars-entry/mars_entry.rmpl", "mars-entry/mars_lander.tcca"], ["engine = standby", "nav = inertial & att = entry-orient", "none"]),
    (["mars-entry/mars_lander.tcca"], ["engine = standby", "lander = separated", "att = entry-orient"]),
    (["safe-mode/safe_mode.rmpl", "safe-mode/satellite.tcca", "--cycle", "1 s"], ["computer = safe", "engine = burning"]),
    (["safe-mode/satellite.tcca", "--cycle", "200 ms"], ["engine = burning", "computer = safe | gauge = working"]),
    (["flash-lamp/flash.rmpl", "flash-lamp/flash.tcca"], []),
    (["power/power.rmpl", "power/power.tcca", "--cycle", "1 s"], []),
    (["rover-camera/rover.tcca"], ["sensor = working", "power = cut"]),
    (["rover-camera/rover.scn", "--only", "the sensor breaks"], []),
    (["safe-mode/safe_mode.scn", "--only", "the gauge goes blind: a doubt"], []),
    (["mars-entry/mars_entry.scn", "--only", "nominal flight"], []),
    (["mars-entry/mars_entry.scn", "--only", "heating, drawn from the model"], []),
]
PLACES = re.compile(r" \([^()]*:\d+\)")
PROMPT = "step> "


class Wrong(Exception):
    pass


class Stepper:
    """A session: its script so far. Each look flies it anew, by the program."""

    def __init__(self, program: str, arguments: list[str]):
        self.command = [program, "step", *arguments]

    def run(self, script: list[str], quiet: bool = False) -> str:
        command = self.command + (["-q"] if quiet else [])
        result = subprocess.run(command, input="\n".join(script) + "\n", capture_output=True, text=True, timeout=120)
        if result.returncode != 0:
            raise Wrong(f"{script}: exit {result.returncode}: {result.stderr}")
        return result.stdout

    def last_view(self, script: list[str]) -> str:
        return self.run([*script, "show"]).split(PROMPT + "show\n")[-1]


def choices(view: str) -> list[str]:
    return re.findall(r"^ +(\d+)  (?:command|transition|stay|fault)", view, re.MULTILINE)


def extended(stepper: Stepper, script: list[str], goals: list[str], rules_only: bool, draw: random.Random) -> list[str]:
    """A longer session: a choice among what may come, a goal, or time that passes."""
    view = stepper.last_view(script)
    if "the run has ended" in view:
        return script
    kind = draw.random()
    if kind < 0.15 and goals:
        return [*script, "goal " + draw.choice(goals)]
    if kind < 0.35:
        return [*script, f"next {draw.randint(1, 60)}"]
    open_ones = choices(view)
    if rules_only:
        open_ones = re.findall(r"^ +(\d+)  command", view, re.MULTILINE)
    if not open_ones:
        return [*script, "next"]
    return [*script, draw.choice(open_ones)]


def story(text: str) -> list[str]:
    """Lines of a story without places and widths."""
    lines = []
    for line in text.splitlines():
        told = re.match(r" +([\d.]+) s  +(?:[\d:.]+  )? *(\w.*)", line)
        if told:
            lines.append(told[1] + " " + PLACES.sub("", told[2]))
    return lines


def check_session(root: pathlib.Path, programs: pathlib.Path, case: int, seed: int) -> None:
    draw = random.Random(seed * 100_003 + case)
    files, goals = RUNS[case % len(RUNS)]
    arguments = [str(root / "examples" / files[0])] + [
        str(root / "examples" / a) if "/" in a else a for a in files[1:]]
    own = files[0].endswith(".scn")
    if not own:
        arguments += ["--seed", str(draw.randint(0, 1000))]
    stepper = Stepper(str(programs / "rmpl-run"), arguments)
    script: list[str] = []
    rules_only = "nominal flight" in files
    for _ in range(draw.randint(1, 6)):
        script = extended(stepper, script, goals, rules_only, draw)
    here = stepper.last_view(script)
    # There and back again.
    position = int(re.search(r"after (\d+) cycle", here)[1])
    on = draw.randint(1, 40)
    if "the run has ended" in here:
        return
    gone = stepper.last_view([*script, f"next {on}"])
    passed = int(re.search(r"after (\d+) cycle", gone)[1]) - position
    if passed > 0:
        again = stepper.last_view([*script, f"next {on}", f"back {passed}"])
        if again != here:
            raise Wrong(f"{files} {script}: `next {on}`, `back {passed}` leads elsewhere:\n{here}\n{again}")
    if position == 0:
        return
    with tempfile.TemporaryDirectory() as folder:
        saved = pathlib.Path(folder) / "saved.scn"
        stepped = stepper.run([*script, f"save {saved}"], quiet=True)
        flown = subprocess.run([str(programs / "rmpl-run"), "scenario", str(saved), "--to", "1000000"],
                               capture_output=True, text=True, timeout=120, check=False)
        if flown.returncode not in (0, 1):
            raise Wrong(f"{files} {script}: what was saved does not fly: {flown.stderr}\n{saved.read_text()}")
        ours, theirs = story(stepped), story(flown.stdout)
        # The flight of a scenario ends with its program, and a scenario of its own goes on to its own end.
        count = min(len(ours), len(theirs))
        if ours[:count] != theirs[:count] or (len(ours) > count and "the program ended" not in flown.stdout):
            raise Wrong(f"{files} {script}: what was saved flies another run:\n" + "\n".join(ours) + "\n---\n" +
                        "\n".join(theirs) + "\n" + saved.read_text())


WORDS = ["next", "to", "until", "truth", "back", "fault", "command", "observe", "goal", "why", "show", "save", "help", "none",
         "engine", "=", "standby", "!=", "&", "(", ")", "engine.cmd", "engine.temp", "low", "for", "3 s", "-1", "0", "1", "7", "99",
         "999999999999999999999", "1e9", "surprise", "likely(engine = off, 0.5)", "\0", "\xff", "φ", "{", "}", '"', "x.scn", "/", "//"]


def check_garbage(root: pathlib.Path, programs: pathlib.Path, case: int, seed: int) -> None:
    """Whatever is typed, each line by itself: it is done or refused, and nothing crashes or hangs."""
    draw = random.Random(seed * 100_019 + case)
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(10):
            line = " ".join(draw.choice(WORDS) for _ in range(draw.randint(1, 6)))
            script = ("next 3\n" + line + "\nshow\n").encode("utf-8", "surrogateescape")
            result = subprocess.run([str(programs.resolve() / "rmpl-run"), "step", "--duration", "20 s",
                                     str(root.resolve() / "examples/mars-entry/mars_lander.tcca")],
                                    input=script, capture_output=True, timeout=60, cwd=folder, check=False)
            if result.returncode not in (0, 2) or (result.returncode == 2) != bool(result.stderr):
                raise Wrong(f"{line!r}: exit {result.returncode}: {result.stderr!r}")


def check_terminal(root: pathlib.Path, programs: pathlib.Path) -> None:
    """On a terminal lines are edited, a wrong command is a message, and the session goes on."""
    lander = str(root / "examples/mars-entry/mars_lander.tcca")
    ours, theirs = pty.openpty()
    process = subprocess.Popen([str(programs / "rmpl-run"), "step", lander, "--color", "never"],
                               stdin=theirs, stdout=theirs, stderr=theirs, env={**os.environ, "TERM": "vt100"})
    os.close(theirs)
    got = b""

    def read_until(text: bytes) -> None:
        nonlocal got
        while text not in got:
            part = os.read(ours, 65536)
            if not part:
                raise Wrong(f"expected {text!r}, got {got!r}")
            got += part

    for typed, expected in [(b"", PROMPT.encode()), (b"nxtt\n", b"did you mean 'next'?"),
                            (b"nexx\x7ft\n", b"after 1 cycle"), (b"qu\t\n", b"qu")]:
        got = b""
        os.write(ours, typed)
        read_until(expected)
        if typed and b"qu" not in typed:
            read_until(PROMPT.encode())
    try:
        while os.read(ours, 65536):
            pass
    except OSError:  # the other end is closed
        pass
    os.close(ours)
    if process.wait(timeout=60) != 0:
        raise Wrong(f"on a terminal: exit {process.returncode}")


def check_interrupt(root: pathlib.Path, programs: pathlib.Path) -> None:
    """A signal ends a session soon, whether it goes on, goes back or waits for a command."""
    for script in (b"until computer = safe\n", b"to 2000 s\nback\nback\nback\nback\n", b"next\n"):
        process = subprocess.Popen([str(programs / "rmpl-run"), "step", "-q", str(root / "examples/safe-mode/satellite.tcca"),
                                    "--cycle", "1 ms", "--duration", "100 d"],
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stdin.write(script)
        process.stdin.flush()
        said = b""
        while PROMPT.encode() not in said:
            said += os.read(process.stdout.fileno(), 4096)
        process.send_signal(signal.SIGINT)
        if process.wait(timeout=30) != 3:
            raise Wrong(f"{script!r}, interrupted: exit {process.returncode}")


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("--cases", type=int, default=55)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    failed = 0
    for check, arguments in [(check_terminal, ()), (check_interrupt, ()), *((check_session, (case, options.seed)) for case in range(options.cases)),
                              *((check_garbage, (case, options.seed)) for case in range(options.cases // 5))]:
        try:
            check(options.root, options.programs, *arguments)
        except Wrong as wrong:
            print(wrong, file=sys.stderr)
            failed += 1
    print(f"{options.cases} sessions and one on a terminal, {failed} wrong")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
