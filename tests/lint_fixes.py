#!/usr/bin/env python3
# Sure fixes: each is made, the finding is gone, and the text is what its author would have made of it.
# SPDX-License-Identifier: MIT
"""lint_fixes.py RMPLC: lints texts that are in the one style, with and without --fix.

For each case, with the texts in the one style: the finding is there with a fix; after --fix it is not there, and the
text is the expected one, in the one style again. Where there is no fix, the text stays. CODES lists every code that has
a fix in any case, and each of these has a case of its own."""

import json
import pathlib
import subprocess
import sys
import tempfile

CODES = {"RMPL0500", "RMPL0511", "RMPL0512", "RMPL0514", "RMPL0518", "RMPL0521", "RMPL0534", "RMPL0546", "RMPL0548"}

VALVE = """\
component Valve {{
  input  cmd      : {{ none, open, close }};
  output position : {{ shut, wide }};
{attributes}  initial closed;
  mode closed {{ position = shut }};
  mode open   {{ position = wide }};
{transitions}}}
plant Feed {{
  valve : Valve;
  control valve.cmd default none;
  observe valve.position;
}}
"""
OPEN = "  closed -> open when cmd = open;\n"
CLOSE = "  open -> closed when cmd = close;\n"


def valve(attributes: str = "", transitions: str = OPEN + CLOSE, before: str = "") -> str:
    return before + VALVE.format(attributes=attributes, transitions=transitions)


def own(clocks: str) -> str:
    return "P() :: {\n" + clocks + "  t = 0;\n  when t >= 1 s donext tap = open\n}\n"


# What it is, the file, the code that has a fix, and the text before and after.
FIXED = [
    ("a domain", "plant.tcca", "RMPL0512", valve(before="domain Level = { low, high };\n"), valve()),
    ("a domain between others", "plant.tcca", "RMPL0512",
     valve("  internal a     : Own;\n", OPEN.replace(";", " & a = x;") + CLOSE,
           "domain Own = { x, y };\n\ndomain Level = { low, high };\n\n").replace("shut }", "shut & a = x }"),
     valve("  internal a     : Own;\n", OPEN.replace(";", " & a = x;") + CLOSE,
           "domain Own = { x, y };\n\n").replace("shut }", "shut & a = x }")),
    ("a domain with an allowance of something else", "plant.tcca", "RMPL0512",
     valve(before="// lint: allow RMPL0500 because it was so\ndomain Level = { low, high };\n"), valve()),
    ("a clock that is declared", "main.rmpl", "RMPL0511", own("  clock t;\n  clock idle;\n"), own("  clock t;\n")),
    ("a clock beside another", "main.rmpl", "RMPL0511", own("  clock idle, t;\n"), own("  clock t;\n")),
    ("a clock behind another", "main.rmpl", "RMPL0511", own("  clock t, idle;\n"), own("  clock t;\n")),
    ("all clocks of a declaration", "main.rmpl", "RMPL0511", own("  clock a, b, c;\n  clock t;\n"), own("  clock t;\n")),
    ("braces", "main.rmpl", "RMPL0514", "P() :: {\n  engine = on; valve = open,\n  lamp = on\n}\n",
     "P() :: {\n  { engine = on; valve = open },\n  lamp = on\n}\n"),
    ("a wait that whenever starts anew", "main.rmpl", "RMPL0521",
     "P() :: {\n  whenever tap = shut donext Wait()\n}\n\n"
     "Wait() :: {\n  clock t;\n  t = 0;\n  when t >= 5 s donext tap = open\n}\n",
     "P() :: {\n  repeat when tap = shut donext Wait()\n}\n\n"
     "Wait() :: {\n  clock t;\n  t = 0;\n  when t >= 5 s donext tap = open\n}\n"),
    ("an allowance", "main.rmpl", "RMPL0518",
     "P() :: {\n  tap = open;\n\n  // lint: allow RMPL0514 because it was so\n\n  tap = shut\n}\n",
     "P() :: {\n  tap = open;\n\n  tap = shut\n}\n"),
    ("an allowance between slash and star", "main.rmpl", "RMPL0518",
     "P() :: {\n  tap = open;  /* lint: allow RMPL0514 because\n                  it was so */\n  tap = shut\n}\n",
     "P() :: {\n  tap = open;\n  tap = shut\n}\n"),
    ("a code of an allowance", "main.rmpl", "RMPL0518",
     "P() :: {\n  // lint: allow RMPL0504, RMPL0514, RMPL0507 because so\n  engine = on; valve = open,\n  lamp = on\n}\n",
     "P() :: {\n  // lint: allow RMPL0514 because so\n  engine = on; valve = open,\n  lamp = on\n}\n"),
    ("a transition given twice", "plant.tcca", "RMPL0500", valve(transitions=OPEN + OPEN + CLOSE), valve()),
    ("a transition given twice, of several sources", "plant.tcca", "RMPL0500",
     valve("  internal a     : { x, y };\n", "  any -> closed when cmd = close;\n" + OPEN + CLOSE).replace("shut }", "shut & a = x }"),
     valve("  internal a     : { x, y };\n", "  any -> closed when cmd = close;\n" + OPEN).replace("shut }", "shut & a = x }")),
    ("a transition that another one to the same mode forestalls", "plant.tcca", "RMPL0534",
     valve(transitions=OPEN + CLOSE + "  open -> closed when cmd = close in [5 s, 9 s];\n"), valve()),
    ("a transition to the mode that it sets out from", "plant.tcca", "RMPL0548",
     valve(transitions=OPEN + CLOSE + "  closed -> closed when cmd = close;\n"), valve()),
    ("an attribute", "plant.tcca", "RMPL0546", valve("  output current  : { zero, nominal };\n"), valve()),
    ("an attribute whose name sets the column", "plant.tcca", "RMPL0546",
     valve("  output temperature : { zero, nominal };\n").replace("cmd      :", "cmd         :").replace(
         "position :", "position    :"), valve()),
]

# What it is, the file, the code that has no fix, and the text.
LEFT = [
    ("a domain that a comment speaks of", "plant.tcca", "RMPL0512",
     valve(before="// Of the tank.\ndomain Level = { low, high };\n")),
    ("a domain with a comment behind it", "plant.tcca", "RMPL0512",
     valve(before="domain Level = { low, high };  // of the tank\n")),
    ("a clock of several, with a comment behind them", "main.rmpl", "RMPL0511",
     own("  clock t, u;  // u is for the second try\n")),
    ("a clock that is started", "main.rmpl", "RMPL0511", own("  clock t, u;\n  u = 0;\n")),
    ("a transition given twice beside another one", "plant.tcca", "RMPL0500",
     valve(transitions=OPEN + OPEN + "  closed -> closed when cmd != none;\n" + CLOSE)),
    ("a fault given twice, which is more likely", "plant.tcca", "RMPL0500",
     valve("  fault stuck;\n", OPEN + CLOSE + "  open -> stuck with 0.1;\n  open -> stuck with 0.1;\n")),
    ("a transition that one to another mode forestalls", "plant.tcca", "RMPL0534",
     valve("  mode half;\n",
           OPEN + CLOSE + "  open -> half when cmd = close in [5 s, 9 s];\n  closed -> half when cmd = close;\n")),
    ("a transition that keeps others from being taken", "plant.tcca", "RMPL0533",
     valve(transitions=OPEN + CLOSE + "  open -> open when cmd in { open, close };\n")),
    ("a type", "plant.tcca", "RMPL0513", valve(before="component Tank {\n  initial full;\n  mode full;\n}\n")),
    ("a definition", "main.rmpl", "RMPL0509", "P() :: { tap = open }\nQ(c) :: { c = open }\n"),
]


class Lint:
    def __init__(self, rmplc: pathlib.Path, folder: pathlib.Path, name: str, text: str) -> None:
        self.rmplc, self.folder, self.name = rmplc, folder, name
        (folder / name).write_text(text, encoding="utf-8")

    def text(self) -> str:
        return (self.folder / self.name).read_text(encoding="utf-8")

    def run(self, *arguments: str) -> str:
        run = subprocess.run([self.rmplc, *arguments, self.name], cwd=self.folder, capture_output=True, text=True,
                             timeout=60, check=False)
        if run.returncode not in (0, 1):
            raise SystemExit(f"rmplc {' '.join(arguments)} ended with {run.returncode}:\n{run.stderr}\n{self.text()}")
        return run.stdout

    def lint(self, *arguments: str) -> str:
        main = ("--main", "P") if self.name.endswith(".rmpl") else ()
        return self.run("lint", "--level", "note", *main, *arguments)

    def fixes(self) -> dict[str, bool]:
        """The codes found, and whether one of each has a fix."""
        found: dict[str, bool] = {}
        for one in json.loads(self.lint("--format", "json")):
            found[one["code"]] = found.get(one["code"], False) or bool(one["fix"])
        return found



def why_not(rmplc: pathlib.Path, folder: pathlib.Path, name: str, code: str, texts: list[str | None]) -> str | None:
    laid_out = []
    for text in texts:
        if text is not None:
            lint = Lint(rmplc, folder, name, text)
            lint.run("format")
            laid_out.append(lint.text())
    before, after = laid_out[0], laid_out[-1]
    fixed = len(laid_out) > 1
    lint = Lint(rmplc, folder, name, before)
    found = lint.fixes()
    if not CODES.issuperset(code for code, fix in found.items() if fix):
        return f"fixes of codes that are not listed: {found}"
    if found.get(code) is not fixed:
        return f"found {found}"
    lint.lint("--quiet", "--fix")
    if lint.text() != after:
        return "became\n" + lint.text()
    if fixed and code in lint.fixes():
        return "is still found"
    return None


def main() -> int:
    rmplc = pathlib.Path(sys.argv[1]).resolve()
    cases = FIXED + [(*case, None) for case in LEFT]
    failures = 0
    for what, name, code, before, after in cases:
        with tempfile.TemporaryDirectory() as folder:
            wrong = why_not(rmplc, pathlib.Path(folder), name, code, [before, after])
        if wrong:
            failures += 1
            print(f"{code}, {what}: {wrong}")
    untried = CODES - {code for _, _, code, *_ in FIXED}
    if untried:
        print(f"no case for {sorted(untried)}")
    print(f"{len(cases)} cases, {failures} failures")
    return 1 if failures or untried else 0


if __name__ == "__main__":
    sys.exit(main())
