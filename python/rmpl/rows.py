"""Answers that are lists of dictionaries, and tables of them."""
# SPDX-License-Identifier: MIT


def frame_of(rows):
    """The rows as a pandas frame: a column for each value, those of nested dictionaries by the path of its keys."""
    try:
        import pandas
    except ImportError as error:
        raise ImportError("frames need pandas: install the package python3-pandas") from error
    return pandas.json_normalize(list(rows))


class Rows(list):
    """A list of dictionaries."""

    def frame(self):
        """The same as a pandas frame. Raises ImportError where pandas is not there."""
        return frame_of(self)
