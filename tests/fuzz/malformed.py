#!/usr/bin/env python3
# Malformed inputs: whatever the text, the programs accept it or say where it is wrong.
# SPDX-License-Identifier: MIT
"""Usage: malformed.py PROGRAMS MUTATE EXAMPLES COUNT SEED

Makes COUNT mutations of the examples. `rmplc compile` must answer each with exit code 0, or with 2, nothing on standard
output and file:line:column on standard error. What it refuses, the program that would run it must refuse alike.
"""

import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TIMEOUT = 20  # seconds
EXTENSIONS = (".rmpl", ".tcca", ".scn")
# How each kind of input reaches the program that would use it.
USERS = {
    ".rmpl": ["rmpl-run", "sequence", "{}", "--log", "/dev/null"],
    ".tcca": ["tcca-check", "reachability", "{}", "--target", "true"],
    ".scn": ["rmpl-run", "scenario", "{}"],
}
LOCATION = re.compile(rb"\S:\d+:\d+\b")


def run(command: list[str]) -> tuple[int | None, bytes, bytes]:
    try:
        done = subprocess.run(command, capture_output=True, timeout=TIMEOUT, check=False, stdin=subprocess.DEVNULL)
        return done.returncode, done.stdout, done.stderr
    except subprocess.TimeoutExpired:
        return None, b"", b""


def refused_well(command: list[str], answer: tuple[int | None, bytes, bytes]) -> str | None:
    """What is wrong with a refusal, or None."""
    code, out, err = answer
    said = " ".join(command)
    if code is None:
        return f"{said}: not done after {TIMEOUT} s"
    if code != 2:
        return f"{said}: exit code {code}, expected 2"
    if out:
        return f"{said}: refused, but wrote to standard output: {out[:100]!r}"
    if not LOCATION.search(err):
        return f"{said}: no file:line:column on standard error: {err[:200]!r}"
    return None


def check(programs: pathlib.Path, path: str) -> tuple[bool, str | None]:
    """Whether the input was refused, and what is wrong with the answers."""
    compile_it = [str(programs / "rmplc"), "compile", path]
    answer = run(compile_it)
    if answer[0] == 0:
        return False, None
    wrong = refused_well(compile_it, answer)
    if wrong:
        return True, wrong
    program, *arguments = USERS[pathlib.Path(path).suffix]
    use_it = [str(programs / program), *(a.format(path) for a in arguments)]
    return True, refused_well(use_it, run(use_it))


def main(programs: str, mutate: str, examples: str, count: str, seed: str) -> int:
    with tempfile.TemporaryDirectory() as directory:
        copy = pathlib.Path(directory, "examples")
        shutil.copytree(examples, copy)
        made = subprocess.run([mutate, count, seed, str(copy), *EXTENSIONS], capture_output=True, check=True, text=True)
        paths = made.stdout.splitlines()
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            answers = list(pool.map(lambda path: check(pathlib.Path(programs), path), paths))
        refused = sum(was_refused for was_refused, _ in answers)
        wrong = [(path, reason) for path, (_, reason) in zip(paths, answers) if reason]
        for path, reason in wrong[:20]:
            kept = pathlib.Path.cwd() / pathlib.Path(path).name
            shutil.copy(path, kept)
            print(f"{kept}: {reason}")
    print(f"{len(paths)} inputs, {refused} refused, {len(wrong)} answered wrongly")
    return 1 if wrong or not paths else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
