"""Models: compiled sources, and their drawings."""
# SPDX-License-Identifier: MIT
import json
import os
import subprocess
from collections.abc import Mapping

from rmpl import _rmpl
from rmpl.errors import InputError


def svg_of(dot: str) -> str:
    """A graph laid out by Graphviz. Raises InputError where its program `dot` is not there, or fails."""
    try:
        done = subprocess.run(["dot", "-Tsvg"], input=dot.encode(), capture_output=True, check=False)
    except FileNotFoundError as error:
        raise InputError("dot, the layout program of Graphviz, is not installed: install the package 'graphviz'") from error
    if done.returncode != 0:
        raise InputError("dot, the layout program of Graphviz, failed: " + done.stderr.decode(errors="replace"))
    return done.stdout.decode()


class Diagram:
    """An automaton or a plant as a picture. Notebooks show it as SVG, where Graphviz is installed."""

    def __init__(self, dot: str):
        self.dot = dot

    def svg(self) -> str:
        """The picture. Raises InputError where Graphviz is not there."""
        return svg_of(self.dot)

    def _repr_svg_(self):
        try:
            svg = self.svg()
        except InputError:
            return None
        return svg[svg.index("<svg"):]


class Model:
    """What was compiled; see `compile`."""

    def __init__(self, compiled, files):
        self._compiled = compiled
        self._names = json.loads(compiled.names())
        self.files: list[str] = files

    def __repr__(self):
        what = [f"{kind} {', '.join(names)}" for kind, names in self._names.items() if names]
        return f"<rmpl.Model {'; '.join(what)}>"

    @property
    def plants(self) -> list[str]:
        """Names of the plants."""
        return self._names["plants"]

    @property
    def programs(self) -> list[str]:
        """Names of the control programs."""
        return self._names["programs"]

    @property
    def model_programs(self) -> list[str]:
        """Names of the model programs."""
        return self._names["models"]

    @property
    def scenarios(self) -> list[str]:
        """Names of the scenarios."""
        return self._names["scenarios"]

    @property
    def diagnostics(self) -> list[dict]:
        """Warnings of the compiler, as `Rejected.diagnostics`."""
        return json.loads(self._compiled.diagnostics())

    def document(self) -> dict:
        """The automata: what `rmplc compile` writes."""
        return json.loads(self._compiled.text())

    def diagram(self, of: str = "", depth: int | None = None) -> Diagram:
        """A picture as `rmplc diagram --of` draws it: a program, a plant, a component type, or the path of a module."""
        return Diagram(self._compiled.dot(of, depth))

    def _repr_svg_(self):
        try:
            return self.diagram()._repr_svg_()
        except InputError:
            return None


def compile(*files, main: str = "", texts: Mapping | None = None) -> Model:
    """Compiles sources (.tcca, .rmpl, .scn, .mon) and compiled documents (.json) as one input set.

    `main` is the definition that a control program starts with. `texts` holds sources by name, which need no file: names that are
    no `files` too are compiled with them. Raises Rejected with the diagnostics where there are errors.
    """
    sources = {os.fspath(path): str(text) for path, text in (texts or {}).items()}
    paths = [os.fspath(path) for path in files] or list(sources)
    if not paths:
        raise InputError("compile: expected files, or texts")
    return Model(_rmpl.Model(paths, sources, main), paths)


def model_of(given) -> Model:
    """A model, or the files to make it of: a path, or several."""
    if isinstance(given, Model):
        return given
    return compile(given) if isinstance(given, (str, os.PathLike)) else compile(*given)
