#!/usr/bin/env python3
# The API pages: built without a warning of Doxygen, a page for each public header, and a search.
# SPDX-License-Identifier: MIT
"""Usage: api.py ROOT.  Exit code 77 where doxygen is missing: the test is skipped, and says so."""

import collections
import html
import pathlib
import re
import subprocess
import sys
import tempfile

SKIPPED = 77
INTERNAL = {"grammar/parse/lexeme.hpp", "grammar/parse/record.hpp", "grammar/parse/rules.hpp"}


def missing(root, pages):
    """Headers that librmpl-dev installs and that have no page, and what the first page names and is not there."""
    listed = collections.Counter()
    for page in pages.glob("*_8hpp.html"):
        listed[html.unescape(re.search(r"<title>[^<]*?([^ /]+\.hpp) ", page.read_text(encoding="utf-8"))[1])] += 1
    for folder in ("base", "automata", "grammar", "compiler", "runtime", "verifier"):
        for header in (root / folder).rglob("*.hpp"):
            if str(header.relative_to(root)) not in INTERNAL and "schema" not in header.parts:
                listed[header.name] -= 1
    yield from (f"{name}: {-count} headers of that name have no page" for name, count in sorted(listed.items()) if count)
    for name in re.findall(r"\b(?:base|automata|grammar|compiler|runtime|verifier)/[\w./]+\w",
                           (root / "docs/api/libraries.md").read_text(encoding="utf-8")):
        if not (root / name).exists():
            yield f"docs/api/libraries.md names {name}, which is not there"


def main(root):
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([root / "docs/api/build", folder], capture_output=True, text=True, timeout=300, check=False)
        if done.returncode == 2:
            print(f"skipped: {done.stderr.strip()}")
            return SKIPPED
        if done.returncode != 0 or done.stdout + done.stderr:
            print(f"docs/api/build ends with {done.returncode}\n{done.stdout}{done.stderr}")
            return 1
        pages = pathlib.Path(folder) / "html"
        found = list(missing(root, pages))
        if not list((pages / "search").glob("all_*.js")):
            found.append("there is no search")
    print("\n".join([*found, f"{len(found)} complaints"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
