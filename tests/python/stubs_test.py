#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The stubs: a type checker takes a program and refuses wrong ones; every public name is there and explained."""

import inspect
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from checks import PACKAGES, ROOT, expect, run_all

import l3d

HERE = pathlib.Path(__file__).parent


def checked_types(file):
    with tempfile.TemporaryDirectory() as cache:
        return subprocess.run(["mypy", "--strict", "--cache-dir", cache, str(HERE / file)], text=True,
                              capture_output=True, env={**os.environ, "MYPYPATH": str(PACKAGES)})


def check_mypy_takes_a_program():
    done = checked_types("typed_program.py")
    expect(done.returncode == 0, done.stdout, done.stderr)


def check_mypy_refuses_wrong_lines():
    done = checked_types("typed_wrongly.py")
    wrong = [int(line) for line in re.findall(r"typed_wrongly.py:(\d+): error", done.stdout)]
    lines = (HERE / "typed_wrongly.py").read_text().splitlines()
    wanted = [i + 1 for i, line in enumerate(lines) if line.startswith("l3d.")]
    expect(sorted(set(wrong)) == wanted, done.stdout)


def check_the_program_runs():
    done = subprocess.run([sys.executable, str(HERE / "typed_program.py")], text=True, capture_output=True,
                          env={**os.environ, "PYTHONPATH": str(PACKAGES)})
    expect(done.returncode == 0, done.stderr)


def public_names(scope):
    return {name for name in dir(scope) if not name.startswith("_") or name == "_repr_png_"}


def check_every_name_is_in_the_stubs_and_explained():
    stub = (ROOT / "python" / "l3d" / "__init__.pyi").read_text()
    classes = {name: text for name, text in re.findall(r"^class (\w+).*?:\n(.*?)(?=^\S|\Z)", stub, re.M | re.S)}
    functions = set(re.findall(r"^def (\w+)", stub, re.M))
    public = {name for name in classes if not name.startswith("_")} | functions
    expect(public_names(l3d) == public, public_names(l3d) ^ public)
    for name in public:
        thing = getattr(l3d, name)
        expect(thing.__doc__ and len(thing.__doc__.split()) > 3, name)
        if name not in classes or issubclass(thing, Exception):
            continue
        listed = set(re.findall(r"^    def (\w+)", classes[name], re.M))
        listed = {one for one in listed if not one.startswith("__")}
        expect(public_names(thing) == listed, name, public_names(thing) ^ listed)
        for member in listed:
            expect(getattr(thing, member).__doc__, name, member)


def check_signatures_are_those_of_calls():
    parameters = inspect.signature(l3d.draw).parameters
    expect(parameters["tolerance"].default == 0.25 and parameters["size"].default == (640, 480))
    for name, parameter in parameters.items():
        if name in ("what", "camera", "style", "rotation", "cull", "material", "frame"):
            continue
        if parameter.default is not None:
            l3d.draw(l3d.Model.load("teapot"), **{"size": (16, 16), name: parameter.default})


if __name__ == "__main__":
    run_all(globals(), "python_stubs")
