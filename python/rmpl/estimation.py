"""What state a plant is in: beliefs, update by update."""
# SPDX-License-Identifier: MIT
import json
from collections.abc import Iterable, Iterator, Mapping

from rmpl import _rmpl
from rmpl.model import model_of
from rmpl.rows import Rows, frame_of
from rmpl.text import chosen, duration


class State(Mapping):
    """A mode for each component; `clocks` has those that count, in seconds since they started. It does not change.

    Of a model program: the values that a marking entails, which need not be of every variable; `marking` has its locations by number.
    """

    __slots__ = ("_modes", "clocks", "marking", "_key")

    def __init__(self, modes: dict, clocks: dict, marking: tuple[int, ...] | None = None):
        self._modes = modes
        self.clocks = clocks
        self.marking = marking
        self._key = (tuple(modes.items()), tuple(clocks.items()), marking)

    def __getitem__(self, component):
        return self._modes[component]

    def __iter__(self):
        return iter(self._modes)

    def __len__(self):
        return len(self._modes)

    def __hash__(self):
        return hash(self._key)

    def __eq__(self, other):
        return self._key == other._key if isinstance(other, State) else self._modes == other

    def __repr__(self):
        modes = ", ".join(f"{name} = {mode}" for name, mode in self._modes.items())
        clocks = ", ".join(f"{name}: {seconds} s" for name, seconds in self.clocks.items())
        marking = "" if self.marking is None else f"{list(self.marking)} "
        return f"<{marking}{modes}{'; ' + clocks if clocks else ''}>"


def state_of(entry: dict) -> State:
    """Of an entry of a belief, as an answer has it."""
    return State(entry["modes"], entry["clocks"]) if "modes" in entry else State(entry["values"], {}, tuple(entry["marking"]))


class Belief(Mapping):
    """States with their probabilities, the most probable first; with ranks, states with their ranks.

    `answer` is the line of `rmpl-run estimate` as a dictionary: `time`, `estimate`, `belief`, `missing_mass`, and `set_aside`, `cut`,
    `history`, `revised`, `events` where there is something to say; of a model program also `marking`.
    """

    def __init__(self, answer: dict, variables: frozenset[str] | None = None):
        self.answer = answer
        self._variables = variables  # of a model program: a state need not have them all
        self._states: dict | None = None

    def _all(self) -> dict:
        if self._states is None:
            self._states = {state_of(entry): entry["probability"] if "probability" in entry else entry["rank"]
                            for entry in self.answer["belief"]}
        return self._states

    @property
    def time(self) -> float:
        """Seconds."""
        return self.answer["time"]

    @property
    def estimate(self) -> dict:
        """The most likely mode of each component; of a model program what the most likely marking entails."""
        return self.answer.get("estimate", {})

    @property
    def marking(self) -> list[int] | None:
        """Of a model program: the locations of the most likely marking."""
        return self.answer.get("marking")

    @property
    def missing_mass(self) -> float | None:
        """An upper bound of the probability of all states that are not listed."""
        return self.answer.get("missing_mass")

    def __getitem__(self, state):
        return self._all()[state]

    def __iter__(self) -> Iterator[State]:
        return iter(self._all())

    def __len__(self):
        return len(self.answer["belief"])

    def probability(self, **modes) -> float:
        """Of all states in which these components are in these modes, or these values are entailed."""
        return sum(share for state, share in self.items() if all(self._value(state, name) == mode for name, mode in modes.items()))

    def _value(self, state: State, name: str):
        """Of a model program None where the marking leaves it open. Raises KeyError where there is no such name."""
        if self._variables is None:
            return state[name]
        if name not in self._variables:
            raise KeyError(name)
        return state.get(name)

    def marginal(self, component: str) -> dict[str | None, float]:
        """The probability of each mode of a component, most probable first.

        Of a model program: that a value of the variable is entailed; None is that of all markings that leave it open.
        """
        shares: dict[str | None, float] = {}
        for state, share in self.items():
            value = self._value(state, component)
            shares[value] = shares.get(value, 0) + share
        return dict(sorted(shares.items(), key=lambda item: -item[1]))

    def frame(self):
        """A pandas frame: a row a state, a column a component, clocks, and the probability."""
        return frame_of(self.answer["belief"])

    def __repr__(self):
        return f"<rmpl.Belief at {self.time} s: {len(self)} states, {self.estimate}>"


class Estimator:
    """The belief about a plant or a model program, told what was commanded and seen. It starts at time 0 in the initial distribution.

    `estimator` is `k-best` or `exact`; `k` is how many states k-best keeps, or exact lists. With `window`, answers have the most likely
    histories of so many updates. The options are those of `rmpl-run estimate`; `beam` is about model programs, and `thesis`, `ranks`,
    `all_clocks`, `deadline` and `max_memory` are about plants. Each update of a model program is a step, whatever its time.
    """

    def __init__(self, model, estimator: str = "k-best", k: int | None = None, window: int | None = None, deadline=None,
                 max_memory: int | None = None, thesis: bool = False, ranks: bool = False, all_clocks: bool = False,
                 stats: bool = False, beam: bool = False):
        exact = chosen(estimator, "k-best", "exact", "estimator")
        if exact and (thesis or ranks or deadline is not None):
            raise ValueError("thesis, ranks and deadline are about k-best")
        if beam and (exact or window is not None):
            raise ValueError("beam keeps a beam of its own: expected neither an exact estimator nor a window")
        if window is not None and (thesis or ranks or deadline is not None):
            raise ValueError("a window weighs exactly: expected none of thesis, ranks and deadline")
        if k is not None and k < 1:
            raise ValueError("k: expected at least 1")
        self._estimator = _rmpl.Estimator(model_of(model)._compiled, exact, k, window, duration(deadline), max_memory, thesis, ranks,
                                          all_clocks, stats, beam)
        variables = self._estimator.variables()
        self._variables = None if variables is None else frozenset(variables)

    def update(self, time: float | None = None, command: Mapping | None = None, observations: Mapping | None = None,
               **line) -> Belief:
        """Takes in the command that was in force since the update before, and what is seen at `time`; the belief after that.

        Variables that the command leaves out are idle. At time 0 and without a command it says what is seen at the start. More keys of
        a log's line may be given, such as `cycle`.
        """
        if time is not None:
            line["time"] = time
        if command is not None:
            line["command"] = dict(command)
        if observations is not None:
            line["observations"] = dict(observations)
        return Belief(json.loads(self._estimator.update(json.dumps(line))), self._variables)

    def follow(self, log) -> Iterator[Belief]:
        """The belief after each line of a log: a path of JSON Lines, or lines as dictionaries."""
        if isinstance(log, Iterable) and not isinstance(log, (str, bytes)):
            lines = (json.dumps(line) for line in log)
            yield from self._answers(lines)
        else:
            with open(log, encoding="utf-8") as lines:
                yield from self._answers(lines)

    def _answers(self, lines) -> Iterator[Belief]:
        for line in lines:
            if not line.isspace():
                answer = self._estimator.update(line)
                if answer:
                    yield Belief(json.loads(answer), self._variables)


def estimate(model, log, **options) -> Rows:
    """The answers to all lines of a log, as `rmpl-run estimate` gives them. `options` are those of `Estimator`."""
    return Rows(belief.answer for belief in Estimator(model, **options).follow(log))
