#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Drawing in two dimensions: exact places and colours of a few pixels."""

import os
import sys
import tempfile
import threading
import time

from checks import expect, run_all

import l3d


def pixel(canvas, x, y):
    return canvas.picture().words[y, x]


def check_shapes():
    canvas = l3d.Canvas((20, 10))
    expect(canvas.size == (20, 10) and pixel(canvas, 3, 3) == 0xffffff)
    canvas.draw_path(l3d.Path().add_box(2, 2, 5, 5), 0xff0000)
    expect([pixel(canvas, x, 3) for x in (1, 2, 4, 5)] == [0xffffff, 0xff0000, 0xff0000, 0xffffff])
    canvas.clear("#102030").draw_line((0, 0), (19, 0), "#ffffff")
    expect(pixel(canvas, 10, 0) == 0xffffff and pixel(canvas, 10, 5) == 0x102030)
    canvas.draw_points([(3, 4), (7.4, 4.6)], (0, 255, 0))
    expect(pixel(canvas, 3, 4) == pixel(canvas, 7, 5) == 0x00ff00)
    ring = l3d.Path().add_circle((10, 5), 4).add_circle((10, 5), 2)
    canvas.clear().draw_path(ring, inside="even_odd")
    expect(pixel(canvas, 10, 5) == 0xffffff and pixel(canvas, 10, 2) < 0x808080)


def check_strokes_and_clips():
    line = l3d.Path().move_to((2, 5)).line_to((18, 5))
    canvas = l3d.Canvas((20, 10)).draw_path(line.stroked(3, dashes=(4, 4)), 0)
    expect(pixel(canvas, 4, 5) == 0 and pixel(canvas, 8, 5) == 0xffffff)
    half = l3d.Path().add_box(0, 0, 10, 10)
    canvas = l3d.Canvas((20, 10)).draw_path(line.stroked(3), 0, clip=half)
    expect(pixel(canvas, 5, 5) == 0 and pixel(canvas, 12, 5) == 0xffffff)
    moved = l3d.Path().add(line, at=(0, 3))
    expect(pixel(l3d.Canvas((20, 10)).draw_path(moved.stroked(1)), 9, 8) == 0)


def check_gradients_and_meshes():
    box = l3d.Path().add_box(0, 0, 20, 10)
    across = l3d.Gradient.linear((0, 0), (19, 0), [(0, 0), (1, 0xffffff)])
    levels = [pixel(l3d.Canvas((20, 10)).draw_path(box, gradient=across), x, 5) & 255 for x in range(20)]
    expect(levels == sorted(levels) and levels[0] < 8 and levels[-1] > 247, levels)
    points = [[[(x * 20 / 3 - 0.5, y * 10 / 3 - 0.5) for x in range(4)] for y in range(4)]]
    canvas = l3d.Canvas((20, 10)).draw_mesh(points, [[0xff0000, 0xff0000, 0x0000ff, 0x0000ff]])
    expect(pixel(canvas, 10, 0) >> 16 > 200 and pixel(canvas, 10, 9) & 255 > 200)


def check_images():
    image = l3d.Picture.from_array([[0, 255], [255, 0]])
    canvas = l3d.Canvas((8, 8), background=0x00ff00).draw_image(image, (2, 2), (4, 4), filter="nearest")
    expect([pixel(canvas, x, 2) for x in (1, 2, 3, 4, 5, 6)] ==
           [0x00ff00, 0, 0, 0xffffff, 0xffffff, 0x00ff00])
    over = l3d.Canvas(image).draw_points([(0, 0)], 0x123456).picture()
    expect(over.words[0, 0] == 0x123456 and image.words[0, 0] == 0, "a canvas copies its ground")


def check_text():
    built_in = l3d.Font()
    expect(built_in.name == "built-in" and built_in.width("ab", 14) > built_in.width("a", 14) > 0)
    canvas = l3d.Canvas((40, 20)).draw_text((2, 2), "H", 0, 14, built_in)
    expect(bytes(canvas.picture()).count(0) > 0)
    expect(not l3d.Font.system().outline("Ä", 20, (0, 20)).is_empty)


def check_files():
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "clear.png")
        l3d.Canvas((3, 2), background=None).draw_points([(1, 1)], 0x0000ff).save(file)
        picture = l3d.Picture.load(file)
        expect(picture.words.tolist()[1] == [0xff000000, 0x0000ff, 0xff000000], picture.words.tolist())
        with open(file, "rb") as bytes_of:
            expect(bytes_of.read() == picture._repr_png_())


def many_circles():
    path = l3d.Path()
    for i in range(2000):
        path.add_circle((i % 400, i * 7 % 300), 5)
    return path


def in_threads(work, count):
    threads = [threading.Thread(target=work) for _ in range(count)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()


def check_two_threads_draw_the_same_bits():
    """Also while others change the path and the clip that are drawn."""
    path, clip = many_circles(), l3d.Path().add_box(10, 10, 390, 290)

    def drawn():
        canvas = l3d.Canvas((400, 300)).draw_path(path, "#a04020", alpha=0.5, clip=clip)
        return bytes(canvas.draw_image(canvas.picture(), (5, 5), (90, 60), turn=10).picture())

    wanted, same = drawn(), []

    def work():
        for _ in range(10):
            same.append(drawn() == wanted)
            path.move_to((0, 0))
            clip.move_to((0, 0))

    in_threads(work, 3)
    expect(same == [True] * 30, same.count(True), len(same))


def check_one_canvas_in_two_threads_is_refused_or_draws():
    canvas, path, said = l3d.Canvas((400, 300)), many_circles(), []

    def work():
        for _ in range(100):
            try:
                canvas.draw_path(path)
                canvas.picture()
            except l3d.Error as error:
                said.append(str(error))

    in_threads(work, 4)
    expect(said and all("Canvas" in text and "another thread" in text for text in said), said[:3])


def check_others_run_while_it_draws():
    """Nobody else runs unless this thread lets them: it would have to work for an hour."""
    canvas, path, turns, is_over = l3d.Canvas((400, 300)), many_circles(), [0], threading.Event()

    def count():
        while not is_over.is_set():
            turns[0] += 1
            time.sleep(0.0001)

    usual = sys.getswitchinterval()
    other = threading.Thread(target=count)
    other.start()
    sys.setswitchinterval(3600)
    begun = turns[0]
    draws = 0
    while turns[0] == begun and draws < 500:
        canvas.draw_path(path)
        draws += 1
    moved = turns[0] != begun
    sys.setswitchinterval(usual)
    is_over.set()
    other.join()
    expect(moved, draws)


if __name__ == "__main__":
    run_all(globals(), "python_drawing")
