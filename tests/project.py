#!/usr/bin/env python3
# Projects as people make and test them: what is new passes, what is broken is told, with its place and its exit code.
# SPDX-License-Identifier: MIT
"""Usage: project.py ROOT PROGRAMS.  Prints a line for each thing that is not as it should be, and exits 1 where there is any."""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as xml

ROOT, PROGRAMS = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
failures = []


def expect(is_so, what):
    if not is_so:
        failures.append(what)


def rmplc(*words, folder, program=PROGRAMS / "rmplc"):
    done = subprocess.run([str(program), *map(str, words)], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True,
                          timeout=120, check=False)
    return done.returncode, done.stdout.decode(), done.stderr.decode()


def replace(path, old, new):
    text = path.read_text(encoding="utf-8")
    assert old in text, f"{path} has no {old!r}"
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


def made(folder, name="demo"):
    code, _, error = rmplc("new", name, folder=folder)
    expect(code == 0, f"rmplc new {name}: {code} {error}")
    return folder / name


def new_projects(folder):
    project = made(folder)
    expect(rmplc("test", folder=project)[0] == 0, "a new project passes in its folder")
    expect(rmplc("test", "demo", folder=folder)[0] == 0, "a new project passes from beside")
    expect(rmplc("test", folder=project / "plant")[0] == 2, "a folder without scenarios and properties is told")
    for command in (["lint", "scenarios/fill.scn", "properties/station.props"],
                    ["format", "--check", "plant/station.tcca", "program/fill.rmpl", "scenarios/fill.scn",
                     "properties/station.props"]):
        expect(rmplc(*command, folder=project)[0] == 0, f"a new project is clean: {command[0]}")
    before = sorted(folder.rglob("*"))
    expect(rmplc("new", "demo", folder=folder)[0] == 2, "a folder that is there is refused")
    (folder / "file").touch()
    (folder / "link").symlink_to("nowhere")
    for name in ("file", "link", "", ".", "..", "no/such/folder", "\udcff"):
        expect(rmplc("new", name, folder=folder)[0] == 2, f"rmplc new {name!r} is refused")
    expect(sorted(folder.rglob("*")) == sorted(before + [folder / "file", folder / "link"]), "nothing half made stays")
    odd = made(folder, 'a "b" \\ c')
    code, text, _ = rmplc("test", "--format", "json", folder=odd)
    expect(code == 0 and json.loads(text)["project"] == 'a "b" \\ c', "any name will do")


def outcomes(folder):
    project = made(folder)
    scenarios = project / "scenarios/fill.scn"
    replace(scenarios, "expect finished within 30 s", "expect finished within 3 s")
    code, text, _ = rmplc("test", "--junit", "out.xml", "--markdown", "out.md", folder=project)
    expect(code == 1 and "scenarios/fill.scn:12: finished within 3 s: " in text, f"a failure tells its place: {text}")
    failed = [case for case in xml.parse(project / "out.xml").iter("testcase") if case.find("failure") is not None]
    expect([(case.get("file"), case.get("line")) for case in failed] == [("scenarios/fill.scn", "12")],
           "JUnit has file and line of what failed")
    expect("| scenarios/fill.scn: the tank is filled | failed |" in (project / "out.md").read_text(encoding="utf-8"),
           "Markdown tells what failed")
    _, text, _ = rmplc("test", "--format", "github", folder=project)
    expect(text.startswith("::error file=scenarios/fill.scn,line=12,title=scenarios/fill.scn%3A the tank is filled::"),
           f"GitHub annotates the line: {text}")
    expect(rmplc("test", "--only", "the switch*", folder=project)[0] == 0, "what is chosen passes")
    code, text, _ = rmplc("test", "properties", "--format", "json", folder=project)
    expect(code == 0 and {test["kind"] for test in json.loads(text)["tests"]} == {"property"}, "a folder is chosen")
    answers = []
    for jobs in ("1", "4"):
        answer = rmplc("test", "-j", jobs, "--format", "json", folder=project)[1]
        answers.append(re.sub(r'"seconds":[-+.0-9e]+', "", answer))
    expect(answers[0] == answers[1], "any number of jobs gives the same answer")

    replace(project / "properties/station.props", "faults 1", "faults 0")
    replace(project / "plant/station.tcca", "component Pump {", "component Idle { initial a; mode a; }\ncomponent Pump {")
    _, text, _ = rmplc("test", "--format", "json", folder=project)
    lint = [test for test in json.loads(text)["tests"] if test["kind"] == "lint"]
    expect(lint[0]["outcome"] == "failed" and lint[0]["failures"][0]["file"] == "plant/station.tcca",
           f"lint is told: {lint}")
    replace(project / "rmpl.toml", "[lint]\n", '[lint]\nunused = "off"\n')
    _, text, _ = rmplc("test", "--format", "json", folder=project)
    expect(json.loads(text)["tests"][0]["outcome"] == "passed", "levels of rmpl.toml count")
    code, text, _ = rmplc("lint", "plant/station.tcca", folder=project)
    expect(code == 0, f"they count for rmplc lint, too: {text}")

    (project / "scenarios/wrong.scn").write_text('scenario "x" {\n  program "none.rmpl";\n', encoding="utf-8")
    code, text, _ = rmplc("test", "--format", "json", folder=project)
    found = [(test["kind"], test.get("file"), test["outcome"]) for test in json.loads(text)["tests"]]
    for wrong in (("lint", None, "wrong"), ("scenario", "scenarios/wrong.scn", "wrong")):
        expect(code == 2 and wrong in found, f"a file that is wrong: {code} {found}")
    for other in (("scenario", "scenarios/fill.scn", "failed"), ("scenario", "scenarios/fill.scn", "passed"),
                  ("property", "properties/station.props", "passed")):
        expect(other in found, f"it takes nothing from the others: {found}")


def requirements(folder):
    project = made(folder)
    scenarios, properties, manifest = (project / name for name in ("scenarios/fill.scn", "properties/station.props", "rmpl.toml"))
    code, text, _ = rmplc("test", folder=project)
    expect("requirements" not in text, f"where none are named nothing is told: {text}")
    replace(scenarios, "  seed    1;\n", '  seed    1;\n  requirement "FILL-2", "FILL-10";\n')
    replace(scenarios, "expect finished within 30 s", 'expect finished within 3 s requirement "FILL-1", "SAFE-1"')
    replace(properties, "  reach pump = running;\n", '  reach pump = running;\n  requirement "FILL-1";\n')

    def matrix(*words):
        code, text, error = rmplc("test", "--format", "json", *words, folder=project)
        return code, {one["requirement"]: (one["outcome"], one["verified"],
                                           [(by["kind"], by.get("line"), by["outcome"]) for by in one["by"]])
                      for one in json.loads(text)["requirements"]} if text else error

    known = {"FILL-1": ("failed", True, [("expectation", 13, "failed"), ("property", 3, "passed")]),
             "FILL-2": ("failed", False, [("scenario", 3, "failed")]),
             "FILL-10": ("failed", False, [("scenario", 3, "failed")]),
             "SAFE-1": ("failed", False, [("expectation", 13, "failed")])}
    expect(matrix() == (1, known), f"a matrix: {matrix()}")
    expect(list(matrix()[1]) == list(known), "numbers in names count")
    code, text, _ = rmplc("test", "--junit", "out.xml", "--markdown", "out.md", folder=project)
    expect(text.endswith("no passing test verifies FILL-2, FILL-10, SAFE-1\n"), f"what is not verified is told: {text}")
    expect("**No passing test verifies** FILL-2, FILL-10, SAFE-1" in (project / "out.md").read_text(encoding="utf-8"),
           "Markdown tells it, too")
    named = {case.get("name"): [one.get("value") for one in case.iter("property")]
             for case in xml.parse(project / "out.xml").iter("testcase")}
    expect(named["finished within 3 s"] == ["FILL-2", "FILL-10", "FILL-1", "SAFE-1"], f"JUnit has them: {named}")
    expect(named["the pump can run"] == ["FILL-1"], f"also of properties: {named}")

    replace(scenarios, "finished within 3 s", "finished within 30 s")
    expect(matrix()[0] == 0, "all passes")
    replace(manifest, 'name = "demo"\n', 'name = "demo"\nrequirements = ["FILL-1", "FILL-2", "FILL-10", "SAFE-1", "SAFE-2"]\n')
    code, found = matrix()
    expect(code == 1 and found["SAFE-2"] == ("failed", False, []), f"what is listed and not named fails: {code} {found}")
    code, text, _ = rmplc("test", folder=project)
    expect("  SAFE-2   FAILED     no scenario and no property names it\nno passing test verifies SAFE-2\n" in text, f"it is told: {text}")
    code, found = matrix("--only", "the tank is filled")
    expect(code == 0 and sorted(found) == ["FILL-1", "FILL-10", "FILL-2", "SAFE-1"], f"a part is a part: {code} {found}")
    replace(manifest, '"SAFE-2"', '"SAFE-1", " "')
    code, _, error = rmplc("test", folder=project)
    expect(code == 2 and "rmpl.toml:5:58: requirement 'SAFE-1' stands twice" in error and "has no name" in error,
           f"a list that is wrong: {error}")


def defaults(folder):
    project = made(folder)
    manifest = project / "rmpl.toml"
    text = manifest.read_text(encoding="utf-8")
    flight = ["scenario", "scenarios/fill.scn", "--format", "json", "--only", "the tank is filled"]

    def seed(*words):
        code, text, error = rmplc(*flight, *words, folder=project, program=PROGRAMS / "rmpl-run")
        return json.loads(text)["scenarios"][0]["seed"] if code < 2 else error

    manifest.write_text(text + "[rmpl-run.scenario]\nseed = 77\n", encoding="utf-8")
    expect(seed() == 77, "options stand in rmpl.toml")
    expect(seed("--seed", "5") == 5, "the command line comes before rmpl.toml")
    manifest.write_text(text + "[rmpl-run.scenario]\nsed = 77\n", encoding="utf-8")
    expect("rmpl.toml:18:1: scenario has no option 'sed'; did you mean 'seed'?" in str(seed()), f"{seed()}")
    manifest.write_text(text + "[rmpl-run.scenario]\nseed = -1\n", encoding="utf-8")
    expect("rmpl.toml:18:1: --seed" in str(seed()), f"a bad value is told: {seed()}")
    manifest.write_text(text + "[rmpl-run.scenari]\nseed = 1\n", encoding="utf-8")
    expect("did you mean 'scenario'?" in str(seed()), "a subcommand that there is not is told")


def endless(folder):
    """A project with a flight that takes very long."""
    project = made(folder)
    (project / "program/fill.rmpl").write_text("Fill() :: { always (pump = running) }\n", encoding="utf-8")
    (project / "scenarios/fill.scn").write_text(
        'scenario "on and on" {\n  program "../program/fill.rmpl";\n  plant "../plant/station.tcca";\n'
        '  duration 200000 h;\n  expect never switch = stuck & pump = running;\n}\n', encoding="utf-8")
    return project


def limits(folder):
    project = endless(folder)
    code, text, _ = rmplc("test", "--only", "on and on", "--time-limit", "0.5", folder=project)
    expect(code == 3 and "not done within the time limit" in text, f"a limit: {code} {text}")
    process = subprocess.Popen([PROGRAMS / "rmplc", "test", "--format", "json", "-j", "1"], cwd=project,
                               stdout=subprocess.PIPE)
    time.sleep(1)
    process.send_signal(signal.SIGTERM)
    text = process.communicate(timeout=60)[0]
    kinds = {test["kind"]: test["outcome"] for test in json.loads(text)["tests"]}
    expect(process.returncode == 3 and kinds["scenario"] == "undecided" and kinds["property"] == "skipped",
           f"an interruption: {process.returncode} {kinds}")


def broken(folder):
    project = made(folder)
    programs = folder / "bin"
    programs.mkdir()
    shutil.copy(PROGRAMS / "rmplc", programs)
    shutil.copy(PROGRAMS / "tcca-check", programs)
    (programs / "rmpl-run").write_text("#!/bin/sh\nkill -SEGV $$\n", encoding="utf-8")
    os.chmod(programs / "rmpl-run", 0o755)
    code, text, _ = rmplc("test", folder=project, program=programs / "rmplc")
    expect(code == 4 and "ended by signal 11" in text, f"a program that fails: {code} {text}")


def baselines(folder):
    project = made(folder)
    plant = project / "plant/station.tcca"
    replace(plant, "component Pump {", "component Idle { initial a; mode a; }\n\ncomponent Pump {")
    replace(project / "rmpl.toml", "[lint]\n", '[lint]\nbaseline = "known.json"\n')
    expect("rmpl.toml:7:12: there is no file known.json" in rmplc("test", folder=project)[2], "a baseline that is not there")
    (project / "known.json").write_text("{}", encoding="utf-8")
    expect(rmplc("test", folder=project)[0] == 2, "a baseline that is none")
    code, text, error = rmplc("lint", "plant/station.tcca", "--write-baseline", "known.json", folder=project)
    known = json.loads((project / "known.json").read_text(encoding="utf-8"))
    expect((code, text) == (0, "") and [(one["code"], one["file"], one["count"]) for one in known["findings"]] ==
           [("RMPL0513", "plant/station.tcca", 1)], f"a baseline is written: {code} {text} {error} {known}")
    expect(rmplc("test", folder=project)[0] == 0, "what is known is not told by test")
    expect(rmplc("lint", "station.tcca", folder=project / "plant")[:2] == (0, ""), "nor by lint, wherever it runs")
    expect(rmplc("check", "plant/station.tcca", folder=project)[0] == 0, "nor by check")
    replace(plant, "// A pump", "\n\n// A pump")
    expect(rmplc("test", folder=project)[0] == 0, "lines do not count")
    replace(plant, "component Idle", "component Idler { initial a; mode a; }\n\ncomponent Idle")
    code, text, _ = rmplc("lint", "plant/station.tcca", folder=project)
    expect(code == 1 and "Idler" in text and "`Idle`" not in text, f"what is new is told: {text}")
    replace(plant, "component Idle { initial a; mode a; }", "")
    _, _, error = rmplc("lint", "plant/station.tcca", "--baseline", "known.json", folder=project)
    expect("1 known finding no longer found" in error, f"what is no more is told: {error}")


def baselines_of_monitors(folder):
    project = made(folder)
    (project / "station.mon").write_text('channel "F" : pump.flow { zero below 1; full above 3; }\n', encoding="utf-8")
    files = ("plant/station.tcca", "station.mon")
    code, text, _ = rmplc("lint", *files, folder=project)
    expect(code == 1 and "station.mon:1" in text, f"a gap between limits is told: {code} {text}")
    rmplc("lint", *files, "--write-baseline", "known.json", folder=project)
    said = rmplc("lint", *files, "--baseline", "known.json", folder=project)
    expect(said == (0, "", ""), f"what is known of monitors is not told by lint: {said}")
    replace(project / "rmpl.toml", "[lint]\n", '[lint]\nbaseline = "known.json"\n')
    said = rmplc("check", *files, folder=project)
    expect(said == (0, "", ""), f"nor by check: {said}")


def fixes_beside_a_baseline(folder):
    project = made(folder)
    plant = project / "plant/station.tcca"
    first, second = "  open   -> closed when cmd = on;\n", "  closed -> open   when cmd = off;\n"
    replace(plant, first, first + first)
    rmplc("lint", "plant/station.tcca", "--write-baseline", "known.json", folder=project)
    replace(plant, second, second + second)
    code, text, error = rmplc("lint", "plant/station.tcca", "--baseline", "known.json", "--fix", folder=project)
    mended = plant.read_text(encoding="utf-8")
    expect(code == 0 and "1 finding fixed" in error and mended.count(first) + mended.count(second) == 3,
           f"what is known is not fixed: {code} {text} {error}")


def dependencies(folder):
    project = made(folder)
    (project / "other.tcca").write_text("component A { initial a; mode a; }\nplant P { a : A; }\n", encoding="utf-8")
    with (project / "rmpl.toml").open("a", encoding="utf-8") as manifest:
        manifest.write('[set.other]\nplant = "other.tcca"\n')

    def git(*words):
        subprocess.run(["git", "-c", "user.name=x", "-c", "user.email=x@example.org", *words], cwd=project, check=True,
                       capture_output=True)

    def sets(*words):
        code, text, error = rmplc("test", "--format", "json", "--changed-since", *words, folder=project)
        return sorted({test["set"] for test in json.loads(text)["tests"]}) if code < 2 else (code, error)

    expect(sets("HEAD")[0] == 2, "no repository is told")
    git("init", "-q")
    git("add", "-A")
    git("commit", "-qm", "x")
    expect(sets("HEAD") == [], f"nothing has changed: {sets('HEAD')}")
    replace(project / "plant/station.tcca", "// A pump", "// The pump")
    expect(sets("HEAD") == ["fill"], f"a plant has changed: {sets('HEAD')}")
    git("commit", "-qam", "x")
    expect(sets("HEAD") == [] and sets("HEAD~1") == ["fill"], "a revision before")
    (project / "scenarios/more.scn").write_text(
        (project / "scenarios/fill.scn").read_text(encoding="utf-8").replace("the ", "once more the "), encoding="utf-8")
    expect(sets("HEAD") == ["fill"], "a file that git does not know yet")
    replace(project / "rmpl.toml", "60 s", "61 s")
    expect(sets("HEAD") == ["fill", "other"], "the manifest has changed")
    for wrong in ("nowhere", "--output=x", "-p"):
        code, _, error = rmplc("test", f"--changed-since={wrong}", folder=project)
        expect(code == 2, f"no such revision: {wrong} {error}")

    rmplc("test", "-q", "--junit", "out.xml", "--depfile", "out.d", folder=project)
    rule = (project / "out.d").read_text(encoding="utf-8").replace("\\\n", "").split()
    expect(rule[0] == "out.xml:" and {"rmpl.toml", "plant/station.tcca", "program/fill.rmpl", "scenarios/fill.scn",
                                      "properties/station.props", "other.tcca"} <= set(rule), f"a rule: {rule}")
    expect(rmplc("test", "--depfile", "out.d", folder=project)[0] == 2, "a rule needs a target")
    (project / "a b$.tcca").write_text('import "other.tcca";\n', encoding="utf-8")
    code, _, error = rmplc("compile", "a b$.tcca", "-o", "x.json", "--depfile", "x.d", folder=project)
    expect((project / "x.d").read_text(encoding="utf-8") == "x.json: \\\n  a\\ b$$.tcca \\\n  other.tcca\n", f"x.d: {error}")


def answers_in_files(folder):
    """Pictures are what their names say, and line ends do not change in silence."""
    project = made(folder)
    plant = project / "plant/station.tcca"
    if shutil.which("dot"):
        for end, magic in ((".png", b"\x89PNG"), (".pdf", b"%PDF"), (".svg", b"<?xml"), (".gv", b"digraph"), ("", b"digraph")):
            code, _, error = rmplc("diagram", plant, "-o", f"picture{end}", folder=folder)
            expect(code == 0 and (folder / f"picture{end}").read_bytes().startswith(magic), f"picture{end}: {error}")
        code, _, _ = rmplc("diagram", plant, "--format", "png", "-o", "picture.x", folder=folder)
        expect(code == 0 and (folder / "picture.x").read_bytes().startswith(b"\x89PNG"), "--format has the last word")
    code, _, error = rmplc("diagram", plant, "-o", "picture.jpg", folder=folder)
    expect(code == 2 and not (folder / "picture.jpg").exists(), f"picture.jpg: {code} {error}")
    plant.write_bytes(plant.read_bytes().replace(b"\n", b"\r\n"))
    code, text, error = rmplc("format", "--check", plant, folder=folder)
    expect(code == 1 and "lines end in CR LF; they would end in LF" in error, f"format --check: {code} {text} {error}")
    code, text, error = rmplc("format", plant, folder=folder)
    expect(code == 0 and "lines end in CR LF; they end in LF now" in error, f"format: {code} {text} {error}")
    expect(rmplc("format", plant, folder=folder) == (0, "", ""), "once is enough")


def main():
    for case in (new_projects, baselines, baselines_of_monitors, fixes_beside_a_baseline, dependencies, answers_in_files, outcomes, requirements, defaults, limits, broken):
        with tempfile.TemporaryDirectory() as folder:
            case(pathlib.Path(folder))
    for failure in failures:
        print(failure)
    print(f"{len(failures)} failures")
    return 1 if failures else 0


sys.exit(main())
