"""Questions to a model: what would be done, what is broken, what is so on every run."""
# SPDX-License-Identifier: MIT
import json
import os
from collections.abc import Sequence

from rmpl import _rmpl
from rmpl.model import model_of
from rmpl.text import assignments, chosen, duration


def plan(model, goal: str, start=None, reconfigurer: str = "planner", cycle=None) -> dict:
    """The commands that lead from the modes `start` to the goal, as `rmpl-run plan --format json` has them.

    `start` is a mapping or a text such as `engine = off, pde = off`; components that it leaves out are in their most likely initial
    mode. `cycle` is that of the executive, in seconds or as a text; without it time is dense.
    """
    one_step = chosen(reconfigurer, "planner", "one-step", "reconfigurer")
    return json.loads(_rmpl.plan(model_of(model)._compiled, assignments(start), assignments(goal), one_step, duration(cycle)))


def diagnose(model, observe, modes=None, k: int = 10, ratio: float = float("inf"), all_minimal: bool = False, first: bool = False,
             count: bool = False) -> dict:
    """The faults that explain one snapshot, best first, as `rmpl-run diagnose --format json` has them."""
    return json.loads(_rmpl.diagnose(model_of(model)._compiled, assignments(observe), assignments(modes), k, ratio, all_minimal, first,
                                     count))


def check(model, properties, text: str | None = None, only: Sequence[str] = (), max_states: int | None = None, timeout=None,
          max_memory: int | None = None) -> dict:
    """The verdicts on a file of properties, as `tcca-check check --format json` has them.

    The model is a plant, with the control program that the properties speak of, if any. With `text`, the properties are what it says,
    and `properties` is their name.
    """
    return json.loads(_rmpl.check(model_of(model)._compiled, os.fspath(properties), text, list(only), max_states, duration(timeout),
                                  max_memory))
