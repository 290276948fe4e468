#!/usr/bin/env python3
# The arrow check: every #include of the tree against the arrows of docs/architecture.md.
# SPDX-License-Identifier: MIT
"""Usage: arrows.py ROOT. Prints one line a violation and exits 1 where there is any."""

import pathlib
import re
import sys

# What the files of a library may include, besides their own folder.
ARROWS = {
    "base": (),
    "automata": ("base/",),
    "grammar": ("base/",),
    "compiler": ("base/", "grammar/", "automata/"),
    "runtime/reasoning": ("base/", "automata/"),
    "runtime/executive": ("base/", "automata/", "runtime/reasoning/"),
    "verifier": ("base/", "automata/", "runtime/reasoning/"),
    "tools": ("base/", "automata/", "grammar/", "compiler/", "runtime/", "verifier/"),
}
# Boost.Spirit X3 stays behind the parser: it is slow to compile.
X3 = re.compile(r"^boost/spirit/")
X3_USERS = re.compile(r"^grammar/parse/")
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')


def library(path: str) -> str | None:
    """The library that a file belongs to."""
    return next((name for name in ARROWS if path.startswith(name + "/")), None)


def violation(user: str, kind: str, target: str, root: pathlib.Path) -> str | None:
    """Why the file `user` may not include `target`, or None where it may."""
    folder = library(user)
    owner = library(target)
    if X3.match(target) and not X3_USERS.match(user):
        return "only grammar/parse/ includes Boost.Spirit"
    if owner is None and not target.startswith("tests/"):
        if kind == '"' and not (root / target).is_file():
            return "includes are written from the root of the tree"
        return None
    if kind == "<":
        return "own headers are included with quotes"
    if not (root / target).is_file():
        return "there is no such file"
    if owner == folder or target.startswith(ARROWS[folder]):
        return None
    allowed = ", ".join((folder + "/",) + ARROWS[folder])
    return f"{folder}/ may include only {allowed}"


def main(root: pathlib.Path) -> int:
    found = 0
    files = sorted(p for folder in ARROWS for p in (root / folder).rglob("*") if p.suffix in (".hpp", ".cpp"))
    for path in files:
        user = path.relative_to(root).as_posix()
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            reason = match and violation(user, match[1], match[2], root)
            if reason:
                found += 1
                print(f"{user}:{number}: includes {match[2]}: {reason}")
    print(f"{len(files)} files checked, {found} forbidden includes")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
