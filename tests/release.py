#!/usr/bin/env python3
# What a release says of itself: one version everywhere, files that forges and citation tools can read.
# SPDX-License-Identifier: MIT
"""Usage: release.py ROOT.  Exit code 77 where python3-yaml is missing: the test is skipped, and says so."""

import pathlib
import re
import sys

try:
    import yaml
except ImportError:
    print("skipped: there is no module yaml (python3-yaml)")
    sys.exit(77)

# Each place of the version, and where it stands there.
PLACES = {
    "CITATION.cff": r"^version: (.*)$",
    "CHANGELOG.md": r"^## \[(.*?)\]",
    "docs/ci.md": r"rmpl(?:_|@v)([\d.]+\d)",
    "docs/ci/github.yml": r"rmpl_([\d.]+)_amd64",
    "docs/ci/gitlab.yml": r"rmpl_([\d.]+)_amd64",
    "docs/ci/pre-commit.yml": r"rev: v(.*)$",
    "editors/vscode/package.json": r'^  "version": "(.*)"',
}


def text(root, name):
    return (root / name).read_text(encoding="utf-8")


def versions(root):
    """Places that name another version than the build does."""
    version = re.search(r"^project\(rmpl VERSION (\S+)", text(root, "CMakeLists.txt"), re.MULTILINE)[1]
    for name, pattern in PLACES.items():
        found = re.findall(pattern, text(root, name), re.MULTILINE)
        named = [entry for entry in found if entry != "Unreleased"][:1] if name == "CHANGELOG.md" else found
        if not named or set(named) != {version}:
            yield f"{name} names the version {', '.join(named) or 'nowhere'}; CMakeLists.txt says {version}"


def citation(root):
    """What CITATION.cff lacks, by version 1.2.0 of its format."""
    cited = yaml.safe_load(text(root, "CITATION.cff"))
    day = re.search(r"^## \[[\d.]+\] — (\S+)", text(root, "CHANGELOG.md"), re.MULTILINE)[1]
    if cited.get("date-released") != day:
        yield f"CITATION.cff: released on {cited.get('date-released')}; CHANGELOG.md says {day}"
    for key in ("cff-version", "message", "title", "authors"):
        if not cited.get(key):
            yield f"CITATION.cff: there is no {key}"
    for reference in cited["references"]:
        for key in ("type", "title", "authors", "year"):
            if not reference.get(key):
                yield f"CITATION.cff: {reference.get('title')} has no {key}"


def templates(root):
    """Issue templates that a forge would not offer."""
    for path in sorted((root / ".github/ISSUE_TEMPLATE").glob("*.md")):
        head = yaml.safe_load(path.read_text(encoding="utf-8").split("---\n")[1])
        if not {"name", "about"} <= set(head):
            yield f"{path.name}: a template needs name and about, has {sorted(head)}"
    yaml.safe_load(text(root, ".github/ISSUE_TEMPLATE/config.yml"))


def links(root):
    """Links of the pages at the root that lead nowhere."""
    for path in sorted(root.glob("*.md")):
        for target in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", path.read_text(encoding="utf-8")):
            if not target.startswith("https://") and not (root / target).exists():
                yield f"{path.name} names {target}, which is not there"


def main(root):
    found = [*versions(root), *citation(root), *templates(root), *links(root)]
    print("\n".join([*found, f"{len(found)} complaints"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
