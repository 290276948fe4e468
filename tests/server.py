#!/usr/bin/env python3
# The language server, driven over standard input and output by a client of our own: every capability, and abuse.
# SPDX-License-Identifier: MIT
"""Usage: server.py ROOT PROGRAMS."""

import json
import os
import pathlib
import shutil
import subprocess
import sys

import cases

TIMEOUT = 60
ENGINE = """domain Level = { low, high };

// An engine.
component Engine {
  input  cmd  : { none, on, off };
  output temp : Level;
  initial off;
  mode  off { temp = low };
  // It is warm.
  mode  on  { temp = high };
  fault broken;
  off -> on  when cmd = on after 5 s;
  on  -> off when cmd = off;
  any -> broken with 0.001;
}
"""
PLANT = """import "engine.tcca";

plant Ship {
  engine, spare : Engine;
  control engine.cmd, spare.cmd default none;
  observe engine.temp, spare.temp;
}
"""
PROGRAM = """// Starts the ship.
Start() :: {
  engine = on;
  t1 = 0;
  when t1 >= 5 s & engine.temp = high donext Stop(spare)
}

Stop(what) :: { engine = off }
"""
SCENARIO = """scenario "start" {
  program "start.rmpl" main Start;
  plant "ship.tcca";
  cycle 1 s;
  duration 60 s;
  seed 1;
  expect engine = on within 20 s;
}
"""
FILES = {"engine.tcca": ENGINE, "ship.tcca": PLANT, "start.rmpl": PROGRAM, "start.scn": SCENARIO}


class Client:
    """Speaks with one server. What it is told without asking is kept."""

    def __init__(self, program: pathlib.Path, folder: pathlib.Path):
        self.folder = folder
        self.process = subprocess.Popen([program, "server", "--stdio"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.id = 0
        self.versions: dict[str, int] = {}
        self.diagnostics: dict[str, dict] = {}
        self.told: list[dict] = []

    def write(self, text: bytes) -> None:
        self.process.stdin.write(text)
        self.process.stdin.flush()

    def send(self, **message) -> None:
        text = json.dumps({"jsonrpc": "2.0", **message}, ensure_ascii=False).encode()
        self.write(b"Content-Length: %d\r\n\r\n" % len(text) + text)

    def read(self) -> dict:
        length = 0
        while line := self.process.stdout.readline().strip():
            name, _, value = line.partition(b":")
            assert name == b"Content-Length", line
            length = int(value)
        assert length > 0, "the server has ended: " + self.process.stderr.read().decode()
        message = json.loads(self.process.stdout.read(length))
        assert message["jsonrpc"] == "2.0", message
        if message.get("method") == "textDocument/publishDiagnostics":
            self.diagnostics[message["params"]["uri"]] = message["params"]
        elif "method" in message:
            self.told.append(message)
        return message

    def answer(self, identity) -> dict:
        while True:
            message = self.read()
            if "method" not in message and message["id"] == identity:
                return message

    def ask(self, method: str, **params):
        self.id += 1
        self.send(id=self.id, method=method, params=params)
        return self.answer(self.id)

    def get(self, method: str, **params):
        answer = self.ask(method, **params)
        assert "error" not in answer, answer
        return answer["result"]

    def refused(self, method: str, **params) -> str:
        answer = self.ask(method, **params)
        assert "error" in answer, answer
        return answer["error"]["message"]

    def notify(self, method: str, **params) -> None:
        self.send(method=method, params=params)

    def start(self, root=None) -> dict:
        result = self.get("initialize", processId=None, rootUri=root and root.as_uri(), capabilities={})
        self.notify("initialized")
        return result

    def end(self) -> None:
        assert self.get("shutdown") is None
        self.notify("exit")
        assert self.process.wait(TIMEOUT) == 0
        assert self.process.stdout.read() == b"" and self.process.stderr.read() == b""

    # Documents.

    def uri(self, name: str) -> str:
        return (self.folder / name).as_uri()

    def open(self, name: str, text: str | None = None) -> None:
        text = (self.folder / name).read_text(encoding="utf-8") if text is None else text
        self.versions[name] = 1
        language = name.rpartition(".")[2]
        self.notify("textDocument/didOpen", textDocument={"uri": self.uri(name), "languageId": language, "version": 1, "text": text})

    def change(self, name: str, text: str, start=None, end=None) -> None:
        self.versions[name] += 1
        change = {"text": text}
        if start is not None:
            change["range"] = {"start": place(*start), "end": place(*end)}
        self.notify("textDocument/didChange", textDocument={"uri": self.uri(name), "version": self.versions[name]}, contentChanges=[change])

    def at(self, name: str, line: int, character: int) -> dict:
        return {"textDocument": {"uri": self.uri(name)}, "position": place(line, character)}

    def findings(self, name: str) -> list[str]:
        """The diagnostics of the version that was sent last, as `code line:character message`."""
        while (told := self.diagnostics.get(self.uri(name))) is None or told.get("version", -1) != self.versions.get(name, -1):
            self.read()
        return [f"{d['code']} {d['range']['start']['line']}:{d['range']['start']['character']} {d['message'].splitlines()[0]}" for d in told["diagnostics"]]


def place(line: int, character: int) -> dict:
    return {"line": line, "character": character}


def same(found, expected) -> None:
    assert found == expected, f"\n  found    {found}\n  expected {expected}"


def spots(client: Client, locations: list[dict]) -> list[str]:
    """`file line:character-character`."""
    return [f"{pathlib.Path(at['uri']).name} {r['start']['line']}:{r['start']['character']}-{r['end']['character']}"
            for at in locations for r in (at["range"],)]


def lifecycle(program, folder):
    client = Client(program, folder)
    same(client.ask("textDocument/hover", **client.at("a.tcca", 0, 0))["error"]["code"], -32002)
    result = client.start()
    same(result["serverInfo"]["name"], "rmplc")
    same(client.ask("initialize", capabilities={})["error"]["code"], -32600)
    same(client.ask("no/such")["error"]["code"], -32601)
    same(client.ask("$/nothing")["error"]["code"], -32601)
    same(client.ask("textDocument/hover", **client.at("a.tcca", 0, 0))["error"]["code"], -32602)
    same(client.ask("textDocument/hover")["error"]["code"], -32602)
    client.notify("$/nothing")
    client.send(id=77, method="textDocument/hover", params={})
    client.send(method="$/cancelRequest", params={"id": 77})
    assert client.answer(77)["error"]["code"] in (-32800, -32602)
    same(client.get("shutdown"), None)
    same(client.ask("textDocument/hover")["error"]["code"], -32600)
    client.notify("exit")
    same(client.process.wait(TIMEOUT), 0)
    for unfinished in (lambda c: c.notify("exit"), lambda c: c.process.stdin.close()):
        client = Client(program, folder)
        client.start()
        unfinished(client)
        same(client.process.wait(TIMEOUT), 1)


def abuse(program, folder):
    client = Client(program, folder)
    client.write(b"garbage\r\nmore of it\r\n\r\n\r\n")
    same(client.read()["error"]["code"], -32700)
    client.write(b"Content-Length: many\r\n\r\n{}")
    client.write(b"\r\n\r\n")
    client.write(b"x" * 10_000 + b"\n")
    client.start()
    for body, code in ((b"{", -32700), (b'{"jsonrpc":"2.0","id":1,"method":"\xff"}', -32700), (b"[]", -32600), (b"1", -32600), (b"{}", -32600),
                       (b'{"jsonrpc":"2.0","id":{},"method":"a"}', -32600), (b'{"jsonrpc":"2.0","id":5,"method":"a","params":1}', -32600),
                       (b'{"jsonrpc":"1.0","id":5,"method":"a"}', -32600), (b"[" * 100_000, -32700)):
        client.write(b"content-length:%d\r\nContent-Type: application/vscode-jsonrpc; charset=utf-8\r\n\r\n" % len(body) + body)
        message = client.read()
        same((message["error"]["code"], body), (code, body))
    huge = 64 * 2**20 + 1
    client.write(b"Content-Length: %d\r\n\r\n" % huge + b" " * huge)
    same(client.read()["error"]["code"], -32700)
    client.notify("textDocument/didOpen", textDocument={"uri": 1})
    client.notify("textDocument/didChange", textDocument={"uri": client.uri("none.tcca")}, contentChanges=[])
    client.notify("textDocument/didOpen", textDocument={"uri": "file:///" + "a" * 5000 + ".tcca", "text": ""})
    client.notify("textDocument/didOpen", textDocument={"uri": "untitled:Untitled-1", "languageId": "tcca", "version": 1, "text": "component {"})
    while "untitled:Untitled-1" not in client.diagnostics:
        client.read()
    same(client.diagnostics["untitled:Untitled-1"]["diagnostics"][0]["code"], "RMPL0001")
    same([m["method"] for m in client.told[:3]], ["window/logMessage"] * 3)
    client.end()
    client = Client(program, folder)
    client.start()
    client.write(b"Content-Length: 99999999999999999\r\n\r\n{")
    client.process.stdin.close()
    same(client.process.wait(TIMEOUT), 1)


def hovers(client: Client, name: str, line: int, character: int) -> str:
    result = client.get("textDocument/hover", **client.at(name, line, character))
    return result["contents"]["value"] if result else ""


def diagnostics(program, folder):
    client = Client(program, folder)
    client.start()
    client.open("start.rmpl")
    same(client.findings("start.rmpl"), [])
    client.change("start.rmpl", "engin", (2, 2), (2, 8))  # engine = on
    same(client.findings("start.rmpl"), ["RMPL0308 2:2 plant `Ship` has no variable `engin`"])
    actions = client.get("textDocument/codeAction", textDocument={"uri": client.uri("start.rmpl")},
                         range={"start": place(2, 3), "end": place(2, 3)}, context={"diagnostics": []})
    same([a["title"] for a in actions], ["did you mean `engine`?"])
    same(actions[0]["edit"]["changes"], {client.uri("start.rmpl"): [{"range": {"start": place(2, 2), "end": place(2, 7)}, "newText": "engine"}]})
    assert "**RMPL0308**" in hovers(client, "start.rmpl", 2, 3)
    client.change("start.rmpl", "engine", (2, 2), (2, 7))
    same(client.findings("start.rmpl"), [])
    # Two units of UTF-16 for one character; a change of several lines; a change of all.
    client.change("start.rmpl", "/* \U0001F680 */ engine = offf", (2, 2), (2, 13))
    same(client.findings("start.rmpl"), ["RMPL0102 2:20 `offf` is no value of `engine`, expected `off`, `on` or `broken`"])
    client.change("start.rmpl", "  engine = on;\n  t1 = 0;", (2, 0), (3, 9))
    same(client.findings("start.rmpl"), [])
    # What is not saved in one file is seen from another.
    client.open("engine.tcca")
    client.change("engine.tcca", ENGINE.replace("on  {", "lit {").replace("-> on ", "-> lit ").replace("  on ", "  lit "))
    found = client.findings("start.rmpl")
    while not found:
        client.read()
        found = client.findings("start.rmpl")
    same(found, ["RMPL0102 2:11 `on` is no value of `engine`, expected `off`, `lit` or `broken`"])
    client.notify("textDocument/didClose", textDocument={"uri": client.uri("engine.tcca")})
    client.get("textDocument/foldingRange", textDocument={"uri": client.uri("start.rmpl")})
    while client.findings("start.rmpl"):
        client.read()
    # What is no regular file is not read, and not waited for.
    os.mkfifo(folder / "pipe.rmpl")
    for name in ("pipe.rmpl", "/dev/zero"):
        client.change("start.rmpl", f'import "{name}"; ', (0, 0), (0, 0))
        assert "no regular file" in client.findings("start.rmpl")[0], client.findings("start.rmpl")
        client.change("start.rmpl", "", (0, 0), (0, len(f'import "{name}"; ')))
        same(client.findings("start.rmpl"), [])
    (folder / "pipe.rmpl").unlink()
    # A file of properties, with the plant beside it; a file that nothing uses.
    client.open("ship.props", 'property "p" { never engine = brokn; }')
    same([f[:13] for f in client.findings("ship.props")], ["RMPL0102 0:30"])
    client.open("part.rmpl", "A(x) :: { x }  B() :: { y = 0; when y > 1 s donext A(a = b) } C() :: { a = b }")
    same(client.findings("part.rmpl"), [])
    client.end()


def lints(program, folder):
    """Lint comes after a pause, in the background, and goes with the edit that mends what it found."""

    def wait_for(expected: list[str]) -> None:
        while [" ".join(finding.split()[:2]) for finding in client.findings("start.rmpl")] != expected:
            client.read()

    client = Client(program, folder)
    client.start()
    client.open("start.rmpl")
    same(client.findings("start.rmpl"), [])
    wait_for(["RMPL0510 7:5"])
    assert "**RMPL0510**" in hovers(client, "start.rmpl", 7, 6)
    client.change("start.rmpl", "what", (7, 16), (7, 22))  # what = off
    wait_for([])
    client.change("start.rmpl", "engin", (2, 2), (2, 8))  # what does not compile is not linted
    wait_for(["RMPL0308 2:2"])
    for _ in range(20):  # an edit overtakes the lint of the one before it
        client.change("start.rmpl", PROGRAM)
    wait_for(["RMPL0510 7:5"])
    client.change("start.rmpl", PROGRAM.replace("{ engine = off }", "{ what = off; what = on, spare = off }"))
    while not any(finding.startswith("RMPL0514") for finding in client.findings("start.rmpl")):
        client.read()
    actions = client.get("textDocument/codeAction", textDocument={"uri": client.uri("start.rmpl")},
                         range={"start": place(7, 0), "end": place(7, 60)}, context={"diagnostics": []})
    same([edit["newText"] for edit in actions[0]["edit"]["changes"][client.uri("start.rmpl")]], ["{ ", " }"])
    client.change("start.rmpl", PROGRAM.replace("  engine = on;", "  clock idle;\n  engine = on;", 1).replace("{ engine", "{ what"))
    wait_for(["RMPL0511 2:8"])
    actions = client.get("textDocument/codeAction", textDocument={"uri": client.uri("start.rmpl")},
                         range={"start": place(2, 9), "end": place(2, 9)}, context={"diagnostics": []})
    same(actions[0]["title"], "remove it")
    same(actions[0]["edit"]["changes"][client.uri("start.rmpl")],
         [{"range": {"start": place(2, 0), "end": place(3, 0)}, "newText": ""}])
    (folder / "rmpl.ini").write_text("[lint]\nunused = of\n", encoding="utf-8")
    client.change("start.rmpl", PROGRAM)
    while not any("not linted" in told["params"].get("message", "") for told in client.told):
        client.read()
    (folder / "rmpl.ini").write_text("[lint]\nunused = off\n", encoding="utf-8")
    client.change("start.rmpl", PROGRAM + "\n")
    client.change("start.rmpl", PROGRAM)
    same(client.findings("start.rmpl"), [])
    client.end()


def projects(program, folder):
    """Files of a project belong together, wherever they are."""
    subprocess.run([program, "new", "-q", "demo"], cwd=folder, check=True)
    demo = folder / "demo"

    def told(name, old, new, wanted):
        client = Client(program, demo)
        client.start()
        text = (demo / name).read_text(encoding="utf-8")
        client.open(name, text)
        same(client.findings(name), [])
        assert old in text
        client.change(name, text.replace(old, new))
        same([finding.split(" `")[0] for finding in client.findings(name)], wanted)
        client.end()

    told("program/fill.rmpl", "pump = broken", "pump = brokem", ["RMPL0102 8:21"])
    told("properties/station.props", "reach pump", "reach pomp", ["RMPL0308 3:8 plant"])
    told("plant/station.tcca", "open   -> closed", "open   -> closet", ["RMPL0100 11:12 component"])
    # Without a scenario the project says what the program runs on.
    manifest = demo / "rmpl.toml"
    lines = manifest.read_text(encoding="utf-8").splitlines(keepends=True)
    manifest.write_text("".join(line for line in lines if not line.startswith("scenarios")), encoding="utf-8")
    told("program/fill.rmpl", "pump = broken", "pump = brokem", ["RMPL0102 8:21"])
    # A manifest that is wrong leaves the files by themselves.
    manifest.write_text("[set.fill\n", encoding="utf-8")
    told("program/fill.rmpl", "pump = broken", "pump = brokem", [])


def pages(program, folder):
    """An installed server says where the page of a code is."""
    (folder / "bin").mkdir()
    installed = shutil.copy(program, folder / "bin")
    page = folder / "share/doc/rmpl/docs/diagnostics/RMPL0308.md"
    for there in (False, True):
        if there:
            page.parent.mkdir(parents=True)
            page.touch()
        client = Client(pathlib.Path(installed), folder)
        client.start()
        client.open("start.rmpl", PROGRAM.replace("engine = on", "engin = on", 1))
        same([finding.split()[0] for finding in client.findings("start.rmpl")], ["RMPL0308"])
        one = client.diagnostics[client.uri("start.rmpl")]["diagnostics"][0]
        same(one.get("codeDescription"), {"href": page.as_uri()} if there else None)
        client.end()


def everywhere_named(program, folder):
    """What is declared anywhere in the workspace, by name."""
    (folder / "ship.props").write_text('property "it starts" {\n  reach engine = on;\n}\n', encoding="utf-8")
    client = Client(program, folder)
    client.start(folder)
    client.open("start.rmpl", PROGRAM + "\nStartAgain() :: { Start() }\n")

    def found(query):
        return [(s["name"], s["location"]["uri"].rpartition("/")[2], s["location"]["range"]["start"]["line"], s["containerName"])
                for s in client.get("workspace/symbol", query=query)]

    same(found("engine"), [("Engine", "engine.tcca", 3, ""), ("engine", "ship.tcca", 3, "Ship")])
    same(found("brkn"), [("broken", "engine.tcca", 10, "Engine")])
    same(found("start"), [("it starts", "ship.props", 0, ""), ("Start", "start.rmpl", 1, ""), ("StartAgain", "start.rmpl", 9, ""), ("start", "start.scn", 0, "")])
    same(found("it starts"), [("it starts", "ship.props", 0, "")])
    same(found("nothing of that name"), [])
    client.end()


def formats(program, folder):
    client = Client(program, folder)
    client.start()
    client.open("start.rmpl", "S()::{a=b;// why\n c=d}")
    uri = {"uri": client.uri("start.rmpl")}
    edits = client.get("textDocument/formatting", textDocument=uri, options={"tabSize": 2, "insertSpaces": True})
    same([e["range"] for e in edits], [{"start": place(0, 0), "end": place(1, 5)}])
    client.change("start.rmpl", edits[0]["newText"])
    assert "a = b;" in edits[0]["newText"] and "// why" in edits[0]["newText"], edits
    same(client.get("textDocument/formatting", textDocument=uri, options={}), [])
    client.change("start.rmpl", "S( {")
    assert "syntax" in client.refused("textDocument/formatting", textDocument=uri, options={})
    client.end()


def names(program, folder):
    client = Client(program, folder)
    client.start()
    for name in ("start.rmpl", "ship.tcca", "engine.tcca"):
        client.open(name)

    def defined(name, line, character):
        at = client.get("textDocument/definition", **client.at(name, line, character))
        return spots(client, [at])[0] if at else None

    same(defined("start.rmpl", 2, 4), "ship.tcca 3:2-8")
    same(defined("start.rmpl", 2, 12), "engine.tcca 9:8-10")
    same(defined("start.rmpl", 4, 28), "engine.tcca 5:9-13")
    same(defined("start.rmpl", 4, 35), "engine.tcca 0:22-26")
    same(defined("start.rmpl", 4, 8), "start.rmpl 3:2-4")
    same(defined("start.rmpl", 4, 46), "start.rmpl 7:0-4")
    same(defined("ship.tcca", 0, 12), "engine.tcca 0:0-0")
    same(defined("start.rmpl", 5, 0), None)
    uses = client.get("textDocument/references", **client.at("engine.tcca", 9, 9), context={"includeDeclaration": True})
    same(spots(client, uses), ["engine.tcca 9:8-10", "engine.tcca 11:9-11", "engine.tcca 12:2-4", "start.rmpl 2:11-13", "start.scn 6:18-20"])
    uses = client.get("textDocument/references", **client.at("ship.tcca", 3, 3), context={"includeDeclaration": False})
    same(spots(client, uses), ["ship.tcca 4:10-16", "ship.tcca 5:10-16", "start.rmpl 2:2-8", "start.rmpl 4:19-25", "start.rmpl 7:16-22", "start.scn 6:9-15"])
    marks = client.get("textDocument/documentHighlight", **client.at("ship.tcca", 4, 22))
    same([m["range"]["start"] for m in marks], [place(3, 10), place(4, 22), place(5, 23)])

    text = hovers(client, "start.rmpl", 2, 12)
    for part in ("mode on { temp = high };", "out of it", "on -> off when cmd = off;", "any -> broken with 0.001;", "into it", "off -> on when cmd = on after 5 s;", "It is warm."):
        assert part in text, text
    assert text.count("any -> broken") == 1, text
    text = hovers(client, "start.rmpl", 4, 28)
    assert "output temp : Level;" in text and "domain Level = { low, high };" in text, text
    assert "It starts in line 4." in hovers(client, "start.rmpl", 4, 8)
    text = hovers(client, "start.scn", 0, 0) if "start.scn" in client.versions else hovers(client, "start.rmpl", 4, 46)
    assert "Stop(what)" in text, text
    text = hovers(client, "ship.tcca", 3, 3)
    assert "engine, spare : Engine;" in text and "An engine." in text and "initial off;" in text, text
    same(hovers(client, "start.rmpl", 5, 0), "")
    client.end()


def renaming(program, folder):
    client = Client(program, folder)
    client.start()
    client.open("ship.tcca")
    client.open("start.rmpl")
    at = client.at("start.rmpl", 4, 20)
    same(client.get("textDocument/prepareRename", **at), {"range": {"start": place(4, 19), "end": place(4, 25)}, "placeholder": "engine"})
    changes = client.get("textDocument/rename", **at, newName="main-engine")["changes"]
    same({pathlib.Path(uri).name: [e["range"]["start"]["character"] for e in edits] for uri, edits in changes.items()},
         {"ship.tcca": [2, 10, 10], "start.rmpl": [2, 19, 16], "start.scn": [9]})
    changes = client.get("textDocument/rename", **client.at("start.rmpl", 4, 28), newName="heat")["changes"]
    same(sorted(pathlib.Path(uri).name for uri in changes), ["engine.tcca", "ship.tcca", "start.rmpl"])
    for new, why in (("1x", "is no name"), ("a.b", "is no name"), ("watching", "word of the language"), ("spare", "already"), ("", "is no name")):
        said = client.refused("textDocument/rename", **at, newName=new)
        assert why in said, said
    said = client.refused("textDocument/rename", **client.at("start.rmpl", 7, 6), newName="engine")
    assert "meaning" in said or "would be wrong" in said, said
    client.refused("textDocument/prepareRename", **client.at("start.rmpl", 5, 0))
    client.open("broken.rmpl", "P() :: { Q() } Q( :: { x = y }")
    said = client.refused("textDocument/rename", **client.at("broken.rmpl", 0, 0), newName="R")
    assert "syntax errors" in said, said
    client.end()


def renaming_everywhere(program, folder):
    """What uses a library lies in other folders, open or not; a program that fits no plant of it is another's."""
    texts = {
        "lib/bus.tcca": "component Bus {\n  input cmd : { none, go };\n\n  initial unpowered;\n  mode unpowered;\n  mode powered;\n\n"
                        "  unpowered -> powered when cmd = go;\n}\n",
        "lib/plant.tcca": 'import "bus.tcca";\nplant P { bus : Bus; control bus.cmd default none; }\n',
        "other/plant.tcca": 'import "../lib/bus.tcca";\nplant P { bus : Bus; control bus.cmd default none; }\n',
        "other/p.rmpl": "Main() :: { bus = powered }\n",
        "flights/p.scn": 'scenario "s" { program "../other/p.rmpl"; plant "../lib/plant.tcca"; expect bus = powered within 1 s; }\n',
        "props/p.props": 'property "x" { reach bus = powered; }\n',
        "props/q.props": 'property "x" { reach radio = powered; }\n',
        ".hidden/p.rmpl": "Main() :: { bus = powered }\n",
        "style/bus.tcca": 'import "../lib/bus.tcca";\n\nplant Q {\n  bus : Bus;\n\n  bus = powered | bus = unpowered;  // always\n  control bus.cmd default none;      // the switch\n}\n',
    }
    root = folder / "everywhere"
    for name, text in texts.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text, encoding="utf-8")
    client = Client(program, root)
    client.start(root)
    client.open("lib/bus.tcca")
    at = client.at("lib/bus.tcca", 5, 7)
    found = client.get("textDocument/references", **at, context={"includeDeclaration": True})
    changes = client.get("textDocument/rename", **at, newName="live")["changes"]
    names = sorted(str(pathlib.Path(uri.removeprefix("file://")).relative_to(root)) for uri in changes)
    same(names, ["flights/p.scn", "lib/bus.tcca", "other/p.rmpl", "props/p.props", "style/bus.tcca"])
    same(len(found), 6)
    client.end()


def completing(program, folder):
    client = Client(program, folder)
    client.start()
    client.open("ship.tcca")
    client.open("engine.tcca")
    client.open("start.rmpl")

    def offered(name: str, text: str, more: str = "") -> list[str]:
        """What is offered behind a text."""
        client.change(name, text + more)
        lines = text.split("\n")
        items = client.get("textDocument/completion", **client.at(name, len(lines) - 1, len(lines[-1])))["items"]
        return [i["label"] for i in sorted(items, key=lambda i: i["sortText"])]

    same(offered("start.rmpl", "Start() :: { engine = "), ["broken", "off", "on", "false", "true"])
    same(offered("start.rmpl", "Start() :: { engine = o", "; }"), ["broken", "off", "on", "false", "true"])
    same(offered("start.rmpl", "Start() :: { when engine.temp = "), ["high", "low", "false", "true"])
    same(offered("start.rmpl", "Start() :: { when engine in { on, "), ["broken", "off", "on", "false", "true"])
    same(offered("start.rmpl", "Start() :: { when engine."), ["engine.cmd", "engine.temp"])
    found = offered("start.rmpl", "Start() :: { engine = on; ", " } Stop() :: { engine = off }")
    for label in ("engine", "spare", "Stop", "always", "if", "do", "whenever", "unless", "choose", "next", "when"):
        assert label in found, (label, found)
    assert "mode" not in found and "thennext" not in found, found
    same(offered("start.rmpl", "Start() :: { when engine = on "), ["and", "donext", "or"])
    assert "maintaining" in offered("start.rmpl", "Start() :: { engine = on ")
    same(offered("start.rmpl", "Start() :: { do engine = on // engine = "), [])
    same(offered("start.rmpl", 'import "'), [] )
    found = offered("engine.tcca", ENGINE[: ENGINE.index("off -> on")], "}")
    for label in ("off", "on", "broken", "input", "mode", "fault", "any"):
        assert label in found, (label, found)
    same(offered("engine.tcca", ENGINE[: ENGINE.index("on  when")], ";\n}\n"), ["broken", "off", "on", "after", "in", "when"])
    same(offered("engine.tcca", ENGINE[: ENGINE.index("Level;")], ";\n}\n"), ["Level"])
    mode = ENGINE.index("temp = low")
    same(offered("engine.tcca", ENGINE[:mode] + "temp = ", ENGINE[mode + len("temp = low") :]), ["high", "low", "false", "true"])
    for rest in (ENGINE[mode + len("temp = low") :], " } " + ENGINE[mode + len("temp = low") :], ""):  # nothing is closed yet
        same(offered("engine.tcca", ENGINE[:mode] + "temp in { ", rest), ["high", "low", "false", "true"])
    same(offered("engine.tcca", ENGINE[:mode] + "temp = "), ["high", "low", "false", "true"])
    assert "min" in offered("engine.tcca", ENGINE[: ENGINE.index("0.001")] + "rate 1e-6 / ", ";\n}\n")
    client.change("engine.tcca", ENGINE)
    for rest in (" }; }", ""):
        same(offered("ship.tcca", PLANT[: PLANT.index(";\n  control")] + " { initial ", rest), ["broken", "off", "on"])
    same(offered("ship.tcca", PLANT[: PLANT.index("Engine;")], ";\n}\n"), ["Engine", "model"])
    same(offered("ship.tcca", PLANT[: PLANT.index("none;")], ";\n}\n"), ["none", "off", "on", "false", "true"])
    same(offered("ship.tcca", PLANT[: PLANT.index("engine.temp")] + "engine.", ";\n}\n"), ["engine.cmd", "engine.temp"])
    same(offered("ship.tcca", ""), ["component", "domain", "import", "module", "plant", "progress"])
    same(offered("ship.tcca", 'import "'), ['"engine.tcca"'])
    client.change("ship.tcca", PLANT)
    client.open("start.scn")
    same(offered("start.scn", SCENARIO[: SCENARIO.index("on within")], ";\n}\n"), ["broken", "off", "on", "false", "true"])
    assert "min" in offered("start.scn", 'scenario "s" { cycle 1 ')
    named = 'scenario "s" {\n  program "start.rmpl" main '
    client.change("start.rmpl", PROGRAM)
    for text, rest in ((named, ""), (named, ";\n}\n"), (named + "St", "\n}\n"), (named, ';\n  plant "ship.tcca";\n}\n')):
        same(offered("start.scn", text, rest), ["Start"])  # Stop takes a parameter
    same(offered("start.scn", named.replace("start.rmpl", "none.rmpl")), [])
    assert {"expect", "at", "when", "seed", "truth"} <= set(offered("start.scn", 'scenario "s" { cycle 1 s; '))
    client.end()


def outline(program, folder):
    client = Client(program, folder)
    legend = client.start()["capabilities"]["semanticTokensProvider"]["legend"]
    client.open("engine.tcca")
    client.open("start.rmpl")
    uri = {"uri": client.uri("engine.tcca")}
    symbols = client.get("textDocument/documentSymbol", textDocument=uri)
    same([s["name"] for s in symbols], ["Level", "Engine"])
    same([s["name"] for s in symbols[1]["children"]], ["cmd", "temp", "off", "on", "broken"])
    folds = client.get("textDocument/foldingRange", textDocument=uri)
    same([(f["startLine"], f["endLine"]) for f in folds], [(3, 13)])
    text = 'import "engine.tcca"; import "none.tcca"; Wait() :: { t = 0; when t >= 16830 s donext true } // 90 s\n'
    client.open("slow.rmpl", text)
    links = client.get("textDocument/documentLink", textDocument={"uri": client.uri("slow.rmpl")})
    same([(link["target"].rsplit("/", 1)[1], link["range"]["start"]["character"]) for link in links], [("engine.tcca", 8)])
    hints = client.get("textDocument/inlayHint", textDocument={"uri": client.uri("slow.rmpl")},
                       range={"start": {"line": 0, "character": 0}, "end": {"line": 1, "character": 0}})
    same([(text[: hint["position"]["character"]][-7:], hint["label"]) for hint in hints], [("16830 s", "(4:40:30)")])
    data = client.get("textDocument/semanticTokens/full", textDocument={"uri": client.uri("start.rmpl")})["data"]
    line = character = 0
    seen = []
    rows = PROGRAM.split("\n")
    for down, right, length, kind, declared in zip(*[iter(data)] * 5):
        line, character = line + down, right if down else character + right
        seen.append((rows[line][character : character + length], legend["tokenTypes"][kind], declared))
    same(seen[:7], [("// Starts the ship.", "comment", 0), ("Start", "function", 1), ("engine", "variable", 0), ("on", "enumMember", 0), ("t1", "event", 1), ("0", "number", 0), ("when", "keyword", 0)])
    same(seen[10:14], [("engine", "variable", 0), ("temp", "property", 0), ("high", "enumMember", 0), ("donext", "keyword", 0)])
    client.end()


def lenses(program, folder):
    """What can be done with a scenario, a property and a program, as a call of a program that is there."""

    def found(name):
        return [(lens["range"]["start"]["line"], lens["command"]["title"], lens["command"]["command"], lens["command"]["arguments"][0])
                for lens in client.get("textDocument/codeLens", textDocument={"uri": client.uri(name)})]

    def run(argument, folder):
        """The exit code of what a lens runs."""
        same(argument["folder"], str(folder))
        beside = program.parent / argument["program"]
        return subprocess.run([beside, *argument["arguments"]], cwd=argument["folder"], capture_output=True, check=False).returncode

    client = Client(program, folder)
    client.start(folder)
    client.open("start.scn")
    told = found("start.scn")
    same([one[:3] for one in told], [(0, "fly", "rmpl.run"), (0, "debug", "rmpl.debug")])
    same(run(told[0][3], folder), 0)
    same(told[1][3], {"type": "rmpl", "request": "launch", "name": "start", "scenario": str(folder / "start.scn"), "only": "start"})
    client.change("start.scn", SCENARIO + SCENARIO.replace('"start"', '"once more"'))
    same([one[:2] for one in found("start.scn")], [(0, "fly all"), (0, "fly"), (0, "debug"), (8, "fly"), (8, "debug")])
    client.open("start.rmpl")
    told = found("start.rmpl")
    same([one[:3] for one in told], [(1, "check", "rmpl.run")])  # Stop takes a parameter
    same(told[0][3]["arguments"], ["program", str(folder / "start.rmpl"), str(folder / "ship.tcca"), "--main", "Start"])
    assert run(told[0][3], folder) in (0, 1)
    client.open("ship.tcca")
    same(found("ship.tcca"), [])
    # Properties: of a plant, and of the program of that name once it is there.
    properties = 'property "p" { reach engine = on; }\nproperty "q" { program terminates; faults 1; }\n'
    (folder / "ship.props").write_text(properties, encoding="utf-8")
    client.open("ship.props")
    told = found("ship.props")
    same([one[:2] for one in told], [(0, "check")])
    same(run(told[0][3], folder), 0)
    (folder / "ship.rmpl").write_text("Fly() :: { engine = on }\n", encoding="utf-8")
    told = found("ship.props")
    same([one[:2] for one in told], [(0, "check all"), (0, "check"), (1, "check")])
    assert run(told[2][3], folder) in (0, 1)
    # What is no file cannot be read by a program.
    client.notify("textDocument/didOpen", textDocument={"uri": "untitled:a", "languageId": "scn", "version": 1, "text": SCENARIO})
    same(client.get("textDocument/codeLens", textDocument={"uri": "untitled:a"}), [])
    client.end()
    subprocess.run([program, "new", "-q", "demo"], cwd=folder, check=True)
    client = Client(program, folder / "demo")
    client.start(folder / "demo")
    for name in ("properties/station.props", "program/fill.rmpl"):
        client.open(name)
        for _, title, _, argument in found(name):
            same((title.split()[0], run(argument, (folder / "demo" / name).parent)), ("check", 0))
    assert len(found("properties/station.props")) == 4, found("properties/station.props")
    client.end()


def calls(program, folder):
    """Who calls whom, across files, open or not."""
    (folder / "lib.rmpl").write_text("Wait() :: { t = 0; when t >= 1 s donext true }\nTwice() :: { Wait(); Wait() }\n", encoding="utf-8")
    (folder / "start.rmpl").write_text('import "lib.rmpl";\n' + PROGRAM.replace("Stop(spare)", "Stop(spare);\n  Twice()"), encoding="utf-8")
    client = Client(program, folder)
    client.start(folder)
    client.open("start.rmpl")

    def prepared(name, line, character):
        return client.get("textDocument/prepareCallHierarchy", **client.at(name, line, character))

    def called(direction, item):
        side = {"incoming": "from", "outgoing": "to"}[direction]
        return [(call[side]["name"], pathlib.Path(call[side]["uri"]).name,
                 [(r["start"]["line"], r["start"]["character"]) for r in call["fromRanges"]], call[side])
                for call in client.get(f"callHierarchy/{direction}Calls", item=item)]

    (start,) = prepared("start.rmpl", 2, 3)
    same((start["name"], start["kind"], start["selectionRange"]["start"]), ("Start", 12, place(2, 0)))
    same([one[:3] for one in called("incoming", start)], [("start", "start.scn", [(1, 28)])])
    told = called("outgoing", start)
    same([one[:3] for one in told], [("Stop", "start.rmpl", [(5, 45)]), ("Twice", "lib.rmpl", [(6, 2)])])
    twice = told[1][3]  # in a file that is not open
    told = called("outgoing", twice)
    same([one[:3] for one in told], [("Wait", "lib.rmpl", [(1, 13), (1, 21)])])
    same([one[:3] for one in called("incoming", told[0][3])], [("Twice", "lib.rmpl", [(1, 13), (1, 21)])])
    same([one[:3] for one in called("incoming", twice)], [("Start", "start.rmpl", [(6, 2)])])
    scenario = called("incoming", start)[0][3]
    same(called("incoming", scenario), [])
    same([one[0] for one in called("outgoing", scenario)], ["Start"])
    same(prepared("start.rmpl", 3, 3), None)  # an engine
    client.refused("callHierarchy/incomingCalls", item={"uri": "file:///nowhere.rmpl", "selectionRange": {"start": place(0, 0)}})
    client.refused("callHierarchy/outgoingCalls", item={})
    client.end()


MONITORS = """// The temperature, in kelvins.
channel "T1" : engine.temp { low below 300; high 300 to 900; }
channel "T2" : spare.temp { low below 300; high 300 to 900; }
"""
SAMPLED = SCENARIO.replace("  expect", "  at 3 s channel \"T1\" = 310;\n  expect")


def monitoring(program, folder):
    """Monitors, the plant that they speak of, and the scenarios that sample their channels."""
    (folder / "ship.mon").write_text(MONITORS, encoding="utf-8")
    client = Client(program, folder)
    client.start(folder)
    client.open("ship.mon")
    same(client.findings("ship.mon"), [])
    uri = {"uri": client.uri("ship.mon")}
    # Wrong values, and channels that nothing reads.
    client.change("ship.mon", "warm", (1, 29), (1, 32))
    same(client.findings("ship.mon"), ["RMPL0102 1:29 `warm` is no value of `engine.temp`, expected `low` or `high`"])
    assert "**RMPL0102**" in hovers(client, "ship.mon", 1, 30)
    client.change("ship.mon", "low", (1, 29), (1, 33))
    same(client.findings("ship.mon"), [])
    client.open("start.scn", SAMPLED.replace('"T1"', '"T3"'))
    same(client.findings("start.scn"), ['RMPL0413 6:17 no monitor reads channel "T3"'])
    actions = client.get("textDocument/codeAction", textDocument={"uri": client.uri("start.scn")},
                         range={"start": place(6, 18), "end": place(6, 18)}, context={"diagnostics": []})
    same([a["title"] for a in actions], ['did you mean "T1"?'])
    client.change("start.scn", '"T1"', (6, 17), (6, 21))
    same(client.findings("start.scn"), [])
    # From a sample to its monitor, from there to the plant, and back.
    monitor = client.get("textDocument/definition", **client.at("start.scn", 6, 19))
    same(spots(client, [monitor]), ["ship.mon 1:8-12"])
    attribute = client.get("textDocument/definition", **client.at("ship.mon", 1, 23))
    same(spots(client, [attribute]), ["engine.tcca 5:9-13"])
    value = client.get("textDocument/definition", **client.at("ship.mon", 1, 30))
    same(spots(client, [value]), ["engine.tcca 0:17-20"])
    client.open("engine.tcca")
    uses = spots(client, client.get("textDocument/references", **client.at("engine.tcca", 5, 10), context={"includeDeclaration": False}))
    assert {"ship.mon 1:22-26", "ship.mon 2:21-25"} <= set(uses), uses
    uses = spots(client, client.get("textDocument/references", **client.at("ship.mon", 1, 9), context={"includeDeclaration": True}))
    same(uses, ["ship.mon 1:8-12", "start.scn 6:17-21"])
    assert "below 300" in hovers(client, "start.scn", 6, 19) and "kelvins" in hovers(client, "start.scn", 6, 19)
    assert "output temp" in hovers(client, "ship.mon", 1, 23)
    # A new name of the plant's attribute is one of the monitors; a channel is called as the telemetry calls it.
    edits = client.get("textDocument/rename", **client.at("engine.tcca", 5, 10), newName="heat")["changes"]
    assert client.uri("ship.mon") in edits, edits
    assert "telemetry" in client.refused("textDocument/rename", **client.at("ship.mon", 1, 9), newName="T9")
    # Outline, style, colours, and what may come next.
    symbols = client.get("textDocument/documentSymbol", textDocument=uri)
    same([(s["name"], s["detail"]) for s in symbols], [("T1", "engine.temp"), ("T2", "spare.temp")])
    same(len(client.get("textDocument/formatting", textDocument=uri, options={"tabSize": 2, "insertSpaces": True})), 1)
    assert client.get("textDocument/semanticTokens/full", textDocument=uri)["data"]

    def offered(name: str, text: str) -> set[str]:
        client.open(name, text)
        line = text.count("\n")
        items = client.get("textDocument/completion", **client.at(name, line, len(text) - text.rfind("\n") - 1))["items"]
        client.notify("textDocument/didClose", textDocument={"uri": client.uri(name)})
        return {item["label"] for item in items}

    client.notify("textDocument/didClose", textDocument=uri)
    assert {"engine", "spare"} <= offered("ship.mon", 'channel "T1" : ')
    assert "engine.temp" in offered("ship.mon", 'channel "T1" : engine.')
    assert {"low", "high", "hysteresis", "persist", "stale"} <= offered("ship.mon", 'channel "T1" : engine.temp { ')
    same(offered("ship.mon", ""), {"channel"})
    client.notify("textDocument/didClose", textDocument={"uri": client.uri("start.scn")})
    cut = SAMPLED.index('T1" = 310')
    same(offered("start.scn", SAMPLED[:cut]), {'"T1"', '"T2"'})
    assert "channel" in offered("start.scn", SAMPLED[: SAMPLED.index('channel')])
    client.end()


TESTS = [lifecycle, abuse, diagnostics, lints, projects, pages, everywhere_named, formats, names, renaming, renaming_everywhere, completing, outline, lenses, calls, monitoring]


def main(root: str, programs: str) -> int:
    program = pathlib.Path(programs, "rmplc").resolve()

    def with_files(test):
        def case(folder: pathlib.Path) -> None:
            for file, text in FILES.items():
                (folder / file).write_text(text, encoding="utf-8")
            test(program, folder)

        case.__name__ = test.__name__
        return case

    return cases.run([with_files(test) for test in TESTS])


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
