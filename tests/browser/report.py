#!/usr/bin/env python3
# The report in a browser: it opens without a network and without a word on the console, and says what the trace says.
# SPDX-License-Identifier: MIT
"""Usage: report.py ROOT PROGRAMS

Skipped (77) where chromium or chromedriver is not there.
"""

import base64
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import webdriver

LEFT, RIGHT, SHIFT, ENTER = "\ue012", "\ue014", "\ue008", "\ue007"
SKIPPED = 77
MARKED = "return [...document.querySelectorAll('#pane-program .marked')].map(e => e.dataset.title).sort()"
VALUES = """return Object.fromEntries([...document.querySelectorAll('.row:not(.child):not(.note)')]
  .map(row => [row.querySelector('.text').textContent, row.querySelector('.value').textContent]))"""
NAMELESS = """return [...document.querySelectorAll('button, select, input, [role]')].filter(e => e.offsetParent !== null &&
  e.getAttribute('role') !== 'gridcell' && !(e.getAttribute('aria-label') || e.getAttribute('aria-labelledby') || e.textContent.trim() || e.closest('label'))).map(e => e.outerHTML)"""

HOSTILE = {
    "m.rmpl": "Main() :: { pump = on }\n",
    "m.tcca": """component Pump {
  input cmd : { none, go };
  output flow : { no, yes };
  initial off;
  mode off { flow = no };
  mode on { flow = yes };
  fault stuck { flow = no };
  off -> on when cmd = go;
  off -> stuck when cmd = go with 0.01;
}
plant House {
  pump : Pump;
  control pump.cmd default none;
  observe pump.flow;
}
""",
    "m.scn": """scenario "</script><script>document.title='broken into'</script><!-- & 'x'" {
  program "m.rmpl";
  plant "m.tcca";
  cycle 1 ms;
  duration 20 ms;
  at 0 s observe pump.flow = no;
  expect pump = on within 5 ms;
}
""",
}


def run(command: list, **more) -> None:
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, timeout=120, **more)
    assert done.returncode in (0, 1) and not done.stderr, (command, done)


def at(lines: list[dict], time: float) -> tuple[list[str], dict]:
    """Marking and estimate at a time, as a trace of all cycles has them: the line of a cycle begins with its marking."""
    estimate = next(line["estimate"] for line in reversed(lines) if line["time"] <= time)
    later = [line["marking"] for line in lines if line["time"] > time]
    return (later[0] if later else []), estimate


def check_flight(browser: webdriver.Browser, page: pathlib.Path, trace: list[dict]) -> None:
    """Cursor, marking, modes, zoom, search, themes."""
    browser.open(page.as_uri())
    browser.wait("document.documentElement.dataset.ready")
    assert browser.complaints() == []
    moments = browser.run("return globalThis.flightReport.moments")
    assert len(moments) > 5, moments
    browser.run("globalThis.flightReport.setCursor(0, true)")
    for moment in [m for m in moments if m > 0][:12]:
        browser.press("n")
        cursor = browser.run("return globalThis.flightReport.cursor")
        assert cursor == moment, (cursor, moment)
        marking, estimate = at(trace, moment)
        marked = [int(title.rpartition("l")[2]) for title in browser.run(MARKED)]
        assert sorted(marked) == sorted(marking), (moment, marked, marking)
        values = browser.run(VALUES)
        for component, mode in estimate.items():
            if component in values:
                assert values[component].startswith(mode), (moment, component, values[component], mode)
    browser.press("p")
    browser.press(RIGHT, RIGHT, LEFT)
    text = browser.run("return document.getElementById('ruler').getAttribute('aria-valuetext')")
    assert text == browser.run("return document.getElementById('now').textContent") and text
    check_view(browser)
    check_search(browser)
    before = browser.run("return document.documentElement.dataset.theme")
    browser.press("t")
    assert browser.run("return document.documentElement.dataset.theme") != before
    nameless = browser.run(NAMELESS)
    assert nameless == [], nameless
    browser.run("document.getElementById('tab-plant').click()")
    assert browser.run("return document.querySelectorAll('#pane-plant .badge').length") > 3
    assert len(base64.b64decode(browser.picture())) > 20_000
    assert browser.complaints() == []


def check_view(browser: webdriver.Browser) -> None:
    """Zoom by keys, down to milliseconds and back; the cursor by the mouse; rows by keys."""
    span = "return globalThis.flightReport.view.to - globalThis.flightReport.view.from"
    whole = browser.run(span)
    for _ in range(30):
        browser.press("+")
    assert 1e-4 < browser.run(span) < 0.01
    browser.press("f")
    assert abs(browser.run(span) - whole) < 1e-6 * whole
    box = browser.run("const b = document.querySelector('.row .lane').getBoundingClientRect(); return [b.left, b.top, b.width, b.height]")
    browser.click(int(box[0] + box[2] / 2), int(box[1] + box[3] / 2))
    middle = browser.run("return globalThis.flightReport.cursor / globalThis.flightReport.flight.end")
    assert 0.45 < middle < 0.55, middle
    browser.run("[...document.querySelectorAll('.row[aria-expanded]')][0].focus()")
    rows = browser.run("return document.querySelectorAll('.row').length")
    browser.run("const r = [...document.querySelectorAll('.row[aria-expanded]')][0]; r.querySelector('.label').click()")
    assert browser.run("return document.querySelectorAll('.row').length") > rows
    browser.run("globalThis.flightReport.setPlaying(true)")
    browser.wait(f"globalThis.flightReport.cursor / globalThis.flightReport.flight.end > {middle} + 1e-6")
    browser.run("globalThis.flightReport.setPlaying(false)")


def check_search(browser: webdriver.Browser) -> None:
    all_events = browser.run("return document.querySelectorAll('.event').length")
    browser.press("/")
    browser.press(*"backup")
    found = browser.run("return document.querySelectorAll('.event').length")
    assert 0 < found < all_events, (found, all_events)
    browser.press(ENTER)
    assert browser.run("return document.getElementById('found').textContent") == f"1 / {found}"
    browser.run("globalThis.flightReport.search(''); document.activeElement.blur()")


def check_hostile(browser: webdriver.Browser, programs: pathlib.Path, folder: pathlib.Path) -> None:
    for name, text in HOSTILE.items():
        (folder / name).write_text(text)
    page = folder / "hostile.html"
    run([programs / "rmpl-run", "scenario", "-q", "m.scn", "--report", page], cwd=folder, env={**os.environ, "PATH": "/nonexistent"})
    browser.open(page.as_uri())
    browser.wait("document.documentElement.dataset.ready")
    assert browser.run("return document.title") == "m.scn"
    assert browser.run("return document.getElementById('name').textContent").startswith("</script>")
    assert "graphviz" in browser.run("return document.getElementById('pane-program').textContent")
    assert browser.run("return document.getElementById('verdict').textContent") == "failed"
    # What failed is what is shown first.
    assert browser.run("return globalThis.flightReport.cursor") == 0.005
    assert browser.complaints() == []


def check_counterexample(browser: webdriver.Browser, root: pathlib.Path, programs: pathlib.Path, folder: pathlib.Path) -> None:
    page = folder / "counterexample.html"
    run([programs / "tcca-check", "safety", root / "examples/propulsion/propulsion.tcca", "--never", "engine = firing", "--faults", "1",
         "--report", page])
    browser.open(page.as_uri())
    browser.wait("document.documentElement.dataset.ready")
    assert browser.run("return document.getElementById('verdict').textContent") == "violated"
    assert browser.run("return document.getElementById('tab-program').hidden")
    browser.run("globalThis.flightReport.setCursor(globalThis.flightReport.flight.end)")
    assert browser.run(VALUES)["engine"] == "firing"
    assert browser.complaints() == []


def main() -> int:
    root, programs = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    if webdriver.programs() is None:
        print("skipped: chromium and chromedriver are not there")
        return SKIPPED
    with tempfile.TemporaryDirectory() as name, webdriver.Browser(1400, 900) as browser:
        folder = pathlib.Path(name)
        page, trace = folder / "entry.html", folder / "entry.jsonl"
        run([programs / "rmpl-run", "scenario", "-q", root / "examples/mars-entry/mars_entry.scn", "--only",
             "primary latch misfires, the backup answers", "--report", page, "--trace", trace, "--trace-detail", "cycles"])
        assert page.stat().st_size < 3_000_000
        lines = [json.loads(line) for line in trace.read_text().splitlines()]
        check_flight(browser, page, lines)
        check_hostile(browser, programs, folder)
        check_counterexample(browser, root, programs, folder)
    print("the report opens, says what the trace says, and the console is silent")
    return 0


if __name__ == "__main__":
    sys.exit(main())
