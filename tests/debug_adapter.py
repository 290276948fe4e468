#!/usr/bin/env python3
# The debug adapter, driven over standard input and output by a client of our own: every request, and abuse.
# SPDX-License-Identifier: MIT
"""Usage: debug_adapter.py ROOT PROGRAMS."""

import json
import os
import pathlib
import random
import select
import signal
import subprocess
import sys
import tempfile
import time

TIMEOUT = 60


class Client:
    """Speaks with one adapter. Events are kept until they are waited for."""

    def __init__(self, program: pathlib.Path):
        self.process = subprocess.Popen([program, "step", "--dap"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE)
        self.sequence = 0
        self.received = 0
        self.events: list[dict] = []
        self.bytes = b""

    def write(self, data: bytes) -> None:
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def message(self) -> dict:
        end = time.monotonic() + TIMEOUT
        while True:
            head, found, rest = self.bytes.partition(b"\r\n\r\n")
            if found:
                length = int(head.split(b":")[1])
                if len(rest) >= length:
                    self.bytes = rest[length:]
                    message = json.loads(rest[:length])
                    self.received += 1
                    assert message["seq"] == self.received, message
                    return message
            ready, _, _ = select.select([self.process.stdout], [], [], end - time.monotonic())
            assert ready, "no message in time"
            part = os.read(self.process.stdout.fileno(), 65536)
            assert part, f"the adapter is gone: {self.process.stderr.read()}"
            self.bytes += part

    def send(self, command: str, **arguments) -> int:
        self.sequence += 1
        text = json.dumps({"seq": self.sequence, "type": "request", "command": command, "arguments": arguments}).encode()
        self.write(b"Content-Length: %d\r\n\r\n%s" % (len(text), text))
        return self.sequence

    def answer(self, command: str, **arguments) -> dict:
        """The response, whether it is a success."""
        number = self.send(command, **arguments)
        while True:
            message = self.message()
            if message["type"] == "event":
                self.events.append(message)
                continue
            assert (message["request_seq"], message["command"]) == (number, command), message
            return message

    def request(self, command: str, **arguments) -> dict:
        message = self.answer(command, **arguments)
        assert message["success"], message
        return message.get("body", {})

    def refused(self, command: str, **arguments) -> str:
        message = self.answer(command, **arguments)
        assert not message["success"] and message["message"], message
        return message["message"]

    def event(self, name: str) -> dict:
        while True:
            for i, event in enumerate(self.events):
                if event["event"] == name:
                    del self.events[:i + 1]
                    return event["body"]
            message = self.message()
            assert message["type"] == "event", message
            self.events.append(message)

    def stopped(self, reason: str) -> dict:
        body = self.event("stopped")
        assert body["reason"] == reason, body
        return body

    def variables(self, scope: str) -> dict[str, str]:
        scopes = {s["name"]: s["variablesReference"] for s in self.request("scopes", frameId=1)["scopes"]}
        return {v["name"]: v["value"]
                for v in self.request("variables", variablesReference=scopes[scope])["variables"]}

    def end(self, over: bool = False) -> None:
        """`over`: the client has been told that the run is."""
        self.request("disconnect")
        if not over:
            self.event("terminated")
        assert self.process.wait(TIMEOUT) == 0


def line_of(path: pathlib.Path, text: str) -> int:
    return next(i for i, line in enumerate(path.read_text().splitlines(), 1) if text in line)


def launched(programs: pathlib.Path, **arguments) -> Client:
    client = Client(programs / "rmpl-run")
    body = client.request("initialize", adapterID="rmpl", linesStartAt1=True)
    assert body["supportsStepBack"] and body["supportsFunctionBreakpoints"] and body["supportsDataBreakpoints"]
    assert [f["filter"] for f in body["exceptionBreakpointFilters"]] == ["surprise", "noplan", "goal-conflict"]
    client.request("launch", **arguments)
    client.event("initialized")
    return client


def check_lines(root: pathlib.Path, programs: pathlib.Path) -> None:
    program = root / "examples/mars-entry/mars_entry.rmpl"
    plant = root / "examples/mars-entry/mars_lander.tcca"
    client = launched(programs, scenario=str(root / "examples/mars-entry/mars_entry.scn"), only="nominal flight")
    wanted = line_of(program, "nav = inertial")
    placed = client.request("setBreakpoints", source={"path": str(program)},
                            breakpoints=[{"line": wanted - 1}, {"line": 10_000}])["breakpoints"]
    assert placed[0]["verified"] and not placed[1]["verified"] and placed[1]["message"], placed
    placed = client.request("setBreakpoints", source={"path": str(program)}, breakpoints=[{"line": wanted}])["breakpoints"]
    assert placed[0]["verified"] and placed[0]["line"] == wanted, placed
    mode = client.request("setBreakpoints", source={"path": str(plant)},
                          breakpoints=[{"line": line_of(plant, "mode  standby")}])["breakpoints"][0]
    client.request("configurationDone")
    client.stopped("entry")
    frames = client.request("stackTrace", threadId=1)
    assert frames["stackFrames"][0]["name"] == "engine = standby", frames
    client.request("continue", threadId=1)
    assert client.stopped("breakpoint")["hitBreakpointIds"] == [mode["id"]]
    assert client.variables("Belief")["engine"] == "standby"
    client.request("continue", threadId=1)
    assert client.stopped("breakpoint")["hitBreakpointIds"] == [placed[0]["id"]]
    top = client.request("stackTrace", threadId=1)["stackFrames"][0]
    assert top["line"] == wanted and pathlib.Path(top["source"]["path"]).samefile(program), top
    decided = client.variables("Goal and command")
    assert decided["goal"].startswith("nav = inertial") and decided["command"] == "nav.cmd = to-inertial", decided
    here = client.variables("Belief"), decided["time"]
    client.request("next", threadId=1)
    client.stopped("step")
    assert client.variables("Belief")["nav"] == "inertial"
    client.request("stepBack", threadId=1)
    client.stopped("step")
    assert (client.variables("Belief"), client.variables("Goal and command")["time"]) == here
    client.request("reverseContinue", threadId=1)
    assert client.stopped("breakpoint")["hitBreakpointIds"] == [mode["id"]]
    client.request("reverseContinue", threadId=1)
    client.stopped("entry")
    assert "where the run starts" in client.refused("stepBack", threadId=1)
    client.end()


def check_conditions(root: pathlib.Path, programs: pathlib.Path) -> None:
    """A surprise is caught, and conditions on modes; the scenario dictates the reading."""
    client = launched(programs, scenario=str(root / "examples/safe-mode/safe_mode.scn"),
                      only="a reading that nothing explains", stopOnEntry=False)
    assert "no exception is called" in client.refused("setExceptionBreakpoints", filters=["surprse"])
    client.request("setExceptionBreakpoints", filters=["surprise"])
    placed = client.request("setFunctionBreakpoints", breakpoints=[
        {"name": "computer = safe"}, {"name": "computer = saf"}, {"name": "truth engine = burning"}])["breakpoints"]
    assert [p["verified"] for p in placed] == [True, False, True] and "saf" in placed[1]["message"], placed
    info = client.request("dataBreakpointInfo", name="computer", variablesReference=3)
    assert info["dataId"] == "truth computer", info
    assert client.request("dataBreakpointInfo", name="engine.thrust")["dataId"] is None
    client.request("setDataBreakpoints", breakpoints=[])
    client.request("configurationDone")
    assert "engine.thrust = full" in client.stopped("exception")["text"]
    assert client.variables("Readings")["engine.thrust"] == "full"
    assert client.variables("Goal and command")["time"].startswith("100 s")
    for expression, result in [("surprise", "true"), ("engine = off", "true"), ("truth engine = burning", "false"),
                               ("engine", "off"), ("engine.thrust", "full"), ("likely(battery = full, 0.9)", "true")]:
        assert client.request("evaluate", expression=expression)["result"] == result, expression
    assert "stanby" in client.refused("evaluate", expression="engine = stanby")
    client.request("continue", threadId=1)
    # The reading lasts three seconds, and the first of two hits of one cycle is told.
    client.stopped("exception")
    client.request("setExceptionBreakpoints", filters=[])
    client.request("stepBack", threadId=1)
    client.stopped("step")
    client.request("continue", threadId=1)
    assert client.stopped("function breakpoint")["hitBreakpointIds"] == [placed[0]["id"]]
    client.request("setDataBreakpoints", breakpoints=[{"dataId": "truth computer"}])
    client.request("setFunctionBreakpoints", breakpoints=[])
    client.request("stepBack", threadId=1)
    client.stopped("step")
    client.request("continue", threadId=1)
    client.stopped("data breakpoint")
    frames = client.request("stackTrace", threadId=1)["stackFrames"]
    assert frames[0]["name"] == "the program has ended", frames
    client.request("continue", threadId=1)
    client.stopped("pause")
    client.request("setDataBreakpoints", breakpoints=[])
    client.request("continue", threadId=1)
    client.event("terminated")
    client.end(over=True)


def check_pause(root: pathlib.Path, programs: pathlib.Path) -> None:
    """A run that goes on listens."""
    client = launched(programs, plant=str(root / "examples/safe-mode/satellite.tcca"), cycle="1 ms", duration="20 d",
                      stopOnEntry=False)
    client.request("configurationDone")
    client.request("threads")
    client.request("pause", threadId=1)
    client.stopped("pause")
    client.request("next", threadId=1)
    client.stopped("step")
    client.request("continue", threadId=1)
    client.end()


def check_choices(root: pathlib.Path, programs: pathlib.Path) -> None:
    """What is chosen in the console comes, and is undone by going back."""
    client = launched(programs, plant=str(root / "examples/safe-mode/satellite.tcca"), cycle=1)
    client.request("configurationDone")
    client.stopped("entry")
    client.request("next", threadId=1)
    client.stopped("step")
    client.request("evaluate", expression="fault gauge = blind", context="repl")
    client.request("evaluate", expression="command computer.cmd = to-safe", context="repl")
    client.request("evaluate", expression="observe engine.thrust = full for 1 s", context="repl")
    for wrong in ("fault gauge = blnd", "fault gauge.cmd = reset", "command gauge = blind", "observe gauge = blind", "observe engine.thrust = full for x"):
        client.refused("evaluate", expression=wrong, context="repl")
    assert client.variables("Goal and command")["command"] == "computer.cmd = to-safe"
    client.request("setFunctionBreakpoints", breakpoints=[{"name": "truth gauge = blind"}])
    client.request("next", threadId=1)
    client.stopped("function breakpoint")
    truth = client.variables("Truth")
    assert (truth["gauge"], truth["computer"]) == ("blind", "safe"), truth
    assert client.variables("Readings")["engine.thrust"] == "full"
    client.request("next", threadId=1)
    client.stopped("step")
    client.request("reverseContinue", threadId=1)
    client.stopped("function breakpoint")
    assert client.variables("Truth") == truth
    client.request("stepBack", threadId=1)
    client.stopped("step")
    client.request("next", threadId=1)
    client.stopped("step")
    assert client.variables("Truth")["gauge"] == "working"
    client.end()


def check_abuse(root: pathlib.Path, programs: pathlib.Path) -> None:
    client = Client(programs / "rmpl-run")
    for command in ("stackTrace", "next", "evaluate", "configurationDone", "setBreakpoints", "stepBack"):
        assert "launched" in client.refused(command), command
    assert "no request is called" in client.refused("nxt")
    assert "expected a `plant`" in client.refused("launch")
    assert "No such file" in client.refused("launch", plant="/no/such.tcca")
    assert "expected a duration" in client.refused("launch", plant="x.tcca", cycle=-1)
    with tempfile.TemporaryDirectory() as folder:
        wrong = pathlib.Path(folder) / "wrong.tcca"
        wrong.write_text("plant P {")
        assert "RMPL" in client.refused("launch", plant=str(wrong))
    for bad in (b"{", b"[]", b"null", b'{"type":"request"}', b'{"type":"request","command":7,"arguments":[]}'):
        client.write(b"Content-Length: %d\r\n\r\n%s" % (len(bad), bad))
    client.write(b"garbage\r\n\r\n")
    client.message()  # the answers to the two that are requests
    client.message()
    client.request("initialize")
    client.request("launch", plant=str(root / "examples/safe-mode/satellite.tcca"))
    assert "launches once" in client.refused("launch", plant=str(root / "examples/safe-mode/satellite.tcca"))
    for arguments in ({}, {"source": {"path": 7}}, {"source": {"path": "x"}, "breakpoints": [{}]},
                      {"source": {"path": "x"}, "breakpoints": 3}):
        client.refused("setBreakpoints", **arguments)
    client.end()


def check_nonsense(root: pathlib.Path, programs: pathlib.Path) -> None:
    """Arguments of any kind: each request has its answer, and the session goes on."""
    draw = random.Random(1)
    values = [None, 0, 1, -1, 2**64, 1.5, "", "engine", "engine = off", "truth gauge = blind", "fault gauge = blind", "repl", [], {}, [{}],
              [{"line": 1}], [{"line": -1}], [{"name": "surprise"}], [{"dataId": "engine"}], ["surprise"], {"path": "x.rmpl"}, True]
    keys = ["breakpoints", "filters", "source", "expression", "context", "name", "variablesReference", "frameId", "threadId", "startFrame",
            "levels", "program", "plant", "scenario", "seed", "cycle", "stopOnEntry"]
    commands = ["initialize", "launch", "setBreakpoints", "setFunctionBreakpoints", "setExceptionBreakpoints", "dataBreakpointInfo",
                "setDataBreakpoints", "threads", "stackTrace", "scopes", "variables", "evaluate", "continue", "next", "stepIn", "stepOut",
                "stepBack", "reverseContinue", "pause"]
    client = launched(programs, plant=str(root / "examples/safe-mode/satellite.tcca"), duration="1 min")
    for _ in range(1000):
        arguments = {draw.choice(keys): draw.choice(values) for _ in range(draw.randint(0, 3))}
        client.answer(draw.choice(commands), **arguments)
    client.answer("disconnect")
    assert client.process.wait(TIMEOUT) == 0


def check_ends(root: pathlib.Path, programs: pathlib.Path) -> None:
    """A client that goes, and a signal, end it."""
    client = launched(programs, plant=str(root / "examples/safe-mode/satellite.tcca"))
    client.process.stdin.close()
    assert client.process.wait(TIMEOUT) == 1
    client = launched(programs, plant=str(root / "examples/safe-mode/satellite.tcca"))
    client.process.send_signal(signal.SIGTERM)
    assert client.process.wait(TIMEOUT) == 3


def main() -> int:
    root, programs = map(pathlib.Path, sys.argv[1:])
    checks = [check_lines, check_conditions, check_pause, check_choices, check_abuse, check_nonsense, check_ends]
    for check in checks:
        check(root.resolve(), programs)
    print(f"{len(checks)} sessions of a debugger")
    return 0


if __name__ == "__main__":
    sys.exit(main())
