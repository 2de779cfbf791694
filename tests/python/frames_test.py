#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Frames: the first program of docs/PYTHON.md, views, threads, and memory."""

import os
import resource
import signal
import tempfile
import threading

from checks import expect, run_all

import l3d

teapot = l3d.Model.load("teapot")


def check_first_program():
    picture = l3d.draw(l3d.Model.load("teapot"), size=(640, 480), tolerance=0.1)
    with tempfile.TemporaryDirectory() as folder:
        picture.save(os.path.join(folder, "teapot.png"))
        same = l3d.Picture.load(os.path.join(folder, "teapot.png"))
        expect(bytes(same) == bytes(picture))
    expect(0 < picture.report["error_bound_px"] <= 0.1, picture.report["error_bound_px"])
    expect(memoryview(picture).shape == (480, 640, 3), memoryview(picture).shape)


def check_frames_follow_scene_camera_and_settings():
    scene = l3d.Scene(teapot)
    view = l3d.View(scene, (160, 120))
    seen = [bytes(view.draw())]

    def differs(what):
        seen.append(bytes(view.draw()))
        expect(seen[-1] not in seen[:-1], what)

    scene.add(teapot, at=(4, 0, 0))
    differs("an instance")
    scene.place(1, at=(4, 1, 0), turn=(0, 40, 0), scale=0.5)
    differs("a place")
    scene.paint(1, l3d.Material(0xff0000))
    differs("a material")
    scene.set_opacity(1, 0.5)
    differs("an opacity")
    view.camera.orbit(30)
    differs("a turn of the camera")
    view.camera = l3d.Camera((1, 9, 9))
    differs("another camera")
    view.change(background=0xffffff)
    differs("a setting")
    view.change(curves=[(l3d.Curve.circle(3), "#00ff00", 4)])
    differs("a curve")
    expect(bytes(l3d.draw(scene, (160, 120), camera=view.camera, background=0xffffff,
                          curves=[(l3d.Curve.circle(3), "#00ff00", 4)])) == seen[-1])


def check_scenes_of_files_are_their_models():
    scene = l3d.Scene.load("teapot.bpt")
    expect(len(scene) == 1, scene)
    expect(bytes(l3d.draw(scene, (64, 48))) == bytes(l3d.draw(l3d.Model.load("teapot.bpt"), (64, 48))))


def check_pictures_never_change():
    view = l3d.View(teapot, (160, 120))
    pictures, texts = [], []
    for _ in range(5):
        pictures.append(view.draw())
        texts.append(bytes(pictures[-1]))
        view.camera.orbit(20)
    expect([bytes(picture) for picture in pictures] == texts and len(set(texts)) == 5)


def check_results_keep_what_they_need():
    memory = memoryview(l3d.draw(teapot, (64, 48)))
    words = l3d.draw(teapot, (64, 48)).words
    depth = l3d.draw(teapot, (64, 48), depth=True).depth
    patches = l3d.Model.load("teapot").patches
    for _ in range(20):
        l3d.draw(teapot, (64, 48))
    expect(bytes(memory) == bytes(l3d.draw(teapot, (64, 48))))
    expect(words[24, 32] == memory[24, 32, 0] << 16 | memory[24, 32, 1] << 8 | memory[24, 32, 2])
    expect(0 < depth[24, 32] < 100 and patches.shape == (28, 4, 4, 3), depth[24, 32], patches.shape)


def check_polygons():
    sphere = l3d.Model.from_polygons(
        [(0, 1, 0), (1, 0, 0), (0, 0, 1), (-1, 0, 0), (0, 0, -1), (0, -1, 0)],
        [(0, 2, 1), (0, 3, 2), (0, 4, 3), (0, 1, 4), (5, 1, 2), (5, 2, 3), (5, 3, 4), (5, 4, 1)])
    solid = l3d.draw(sphere, (80, 60))
    lines = l3d.draw(sphere, (80, 60), style="hidden_lines", material=l3d.Material(0xff0000))
    expect(solid.report["faces"] == 8 and bytes(solid) != bytes(lines))
    expect(sphere.kind == "polygons" and sphere.vertices.shape == (6, 3) and sphere.patches is None)
    expect(bytes(l3d.draw(sphere.painted(l3d.Material("#2040ff")), (80, 60))) != bytes(solid))


def check_lines():
    view = l3d.View(l3d.Model.from_surfaces(l3d.shape("cylinder")), (160, 120))
    drawing = view.lines(tolerance=0.05)
    expect(0 < drawing["bound"] <= 0.05 and drawing["svg"].startswith("<?xml"), drawing["bound"])
    kinds = sorted((line["kind"], line["is_seen"]) for line in drawing["lines"])
    expect(("contour", True) in kinds and ("crease", True) in kinds and ("crease", False) in kinds, kinds)
    for line in drawing["lines"]:
        expect(line["instance"] == 0 and line["pieces"] and len(line["points"]) >= 2, line)
        expect(all(0 <= x <= 160 and 0 <= y <= 120 and depth > 0 for x, y, depth in line["points"]), line)
    expect(all(line["is_seen"] for line in view.lines(hidden=False)["lines"]))
    triangle = l3d.Model.from_polygons([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
    for wrong, word in ((lambda: view.lines(tolerance=0), "tolerance"), (l3d.View(triangle).lines, "patches")):
        try:
            wrong()
            expect(False, word)
        except l3d.Error as error:
            expect(word in str(error), error)


def check_picks():
    view = l3d.View(teapot, (160, 120))
    pick = view.pick(80, 60)
    expect(pick["part"] == "body" and pick["is_proven"] and pick["point_error"] < 1e-6, pick)
    expect(view.pick(0, 0) is None)


def check_two_threads_draw_the_same_bits():
    eyes = [l3d.Camera((3, 4, 7)), l3d.Camera((-3, 2, 7))]
    wanted = [bytes(l3d.draw(teapot, (320, 240), camera=eye, threads=1)) for eye in eyes]
    same = []

    def work():
        view = l3d.View(teapot, (320, 240), threads=2)
        for frame in range(40):
            view.camera = eyes[frame % 2]
            same.append(bytes(view.draw()) == wanted[frame % 2])

    threads = [threading.Thread(target=work) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    expect(same == [True] * 80, same.count(True), len(same))


def check_one_view_in_two_threads_is_refused_or_draws():
    view = l3d.View(teapot, (160, 120), error_map=True)
    said = []

    def work():
        for _ in range(3):
            try:
                view.camera.orbit(1)
                view.draw()
            except l3d.Error as error:
                said.append(str(error))

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    expect(said and all("another thread" in text for text in said), len(said))


def check_ctrl_c_ends_a_long_frame():
    view = l3d.View(teapot, (640, 480), error_map=True, tolerance=0.01)  # seconds
    timer = threading.Timer(0.1, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    try:
        view.draw()
        raise AssertionError("the frame was drawn to its end")
    except KeyboardInterrupt:
        pass
    picture = view.change(error_map=False).draw()
    expect(bytes(picture) == bytes(l3d.draw(teapot, (640, 480), tolerance=0.01)))


def memory():
    """The memory in use, in KB."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize() // 1024


def check_ten_thousand_frames_take_no_memory():
    count = int(os.environ.get("L3D_FRAMES", 10000))
    view = l3d.View(l3d.Scene(teapot), (32, 24), depth=True, threads=1)
    sizes = []
    for frame in range(count):
        view.camera.orbit(0.1)
        picture = view.draw()
        memoryview(picture)[0, 0, 0], picture.report, picture.depth
        if frame % (count // 10) == 0:
            l3d.draw(teapot, (64, 48))
            try:
                l3d.draw(teapot, (0, 0))
            except l3d.Error:
                pass
            sizes.append(memory())
    expect(sizes[-1] - sizes[len(sizes) // 2] < 1024, sizes)


if __name__ == "__main__":
    run_all(globals(), "python_frames")
