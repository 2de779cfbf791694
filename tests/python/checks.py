# SPDX-License-Identifier: MIT
"""What the tests of the Python module share: checks, and the module itself, never installed."""

import os
import pathlib
import sys
import traceback

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGES = pathlib.Path(os.environ["L3D_PYTHON"]).resolve()  # the folder that has the package l3d
sys.path.insert(0, str(PACKAGES))


def expect(condition, *facts):
    """A condition that must hold, and what to tell if it does not."""
    if not condition:
        raise AssertionError(" ".join(repr(fact) for fact in facts))


def run_all(functions, suite):
    """Runs the functions that are called check_..., prints `ok` or `not ok` for each, and ends."""
    failed = 0
    for name, function in list(functions.items()):
        if not name.startswith("check_"):
            continue
        try:
            function()
            print(f"ok {suite}.{name[6:]}", flush=True)
        except Exception as error:  # a check may fail in any way; the others still run
            failed += 1
            line = traceback.extract_tb(error.__traceback__)[-1].lineno
            why = f"{type(error).__name__} {error}".replace("\n", " | ")
            print(f"not ok {suite}.{name[6:]} line {line}: {why}", flush=True)
    sys.exit(1 if failed else 0)
