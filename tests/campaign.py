#!/usr/bin/env python3
# rmpl-run campaign: the same rows for any number of threads and processes, and every result once, whoever is killed.
# SPDX-License-Identifier: MIT
"""Usage: campaign.py ROOT PROGRAMS."""

import csv
import os
import pathlib
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

RUNS = 60
KILLS = 10


def quiet_folder():
    """In memory where there is such a place: every run is a commit, which waits for the disk several times."""
    memory = pathlib.Path("/dev/shm")
    return memory if memory.is_dir() and os.access(memory, os.W_OK) else None


class Bench:
    def __init__(self, root: pathlib.Path, programs: pathlib.Path, folder: str):
        self.folder = pathlib.Path(folder)
        self.command = [programs / "rmpl-run", "campaign", root / "examples/mars-entry/mars_entry.scn", "--only",
                        "heating, drawn from the model", "--color", "never", "--at-most", "100%"]

    def words(self, name: str, *options) -> list:
        return [*self.command, "--db", self.folder / f"{name}.sqlite", *options]

    def run(self, name: str, *options, before=()) -> subprocess.CompletedProcess:
        return subprocess.run([*before, *self.words(name, "--csv", self.folder / f"{name}.csv", *options)],
                              capture_output=True, text=True, timeout=120, check=False)

    def csv(self, name: str) -> bytes:
        return (self.folder / f"{name}.csv").read_bytes()


def once(bench: Bench, name: str) -> None:
    """Each run has one row, and its one fault has one."""
    with sqlite3.connect(bench.folder / f"{name}.sqlite") as database:
        assert database.execute("PRAGMA integrity_check").fetchone() == ("ok",)
        assert [r for r, in database.execute("SELECT run FROM run ORDER BY run")] == list(range(RUNS))
        assert [r for r, in database.execute("SELECT run FROM fault ORDER BY run")] == list(range(RUNS))


def main(root: pathlib.Path, programs: pathlib.Path) -> int:
    with tempfile.TemporaryDirectory(dir=quiet_folder()) as folder:
        bench = Bench(root.resolve(), programs.resolve(), folder)
        same = ("--runs", str(RUNS), "--faults", "1")
        alone = bench.run("alone", *same, "--jobs", "1", "--report", f"{folder}/alone.html")
        assert alone.returncode == 0, alone
        assert f"of {RUNS}" in alone.stdout and "by component" in alone.stdout, alone.stdout
        rows = list(csv.DictReader(bench.csv("alone").decode().splitlines()))
        assert [int(row["run"]) for row in rows] == list(range(RUNS)) and len({row["seed"] for row in rows}) == RUNS
        page = pathlib.Path(folder, "alone.html").read_text(encoding="utf-8")
        assert "http" not in page and len(page) < 100_000 and "By component" in page
        assert "@media (prefers-color-scheme: dark)" in page
        assert page.count("<svg") == 3 and "Failing runs" in page and "--replay" in page

        several = bench.run("several", *same, "--jobs", "4")
        assert several.returncode == 0 and several.stdout == alone.stdout, several
        assert bench.csv("several") == bench.csv("alone")
        once(bench, "several")

        # Killed at any moment, ten times over.
        draw = random.Random(16)
        for _ in range(KILLS):
            with subprocess.Popen(bench.words("killed", *same, "--jobs", "2"), stdout=subprocess.DEVNULL) as run:
                time.sleep(draw.uniform(0.02, 0.4))
                run.send_signal(signal.SIGKILL)
        left = bench.run("killed", *same, "--jobs", "2")
        assert left.returncode == 0 and left.stdout == alone.stdout, left
        assert bench.csv("killed") == bench.csv("alone")
        once(bench, "killed")

        # Two at the same time, and one of them dies: the other does its runs in flight as well.
        with subprocess.Popen(bench.words("shared", *same, "--jobs", "2"), stdout=subprocess.DEVNULL) as dies:
            with subprocess.Popen(bench.words("shared", *same, "-j", "1"), stdout=subprocess.PIPE, text=True) as lives:
                time.sleep(0.2)
                dies.send_signal(signal.SIGKILL)
                output, _ = lives.communicate(timeout=120)
        assert lives.returncode == 0 and output == alone.stdout, output
        once(bench, "shared")

        # More runs go on from fewer; another campaign is refused.
        assert bench.run("more", "--runs", "20", "--faults", "1").returncode == 0
        assert bench.run("more", *same).returncode == 0 and bench.csv("more") == bench.csv("alone")
        other = bench.run("more", *same, "--seed", "2")
        assert other.returncode == 2 and "another campaign: its seed is '1', not '2'" in other.stderr, other

        # A run flown again is the same run, with the verdict that the table has.
        codes = {"met": 0, "failed": 1, "undecided": 3}
        for row in rows[:6]:
            replayed = subprocess.run([*bench.command, "--faults", "1", "--replay", row["run"], "--report", f"{folder}/run.html"],
                                      capture_output=True, text=True, timeout=120, check=False)
            assert replayed.returncode == codes[row["verdict"]], (row, replayed)
            assert f"{row['cycles']} cycles" in replayed.stdout, (row, replayed.stdout)
            assert f"run {row['run']}" in pathlib.Path(folder, "run.html").read_text(encoding="utf-8")
        refused = subprocess.run([*bench.command, "--replay", "1", "--db", ":memory:"], capture_output=True, text=True, timeout=60, check=False)
        assert refused.returncode == 2 and "--replay" in refused.stderr, refused

        # Enumerated: each fault of the model at each time.
        each = bench.run("each", "--enumerate", "--at", "5s", "--at", "50s")
        assert each.returncode == 0, each
        rows = list(csv.DictReader(bench.csv("each").decode().splitlines()))
        assert len(rows) == 10 and len({(row["faults"], row["at"]) for row in rows}) == 10, rows

        # A gate: the last of an option counts for nothing, so that the command has but one.
        gate = [word for word in bench.command if word not in ("--at-most", "100%")]
        failed = sum(row["verdict"] == "failed" for row in csv.DictReader(bench.csv("alone").decode().splitlines()))
        assert 0 < failed < RUNS
        for most, code in ((None, 1), (str(failed), 0), (str(failed - 1), 1), ("99.9%", 0), ("0%", 1), ("-1", 2), ("1.5", 2)):
            limit = [] if most is None else ["--at-most", most]
            judged = subprocess.run([*gate, "--db", ":memory:", "--jobs", "2", *same, *limit], cwd=folder, capture_output=True,
                                    text=True, timeout=120, check=False)
            assert judged.returncode == code, (most, judged)
            assert code == 2 or judged.stdout == alone.stdout, (most, judged)
        assert not list(pathlib.Path(folder).glob(":memory:*"))

        broken = pathlib.Path(folder, "broken.sqlite")
        broken.write_text("no database, and too long for none" * 100, encoding="utf-8")
        refused = bench.run("broken", *same)
        assert refused.returncode == 2 and "not a database" in refused.stderr, refused

        if shutil.which("mpirun"):
            world = ["mpirun", "-n", "2", "--oversubscribe", "--allow-run-as-root"]
            spread = bench.run("spread", *same, "--jobs", "1", before=world)
            assert spread.returncode == 0 and spread.stdout == alone.stdout, spread
            assert bench.csv("spread") == bench.csv("alone")
            once(bench, "spread")
            # Its terminal is mpirun's, not the user's: no colour.
            words = [word for word in bench.words("spread", *same, "--jobs", "1") if word not in ("--color", "never")]
            piped = subprocess.run([*world, *words], capture_output=True, text=True, timeout=120, check=True)
            assert "\x1b" not in piped.stdout, piped
            # A rank dies: the other does all of it, if mpirun lets it; if not, the same command goes on.
            for name, more in (("recovered", ["--enable-recovery"]), ("ended", [])):
                words = bench.words(name, "--csv", bench.folder / f"{name}.csv", *same, "--jobs", "1")
                with subprocess.Popen([*world, *more, *words], stdout=subprocess.DEVNULL,
                                      stderr=subprocess.DEVNULL) as run:
                    time.sleep(1)
                    # Only mpirun's own children: a rank has one too while LeakSanitizer looks at it, and would wait for
                    # it for ever.
                    ranks = subprocess.run(["pgrep", "-P", str(run.pid), "-f", "--", "rmpl-run campaign"],
                                           capture_output=True, text=True, check=False).stdout.split()
                    if ranks:
                        os.kill(int(ranks[-1]), signal.SIGKILL)
                    run.wait(timeout=120)
                # A rank that dies as the world is still set up takes mpirun with it.
                if more and (bench.folder / f"{name}.csv").exists():
                    assert bench.csv(name) == bench.csv("alone"), "what the dead rank had begun is not done"
                again = bench.run(name, *same, "--jobs", "1", before=world)
                assert again.returncode == 0 and again.stdout == alone.stdout, again
                once(bench, name)
        print(alone.stdout)
    return 0


if __name__ == "__main__":
    sys.exit(main(*map(pathlib.Path, sys.argv[1:])))
