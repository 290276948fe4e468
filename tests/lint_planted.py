# Faults planted one by one in sources without any, and near misses: what the tests of lint by planted faults share.
# SPDX-License-Identifier: MIT
import concurrent.futures
import pathlib
import re
import subprocess
import sys
import tempfile

Edit = tuple[str, str]  # a text that stands once in the sources, and what comes in its place


def edited(sources: dict[str, str], edits: tuple[Edit, ...]) -> dict[str, str]:
    result = dict(sources)
    for old, new in edits:
        places = [name for name, text in result.items() for _ in range(text.count(old))]
        if len(places) != 1:
            raise SystemExit(f"the sources have {len(places)} times, expected once:\n{old}")
        result[places[0]] = result[places[0]].replace(old, new)
    return result


def lint(rmplc: pathlib.Path, sources: dict[str, str], inputs: list[str]) -> tuple[set[int], str]:
    """The codes that lint finds, notes too, and what it says."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in sources.items():
            (pathlib.Path(folder) / name).write_text(text, encoding="utf-8")
        run = subprocess.run([rmplc, "lint", "--level", "note", *inputs], cwd=folder, capture_output=True, text=True,
                             timeout=60, check=False)
    said = run.stdout + run.stderr
    if run.returncode not in (0, 1):
        raise SystemExit(f"rmplc lint ended with {run.returncode}:\n{said}")
    return {int(code) for code in re.findall(r"^(?:warning|note)\[RMPL(\d{4})\]", said, re.MULTILINE)}, said


def main(sources: dict[str, str], inputs: list[str], seeded: list[tuple], clean: list[tuple]) -> int:
    """`seeded`: what is planted, the code that must be found, and the edits. `clean`: what looks like a fault, and the
    edits; nothing is to be found. Reads the path of rmplc from the command line; what inputs there are, `sources` has."""
    rmplc = pathlib.Path(sys.argv[1]).resolve()
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        planted = list(pool.map(lambda seed: lint(rmplc, edited(sources, seed[2:]), inputs), seeded))
        missed = list(pool.map(lambda near: lint(rmplc, edited(sources, near[1:]), inputs), clean))
    failures = 0
    for (what, code, *_), (codes, said) in zip(seeded, planted):
        if code not in codes:
            failures += 1
            print(f"missed: {what}: expected RMPL{code:04}, found {sorted(codes)}\n{said}")
    for (what, *_), (codes, said) in zip(clean, missed):
        if codes:
            failures += 1
            print(f"reported in vain: {what}: {sorted(codes)}\n{said}")
    print(f"{len(seeded)} faults planted, {len(clean)} near misses, {failures} failures")
    return 1 if failures else 0
