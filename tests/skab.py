#!/usr/bin/env python3
# Recorded runs of a real rig: what is diagnosed in each file of SKAB beside its labels.
# SPDX-License-Identifier: MIT
"""Usage: skab.py ROOT BIN_DIR [DATA]

DATA is the folder `data` of the Skoltech Anomaly Benchmark (waico/SKAB, v0.9); without it, ROOT/build/skab. Where it is
not there the test is skipped (exit code 77): the data is not part of the tree. A sample counts as anomalous where the
estimate has a fault. Prints a row a file and all together; exits 1 where the whole is worse than what examples/telemetry/README.md
says of it, or a file has no answer.
"""

import csv
import json
import pathlib
import subprocess
import sys

FEWEST = {"precision": 0.75, "recall": 0.65}


def main() -> int:
    root, bin_dir = map(pathlib.Path, sys.argv[1:3])
    data = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else root / "build/skab"
    files = sorted(data.glob("*/*.csv"), key=lambda f: (f.parent.name, int(f.stem) if f.stem.isdigit() else 0))
    if not files:
        print(f"skipped: {data} has no files of SKAB")
        return 77
    rig = root / "examples/telemetry"
    total = dict.fromkeys(("tp", "fp", "fn", "tn"), 0)
    print("| file | samples | anomalous | named | precision | recall | false alarms |\n|---|---|---|---|---|---|---|")
    for file in files:
        with file.open(encoding="utf-8") as stream:
            labels = [float(row.get("anomaly") or 0) > 0 for row in csv.DictReader(stream, delimiter=";")]
        done = subprocess.run([bin_dir / "rmpl-run", "estimate", rig / "skab.tcca", "--log", file, "--monitors", rig / "skab.mon",
                               "-q", "-k", "4"], capture_output=True, text=True, timeout=300, check=False)
        assert done.returncode == 0, (file, done.stderr)
        answers = [json.loads(line) for line in done.stdout.splitlines()]
        # Rows that repeat an earlier one have no answer of their own.
        by_time = {answer["time"]: answer["estimate"] for answer in answers}
        start = None
        count, named = dict.fromkeys(total, 0), {}
        with file.open(encoding="utf-8") as stream:
            for row, label in zip(csv.DictReader(stream, delimiter=";"), labels, strict=True):
                hours, minutes, seconds = map(int, row["datetime"].split()[1].split(":"))
                now = hours * 3600 + minutes * 60 + seconds
                start = now if start is None else start
                estimate = by_time.get(now - start)
                if estimate is None:
                    continue
                faults = [f"{c} {m}" for c, m in estimate.items() if m not in ("open", "balanced")]
                count[("t" if bool(faults) == label else "f") + ("p" if faults else "n")] += 1
                for fault in faults if label else []:
                    named[fault] = named.get(fault, 0) + 1
        for key, value in count.items():
            total[key] += value
        print(row_of(f"{file.parent.name}/{file.stem}", count, ", ".join(sorted(named, key=named.get, reverse=True)) or "nothing"))
    print(row_of("all", total, ""))
    found = measures(total)
    return 0 if all(found[name] >= least for name, least in FEWEST.items()) else 1


def measures(count: dict) -> dict:
    def share(part, *others):
        whole = part + sum(others)
        return part / whole if whole else 1.0

    return {"precision": share(count["tp"], count["fp"]), "recall": share(count["tp"], count["fn"]),
            "false alarms": share(count["fp"], count["tn"])}


def row_of(name: str, count: dict, named: str) -> str:
    found = measures(count)
    return (f"| {name} | {sum(count.values())} | {count['tp'] + count['fn']} | {named} | "
            + " | ".join(f"{value:.2f}" for value in found.values()) + " |")


if __name__ == "__main__":
    sys.exit(main())
