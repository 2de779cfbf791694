#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Control points in the windows of nurbs and teapot_afd: dragged, weighted, undone, saved and read again."""

import os

import harness
from harness import Checks, Session, await_rest, environment, expect, expect_equal, folder, run, xdotool

SIZE = 500, 400
HANDLE, MARKED = 0xF4F4F4, 0xFFD873


def shown(name, path, *arguments):
    return Session(harness.Program(name, SIZE), *arguments, counted=True, cwd=path, L3D_FONT="built-in")


def seen(it):
    """The picture without the panel, which tells times."""
    return [row if y < 250 else row[:250] for y, row in enumerate(it.picture())]


def middles(rows, color):
    """Middles of dots of a colour."""
    return [(x, y) for y in range(2, len(rows) - 2) for x in range(2, len(rows[y]) - 2)
            if all(x + i < len(rows[y + j]) and rows[y + j][x + i] == color for i in (-1, 0, 1) for j in (-1, 0, 1))]


def rest(it):
    """No message, and the pointer away from all."""
    xdotool(it.display, "mousemove", "--window", it.window, 1, 1, "key", "j")
    await_rest(it)
    return seen(it)


def comes_back(it, wanted, key):
    """That a key leads to a picture that was there before."""
    xdotool(it.display, "key", key)
    rest(it)
    it.await_picture(lambda _: seen(it) == wanted, what="the picture before, by the key " + key)


def does(it, *words):
    """Does what xdotool is told, and expects another picture."""
    before = seen(it)
    xdotool(it.display, *words)
    it.await_picture(lambda _: seen(it) != before, what=" ".join(map(str, words)))
    await_rest(it)
    return seen(it)


def to(it, place):
    return ("mousemove", "--window", it.window, *place)


def drag(it, start, end, button=1):
    """Button down at a dot, which is marked before that."""
    rows = does(it, *to(it, start))
    expect(middles(rows, MARKED), "no dot is marked at", start)
    return does(it, "mousedown", button, *to(it, end), "mouseup", button)


def a_point(it):
    """A dot that is seen well, nearest to the middle."""
    dots = middles(seen(it), HANDLE)
    expect(dots, "no dots")
    return min(dots, key=lambda dot: abs(dot[0] - 200) + abs(dot[1] - 200))


def quit_by_key(it):
    it.press("q")
    it.expect_end(0)


def a_point_is_dragged_weighted_and_all_is_undone():
    with folder() as path, shown("nurbs", path) as it:
        first = rest(it)
        x, y = a_point(it)
        drag(it, (x, y), (x + 40, y - 30))
        moved = rest(it)
        expect(moved != first, "nothing was dragged")
        does(it, *to(it, (x + 40, y - 30)))
        does(it, "mousedown", 3, *to(it, (x + 40, y - 60)), "mouseup", 3)
        farther = rest(it)
        expect(farther != moved, "nothing moved along the view axis")
        comes_back(it, moved, "u")
        does(it, *to(it, (x + 40, y - 30)))
        does(it, "click", "--repeat", 5, 4)
        by_wheel = rest(it)
        does(it, *to(it, (x + 40, y - 30)))
        for _ in range(5):
            does(it, "key", "comma")
        expect(rest(it) != by_wheel, "the key changes no weight")
        comes_back(it, first, "U")
        quit_by_key(it)


def what_is_saved_is_read_bit_for_bit():
    with folder() as path:
        with shown("nurbs", path) as it:
            rest(it)
            x, y = a_point(it)
            drag(it, (x, y), (x - 35, y + 25))
            does(it, "click", "--repeat", 3, 4)
            does(it, "key", "S")
            quit_by_key(it)
        with shown("nurbs", path, "l3d-0001.obj") as it:
            rest(it)
            does(it, "key", "S")
            quit_by_key(it)
        texts = []
        for name in ("l3d-0001.obj", "l3d-0002.obj"):
            with open(os.path.join(path, name), encoding="ascii") as file:
                texts.append(file.read())
        expect(texts[0] == texts[1], "the second file differs")
        expect_equal(texts[0].count("\nsurf "), 1, "surfaces:")
        expect_equal(texts[0].count("v "), 81 + 1, "vertices:")
        # others read it as well, and see the same patches
        picks = [run(harness.Program(name, SIZE).command("--backend", "memory", "--eye", "2,3,7", "--target", "0,1.3,0",
                                                          "--pick", "250,260", "l3d-0001.obj"),
                     environment(), cwd=path) for name in ("nurbs", "teapot_afd")]
        expect_equal(picks[0], picks[1])
        expect_equal(picks[0][0], 0)


def each_shape_comes_by_its_key():
    with folder() as path, shown("nurbs", path) as it:
        pictures = [rest(it)]
        for _ in range(6):
            does(it, "key", "m")
            pictures.append(rest(it))
        expect(all(a != b for i, a in enumerate(pictures) for b in pictures[:i]), "two shapes look the same")
        comes_back(it, pictures[0], "m")
        quit_by_key(it)


def the_teapots_patches_stay_joined_as_they_are_dragged():
    with folder() as path, shown("teapot_afd", path) as it:
        plain = rest(it)
        expect(not middles(plain, HANDLE), "dots without the key")
        does(it, "key", "k")
        net = rest(it)
        x, y = a_point(it)
        drag(it, (x, y), (x + 30, y - 30))
        expect(rest(it) != net, "nothing was dragged")
        does(it, "key", "S")
        comes_back(it, net, "u")
        comes_back(it, plain, "k")
        expect(os.path.exists(os.path.join(path, "l3d-0001.obj")), "nothing saved")
        quit_by_key(it)


def a_scene_of_several_models_has_no_handles():
    with folder() as path, shown("teapot_afd", path, "--opacity", "lid=0.5") as it:
        before = rest(it)
        does(it, "key", "k")
        expect(rest(it) == before, "something else than a message")
        quit_by_key(it)


if __name__ == "__main__":
    checks = Checks()
    for check in (a_point_is_dragged_weighted_and_all_is_undone, what_is_saved_is_read_bit_for_bit,
                  each_shape_comes_by_its_key, the_teapots_patches_stay_joined_as_they_are_dragged,
                  a_scene_of_several_models_has_no_handles):
        checks.run("nurbs." + check.__name__, check)
    checks.finish()
