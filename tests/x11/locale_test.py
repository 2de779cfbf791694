#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A host may have taken a locale with decimal commas, by setlocale and for streams: what every program prints,
writes and draws is the same as without."""

import json
import os
import subprocess
import sys

import harness
from harness import Checks, environment, expect, expect_equal, folder

LOCALE = "de_DE.UTF-8"
# The host's part, which runs before main.
HOST = r"""
#include <clocale>
#include <cstdio>
#include <iostream>
#include <locale>
namespace {
struct host {
    host() {
        std::setlocale(LC_ALL, "");
        std::locale::global(std::locale(""));
        char text[8];
        std::snprintf(text, sizeof text, "%.1f", 0.5);
        if (text[1] != ',')
            std::fputs("no commas here\n", stderr);
    }
} takes_a_locale;
}
"""
PICTURE = ("--no-input", "--backend", "memory", "--size", "157x119", "--frames", "2", "--output", "a.png")
RUNS = (
    ("teapot_afd", *PICTURE, "--pick", "80,60", "--report", "a.json"),
    ("teapot_afd", *PICTURE, "--explain", "--tolerance", "0.005", "--most-samples", "100"),
    ("teapot_afd", *PICTURE, "--shade", "gaussian"),
    ("teapot_afd", *PICTURE, "--fog", "2.5,1.5"),
    ("teapot_afd", *PICTURE, "--eye", "1,2,nan"),
    ("teapot_afd", *PICTURE, "--fov", "0.0001"),
    ("modelview", *PICTURE, "--pipeline", "zbuffer", "--model", "torus.off", "--pick", "80,60", "--explain"),
    ("modelview", *PICTURE, "--pipeline", "zsort", "--hidden-lines", "--facets", "3"),
    ("modelview", *PICTURE, "bird.off", "--pipeline", "zbuffer"),
    ("vecmath",), ("matmul",),
)


def expect_no_commas(host, where, command):
    """Runs a command with and without the host, in folders of their own."""
    results = []
    for more in ({}, {"LD_PRELOAD": host, "LC_ALL": LOCALE, "LOCPATH": where,
                      "ASAN_OPTIONS": "verify_asan_link_order=0"}):
        with folder() as path:
            done = subprocess.run([os.path.join(harness.BIN, command[0]), *command[1:]], cwd=path,
                                  env=environment(**more), capture_output=True, timeout=harness.PATIENCE)
            files = {name: open(os.path.join(path, name), "rb").read() for name in sorted(os.listdir(path))}
            if "a.json" in files:  # but for what takes time
                lines = [json.loads(line) for line in files["a.json"].splitlines()]
                files["a.json"] = [{name: line[name] for name in line if name != "time_ms"} for line in lines]
            results.append((done.returncode, done.stdout, done.stderr, files))
    expect_equal(results[1][:3], results[0][:3])
    expect(results[1][3] == results[0][3], "other files")


def main():
    checks = Checks()
    with folder() as where:
        subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", os.path.join(where, LOCALE)], check=True)
        source, host = os.path.join(where, "host.cpp"), os.path.join(where, "host.so")
        with open(source, "w") as file:
            file.write(HOST)
        compiler = os.environ.get("CXX", "c++").split()  # such as "ccache g++"
        subprocess.run([*compiler, "-std=c++20", "-shared", "-fPIC", source, "-o", host], check=True)
        programs = [name for name in sorted(os.listdir(harness.BIN)) if name not in ("vecmath", "matmul", "thumbnail")]
        for command in (*RUNS, *((name, *PICTURE) for name in programs), *((name, "--help") for name in programs)):
            checks.run("locale." + " ".join(command).replace(" ".join(PICTURE), "").strip(), expect_no_commas, host,
                       where, command)
    checks.finish()


if __name__ == "__main__":
    sys.exit(main())
