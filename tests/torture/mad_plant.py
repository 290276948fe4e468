#!/usr/bin/env python3
# The lander's plant gone mad: answers that no sane plant sends, drawn from a seed and the cycle.
# SPDX-License-Identifier: MIT
"""Usage: mad_plant.py SEED [ADDRESS]. Talks as examples/live/lander.py does, which it wraps; a new process of the same seed
does in a cycle what the one before would have done."""

import importlib.util
import json
import os
import pathlib
import random
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SPEC = importlib.util.spec_from_file_location("lander", ROOT / "examples/live/lander.py")
LANDER = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(LANDER)
NOISE = ['{', '5', '{"cycle":-1}', '{"cycle":1e9}', '{"observations":{}}', '{"cycle":1,"observations":{"engine.tmp":"low"}}',
         '{"cycle":1,"cycle":2}', '\x00', '\u202e', '[' * 60000, 'x' * 100_000, '"' + 'k' * 5000 + '"', '', 'null']


def main() -> None:
    seed = sys.argv[1]
    commands, answers = LANDER.connected(sys.argv[2]) if len(sys.argv) > 2 else (sys.stdin, sys.stdout)
    lander = LANDER.Lander(misfire=False)
    for line in commands:
        given = json.loads(line)
        cycle = given["cycle"]
        lander.command(given["time"], given["command"])
        answer = json.dumps({"cycle": cycle, "observations": lander.readings(given["until"])}) + "\n"
        draw = random.Random(f"{seed} {cycle}")
        mood = draw.randrange(300)
        if mood < 4:
            answers.write("".join(draw.choice(NOISE) + "\n" for _ in range(draw.randrange(1, 5))))
        elif mood == 4:
            answers.flush()
            (sys.stdout if len(sys.argv) < 3 else answers).buffer.write(bytes(draw.randrange(256) for _ in range(500)) + b"\n")
        elif mood == 5:
            answers.write('{"cycle":1}\n' * 3000)
        elif mood == 6:
            answers.write(json.dumps({"cycle": max(1, cycle - 3)}) + "\n")
        elif mood == 7:
            answers.write('{"cyc')
            answers.flush()
            os._exit(draw.randrange(3))
        elif mood == 8:
            os.kill(os.getpid(), 9)
        answers.write(answer)
        answers.flush()


if __name__ == "__main__":
    main()
