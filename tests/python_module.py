#!/usr/bin/env python3
# The Python module against the programs: the same answers, to the byte where bytes are written.
# SPDX-License-Identifier: MIT
"""Usage: python_module.py ROOT PROGRAMS.  Run by the Python that the module was built for, with PYTHONPATH set to it."""

import csv
import io
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

ROOT, PROGRAMS = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
EXAMPLES = ROOT / "examples"

begin = time.perf_counter()
import rmpl  # noqa: E402  # pylint: disable=wrong-import-position

IMPORT_SECONDS = time.perf_counter() - begin


def run(program, *words, status=0, stdin=None):
    done = subprocess.run([PROGRAMS / program, *map(str, words)], input=stdin, capture_output=True, check=False, text=True)
    if done.returncode != status:
        raise AssertionError(f"{program} {words}: exit code {done.returncode}\n{done.stderr}")
    return done.stdout


def without_costs(answer):
    """What two runs have in common."""
    if isinstance(answer, dict):
        return {key: without_costs(value) for key, value in answer.items() if key not in ("statistics", "seconds")}
    return [without_costs(value) for value in answer] if isinstance(answer, list) else answer


class Models(unittest.TestCase):
    def test_names(self):
        model = rmpl.compile(EXAMPLES / "propulsion/burn.scn")
        self.assertEqual(model.plants, ["Propulsion"])
        self.assertIn("a valve sticks closed", model.scenarios)
        self.assertIn("Propulsion", repr(model))

    def test_document_is_that_of_the_compiler(self):
        plant = EXAMPLES / "propulsion/propulsion.tcca"
        self.assertEqual(rmpl.compile(plant).document(), json.loads(run("rmplc", "compile", plant)))

    def test_diagnostics_are_data(self):
        text = "component C { initial a; mode a; b -> a; }\nplant P { c : C; }\n"
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "wrong.tcca")
            file.write_text(text)
            with self.assertRaises(rmpl.Rejected) as caught:
                rmpl.compile(file)
            done = subprocess.run([PROGRAMS / "rmplc", "lint", "--format", "json", file], capture_output=True, check=False, text=True)
        self.assertEqual(caught.exception.diagnostics, json.loads(done.stdout))
        self.assertIn("wrong.tcca:1", str(caught.exception))
        self.assertIsInstance(caught.exception, rmpl.InputError)
        self.assertIsInstance(caught.exception, ValueError)

    def test_texts_need_no_file(self):
        model = rmpl.compile(texts={"lamp.tcca": "component Lamp { initial dark; mode dark; mode lit; dark -> lit in [1 s, 2 s]; }\n"
                                                 "plant Hall { lamp : Lamp; }"})
        self.assertEqual(model.plants, ["Hall"])

    def test_diagram(self):
        model = rmpl.compile(EXAMPLES / "propulsion/propulsion.tcca")
        diagram = model.diagram("Engine")
        self.assertEqual(diagram.dot, run("rmplc", "diagram", EXAMPLES / "propulsion/propulsion.tcca", "--of", "Engine", "--format", "dot"))
        self.assertTrue(diagram._repr_svg_().startswith("<svg"))
        self.assertTrue(model._repr_svg_().startswith("<svg"))
        with self.assertRaises(rmpl.InputError):
            model.diagram("Wheel")

    def test_what_is_not_there(self):
        with self.assertRaises(rmpl.InputError):
            rmpl.compile("/nowhere.tcca")
        with self.assertRaises(rmpl.InputError):
            rmpl.compile()


class Estimates(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.plant = EXAMPLES / "propulsion/propulsion.tcca"
        cls.flight = rmpl.fly(EXAMPLES / "propulsion/burn.scn", "a valve sticks closed", trace="cycles")
        cls.lines = [json.dumps(line) for line in cls.flight.trace]

    def lines_of(self, *options):
        answers = run("rmpl-run", "estimate", "-q", self.plant, "--log", "-", *options, stdin="\n".join(self.lines))
        return [json.loads(line) for line in answers.splitlines()]

    def test_the_same_as_the_program(self):
        for options, words in (({}, ()), ({"k": 3}, ("-k", 3)), ({"estimator": "exact"}, ("--estimator", "exact")),
                               ({"estimator": "exact", "k": 2}, ("--estimator", "exact", "-k", 2)),
                               ({"window": 4}, ("--window", 4)), ({"ranks": True}, ("--ranks",)), ({"thesis": True}, ("--thesis",)),
                               ({"estimator": "exact", "window": 6, "stats": True}, ("--estimator", "exact", "--window", 6, "--stats")),
                               ({"all_clocks": True}, ("--all-clocks",))):
            with self.subTest(**options):
                self.assertEqual(rmpl.estimate(self.plant, self.flight.trace, **options), self.lines_of(*words))

    def test_a_window_revises(self):
        late = [dict(line, observations={name: value for name, value in line["observations"].items()
                                         if name != "valve1.outlet" or not 56 <= line["time"] < 58}) for line in self.flight.trace]
        answers = run("rmpl-run", "estimate", "-q", self.plant, "--log", "-", "--estimator", "exact", "--window", 8,
                      stdin="\n".join(map(json.dumps, late)))
        own = rmpl.estimate(self.plant, late, estimator="exact", window=8)
        self.assertEqual(own, [json.loads(line) for line in answers.splitlines()])
        self.assertTrue(any(answer["revised"] for answer in own))

    def test_a_log_of_changes(self):
        flight = rmpl.fly(EXAMPLES / "propulsion/burn.scn", "a valve sticks closed")
        with tempfile.TemporaryDirectory() as folder:
            log = pathlib.Path(folder, "log.jsonl")
            flight.save(log)
            answers = run("rmpl-run", "estimate", "-q", self.plant, "--log", log)
            self.assertEqual(rmpl.estimate(self.plant, log), [json.loads(line) for line in answers.splitlines()])

    def test_belief_is_a_mapping(self):
        estimator = rmpl.Estimator(self.plant, estimator="exact")
        belief = estimator.update(0.5, {"pde.cmd": "on"}, {"engine.thrust": "zero"})
        self.assertAlmostEqual(sum(belief.values()), 1)
        state = next(iter(belief))
        self.assertEqual(dict(state), belief.estimate)
        self.assertEqual(belief[state], max(belief.values()))
        self.assertAlmostEqual(sum(belief.marginal("engine").values()), 1)
        self.assertAlmostEqual(belief.probability(engine="off"), belief.marginal("engine")["off"])
        self.assertEqual(belief.missing_mass, 0)

    def test_a_wrong_line_changes_nothing(self):
        right, other = rmpl.Estimator(self.plant), rmpl.Estimator(self.plant)
        right.update(0.5, {"pde.cmd": "on"})
        other.update(0.5, {"pde.cmd": "on"})
        for wrong in ({"time": 1, "command": {"pde.cmd": "dance"}}, {"time": 0.1, "command": {}}, {"time": "noon", "command": {}},
                      {"command": {}}):
            with self.assertRaises(rmpl.InputError):
                right.update(**wrong)
        self.assertEqual(right.update(1, {}).answer, other.update(1, {}).answer)

    def test_limits(self):
        with self.assertRaises(ValueError):
            rmpl.Estimator(self.plant, estimator="best")
        with self.assertRaises(ValueError):
            rmpl.Estimator(self.plant, estimator="exact", ranks=True)

    def test_frame(self):
        try:
            import pandas  # noqa: F401  # pylint: disable=import-outside-toplevel,unused-import
        except ImportError:
            self.skipTest("pandas is not there")
        frame = rmpl.estimate(self.plant, self.flight.trace).frame()
        self.assertEqual(len(frame), len(self.lines))
        self.assertIn("estimate.engine", frame.columns)
        self.assertEqual(self.flight.frame()["kind"].iloc[0], self.flight.changes[0]["kind"])


class ModelPrograms(unittest.TestCase):
    """Estimated by their markings, to the same numbers as by the program."""

    @classmethod
    def setUpClass(cls):
        cls.model = EXAMPLES / "rover-camera/rover_camera.rmpl"
        cls.logs = sorted(log for log in (EXAMPLES / "rover-camera").glob("*.jsonl") if log.stem not in ("rover_blank", "steps"))

    def test_the_same_as_the_program(self):
        self.assertTrue(self.logs)
        for log in self.logs:
            for options, words in (({}, ()), ({"k": 2}, ("-k", 2)), ({"estimator": "exact"}, ("--estimator", "exact")),
                                   ({"estimator": "exact", "k": 3, "window": 4}, ("--estimator", "exact", "-k", 3, "--window", 4)),
                                   ({"window": 20}, ("--window", 20)), ({"beam": True, "k": 3}, ("--beam", "-k", 3)),
                                   ({"stats": True}, ("--stats",))):
                with self.subTest(log.stem, **options):
                    answers = run("rmpl-run", "estimate", "-q", self.model, "--log", log, *words)
                    self.assertEqual(rmpl.estimate(self.model, log, **options), [json.loads(line) for line in answers.splitlines()])

    def test_another_model(self):
        navigation = rmpl.compile(EXAMPLES / "optical-navigation/optical_navigation.rmpl")
        self.assertEqual(len(navigation.model_programs), 1)
        log = EXAMPLES / "optical-navigation/camera_dead.jsonl"
        answers = run("rmpl-run", "estimate", "-q", EXAMPLES / "optical-navigation/optical_navigation.rmpl", "--log", log)
        self.assertEqual(rmpl.estimate(navigation, log), [json.loads(line) for line in answers.splitlines()])

    def test_belief_is_a_mapping(self):
        estimator = rmpl.Estimator(self.model, estimator="exact")
        *_, belief = estimator.follow(self.logs[0])
        self.assertAlmostEqual(sum(belief.values()), 1)
        state = next(iter(belief))
        self.assertEqual((dict(state), list(state.marking)), (belief.estimate, belief.marking))
        self.assertEqual(belief[state], max(belief.values()))
        for name in belief.estimate:
            self.assertAlmostEqual(sum(belief.marginal(name).values()), 1)
            self.assertAlmostEqual(belief.probability(**{name: belief.estimate[name]}), belief.marginal(name)[belief.estimate[name]])
        with self.assertRaises(KeyError):
            belief.marginal("no such variable")
        self.assertIsNone(rmpl.Estimator(EXAMPLES / "propulsion/propulsion.tcca").update(0).marking)

    def test_a_wrong_line_changes_nothing(self):
        right, other = rmpl.Estimator(self.model), rmpl.Estimator(self.model)
        lines = [json.loads(line) for line in self.logs[0].read_text(encoding="utf-8").splitlines()]
        for line in lines[:2]:
            right.update(**line)
            other.update(**line)
        for wrong in ({"time": 99, "observations": {"nothing": "x"}}, {"time": "noon"}):
            with self.assertRaises(rmpl.InputError):
                right.update(**wrong)
        self.assertEqual(right.update(**lines[2]).answer, other.update(**lines[2]).answer)

    def test_options_of_plants(self):
        for options in ({"thesis": True}, {"ranks": True}, {"all_clocks": True}, {"deadline": 1}):
            with self.subTest(**options), self.assertRaises(rmpl.InputError):
                rmpl.Estimator(self.model, **options)
        with self.assertRaises(rmpl.InputError):
            rmpl.Estimator(EXAMPLES / "propulsion/propulsion.tcca", beam=True)
        with self.assertRaises(ValueError):
            rmpl.Estimator(self.model, beam=True, window=3)

    def test_frame(self):
        try:
            import pandas  # noqa: F401  # pylint: disable=import-outside-toplevel,unused-import
        except ImportError:
            self.skipTest("pandas is not there")
        frame = rmpl.estimate(self.model, self.logs[0]).frame()
        self.assertIn("marking", frame.columns)


class Questions(unittest.TestCase):
    def test_plan(self):
        plant = EXAMPLES / "propulsion/propulsion.tcca"
        start = {"pde": "off", "valve1": "closed", "valve2": "closed", "engine": "off"}
        words = ", ".join(f"{name} = {mode}" for name, mode in start.items())
        expected = json.loads(run("rmpl-run", "plan", plant, "--goal", "engine = firing", "--from", words, "--format", "json"))
        self.assertEqual(rmpl.plan(plant, "engine = firing", start), expected)
        self.assertEqual(rmpl.plan(rmpl.compile(plant), "engine = firing", words, cycle="0.5 s"),
                         json.loads(run("rmpl-run", "plan", plant, "--goal", "engine = firing", "--from", words, "--format", "json",
                                        "--cycle", "0.5 s")))
        with self.assertRaises(rmpl.Rejected) as caught:
            rmpl.plan(plant, "engine = fring")
        self.assertIn("firing", caught.exception.diagnostics[0]["suggestion"] or caught.exception.diagnostics[0]["message"])
        with self.assertRaises(rmpl.InputError):
            rmpl.plan(plant, "engine = firing", cycle="soon")

    def test_diagnose(self):
        plant = EXAMPLES / "mars-entry/mars_lander.tcca"
        observe = {"engine.power": "zero", "lander.contact": "made"}
        words = ", ".join(f"{name} = {value}" for name, value in observe.items())
        expected = json.loads(run("rmpl-run", "diagnose", plant, "--observe", words, "-k", 4, "--format", "json"))
        self.assertEqual(without_costs(rmpl.diagnose(plant, observe, k=4)), without_costs(expected))
        with self.assertRaises(rmpl.InputError):
            rmpl.diagnose(plant, {"engine": "off"})

    def test_check(self):
        for plant, program, properties in (("propulsion/propulsion.tcca", None, "propulsion/propulsion.props"),
                                           ("power/power.tcca", "power/power.rmpl", "power/power.props")):
            with self.subTest(properties):
                files = [EXAMPLES / plant] + ([EXAMPLES / program] if program else [])
                words = [EXAMPLES / plant, EXAMPLES / properties] + ([EXAMPLES / program] if program else [])
                done = subprocess.run([PROGRAMS / "tcca-check", "check", *words, "--format", "json"], capture_output=True, check=False,
                                      text=True)
                answer = rmpl.check(rmpl.compile(*files), EXAMPLES / properties)
                self.assertEqual(without_costs(answer), without_costs(json.loads(done.stdout)))

    def test_check_of_a_text(self):
        plant = rmpl.compile(texts={"lamp.tcca": "component Lamp { initial dark; mode dark; mode lit; dark -> lit in [1 s, 2 s]; }\n"
                                                 "plant Hall { lamp : Lamp; }"})
        answer = rmpl.check(plant, "hall.props", 'property "lit" { never lamp = lit; }\nproperty "dark" { never lamp = dark; }')
        self.assertEqual([claim["verdict"] for claim in answer["properties"]], ["violated", "violated"])
        with self.assertRaises(rmpl.Rejected):
            rmpl.check(plant, "hall.props", 'property "lit" { never lamp = green; }')

    def test_interruption(self):
        """A search that goes on for very long ends soon after Ctrl-C."""
        parts = "".join(f"  c{i} : C;\n" for i in range(24))
        plant = rmpl.compile(texts={"many.tcca": "component C { internal o : { x, y, z }; initial a; mode a { o = x }; mode b { o = y };"
                                                 " mode c { o = z }; a -> b in [1 s, 7 s]; b -> c in [2 s, 9 s]; c -> a in [3 s, 5 s]; }\n"
                                                 f"plant P {{\n{parts}}}"})
        threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
        start = time.monotonic()
        claims = " & ".join(f"c{i} = {'abc'[i % 3]}" for i in range(24))
        try:
            rmpl.check(plant, "all.props", f'property "all" {{ never {claims}; }}')
            time.sleep(2)
        except KeyboardInterrupt:
            pass
        self.assertLess(time.monotonic() - start, 20)


class Flights(unittest.TestCase):
    def test_views_are_those_of_the_program(self):
        scenario, name = EXAMPLES / "propulsion/burn.scn", "a valve sticks closed"
        flight = rmpl.fly(scenario, name)
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder)
            words = ["--only", name]
            for option in ("csv", "vcd", "mcap"):
                words += [f"--{option}", out / f"other.{option}"]
            told = run("rmpl-run", "scenario", scenario, *words, "--trace", out / "other.jsonl")
            for end in ("csv", "vcd", "mcap", "jsonl"):
                flight.save(out / f"own.{end}")
                self.assertEqual((out / f"own.{end}").read_bytes(), (out / f"other.{end}").read_bytes(), end)
            flight.save(out / "own.html")
            self.assertIn(flight.name, (out / "own.html").read_text())
            with self.assertRaises(rmpl.InputError):
                flight.save(out / "own.pdf")
        self.assertEqual(flight.story, told)
        answer = json.loads(run("rmpl-run", "scenario", scenario, "--only", name, "--format", "json"))
        self.assertEqual(flight.result, answer["scenarios"][0])
        self.assertEqual(flight.verdict, "met")

    def test_report_stands_in_a_notebook(self):
        shown = rmpl.fly(EXAMPLES / "propulsion/burn.scn", "fire and stop")._repr_html_()
        self.assertTrue(shown.startswith("<iframe"))
        self.assertIn("srcdoc=", shown)

    def test_choice_of_scenario(self):
        for name in (None, "no such flight"):
            with self.assertRaises(rmpl.InputError):
                rmpl.fly(EXAMPLES / "propulsion/burn.scn", name)

    def test_campaign(self):
        scenario, name = EXAMPLES / "propulsion/burn.scn", "fire and stop"
        rows = rmpl.campaign(scenario, name, runs=12, faults=1, seed=7)
        with tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder, "runs.csv")
            run("rmpl-run", "campaign", scenario, "--only", name, "--runs", 12, "--faults", 1, "--seed", 7, "--db", ":memory:", "--csv",
                table, "--at-most", "100%")
            expected = list(csv.DictReader(io.StringIO(table.read_text())))
        self.assertEqual([str(row["run"]) for row in rows], [row["run"] for row in expected])
        for row, other in zip(rows, expected):
            self.assertEqual((row["verdict"], str(row["cycles"]), row["faults"][0]["component"] + "=" + row["faults"][0]["mode"]),
                             (other["verdict"], other["cycles"], other["faults"]))
        with self.assertRaises(rmpl.InputError):
            rmpl.campaign(scenario, name, runs=1, faults=100)


if __name__ == "__main__":
    print(f"import: {1000 * IMPORT_SECONDS:.0f} ms")
    unittest.main(argv=sys.argv[:1])
