#!/usr/bin/env python3
# The live view of a flight, on a terminal of 80 columns that this test holds; and without one, the plain story.
# SPDX-License-Identifier: MIT
"""Usage: follow.py ROOT PROGRAMS"""

import fcntl
import os
import pathlib
import pty
import re
import struct
import subprocess
import sys
import termios

CONTROL = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")


def on_terminal(command: list[str], rows: int, columns: int) -> tuple[int, str]:
    """Exit code and all that the terminal got."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=theirs, stderr=theirs)
    os.close(theirs)
    got = b""
    while True:
        try:
            part = os.read(ours, 65536)
        except OSError:  # the other end is closed
            break
        if not part:
            break
        got += part
    os.close(ours)
    return process.wait(timeout=60), got.decode()


def main() -> int:
    root, programs = map(pathlib.Path, sys.argv[1:])
    command = [str(programs / "rmpl-run"), "scenario", str(root / "examples/mars-entry/mars_entry.scn"), "--only",
               "primary latch misfires, the backup answers", "--follow"]
    for rows, columns in ((24, 80), (16, 40), (50, 132)):
        code, text = on_terminal(command, rows, columns)
        assert code == 0, (code, text)
        frames = text.split("\x1b[J")
        assert len(frames) >= 2, text
        last = CONTROL.sub("", frames[-2])
        for word in ("asserts", "commands", "believes", "lander = separated", "━"):
            assert word in last, (word, last)
        for frame in frames[1:-1]:
            lines = CONTROL.sub("", frame).replace("\r", "").split("\n")
            assert len(lines) < rows, frame
            assert all(len(line) <= columns for line in lines), frame
        assert "met " in frames[-1], frames[-1]
    plain = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True)
    story = subprocess.run(command[:-1], capture_output=True, text=True, timeout=60, check=True)
    assert plain.stdout == story.stdout and "\x1b" not in plain.stdout
    print("the live view keeps to its terminal, and is the story without one")
    return 0


if __name__ == "__main__":
    sys.exit(main())
