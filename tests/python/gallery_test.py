#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The programs of docs/PYTHON.md run in a fresh environment and draw the pictures of the page; --write DIR
keeps these."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import venv

from checks import PACKAGES, ROOT, expect, run_all

import l3d

PAGE = (ROOT / "docs" / "PYTHON.md").read_text()
MODELS = ("ball.asc", "bird.off", "mask.off", "teapot.bpt", "thing.asc", "torus.off")
MOST_LINES = 15  # beside empty ones and the first, which says what is shown
NEARLY = 8  # levels: letters and threads of this machine may differ from those of the page


def programs():
    return dict(re.findall(r"^```python\n# (\w+)\.py: .*?\n(.*?)^```", PAGE, re.M | re.S))


def fresh_python(folder):
    """An interpreter that finds the module as it would find one that was installed, and NumPy."""
    venv.create(folder, system_site_packages=True, with_pip=False)
    python = folder / "bin" / "python"
    site = subprocess.run([python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"],
                          check=True, capture_output=True, text=True).stdout.strip()
    shutil.copytree(PACKAGES / "l3d", pathlib.Path(site) / "l3d")
    return python


def run_programs(folder):
    python = fresh_python(folder / "python")
    work = folder / "work"
    (work / "models").mkdir(parents=True)
    for model in MODELS:
        shutil.copy(ROOT / "data" / model, work / "models")
    clean = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    for name, text in programs().items():
        (work / f"{name}.py").write_text(text)
        done = subprocess.run([python, f"{name}.py"], cwd=work, env=clean, text=True, capture_output=True)
        expect(done.returncode == 0, name, done.stderr)
    return work


def share_of_far_pixels(one, other):
    a, b = bytes(one), bytes(other)
    return sum(abs(x - y) > NEARLY for x, y in zip(a, b)) / len(a)


def check_programs_are_short():
    long = {name: len([line for line in text.splitlines() if line.strip()]) for name, text in programs().items()}
    expect(len(long) == 11 and max(long.values()) <= MOST_LINES, long)


def check_programs_draw_the_pages_pictures():
    shown = re.findall(r"\]\(pictures/(python_\w+\.png)\)", PAGE)
    expect(len(shown) == 10, shown)
    with tempfile.TemporaryDirectory() as folder:
        work = run_programs(pathlib.Path(folder))
        for name in shown:
            drawn, kept = l3d.Picture.load(work / name), l3d.Picture.load(ROOT / "docs" / "pictures" / name)
            expect(drawn.size == kept.size, name, drawn.size)
            if name != "python_error.png":  # which shows times
                share = share_of_far_pixels(drawn, kept)
                expect(share < 0.02, name, share)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--write"]:
        with tempfile.TemporaryDirectory() as folder:
            for picture in run_programs(pathlib.Path(folder)).glob("python_*.png"):
                shutil.copy(picture, sys.argv[2])
        sys.exit(0)
    run_all(globals(), "python_gallery")
