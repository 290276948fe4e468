"""Timed model-based programming from Python: compile, fly, estimate, plan, diagnose, check.

The functions call what the programs `rmplc`, `rmpl-run` and `tcca-check` call: answers are the same, as plain
dictionaries with the keys of their JSON. Where pandas is installed, `frame()` makes a table of an answer.
"""
# SPDX-License-Identifier: MIT
from rmpl._rmpl import version as __version__
from rmpl.errors import Error, InputError, InternalError, LimitError, Rejected
from rmpl.estimation import Belief, Estimator, State, estimate
from rmpl.flights import Flight, campaign, fly
from rmpl.model import Diagram, Model, compile  # pylint: disable=redefined-builtin
from rmpl.questions import check, diagnose, plan
from rmpl.rows import Rows

__all__ = ["Belief", "Diagram", "Error", "Estimator", "Flight", "InputError", "InternalError", "LimitError", "Model", "Rejected", "Rows",
           "State", "campaign", "check", "compile", "diagnose", "estimate", "fly", "plan"]
