"""What goes wrong, by whose doing."""
# SPDX-License-Identifier: MIT
import json


class Error(Exception):
    """Any error of this package."""


class InputError(Error, ValueError):
    """An argument or a file is wrong: the programs would end with exit code 2."""


class Rejected(InputError):
    """A model, a formula or a file of properties has errors.

    `diagnostics` lists them as `rmplc check --format json` does: code, severity, file, line, column, message, notes, fix.
    """

    def __init__(self, text: str, diagnostics: str = "[]"):
        super().__init__(text.rstrip())
        self.diagnostics: list[dict] = json.loads(diagnostics)


class LimitError(Error):
    """There is no answer within a limit: the programs would end with exit code 3."""


class InternalError(Error):
    """A result failed its own check, so nothing is claimed: a mistake of this package."""
