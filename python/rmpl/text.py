"""Arguments as the languages write them."""
# SPDX-License-Identifier: MIT
from collections.abc import Mapping


def assignments(given) -> str:
    """`x = v, y = w`, of a mapping or of a text that says so already."""
    if given is None:
        return ""
    if isinstance(given, Mapping):
        return ", ".join(f"{name} = {value}" for name, value in given.items())
    return str(given)


def duration(given) -> str:
    """A number of seconds, or a text such as `90 s`; nothing is an empty text."""
    if given is None:
        return ""
    return f"{given:.9f}" if isinstance(given, (int, float)) else str(given)


def chosen(given: str, first: str, second: str, name: str) -> bool:
    """Whether the second of two words was given."""
    if given not in (first, second):
        raise ValueError(f"{name}: expected '{first}' or '{second}', not '{given}'")
    return given == second
