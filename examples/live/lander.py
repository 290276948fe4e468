#!/usr/bin/env python3
# A lander outside the executive: commands in, readings out, one JSON object a line.
# SPDX-License-Identifier: MIT
"""The plant of examples/mars-entry as a program of its own, for `rmpl-run execute`.

Without --connect it talks over standard input and output, as a child of the executive. It answers each command line with the
readings at the end of that cycle. What it knows of the physics is its own: the executive sees readings alone.
"""

import argparse
import json
import pathlib
import socket
import sys

HEATING = 43.2  # seconds from the command until the engine is warm
SLEW = 12.0  # seconds to turn from cruise to entry
DRAG = 16830.0  # seconds after the start, the atmosphere is felt


class Lander:
    """The physics, from one moment to the next."""

    def __init__(self, misfire: bool):
        self.misfire = misfire  # the primary latch fails
        self.warm_at = self.turned_at = None
        self.inertial = self.firing = self.separated = False

    def command(self, now: float, given: dict) -> None:
        match given["engine.cmd"]:
            case "standby":
                self.warm_at = self.warm_at or now + HEATING
            case "off":
                self.warm_at, self.firing = None, False
            case "fire":
                self.firing = True
        self.inertial |= given["nav.cmd"] == "to-inertial"
        if given["att.cmd"] == "to-entry":
            self.turned_at = self.turned_at or now + SLEW
        self.separated |= given["lander.cmd"] == "fire-backup"
        self.separated |= given["lander.cmd"] == "fire-primary" and not self.misfire

    def readings(self, now: float) -> dict:
        if self.turned_at is None:
            attitude = "in-cruise-orient"
        else:
            attitude = "slewing" if now < self.turned_at else "in-entry-orient"
        return {
            "engine.thrust": "full" if self.firing else "zero",
            "engine.power": "zero" if self.warm_at is None else "nominal",
            "engine.temp": "nominal" if self.warm_at is not None and now >= self.warm_at else "low",
            "nav.star_tracker": "off" if self.inertial else "on",
            "att.obs": attitude,
            "att.acs": "hold-cruise" if self.turned_at is None else "hold-entry",
            "entry.accelerometer": "drag" if now >= DRAG else "quiet",
            "lander.contact": "broken" if self.separated else "made",
        }


def connected(address: str):
    """Streams to and from `unix:PATH` or `tcp:HOST:PORT`."""
    kind, _, rest = address.partition(":")
    if kind == "unix":
        link = socket.socket(socket.AF_UNIX)
        link.connect(rest)
    else:
        host, _, port = rest.rpartition(":")
        link = socket.create_connection((host.strip("[]"), int(port)))
    return link.makefile("r", encoding="utf-8"), link.makefile("w", encoding="utf-8")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--connect", metavar="ADDRESS", help="unix:PATH or tcp:HOST:PORT, where rmpl-run execute listens")
    parser.add_argument("--token", type=pathlib.Path, metavar="FILE", help="its first line is sent first")
    parser.add_argument("--misfire", action="store_true", help="the primary latch does not open")
    parser.add_argument("--die-at", type=float, metavar="SECONDS", help="end there without an answer, once")
    options = parser.parse_args()
    commands, answers = connected(options.connect) if options.connect else (sys.stdin, sys.stdout)
    if options.token:
        print(options.token.read_text(encoding="utf-8").splitlines()[0], file=answers, flush=True)
    lander = Lander(options.misfire)
    for line in commands:
        cycle = json.loads(line)
        lander.command(cycle["time"], cycle["command"])
        if options.die_at is not None and cycle["time"] <= options.die_at < cycle["until"]:
            sys.exit("the lander's computer resets")
        answer = {"cycle": cycle["cycle"], "observations": lander.readings(cycle["until"])}
        print(json.dumps(answer), file=answers, flush=True)


if __name__ == "__main__":
    main()
