#!/usr/bin/env python3
# What the world does to the programs: files, links, modes, descriptors and signals. No file is lost, no answer is half.
# SPDX-License-Identifier: MIT
"""Usage: world.py ROOT PROGRAMS. Each function named test_… is a test, and gets a folder of its own."""

import json
import os
import pathlib
import pty
import re
import signal
import stat
import subprocess
import sys
import tempfile
import time

ROOT = PROGRAMS = pathlib.Path()
PLANT = """component Lamp {
  input cmd : { none, on };
  output light : { dark, bright, flickering };
  initial off;
  mode off { light = dark };
  mode on { light = bright };
  fault broken { light = flickering };
  off -> on when cmd = on in [3 s, 4 s];
  any -> broken with 0.01;
}
plant P { lamp : Lamp; control lamp.cmd default none; observe lamp.light; }
"""
PROGRAM = "Main() :: { lamp = on }\n"


def run(folder, *words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, env=None, preexec=None):
    """Runs a program in a folder: exit code, standard output, standard error."""
    done = subprocess.run([PROGRAMS / words[0], *words[1:]], cwd=folder, stdin=stdin, stdout=stdout, timeout=120,
                          stderr=subprocess.PIPE, env={**os.environ, **(env or {})}, preexec_fn=preexec, check=False)
    return done.returncode, (done.stdout or b"").decode(), done.stderr.decode()


def expect(seen, wanted, what=""):
    assert seen == wanted, f"{what}: expected {wanted!r}, not {seen!r}"


def mentions(text, part):
    assert part in text, f"expected {part!r} in {text!r}"


def model(folder):
    (folder / "lamp.tcca").write_text(PLANT, encoding="utf-8")
    (folder / "main.rmpl").write_text(PROGRAM, encoding="utf-8")


def scenario(folder, *lines):
    text = '\n'.join(['scenario "s" {', 'program "main.rmpl"; plant "lamp.tcca"; cycle 1 s; duration 100 s;', *lines, "}"])
    (folder / "s.scn").write_text(text, encoding="utf-8")


def nothing_else(folder, *names):
    expect(sorted(p.name for p in folder.iterdir()), sorted(names), "files")


# Files that are written.

VIOLATION = ("tcca-check", "program", "main.rmpl", "lamp.tcca", "--faults", "1", "--never", "lamp = broken", "--scenario")


def test_a_scenario_goes_where_a_link_leads(folder):
    model(folder)
    (folder / "real.scn").write_text("old", encoding="utf-8")
    (folder / "link.scn").symlink_to("real.scn")
    code, _, errors = run(folder, *VIOLATION, "link.scn")
    expect(code, 1, errors)
    assert (folder / "link.scn").is_symlink(), "the link is replaced"
    mentions((folder / "real.scn").read_text(encoding="utf-8"), "scenario")
    nothing_else(folder, "lamp.tcca", "link.scn", "main.rmpl", "real.scn")


def test_a_scenario_goes_through_a_pipe(folder):
    model(folder)
    os.mkfifo(folder / "pipe")
    with subprocess.Popen(["cat", folder / "pipe"], stdout=subprocess.PIPE) as reader:
        expect(run(folder, *VIOLATION, "pipe")[0], 1)
        mentions(reader.communicate(timeout=60)[0].decode(), "scenario")
    assert stat.S_ISFIFO((folder / "pipe").stat().st_mode), "the pipe is replaced"


def test_a_part_file_of_another_is_left_alone(folder):
    model(folder)
    (folder / "out.scn.part").write_text("mine", encoding="utf-8")
    run(folder, *VIOLATION, "out.scn")
    expect((folder / "out.scn.part").read_text(encoding="utf-8"), "mine")


def test_what_is_replaced_keeps_its_mode(folder):
    model(folder)
    for name, words in (("out.json", ("rmplc", "compile", "lamp.tcca", "-o", "out.json")), ("out.scn", (*VIOLATION, "out.scn"))):
        (folder / name).write_text("old", encoding="utf-8")
        (folder / name).chmod(0o600)
        run(folder, *words)
        expect(stat.S_IMODE((folder / name).stat().st_mode), 0o600, name)
        assert (folder / name).read_text(encoding="utf-8") != "old"


def test_a_run_that_fails_leaves_the_old_trace(folder):
    model(folder)
    scenario(folder)
    (folder / "t.jsonl").write_text("old\n", encoding="utf-8")
    # A story that cannot be told ends the run before it is over.
    with open("/dev/full", "wb") as full:
        code, _, errors = run(folder, "rmpl-run", "scenario", "s.scn", "--real-time", "--trace", "t.jsonl", stdout=full)
    expect(code, 2)
    mentions(errors, "No space left on device")
    expect((folder / "t.jsonl").read_text(encoding="utf-8"), "old\n")
    nothing_else(folder, "lamp.tcca", "main.rmpl", "s.scn", "t.jsonl")


def test_no_file_that_was_read_is_written(folder):
    model(folder)
    scenario(folder)
    (folder / "import.tcca").write_text('import "lamp.tcca";\n', encoding="utf-8")
    (folder / "lamp.json").symlink_to("lamp.tcca")
    (folder / "log.jsonl").write_text('{"time": 1}\n', encoding="utf-8")
    for words in (
        ("rmplc", "compile", "import.tcca", "-o", "lamp.tcca"),
        ("rmplc", "compile", "import.tcca", "-o", "lamp.json"),
        ("rmpl-run", "scenario", "s.scn", "--trace", "lamp.tcca"),
        ("rmpl-run", "scenario", "s.scn", "--trace", "s.scn"),
        ("tcca-check", "program", "main.rmpl", "import.tcca", "--faults", "1", "--never", "lamp = broken", "--scenario", "lamp.tcca"),
    ):
        code, _, errors = run(folder, *words)
        expect(code, 2, words)
        mentions(errors, "would destroy the input")
    expect((folder / "lamp.tcca").read_text(encoding="utf-8"), PLANT)


def test_reasons_are_given(folder):
    model(folder)
    for words, reason in (
        (("rmplc", "compile", "lamp.tcca", "-o", "none/out.json"), "none/out.json: cannot be written: No such file or directory"),
        (("rmplc", "compile", "lamp.tcca", "-o", "."), ".: cannot be written: is a directory"),
        (("rmpl-run", "scenario", "none.scn"), "none.scn: No such file or directory"),
        (("rmpl-run", "estimate", "lamp.tcca", "--log", "none"), "none: No such file or directory"),
        (("rmpl-run", "estimate", "lamp.tcca", "--log", "."), ".: is a directory, expected a file"),
        (("rmpl-run", "estimate", "lamp.tcca", "--log", "/proc/self/mem"), "/proc/self/mem: Input/output error"),
        (("tcca-check", "check", "lamp.tcca", "/proc/self/mem"), "/proc/self/mem: Input/output error"),
    ):
        code, out, errors = run(folder, *words)
        expect((code, out), (2, ""), words)
        mentions(errors, reason)


def test_names_do_not_move_the_cursor(folder):
    model(folder)
    evil = "\x1b[31m"
    (folder / f"{evil}.tcca").write_text(PLANT, encoding="utf-8")
    (folder / "wrong.tcca").write_text(f"plant P {{ {evil} }}", encoding="utf-8")
    (folder / "names.props").write_text(f'property "{evil}" {{ reach lamp = on; }}', encoding="utf-8")
    (folder / "lamp.json").write_text(run(folder, "rmplc", "compile", "lamp.tcca")[1].replace('"P"', '"P\\u001b[31m"'), encoding="utf-8")
    for words in (("tcca-check", "reachability", f"{evil}.tcca", "--target", "no = on"), ("rmplc", "compile", f"{evil}.none"),
                  ("rmplc", "compile", "wrong.tcca"), ("rmplc", "explain", evil), ("rmplc", "compile", "--main", evil, "main.rmpl"),
                  ("tcca-check", "check", "lamp.tcca", "names.props"), ("rmplc", "compile", "lamp.json"),
                  ("tcca-check", "reachability", "lamp.tcca", "--target", f"lamp = {evil}"), ("rmplc", evil)):
        code, out, errors = run(folder, *words)
        expect(code, 2, words)
        assert "\x1b" not in out + errors, (words, errors)


# Descriptors.

def test_standard_input_that_cannot_be_read(folder):
    model(folder)
    commands = (("rmplc", "compile", "-"), ("rmplc", "import", "-"), ("rmpl-run", "estimate", "lamp.tcca", "--log", "-"),
                ("rmpl-run", "scenario", "-"), ("tcca-check", "reachability", "-", "--target", "lamp = on"),
                ("tcca-check", "check", "lamp.tcca", "-"))
    for words in commands:
        code, out, errors = run(folder, *words, preexec=lambda: os.close(0))
        expect((code, out), (2, ""), words)
        mentions(errors, "standard input: cannot be read: it is closed")
        directory = os.open(folder, os.O_RDONLY)
        code, out, errors = run(folder, *words, stdin=directory)
        os.close(directory)
        expect((code, out), (2, ""), words)
        mentions(errors, "standard input: is a directory")


def test_standard_output_that_cannot_be_written(folder):
    model(folder)
    scenario(folder)
    commands = [(program, option) for program in ("rmplc", "rmpl-run", "tcca-check") for option in ("--help", "--version")]
    commands += [("rmplc", "compile", "lamp.tcca"), ("rmplc", "explain", "RMPL0100"), ("rmpl-run", "scenario", "s.scn"),
                 ("rmpl-run", "plan", "lamp.tcca", "--goal", "lamp = on"), ("rmpl-run", "scenario", "--help"),
                 ("tcca-check", "reachability", "lamp.tcca", "--target", "lamp = on")]
    for words in commands:
        code, _, errors = run(folder, *words, preexec=lambda: os.close(1))
        expect(code, 2, words)
        mentions(errors, "standard output: cannot be written: it is closed")
        with open("/dev/full", "wb") as full:
            code, _, errors = run(folder, *words, stdout=full)
        expect(code, 2, words)
        mentions(errors, "standard output: cannot be written: No space left on device")


def test_closed_descriptors_are_not_taken_by_files(folder):
    model(folder)
    scenario(folder)
    for closed in (1, 2):
        run(folder, "rmpl-run", "scenario", "s.scn", "--stats", "--trace", "t.jsonl", preexec=lambda fd=closed: os.close(fd))
        if closed == 2:
            for line in (folder / "t.jsonl").read_text(encoding="utf-8").splitlines():
                json.loads(line)


# Signals.

def test_sigterm_ends_a_flight_with_what_was_found(folder):
    model(folder)
    scenario(folder)
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        with subprocess.Popen([PROGRAMS / "rmpl-run", "scenario", "s.scn", "--real-time", "--trace", "t.jsonl"], cwd=folder,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, bufsize=0) as flight:
            flight.stdout.readline()
            time.sleep(0.2)
            flight.send_signal(number)
            out, _ = flight.communicate(timeout=60)
        expect(flight.returncode, 3, number)
        mentions(out.decode(), "interrupted")
        for line in (folder / "t.jsonl").read_text(encoding="utf-8").splitlines():
            json.loads(line)
        nothing_else(folder, "lamp.tcca", "main.rmpl", "s.scn", "t.jsonl")


def test_a_late_third_signal_ends_by_force_and_leaves_nothing_half_done(folder):
    model(folder)
    os.mkfifo(folder / "story")
    scenario(folder)
    (folder / "t.jsonl").write_text("old\n", encoding="utf-8")
    # The story goes into a pipe that is full: the flight hangs in a write when the signals come.
    reader, writer = os.pipe()
    import fcntl
    fcntl.fcntl(writer, fcntl.F_SETPIPE_SZ, 4096)
    os.write(writer, b"x" * 4096)
    with subprocess.Popen([PROGRAMS / "rmpl-run", "scenario", "s.scn", "--real-time", "--trace", "t.jsonl"], cwd=folder,
                          stdout=writer, stderr=subprocess.DEVNULL) as flight:
        for _ in range(200):
            if any(p.name.startswith(".t.jsonl.") for p in folder.iterdir()):
                break
            time.sleep(0.05)
        flight.send_signal(signal.SIGTERM)
        time.sleep(0.2)  # two that come at once may be one
        flight.send_signal(signal.SIGTERM)
        time.sleep(1.1)
        assert flight.poll() is None, flight.returncode
        flight.send_signal(signal.SIGINT)
        expect(flight.wait(timeout=60), -signal.SIGINT)
    os.close(reader)
    os.close(writer)
    expect((folder / "t.jsonl").read_text(encoding="utf-8"), "old\n")
    nothing_else(folder, "lamp.tcca", "main.rmpl", "s.scn", "story", "t.jsonl")


def test_what_has_nothing_to_tell_says_so(folder):
    """A catalogue from a pipe that never ends: import waits."""
    reader, writer = os.pipe()
    model(folder)
    with subprocess.Popen([PROGRAMS / "rmplc", "compile", "-", "-o", "old.json"], cwd=folder, stdin=reader, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE) as waits:
        time.sleep(0.3)
        waits.send_signal(signal.SIGTERM)
        out, errors = waits.communicate(timeout=60)
    os.close(reader)
    os.close(writer)
    expect(waits.returncode, 3)
    expect((out, errors), (b"", b"rmplc: interrupted\n"))


def test_no_output_of_an_earlier_run_stays(folder):
    model(folder)
    scenario(folder)
    for name, words in (("r.html", ("tcca-check", "stuck", "lamp.tcca", "--report", "r.html")),
                        ("j.xml", ("rmpl-run", "scenario", "nowhere.scn", "--junit", "j.xml"))):
        (folder / name).write_text("of yesterday", encoding="utf-8")
        code, _, errors = run(folder, *words)
        if name == "r.html":
            expect(code, 0)
            mentions(errors, "r.html: removed, because it was written by an earlier run")
            assert not (folder / name).exists()
        else:
            expect(code, 2)
            mentions((folder / name).read_text(encoding="utf-8"), "nowhere.scn: No such file or directory")
    code, out, _ = run(folder, "tcca-check", "check", "lamp.tcca", "nowhere.props", "--format", "junit")
    expect(code, 2)
    mentions(out, 'errors="1"')


def long_search(folder):
    """Fischer's protocol for nine processes, whose likeness is not made use of: minutes."""
    generated = subprocess.run([sys.executable, ROOT / "examples/classics/generate", "fischer", "9"], capture_output=True,
                               timeout=60, check=True).stdout.decode()
    (folder / "fischer.tcca").write_text(generated, encoding="utf-8")
    never = re.search("^// never: (.*)$", generated, re.MULTILINE)[1]
    return [PROGRAMS / "tcca-check", "safety", "fischer.tcca", "--never", never, "--no-symmetry", "--stats"]


def test_a_signal_ends_a_search_undecided(folder):
    for number in (signal.SIGTERM, signal.SIGHUP):
        with subprocess.Popen(long_search(folder), cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as search:
            time.sleep(1)
            assert search.poll() is None, "the search is too short for this test"
            search.send_signal(number)
            out, _ = search.communicate(timeout=60)
        expect(search.returncode, 3, number)
        mentions(out.decode(), "undecided")


# Terminals.

def on_terminal(folder, words, env=None, kill_after=None):
    """What a program writes to a terminal, both streams together."""
    master, slave = pty.openpty()
    with subprocess.Popen(words, cwd=folder, stdin=subprocess.DEVNULL, stdout=slave, stderr=slave,
                          env={**{k: v for k, v in os.environ.items() if k != "NO_COLOR"}, **(env or {})}) as process:
        os.close(slave)
        if kill_after:
            time.sleep(kill_after)
            process.send_signal(signal.SIGINT)
        text = b""
        while True:
            try:
                block = os.read(master, 65536)
            except OSError:
                break
            if not block:
                break
            text += block
        process.wait(timeout=60)
    os.close(master)
    return text.decode()


def test_no_color_is_honoured_by_all(folder):
    model(folder)
    scenario(folder)
    (folder / "wrong.tcca").write_text("plant P { x : Y; }", encoding="utf-8")
    for words in (("rmplc", "compile", "wrong.tcca"), ("rmpl-run", "scenario", "s.scn"),
                  ("tcca-check", "safety", "lamp.tcca", "--never", "lamp = on"),
                  ("tcca-check", "program", "main.rmpl", "lamp.tcca", "--faults", "1")):
        command = [PROGRAMS / words[0], *words[1:]]
        mentions(on_terminal(folder, command), "\x1b[1")
        plain = on_terminal(folder, command, {"NO_COLOR": "1"})
        assert not re.search("\x1b\\[[0-9;]*m", plain), plain
        mentions(on_terminal(folder, [*command, "--color", "always"], {"NO_COLOR": "1"}), "\x1b[1")


def test_the_line_of_progress_is_erased(folder):
    search = long_search(folder)
    model = [*search[2:5], "--format", "tchecker", "--commands", "any"]
    for words in (search, [search[0], "export", *model]):
        text = on_terminal(folder, words, kill_after=3)
        shown = list(re.finditer(r"\d+ s: \d+ states, \d+ unexplored, \d+ (steps|faults)", text))
        assert shown, f"no progress was shown: {text!r}"
        rest = text[shown[-1].end():]
        assert rest.startswith("\r\x1b[K") and rest[4:].strip(), f"the line is not erased before what follows: {rest!r}"


def main(arguments):
    global ROOT, PROGRAMS
    ROOT, PROGRAMS = (pathlib.Path(a).resolve() for a in arguments[:2])
    wanted = arguments[2:]
    failed = 0
    tests = {name: test for name, test in globals().items() if name.startswith("test_") and (not wanted or name in wanted)}
    for name, test in tests.items():
        with tempfile.TemporaryDirectory() as folder:
            try:
                test(pathlib.Path(folder))
            except (AssertionError, OSError, ValueError, subprocess.SubprocessError) as error:
                failed += 1
                print(f"{name}: {error}")
    print(f"{len(tests)} tests, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
