#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every program command that README.md shows runs as it is printed, and makes what it names."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

BIN = pathlib.Path(os.environ["L3D_BIN"]).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[2]
SHOWN_BIN = "build/float-release/bin"


def commands(text):
    """The indented lines that start a program of ours."""
    return [line.strip() for line in text.splitlines()
            if line.startswith("    " + SHOWN_BIN + "/")]


def links(text):
    """Relative targets of links and pictures."""
    return [target for target in re.findall(r"\]\(([^)#]+)\)", text) if "://" not in target]


def outputs(command):
    """Files that a command is told to write; a numbered name stands for its first file."""
    return [name.replace("%02d", "00")
            for name in re.findall(r"--(?:output|report|depth-output) (\S+)", command)]


def run(command, folder):
    environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "L3D_BACKEND")}
    line = command.replace(SHOWN_BIN, str(BIN))
    done = subprocess.run(line, shell=True, cwd=folder, env=environment, timeout=120,
                          stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode != 0:
        return f"exit status {done.returncode}: {done.stderr.strip()}"
    for name in outputs(command):
        if not (pathlib.Path(folder) / name).is_file():
            return f"wrote no {name}"
    return None


def main():
    failed = 0
    for document in ("README.md", "ARCHITECTURE.md", "docs/NUMERICS.md", "docs/SPEED.md",
                     "docs/DISPLAYS.md", "docs/BOOK.md", "docs/POLYGONS.md"):
        text = (ROOT / document).read_text()
        found = commands(text)
        if document == "README.md" and not found:
            print("not ok docs README.md shows no command")
            failed += 1
        for command in found:
            with tempfile.TemporaryDirectory() as folder:
                why = run(command, folder)
            name = f"docs {document}: {command}"
            print(f"not ok {name} {why}" if why else f"ok {name}", flush=True)
            failed += bool(why)
        broken = [t for t in links(text) if not (ROOT / document).parent.joinpath(t).exists()]
        print(f"not ok docs {document} links to nothing: {broken}" if broken
              else f"ok docs {document}: links", flush=True)
        failed += bool(broken)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
