"""Flights: the executive on a simulated plant, once or many times."""
# SPDX-License-Identifier: MIT
import csv
import html
import io
import json
import os

from rmpl import _rmpl
from rmpl.errors import InputError
from rmpl.model import Model, model_of, svg_of
from rmpl.rows import Rows, frame_of
from rmpl.text import chosen


class Flight:
    """A scenario that was flown; see `fly`. Notebooks show it as the report."""

    def __init__(self, flown):
        self._flown = flown
        self._result = json.loads(flown.result())

    @property
    def name(self) -> str:
        """Of the scenario."""
        return self._result["scenario"]

    @property
    def verdict(self) -> str:
        """`met`, `failed` or `undecided`."""
        return self._result["verdict"]

    @property
    def result(self) -> dict:
        """What `rmpl-run scenario --format json` says of the scenario."""
        return self._result

    @property
    def trace(self) -> Rows:
        """The lines of the trace."""
        return Rows(json.loads(line) for line in self._flown.trace().splitlines())

    @property
    def story(self) -> str:
        """The flight told to people."""
        return self._flown.story()

    @property
    def changes(self) -> Rows:
        """What changed, a row each: time, kind, name, value, note."""
        rows = Rows(csv.DictReader(io.StringIO(self._flown.csv(), newline="")))
        for row in rows:
            row["time"] = float(row["time"])
        return rows

    def frame(self):
        """The changes as a pandas frame."""
        return frame_of(self.changes)

    def report(self) -> str:
        """A page to look at the flight in a browser, all in one file."""
        drawings, missing = [], ""
        for graph in (self._flown.program_dot(), self._flown.plant_dot()):
            try:
                drawings.append(svg_of(graph))
            except InputError as error:
                drawings.append("")
                missing = str(error)
        return self._flown.html(self.name, *drawings, missing)

    def save(self, path) -> None:
        """Writes a view, which the end of the name tells: .html, .jsonl (the trace), .csv, .vcd or .mcap."""
        views = {".html": self.report, ".jsonl": self._flown.trace, ".csv": self._flown.csv, ".vcd": self._flown.vcd,
                 ".mcap": self._flown.mcap}
        end = os.path.splitext(os.fspath(path))[1]
        if end not in views:
            raise InputError(f"{path}: expected a name that ends in {', '.join(views)}")
        view = views[end]()
        with open(path, "wb") as file:
            file.write(view if isinstance(view, bytes) else view.encode())

    def _repr_html_(self):
        return (f'<iframe title="{html.escape(self.name)}" style="width: 100%; height: 40rem; border: 0" '
                f'srcdoc="{html.escape(self.report())}"></iframe>')

    def __repr__(self):
        return f"<rmpl.Flight {self.name}: {self.verdict}>"


def fly(model, scenario: str | None = None, seed: int | None = None, estimator: str = "k-best", k: int = 16,
        reconfigurer: str = "planner", trace: str = "changes") -> Flight:
    """Flies a scenario of a model or a .scn file; `scenario` names it where there are several.

    `seed` draws the plant in place of the scenario's. `trace` is its detail: `changes`, `cycles` or `beliefs`. The options are those of
    `rmpl-run scenario`.
    """
    details = {"changes": _rmpl.TraceDetail.changes, "cycles": _rmpl.TraceDetail.cycles, "beliefs": _rmpl.TraceDetail.beliefs}
    if trace not in details:
        raise ValueError(f"trace: expected one of {', '.join(details)}, not '{trace}'")
    exact = chosen(estimator, "k-best", "exact", "estimator")
    one_step = chosen(reconfigurer, "planner", "one-step", "reconfigurer")
    return Flight(_rmpl.Flight(model_of(model)._compiled, scenario, exact, k, one_step, seed, details[trace]))


def campaign(model: Model | str, scenario: str | None = None, runs: int = 100, faults: int = 0, seed: int = 1, jobs: int | None = None,
             unmodelled: bool = False) -> Rows:
    """Flies a scenario many times with injected faults: a row a run, the same as `rmpl-run campaign` has in its database."""
    workers = jobs if jobs is not None else os.cpu_count() or 1
    return Rows(json.loads(_rmpl.campaign(model_of(model)._compiled, scenario, runs, faults, seed, workers, unmodelled)))
