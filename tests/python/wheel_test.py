#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The wheel: Debian's tools build it, pip installs it into a fresh environment, and the first program runs there."""

import os
import pathlib
import subprocess
import sys
import tempfile
import venv
import zipfile

from checks import PACKAGES, ROOT, expect, run_all


def run(command, folder, **more):
    clean = {name: value for name, value in os.environ.items()
             if not name.startswith("PYTHON") and name != "LD_LIBRARY_PATH"}
    done = subprocess.run(command, cwd=folder, text=True, capture_output=True, env={**clean, **more})
    expect(done.returncode == 0, command, done.stdout[-2000:], done.stderr[-2000:])
    return done.stdout


def built_wheel(folder):
    """A wheel of a copy of the package."""
    for name in ("l3d", "setup.py", "pyproject.toml"):
        run(["cp", "-r", str(PACKAGES / name), str(folder)], folder)
    run([sys.executable, "-m", "build", "--no-isolation", "--wheel"], folder)
    wheels = list((folder / "dist").glob("*.whl"))
    expect(len(wheels) == 1, wheels)
    return wheels[0]


def check_wheel_is_built_installed_and_draws():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "source").mkdir()
        wheel = built_wheel(folder / "source")
        expect(wheel.name.startswith("l3d-") and "-cp311-abi3-linux_" in wheel.name, wheel.name)
        inside = zipfile.ZipFile(wheel).namelist()
        for file in ("__init__.py", "__init__.pyi", "py.typed", "_l3d.abi3.so", "libl3d.so.0"):
            expect("l3d/" + file in inside, file, inside)
        metadata = zipfile.ZipFile(wheel).read(next(f for f in inside if f.endswith("/METADATA"))).decode()
        expect("Requires-Python: >=3.11" in metadata and "License: MIT" in metadata, metadata)
        venv.create(folder / "env", with_pip=True)
        python = folder / "env" / "bin" / "python"
        run([python, "-m", "pip", "install", "--no-index", "--no-deps", str(wheel)], folder)
        first = (ROOT / "docs" / "PYTHON.md").read_text().split("```python\n", 1)[1].split("```", 1)[0]
        (folder / "first.py").write_text(first)
        said = run([python, "first.py"], folder)
        expect("(480, 640, 3)" in said and (folder / "teapot.png").stat().st_size > 1000, said)
        where = run([python, "-c", "import l3d; print(l3d.__file__)"], folder)
        expect(where.startswith(str(folder / "env")), where)


if __name__ == "__main__":
    run_all(globals(), "python_wheel")
