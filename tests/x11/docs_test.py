#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every command that a document shows runs as it is printed, and makes what it names; links lead to
files, and the figures that documents sum up are those of the tables. (What docs/TUTORIAL.md shows is
the matter of tests/install.)"""

import collections
import csv
import functools
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

BIN = pathlib.Path(os.environ["L3D_BIN"]).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[2]
SHOWN_BIN = "build/float-release/bin"
DOCUMENTS = [*sorted(path.name for path in ROOT.glob("*.md")), *sorted(str(path.relative_to(ROOT)) for folder in ("docs", "packaging")
                                  for path in (ROOT / folder).rglob("*.md"))]


def commands(text):
    """The indented lines that start a program of ours, by themselves or through another."""
    return [line.strip() for line in text.splitlines()
            if re.match("    (parallel )?" + SHOWN_BIN + "/", line)]


def make_commands(text):
    """What make is told to do, in lines of its own or within text."""
    return sorted(set(re.findall(r"^    (make .*)$", text, re.M) + re.findall(r"`(make [^`]*)`", text)))


def links(text):
    """Relative targets of links and pictures."""
    prose = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    return [target for target in re.findall(r"\]\(([^)#]+)\)", prose) if "://" not in target]


def outputs(command):
    """Files that a command is told to write; a numbered name stands for its first file."""
    return [re.sub(r"%0(.)d", lambda field: "0" * int(field[1]), name)
            for name in re.findall(r"--(?:output|report|depth-output|error-output) (\S+)", command)]


def run(command, folder):
    environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "L3D_BACKEND")}
    line = command.replace(SHOWN_BIN, str(BIN)).replace(" data/", " %s/data/" % ROOT)
    done = subprocess.run(line, shell=True, cwd=folder, env=environment, timeout=120,
                          stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode != 0:
        return f"exit status {done.returncode}: {done.stderr.strip()}"
    for name in outputs(command):
        if not (pathlib.Path(folder) / name).is_file():
            return f"wrote no {name}"
    return None


@functools.cache
def is_made(command):
    """Whether make knows what it is told to do. Only the first command of README.md is done, where
    all that it builds is there: doing everything again is not a test's business."""
    plain = {k: v for k, v in os.environ.items()
             if not k.startswith("MAKE") and k not in ("MFLAGS", "DISPLAY")}
    if command != "make run" or BIN != ROOT / SHOWN_BIN:
        command = command.replace("make ", "make -n ", 1)
    done = subprocess.run(command, shell=True, cwd=ROOT, env=plain, timeout=600,
                          stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode != 0:
        return done.stderr.strip().replace("\n", " | ")
    if command == "make run" and not (ROOT / done.stdout.split()[-1]).is_file():
        return "names no picture: " + done.stdout
    return None


def peers(ours, peer):
    """How many times as long the peer takes with the mesh that serves it best."""
    ratios = collections.defaultdict(list)
    with open(ROOT / "docs" / "report" / "peers.csv", newline="") as file:
        for row in csv.DictReader(file):
            case = tuple(row[name] for name in ("threads", "view", "width", "error_px"))
            ratios[case].append(float(row[peer + "_ms"]) / float(row[ours]))
    best = [min(of_meshes) for of_meshes in ratios.values()]
    return f"{min(best):.1f} to {max(best):.1f}, median {statistics.median(best):.1f}"


def sizes():
    """The stripped program and the shared library, in millions of bytes, where they are built."""
    found = []
    for path in (BIN / "teapot_afd", *BIN.parent.glob("libl3d.so.*")):
        with tempfile.NamedTemporaryFile() as stripped:
            subprocess.run(["strip", "-o", stripped.name, path], check=True)
            found.append(os.stat(stripped.name).st_size / 1e6)
    return found


def figures(text):
    """What README.md should say of its peers, and does not; sizes may be off by a twentieth."""
    if BIN == ROOT / SHOWN_BIN:
        said = [float(size) for size in re.findall(r"(\d\.\d) MB", text)]
        wrong = [(a, b) for a, b in zip(said, sizes()) if abs(a - b) > 0.05 * b]
        if wrong or len(said) != 2:
            return [f"sizes, said and so: {wrong}"]
    wanted = ["| %s | %s |" % (name, " | ".join(peers(ours, column) for ours in (
        "l3d_ms", "l3d_gouraud_ms"))) for name, column in (("llvmpipe", "llvmpipe"), ("Embree", "embree"))]
    return [line for line in wanted if line not in text]


def left_out(text):
    """The rows that docs/NUMERICS.md should have of what rules gain and cost, and has not."""
    rows = []
    with open(ROOT / "docs" / "report" / "leaving_out.csv", newline="") as file:
        for row in csv.DictReader(file):
            found = f"{row['left_out']} {row['unit']}" if row["left_out"] != "0" else "nothing"
            low, percent, high = (f"{float(row[name]):.1f}" for name in (
                "percent_low", "percent", "percent_high"))
            rows.append(f"| {row['rule']} | {row['scene']} | {found} | {percent} ({low} to {high}) |")
    return [line for line in rows if line not in text] if rows else ["the table is empty"]


@functools.cache
def tests_there():
    """What tests are called: their names, and suite.name of those in C++."""
    names = set()
    for path in [*(ROOT / "tests").rglob("*.cpp"), *(ROOT / "tests").rglob("*.py")]:
        text = path.read_text()
        for suite, name in re.findall(r"\bT(?:YPED_T)?EST(?:_F|_P)?\((\w+),\s*(\w+)\)", text):
            names |= {name, f"{suite}.{name}"}
        if path.suffix == ".py":
            names |= set(re.findall(r"^def (\w+)", text, re.M))
    return names


def is_path(name):
    """A file or folder from the root or from tests/, whose ending may be left out; * stands for anything."""
    return any(list(ROOT.glob(f"{before}{name}{after}")) for before in ("", "tests/") for after in ("", ".cpp"))


def book_rows(text):
    """What the tables of docs/BOOK.md name that is not there, and rows whose last column names no test. A
    test is a file of tests/, a test's name or the beginning of one (row_23), or a target of make."""
    known, wrong, last = tests_there(), [], ""
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")] if line.startswith("|") else []
        if not cells or set(line) <= set("|- "):
            last = last if cells else ""
            continue
        if not last:
            last = cells[-1]
            continue
        for path in re.findall(r"`((?:lib|apps|tests)/[^` ]*)`", line):
            if not is_path(path):
                wrong.append(f"{path} is not there")
        if not last.startswith(("test", "shown by")):
            continue
        found = False
        for quoted, word in re.findall(r"`([^`]+)`|\b([A-Za-z0-9]+_\w+|[A-Z][a-z]+[A-Z]\w+)", cells[-1]):
            if quoted.startswith(("l3d_", "--")) or is_path(f"apps/{quoted}/main.cpp"):
                continue  # said of the test
            is_there = (is_path(quoted) if "/" in quoted else quoted.startswith("make ") if " " in quoted
                        else "=" in quoted or quoted in known or is_path(quoted)) if quoted else any(
                            name.startswith(word) for name in known)
            found |= is_there
            if not is_there:
                wrong.append(f"'{quoted or word}' is no test")
        if not found:
            wrong.append(f"no test: {line[:60]}")
    return wrong


def named_tests(text):
    """Tests that a document names, and that are not there; and rows under "Shown by" that name nothing,
    unless they say why not. `suite.*` stands for all of a suite."""
    known = tests_there()
    known = known | {name.split(".")[0] + ".*" for name in known if "." in name}
    wrong, shows = [], False
    for line in text.splitlines():
        shows = line.startswith("|") and (shows or line.endswith("| Shown by |"))
        suites = [name for name in re.findall(r"`(\w+\.(?:\w+|\*))`", line)
                  if name.split(".")[0] + ".*" in known or name.endswith(".*")]
        wrong += [name for name in suites if name not in known]
        wrong += [name for name in re.findall(r"`(\w+/\w+\.py)`", line) if not is_path(name)]
        what, shown = [cell.strip() for cell in line.strip("|").split("|")][-2:] if shows else ("No.", "")
        if not shown and not what.startswith("No."):
            wrong.append(f"no test: {line[:60]}")
    return wrong


def files_answering(text):
    """Files in the tables of docs/ARCHITECTURE.md that are neither in the root nor in lib/; a name without a folder
    stands for a file in any."""
    named = [name for line in text.splitlines() if line.startswith("|")
             for name in re.findall(r"`([\w/.-]+\.(?:h|cpp|mk))`", line)]
    everywhere = {path.name for folder in ("lib", "tests") for path in (ROOT / folder).rglob("*")}
    return [name for name in named
            if name not in everywhere and not any((ROOT / folder / name).is_file() for folder in ("", "lib"))]


def main():
    failed = 0
    wrong = book_rows((ROOT / "docs" / "BOOK.md").read_text())
    print(f"not ok docs docs/BOOK.md: rows {wrong}" if wrong else "ok docs docs/BOOK.md: rows")
    failed += bool(wrong)
    for document, missing_in in (("README.md", figures), ("docs/NUMERICS.md", left_out), ("docs/ARCHITECTURE.md", files_answering)):
        missing = missing_in((ROOT / document).read_text())
        print(f"not ok docs {document}: {missing_in.__name__} {missing}" if missing
              else f"ok docs {document}: {missing_in.__name__}")
        failed += bool(missing)
    for document in ("docs/DISSERTATION.md", "docs/POLYGONS.md"):
        wrong = named_tests((ROOT / document).read_text())
        print(f"not ok docs {document}: tests {wrong}" if wrong else f"ok docs {document}: tests")
        failed += bool(wrong)
    for document in DOCUMENTS:
        text = (ROOT / document).read_text()
        for command in make_commands(text):
            why = is_made(command)
            print(f"not ok docs {document}: {command} {why}" if why else f"ok docs {document}: {command}")
            failed += bool(why)
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
