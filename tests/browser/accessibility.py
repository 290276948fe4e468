#!/usr/bin/env python3
# The pages against the rules of axe-core: no violation, narrow and wide, light and dark.
# SPDX-License-Identifier: MIT
"""Usage: accessibility.py ROOT PROGRAMS

Skipped (77) where chromium, chromedriver or the npm package axe-core below build/node_modules is not there
(cmake/install-packages editors).
"""

import pathlib
import subprocess
import sys
import tempfile

import webdriver

SKIPPED = 77
WIDTHS = (390, 1280, 1920)
SCHEMES = ("light", "dark")
AUDIT = """const done = arguments[arguments.length - 1];
axe.run(document, {resultTypes: ['violations']}).then(found => done(found.violations.map(
  v => [v.id, v.impact, v.help, v.nodes.map(n => n.target.join(' ') + ': ' + n.failureSummary.replace(/\\s+/g, ' ')).slice(0, 5)])), e => done([[String(e)]]))"""


def run(*words) -> None:
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode in (0, 1), (words, done)


def pages(root: pathlib.Path, programs: pathlib.Path, folder: pathlib.Path) -> dict[str, pathlib.Path]:
    """One of each kind."""
    examples = root / "examples"
    made = {kind: folder / f"{kind}.html" for kind in ("flights", "counterexample", "campaign")}
    run(programs / "rmpl-run", "scenario", "-q", examples / "propulsion/burn.scn", "--report", made["flights"])
    run(programs / "tcca-check", "reachability", examples / "propulsion/propulsion.tcca", "--target", "engine = firing", "--report",
        made["counterexample"])
    run(programs / "rmpl-run", "campaign", "-q", examples / "mars-entry/mars_entry.scn", "--only", "heating, drawn from the model", "--runs", 40,
        "--faults", 1, "--db", ":memory:", "--report", made["campaign"])
    return made


def audit(browser: webdriver.Browser, axe: str, page: pathlib.Path, width: int, scheme: str) -> list:
    browser.call("POST", "/goog/cdp/execute", {"cmd": "Emulation.setDeviceMetricsOverride",
                                               "params": {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False}})
    browser.call("POST", "/goog/cdp/execute", {"cmd": "Emulation.setEmulatedMedia",
                                               "params": {"features": [{"name": "prefers-color-scheme", "value": scheme}]}})
    browser.open(page.as_uri())
    browser.wait("document.readyState === 'complete'")
    browser.run(axe)
    return browser.call("POST", "/execute/async", {"script": AUDIT, "args": []})


def main(root: pathlib.Path, programs: pathlib.Path) -> int:
    axe = root / "build/node_modules/axe-core/axe.min.js"
    if webdriver.programs() is None or not axe.is_file():
        print("skipped: chromium, chromedriver or axe-core (cmake/install-packages editors) is not there")
        return SKIPPED
    script, wrong = axe.read_text(encoding="utf-8"), 0
    with tempfile.TemporaryDirectory() as made, webdriver.Browser(1280, 900) as browser:
        for kind, page in pages(root, programs, pathlib.Path(made)).items():
            for width in WIDTHS:
                for scheme in SCHEMES:
                    for violation in audit(browser, script, page, width, scheme):
                        wrong += 1
                        print(f"{kind}, {width} px, {scheme}: {violation}")
    print(f"{3 * len(WIDTHS) * len(SCHEMES)} audits by axe-core, {wrong} violations")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*(pathlib.Path(word).resolve() for word in sys.argv[1:3])))
