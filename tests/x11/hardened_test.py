#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Programs and plug-ins of a release have guarded stacks, checked calls and tables that are fixed."""

import glob
import os
import subprocess

from harness import BIN, Checks, expect

IS_RELEASE = os.path.basename(os.path.dirname(BIN)).split("-")[1:2] == ["release"]


def told(tool, *arguments):
    return subprocess.run([tool, *arguments], capture_output=True, check=True).stdout.decode()


def is_hardened(file, is_program):
    head = told("readelf", "--wide", "--file-header", "--program-headers", "--dynamic", file)
    expect("DYN (" in head, "no position-independent code")
    expect("GNU_RELRO" in head and "NOW" in head, "no full RELRO")
    if is_program:
        symbols = told("nm", "--dynamic", file)
        expect("__stack_chk_fail" in symbols, "no guarded stacks")
        expect("_chk@" in symbols, "no checked calls")


if __name__ == "__main__":
    checks = Checks()
    if IS_RELEASE:
        for name in ("teapot_afd", "modelview"):
            checks.run("hardened." + name, is_hardened, os.path.join(BIN, name), True)
        for file in glob.glob(os.path.join(BIN, "..", "lib", "l3d", "*.so")):
            checks.run("hardened." + os.path.basename(file), is_hardened, file, False)
    else:
        checks.skip("hardened", "this is no release build")
    checks.finish()
