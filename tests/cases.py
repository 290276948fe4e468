# Cases of a script, each in a folder of its own. SPDX-License-Identifier: MIT
import pathlib
import tempfile
import traceback


def run(cases) -> int:
    """Calls each with an empty folder, tells which fail an assertion, and returns the exit code."""
    failed = 0
    for case in cases:
        with tempfile.TemporaryDirectory() as name:
            try:
                case(pathlib.Path(name).resolve())
            except AssertionError as error:
                failed += 1
                print(f"{case.__name__}: {error or 'failed'}")
                traceback.print_exc()
    print(f"{len(cases)} cases, {failed} failed")
    return 1 if failed else 0
