#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Line drawings: SVG files by a parser of XML, options that do not go together, and the picture of lines."""

import math
import os
import re
import xml.etree.ElementTree as tree

import harness
from harness import Checks, environment, expect, expect_equal, folder, run

VIEWER, TEAPOT = harness.Program("modelview", (400, 300)), harness.Program("teapot_afd", (400, 300))
SVG = "{http://www.w3.org/2000/svg}"


def layers(text):
    """The root, and the paths of both layers as lists of (class, points)."""
    root = tree.fromstring(text)
    paths = {}
    for group in root.findall(SVG + "g"):
        found = []
        for path in group.findall(SVG + "path"):
            data = path.get("d")
            expect(re.fullmatch(r"M-?[\d.]+,-?[\d.]+ L(-?[\d.]+,-?[\d.]+ ?)+Z?", data), data[:80])
            points = [tuple(map(float, p.split(","))) for p in re.findall(r"-?[\d.]+,-?[\d.]+", data)]
            found.append((path.get("class"), points + points[:1] * data.endswith("Z")))
        paths[group.get("id")] = found
    return root, paths


def drawn(program, *arguments):
    status, out, messages = run(program.command(*arguments, "--svg", "-"), environment())
    expect_equal((status, messages), (0, ""))
    return layers(out)


def a_ball_is_one_circle():
    root, paths = drawn(VIEWER, "sphere", "--parallel", "--eye", "0,0,8", "--target", "0,0,0")
    expect_equal((root.get("width"), root.get("height"), root.get("viewBox")), ("400px", "300px", "0 0 400 300"))
    expect_equal(root.find(SVG + "title").text, "sphere")
    expect_equal((len(paths["hidden"]), [name for name, _ in paths["seen"]]), (0, ["contour"]))
    radius = 150 / math.tan(math.radians(19)) / 8
    for x, y in paths["seen"][0][1]:
        expect(abs(math.hypot(x - 200, y - 150) - radius) < 0.1, x, y, radius)


def the_teapot_has_lines_of_all_kinds():
    _, paths = drawn(TEAPOT)
    expect(len(paths["hidden"]) > 3 and len(paths["seen"]) > 3, len(paths["hidden"]), len(paths["seen"]))
    expect({"contour", "border"} <= {name for name, _ in paths["hidden"] + paths["seen"]})
    for _, points in paths["seen"]:
        expect(all(-0.1 <= x <= 400.1 and -0.1 <= y <= 300.1 for x, y in points), "beyond the picture")


def a_file_is_written_whole():
    with folder() as path:
        expect_equal(run(VIEWER.command("cone", "--svg", "a.svg"), environment(), cwd=path), (0, b"", ""))
        expect_equal(os.listdir(path), ["a.svg"])
        with open(os.path.join(path, "a.svg"), "rb") as file:
            expect(len(layers(file.read())[1]["seen"]) >= 2)


def errors_name_option_and_value():
    for arguments, words in ((("--svg", "a.png"), "--svg: 'a.png' does not end in .svg"),
                             (("--svg", "none/a.svg"), "there is no folder 'none'"),
                             (("--svg", "-", "--output", "a.png"), "--svg: it shows nothing"),
                             (("--svg", "-", "--frames", "2"), "--svg: it shows nothing"),
                             (("--drawing", "--wireframe"), "--drawing: --wireframe shows other lines"),
                             (("--drawing", "--texture", "a.png"), "--texture: shades of light show it, and lines do not"),
                             (("--drawing", "--shade", "zebra"), "--drawing: lines have one colour")):
        with folder() as path:
            status, _, messages = run(VIEWER.command("cone", *arguments), environment(), cwd=path)
            expect(status in (1, 2) and words in messages and messages.count("\n") == 1, status, messages)
            expect_equal(os.listdir(path), [])


def a_drawing_of_nothing_says_why():
    command = VIEWER.command("cone", "--eye", "0,0,5", "--target", "0,0,9", "--svg", "-")
    status, out, messages = run(command, environment())
    expect_equal((status, messages), (0, "modelview: the drawing is empty, as the model is behind the eye\n"))
    expect_equal([len(paths) for paths in layers(out)[1].values()], [0, 0])


def the_picture_shows_the_same_lines():
    view = ("torus", "--eye", "0,1.2,9", "--target", "0,0,0", "--background", "black")
    rows = harness.memory_picture(VIEWER, *view, "--drawing")
    _, paths = drawn(VIEWER, *view)
    for _, points in paths["seen"]:
        for x, y in points[::5]:
            near = [rows[int(y) + j][int(x) + i] for i in (-1, 0, 1) for j in (-1, 0, 1)]
            expect(any(near), "no line at", x, y)
    lit = sum(word != 0 for row in rows for word in row)
    length = sum(math.dist(a, b) for lines in paths.values() for _, points in lines for a, b in zip(points, points[1:]))
    expect(0.9 * length < lit < 3.5 * length, lit, length)


if __name__ == "__main__":
    checks = Checks()
    for check in (a_ball_is_one_circle, the_teapot_has_lines_of_all_kinds, a_file_is_written_whole,
                  errors_name_option_and_value, a_drawing_of_nothing_says_why, the_picture_shows_the_same_lines):
        checks.run("drawing." + check.__name__, check)
    checks.finish()
