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


def written(browser: webdriver.Browser) -> list[dict]:
    """What stands in the canvas of the rows, and where."""
    return browser.run("""const r = globalThis.flightReport.timeline, pen = r.pen, texts = [];
        pen.fillText = (text, x, y) => texts.push({text, x, y: y + r.scroll.scrollTop, room: r.labels + r.width - x});
        r.draw(); delete pen.fillText; return texts""")


def check_drawn(browser: webdriver.Browser, root: pathlib.Path, programs: pathlib.Path, folder: pathlib.Path) -> None:
    """A landing in which the belief changes: labels of bars, busy, and the plant with its badges."""
    page = folder / "drawn.html"
    run([programs / "rmpl-run", "scenario", "-q", root / "examples/mars-edl/mars_edl.scn", "--only", "landing, drawn from the model",
         "--report", page])
    browser.open(page.as_uri())
    browser.wait("document.documentElement.dataset.ready")
    # The first cycle of the fault is believed less than the hours after it: one bar to the reader, one label.
    assert sum(text["text"] == "resettable" for text in written(browser)) == 1
    shares = browser.run("return globalThis.flightReport.timeline.shown.find(r => r.label === 'PDE').runs.map(r => r.spans.length)")
    assert max(shares) > 1, shares
    browser.press("b")
    state = browser.run("const {cursor, view} = globalThis.flightReport; return [view.from, cursor, view.to]")
    assert state == sorted(state), state
    assert sum(text["text"] == "inertial" for text in written(browser)) == 1
    # A cursor out of sight is pointed to.
    axis = """const r = globalThis.flightReport, t = r.timeline, texts = []; r.setView(...arguments);
        t.axisPen.fillText = text => texts.push(text); t.draw(); delete t.axisPen.fillText;
        return texts.includes(document.getElementById('now').textContent)"""
    assert browser.run(axis, 0, 60) and not browser.run(axis, 0, 17000)
    browser.run("document.getElementById('tab-plant').click(); document.getElementById('whole').click()")
    check_plant(browser)


# What overlaps: badges with texts of ports, and texts that stand in lines with lines.
OVERLAPS = """const drawing = globalThis.flightReport.drawings[1], apart = (a, b) =>
  a.right <= b.left + 1 || b.right <= a.left + 1 || a.bottom <= b.top + 1 || b.bottom <= a.top + 1;
const pane = drawing.pane.getBoundingClientRect(), bad = [];
const texts = [...drawing.svg.querySelectorAll('g.node text')].filter(t => !t.closest('.badge'));
for (const badge of drawing.svg.querySelectorAll('.badge')) {
  const box = badge.getBoundingClientRect();
  if (box.left < pane.left || box.right > pane.right || box.bottom > pane.bottom) bad.push('cut off: ' + badge.textContent);
  for (const text of texts) if (!apart(box, text.getBoundingClientRect())) bad.push(badge.textContent + ' on ' + text.textContent);
}
for (const path of drawing.svg.querySelectorAll('g.edge path')) {
  const matrix = path.getScreenCTM(), long = path.getTotalLength();
  for (let at = 0; at <= long; at += 2) {
    const p = path.getPointAtLength(at).matrixTransform(matrix);
    for (const text of texts) {
      const box = text.getBoundingClientRect();
      if (p.x > box.left && p.x < box.right && p.y > box.top + 2 && p.y < box.bottom - 2) bad.push('a line through ' + text.textContent);
    }
  }
}
return bad"""


def check_plant(browser: webdriver.Browser) -> None:
    overlaps = browser.run(OVERLAPS)
    assert overlaps == [], overlaps
    # Ports are of ten points: legible, where all of the plant is seen at once.
    assert browser.run("return 10 / globalThis.flightReport.drawings[1].scale()") > 7
    # Where the whole cannot be read, what is chosen is shown so that it can be.
    browser.run("const d = globalThis.flightReport.drawings[1]; d.pane.style.maxHeight = '200px'; globalThis.flightReport.choose(-1);"
                "globalThis.flightReport.choose(globalThis.flightReport.flight.model.components.findIndex(c => c.name === 'engine'))")
    seen = browser.run("""const d = globalThis.flightReport.drawings[1], p = d.pane.getBoundingClientRect(),
        b = d.badges.find(b => b.path === 'engine').group.getBoundingClientRect();
        return [1 / d.scale(), b.left >= p.left && b.right <= p.right && b.top >= p.top && b.bottom <= p.bottom]""")
    assert seen[0] > 0.8 and seen[1], seen


def check_nominal(browser: webdriver.Browser, root: pathlib.Path, programs: pathlib.Path, folder: pathlib.Path) -> None:
    """What is forced into a nominal mode is an event; names of flights and failed expectations are easy to find."""
    scenario = root / "examples/spacecraft-deployment/deployment.scn"
    page = folder / "deployment.html"
    run([programs / "rmpl-run", "scenario", "-q", scenario, "--report", page])
    browser.open(page.as_uri())
    browser.wait("document.documentElement.dataset.ready")
    events = browser.run("return globalThis.flightReport.events.filter(e => e.kind === 'forced').map(e => [e.text, e.severe])")
    assert ["shuttle_signal = signalled", False] in events, events
    assert browser.run("return globalThis.flightReport.events.filter(e => e.severe).length") == 0
    assert browser.run("return globalThis.flightReport.cursor") == 0
    # Nothing in the row or the overview is red.
    used = browser.run("""const t = globalThis.flightReport.timeline, fault = t.color('fault'), used = [];
        const color = t.color; t.color = n => (used.push(n), color(n)); const draw = t.draw;
        t.drawRows(); t.drawOverview(); t.color = color; return used""")
    assert "fault" not in used and "quiet" in used
    story = subprocess.run([programs / "rmpl-run", "scenario", scenario, "--only", "antenna first, then the arrays", "--follow",
                            "--color", "always"], capture_output=True, text=True, timeout=60, check=True).stdout
    assert "plant     shuttle_signal = signalled" in story, story
    names = browser.run("return globalThis.flightReport && [...document.querySelectorAll('#flight option')].map(o => o.textContent)")
    for index in range(len(names)):
        browser.run("globalThis.flightReport.open(arguments[0])", index)
        name, title = browser.run("return [globalThis.flightReport.flight.name, document.getElementById('flight').title]")
        assert name == title and names[index].endswith(name)
    assert browser.complaints() == []


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
    # What failed is what is shown first, in the list too.
    browser.run("const r = globalThis.flightReport; r.flight.asked.unshift({text: 'before', verdict: 'met', reason: '', evidence: ''});"
                "r.panel.buildAsked()")
    chips = browser.run("return [...document.querySelectorAll('#pane-asked .chip')].map(c => c.textContent)")
    assert chips == ["failed", "met"], chips
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
        check_drawn(browser, root, programs, folder)
        check_nominal(browser, root, programs, folder)
    print("the report opens, says what the trace says, and the console is silent")
    return 0


if __name__ == "__main__":
    sys.exit(main())
