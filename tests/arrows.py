#!/usr/bin/env python3
# The arrow check: every #include of the tree against the arrows of docs/architecture.md.
# SPDX-License-Identifier: MIT
"""Usage: arrows.py ROOT [--draw|--table]

Libraries include only what ARROWS says; between folders, of any level, there is no circle; a name stands for one type in
its namespace; docs/house.dot, the picture of the folders and their arrows, is the one that --draw would write. Prints a line for each violation and exits 1 where
there is any. --draw writes docs/house.dot, and docs/house.svg where Graphviz is there; --table lists what was found.
"""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys

# What the files of a library may include, besides their own folder.
ARROWS = {
    "base": (),
    "automata": ("base",),
    "grammar": ("base",),
    "compiler": ("base", "grammar", "automata"),
    "runtime/reasoning": ("base", "automata"),
    "runtime/telemetry": ("base", "automata"),
    "runtime/executive": ("base", "automata", "runtime/reasoning", "runtime/telemetry"),
    "runtime/report": ("base", "automata", "runtime/reasoning", "runtime/telemetry", "runtime/executive"),
    "verifier": ("base", "automata", "runtime/reasoning"),
    "python": ("base", "grammar", "automata", "compiler", "runtime/reasoning", "runtime/telemetry", "runtime/executive", "runtime/report", "verifier"),
    "tools": ("base", "grammar", "automata", "compiler", "runtime/reasoning", "runtime/telemetry", "runtime/executive", "runtime/report", "verifier"),
}
# Libraries that are slow to compile, or that one room stands for: what includes them, and who may.
GUARDED = {
    re.compile(r"^boost/spirit/"): re.compile(r"^grammar/parse/"),
    re.compile(r"^CLI/"): re.compile(r"^tools/"),
    re.compile(r"^boost/program_options/"): re.compile(r"^tools/shared/"),
    re.compile(r"^boost/(asio|beast)/"): re.compile(r"^tools/rmpl-run/foxglove/"),
    re.compile(r"^toml\+\+/"): re.compile(r"^tools/shared/"),
    re.compile(r"^bliss/"): re.compile(r"^verifier/symmetry/"),
    re.compile(r"^pybind11/"): re.compile(r"^python/"),
    re.compile(r"^cadical\.hpp"): re.compile(r"^automata/logic/"),
}
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')


def library(path: str) -> str | None:
    """The library that a file belongs to."""
    return next((name for name in ARROWS if path.startswith(name + "/")), None)


def folder(path: str) -> str:
    return path.rpartition("/")[0]


def violation(user: str, kind: str, target: str, root: pathlib.Path) -> str | None:
    """Why the file `user` may not include `target`, or None where it may."""
    for guarded, users in GUARDED.items():
        if guarded.match(target):
            return None if users.match(user) else f"only {users.pattern[1:]} includes it"
    if library(target) is None and not target.startswith("tests/"):
        if kind == '"' and not (root / target).is_file():
            return "includes are written from the root of the tree"
        return None
    if kind == "<":
        return "own headers are included with quotes"
    if not (root / target).is_file():
        return "there is no such file"
    own = library(user)
    if library(target) in (own, *ARROWS[own]):
        return None
    return f"{own}/ may include only " + ", ".join(f"{name}/" for name in (own, *ARROWS[own]))


def includes(root: pathlib.Path):
    """Every include of the libraries and programs: file, line, quote, target."""
    for path in sorted(p for name in ARROWS for p in (root / name).rglob("*") if p.suffix in (".hpp", ".cpp")):
        user = path.relative_to(root).as_posix()
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            if match:
                yield user, number, match[1], match[2]


NAMESPACE = re.compile(r"^(?:inline )?namespace\s*([\w:]*)\s*\{")
TYPE = re.compile(r"^(?:template <.*> )?(?:class|struct|enum class|enum) (?:\[\[\w+\]\] )?(\w+)(?: final)?(?: :[^;]*)? \{")


def types(root: pathlib.Path):
    """Every type that is defined in a named namespace of libraries, programs or tests: its name in full, file, line. Two
    of one name make programs of which the linker takes whatever function it comes across first."""
    for path in sorted(p for name in (*ARROWS, "tests") for p in (root / name).rglob("*") if p.suffix in (".hpp", ".cpp")):
        spaces: list[str] = []
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if match := NAMESPACE.match(line):
                spaces.append(match[1])
            elif line.startswith("}  // namespace"):
                spaces.pop()
            elif (match := TYPE.match(line)) and spaces and "" not in spaces:
                yield "::".join([*spaces, match[1]]), path.relative_to(root).as_posix(), number


def circle(arrows: dict[str, dict[str, str]]) -> list[str]:
    """Folders that lead back to the first, or none; `arrows` holds an example for each arrow."""
    done: set[str] = set()

    def walk(path: list[str]) -> list[str]:
        for to in sorted(arrows.get(path[-1], {})):
            if to in path:
                return path[path.index(to):] + [to]
            if to not in done:
                found = walk([*path, to])
                if found:
                    return found
        done.add(path[-1])
        return []

    for start in sorted(arrows):
        found = [] if start in done else walk([start])
        if found:
            return found
    return []


def drawn(arrows: dict[str, dict[str, str]], folders: set[str]) -> str:
    """The folders as Graphviz draws them: a box a library, arrows that follow from others left out."""
    def reach(start: str, without: str) -> set[str]:
        seen, open_ = set(), [to for to in arrows.get(start, {}) if to != without]
        while open_:
            at = open_.pop()
            if at not in seen:
                seen.add(at)
                open_ += arrows.get(at, {})
        return seen

    lines = ["// Made by tests/arrows.py --draw: the folders of the tree and who includes whom; arrows that others imply are left out.",
             "digraph house {", '  rankdir=TB; nodesep=0.35; fontname="sans-serif"; node [shape=box, style=rounded, fontname="sans-serif"];']
    for name in ARROWS:
        lines.append(f'  subgraph "cluster_{name}" {{ label="{name}"; style=rounded;')
        for place in sorted(folders):
            if library(place + "/") == name:
                label = place.removeprefix(name + "/") if place != name else name
                lines.append(f'    "{place}" [label="{label}"];')
        lines.append("  }")
    for user in sorted(arrows):
        lines += [f'  "{user}" -> "{to}";' for to in sorted(arrows[user]) if to not in reach(user, to)]
    return "\n".join([*lines, "}", ""])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--draw", action="store_true", help="write the picture of the folders and their arrows")
    parser.add_argument("--table", action="store_true", help="list the folders, their lines and their arrows")
    options = parser.parse_args()
    root = options.root.resolve()

    found, files = 0, set()
    arrows: dict[str, dict[str, str]] = {}
    for user, number, kind, target in includes(root):
        files.add(user)
        reason = violation(user, kind, target, root)
        if reason:
            found += 1
            print(f"{user}:{number}: includes {target}: {reason}")
        elif library(target) and folder(user) != folder(target):
            arrows.setdefault(folder(user), {}).setdefault(folder(target), f"{user}:{number}")
    defined: dict[str, str] = {}
    for name, file, number in types(root):
        if defined.setdefault(name, f"{file}:{number}") != f"{file}:{number}":
            found += 1
            print(f"{file}:{number}: {name} is another type at {defined[name]}")
    closed = circle(arrows)
    if closed:
        found += 1
        print("folders in a circle:")
        for user, target in zip(closed, closed[1:]):
            print(f"  {user} -> {target}, as in {arrows[user][target]}")

    folders: dict[str, int] = {}
    for file in files:
        folders[folder(file)] = folders.get(folder(file), 0) + len((root / file).read_text(encoding="utf-8").splitlines())
    picture, dot = root / "docs/house.dot", drawn(arrows, set(folders))
    if options.draw:
        picture.write_text(dot, encoding="utf-8")
        if shutil.which("dot"):
            subprocess.run(["dot", "-Tsvg", picture, "-o", picture.with_suffix(".svg")], check=True)
    elif not picture.is_file() or picture.read_text(encoding="utf-8") != dot:
        found += 1
        print("docs/house.dot: not the folders and arrows as they are; tests/arrows.py . --draw writes it anew")
    if options.table:
        for place in sorted(folders):
            print(f"{folders[place]:6} {place} -> {', '.join(sorted(arrows.get(place, {}))) or '.'}")
    print(f"{len(files)} files in {len(folders)} folders checked, {found} findings")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())
