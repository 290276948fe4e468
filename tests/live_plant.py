#!/usr/bin/env python3
# rmpl-run execute with real processes and sockets: dead, mad, slow and late plants, reconnects, tokens, signals.
# SPDX-License-Identifier: MIT
"""Usage: live_plant.py ROOT PROGRAMS."""

import collections
import json
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import time

KINDS = {"connected", "gone", "refused", "late", "flood", "unacknowledged"}
EXIT_DONE, EXIT_WRONG, EXIT_UNDECIDED = 0, 2, 3


class Bench:
    """The programs, a folder, and how to run."""

    def __init__(self, root: pathlib.Path, programs: pathlib.Path, folder: str):
        self.root, self.folder = root, pathlib.Path(folder)
        mars = root / "examples/mars-entry"
        self.start = [programs / "rmpl-run", "execute", mars / "mars_entry.rmpl", mars / "mars_lander.tcca"]
        self.lander = f"{sys.executable} {root}/examples/live/lander.py"
        self.mad = f"{sys.executable} {root}/tests/torture/mad_plant.py"
        self.trace = self.folder / "trace.jsonl"

    def run(self, *options, timeout=60) -> subprocess.CompletedProcess:
        return subprocess.run([*self.start, "-q", *options, "--trace", self.trace, "--keyframe", "1"], capture_output=True, text=True,
                              timeout=timeout, check=False)

    def launch(self, *options) -> subprocess.Popen:
        return subprocess.Popen([*self.start, "-q", *options, "--trace", self.trace, "--keyframe", "1"], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)

    def events(self) -> collections.Counter:
        """By kind; what goes on through cycles that were left out counts once."""
        lines = self.trace.read_text(encoding="utf-8").splitlines()
        kinds = (event["kind"] for line in lines for event in json.loads(line)["events"])
        return collections.Counter(kind for kind in kinds if kind in KINDS)


def sane_and_dead(bench: Bench) -> None:
    done = bench.run("--exec", bench.lander, "--clock", "lock-step")
    assert done.returncode == EXIT_DONE, done
    assert done.stdout.startswith("the program ended at 16830.5 s"), done.stdout
    assert "33661 of 33661 commands acknowledged" in done.stdout, done.stdout
    assert bench.events() == {"connected": 1}, bench.events()
    done = bench.run("--exec", bench.lander + " --die-at 60", "--clock", "lock-step", "--duration", "100")
    assert done.returncode == EXIT_DONE and "199 of 200" in done.stdout, done
    assert bench.events() == {"connected": 2, "gone": 1, "unacknowledged": 1}, bench.events()
    done = bench.run("--exec", "exit 7", "--clock", "lock-step", "--give-up", "20")
    assert done.returncode == EXIT_UNDECIDED and done.stdout.startswith("given up, because no plant was connected for 20 s"), done
    assert "it ended with status 7" in bench.trace.read_text(encoding="utf-8")


def mad(bench: Bench) -> None:
    """A day of it; and the same seed is the same trace, whatever the machine does meanwhile."""
    traces = []
    for seed, duration in ((1, "2h"), (1, "2h"), (2, "24h")):
        done = bench.run("--exec", f"{bench.mad} {seed}", "--clock", "lock-step", "--cycle", "10s", "--duration",
                         duration, "--trace-detail", "cycles", "--patience", "30s", timeout=240)
        assert done.returncode in (EXIT_DONE,), done
        traces.append(bench.trace.read_bytes())
        events = bench.events()
        for kind in ("connected", "gone", "refused", "late", "flood", "unacknowledged"):
            assert events[kind] > 0, events
    assert traces[0] == traces[1] != traces[2]


def slow_reader(bench: Bench) -> None:
    """It never reads; cycles go on, and the end is orderly although it does not heed SIGTERM."""
    begin = time.monotonic()
    done = bench.run("--exec", "trap '' TERM; sleep 60", "--cycle", "500us", "--duration", "3s")
    assert done.returncode == EXIT_DONE and " 0 of " in done.stdout, done
    assert time.monotonic() - begin < 20, "it waits for a plant that does not end"
    assert "the plant does not read its input" in bench.trace.read_text(encoding="utf-8")


def flood(bench: Bench) -> None:
    """A cycle is not late for it."""
    begin = time.monotonic()
    done = bench.run("--exec", "yes", "--cycle", "0.2s", "--duration", "2s")
    assert done.returncode == EXIT_DONE, done
    assert time.monotonic() - begin < 10
    assert bench.events()["flood"] > 0, bench.events()


def reconnect(bench: Bench) -> None:
    address = f"unix:{bench.folder}/socket"
    with bench.launch("--listen", address, "--clock", "lock-step", "--duration", "200") as run:
        run.stderr.readline()
        assert (bench.folder / "socket").stat().st_mode & 0o77 == 0, "others may connect"
        first = subprocess.run([*bench.lander.split(), "--connect", address, "--die-at", "60"], timeout=30,
                               capture_output=True, check=False)
        assert first.returncode == 1, first
        subprocess.run([*bench.lander.split(), "--connect", address], timeout=30, check=True)
        output, _ = run.communicate(timeout=30)
    assert run.returncode == EXIT_DONE and "399 of 400" in output, output
    assert bench.events() == {"connected": 2, "gone": 1, "unacknowledged": 1}, bench.events()
    assert not (bench.folder / "socket").exists()


def tokens(bench: Bench) -> None:
    token = bench.folder / "token"
    token.write_text("a token that nobody guesses\n", encoding="utf-8")
    done = bench.run("--listen", "tcp:0.0.0.0:0")
    assert done.returncode == EXIT_WRONG and "other machines could connect" in done.stderr, done
    done = bench.run("--listen", "tcp:0.0.0.0:0", "--allow-remote")
    assert done.returncode == EXIT_WRONG and "--token" in done.stderr, done
    with bench.launch("--listen", "tcp:127.0.0.1:0", "--token", token, "--clock", "lock-step", "--duration", "50") as run:
        address = run.stderr.readline().split()[-1]
        for wrong in (b"another token, and a wrong one\n", b"x" * 10_000, b"\n", b"a token that nobody guesses?\n"):
            with socket.create_connection(("127.0.0.1", int(address.rpartition(":")[2])), timeout=10) as link:
                link.sendall(wrong)
                try:
                    assert link.recv(100) == b"", "it was let in"
                except ConnectionResetError:
                    pass
        subprocess.run([*bench.lander.split(), "--connect", address, "--token", token], timeout=30, check=True)
        output, errors = run.communicate(timeout=30)
    assert run.returncode == EXIT_DONE and "100 of 100" in output, (output, errors)
    assert "sent a wrong token" in errors, errors


def strangers(bench: Bench) -> None:
    """Who connects and says nothing keeps nobody out, be it one or more than may wait."""
    token = bench.folder / "token"
    token.write_text("a token that nobody guesses\n", encoding="utf-8")
    for count in (1, 100):
        with bench.launch("--listen", "tcp:127.0.0.1:0", "--token", token, "--clock", "lock-step", "--duration", "50") as run:
            address = run.stderr.readline().split()[-1]
            port = int(address.rpartition(":")[2])
            silent = [socket.create_connection(("127.0.0.1", port), timeout=10) for _ in range(count)]
            begin = time.monotonic()
            subprocess.run([*bench.lander.split(), "--connect", address, "--token", token], timeout=30, check=True)
            output, errors = run.communicate(timeout=30)
            assert time.monotonic() - begin < 4, "a stranger was waited for"
            for link in silent:
                link.close()
        assert run.returncode == EXIT_DONE and "100 of 100" in output, (output, errors)


def nobody(bench: Bench) -> None:
    """No plant ever comes; ports that are none."""
    bench.trace.unlink(missing_ok=True)
    done = bench.run("--listen", f"unix:{bench.folder}/socket", "--give-up", "1", "--format", "json")
    assert done.returncode == EXIT_UNDECIDED, done
    assert json.loads(done.stdout) == {"end": "abandoned", "cycles": 0, "acknowledged": 0, "time": 0}, done
    assert not bench.trace.exists(), "there was nothing to trace"
    for port in ("65536", "99999999999", "-1", "80x"):
        done = bench.run("--listen", f"tcp:127.0.0.1:{port}")
        assert done.returncode == EXIT_WRONG and "is no port" in done.stderr, done


def signals(bench: Bench) -> None:
    with bench.launch("--exec", bench.lander, "--cycle", "10ms") as run:
        time.sleep(1)
        run.send_signal(signal.SIGTERM)
        output, _ = run.communicate(timeout=30)
    assert run.returncode == EXIT_UNDECIDED and output.startswith("interrupted at"), output
    lines = bench.trace.read_text(encoding="utf-8").splitlines(keepends=True)
    assert all(line.endswith("\n") and json.loads(line) for line in lines)
    with bench.launch("--listen", f"unix:{bench.folder}/socket") as run:
        run.stderr.readline()
        run.send_signal(signal.SIGINT)
        output, _ = run.communicate(timeout=30)
    assert run.returncode == EXIT_UNDECIDED, output


def main(root: pathlib.Path, programs: pathlib.Path) -> int:
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(root.resolve(), programs.resolve(), folder)
        for test in (sane_and_dead, mad, slow_reader, flood, reconnect, tokens, strangers,
                     nobody, signals):
            begin = time.monotonic()
            test(bench)
            print(f"{test.__name__}: {time.monotonic() - begin:.1f} s", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(*map(pathlib.Path, sys.argv[1:])))
