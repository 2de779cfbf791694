#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""modelview --subdivide: with the plug-in, without it, and with one of another version."""

import os
import shutil

import harness
from harness import Checks, environment, expect, expect_equal, folder, run

MODELVIEW = os.path.join(os.environ["L3D_BIN"], "modelview")
PLUGIN = os.path.join(os.environ["L3D_BIN"], "..", "lib", "l3d", "libl3d_subdivision.so")
CUBE = os.path.join(os.environ["L3D_BIN"], "..", "share", "l3d", "cube.obj")
PICTURE = ("--backend", "memory", "--size", "200x150", "--output", "a.png")


def draws_a_smooth_cube():
    with folder() as path:
        status, out, messages = run([MODELVIEW, CUBE, "--subdivide", *PICTURE], environment(), cwd=path)
        expect_equal((status, out), (0, b""), messages)
        expect("cube.obj: subdivided: " in messages and messages.count("\n") == 1, messages)
        expect(harness.has_picture(harness.read_png(os.path.join(path, "a.png"))), "one colour only")


def says_which_package_is_missing(build):
    """A copy of the program elsewhere finds no plug-in, unless one is installed."""
    with folder() as path:
        shutil.copy(MODELVIEW, path)
        command = [os.path.join(path, "modelview"), CUBE, "--subdivide", *PICTURE]
        status, out, messages = run(command, environment(), cwd=path)
        expect_equal((status, out), (5, b""), messages)
        expect("cube.obj: to subdivide polygons, it takes the package l3d-subdivision, which is not "
               "installed" in messages and messages.count("\n") == 1, messages)
        expect_equal(os.listdir(path), ["modelview"])
        shutil.copy(build, os.path.join(path, "libl3d_subdivision.so"))
        status, _, messages = run(command, environment(L3D_PLUGIN_PATH=path), cwd=path)
        expect_equal(status, 5, messages)
        expect("it defines no symbol l3d_subdivision_plugin" in messages, messages)


def refuses_options_that_show_nothing():
    for options, what in ((("--subdivide",), "--subdivide: it takes a FILE of polygons"),
                          ((CUBE, "--subdivide-error", "0.1"), "--subdivide-error: nothing is seen"),
                          ((CUBE, "--subdivide-crease", "9"), "--subdivide-crease: nothing is seen")):
        status, _, messages = run([MODELVIEW, *options, *PICTURE], environment())
        expect_equal(status, 2, messages)
        expect(what in messages, messages)


checks = Checks()
if os.path.exists(PLUGIN):
    checks.run("draws a smooth cube", draws_a_smooth_cube)
else:
    checks.skip("draws a smooth cube", "libl3d_subdivision.so is not built")
checks.run("says which package is missing", says_which_package_is_missing,
           os.path.join(os.environ["L3D_BIN"], "..", "lib", "l3d", "old_version.so"))
checks.run("refuses options that show nothing", refuses_options_that_show_nothing)
checks.finish()
