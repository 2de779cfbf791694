# SPDX-License-Identifier: MIT
"""A program that `mypy --strict` judges by the stubs."""

import pathlib
from typing import Optional

import numpy

import l3d


def picture_of(model: l3d.Model, eye: tuple[float, float, float]) -> l3d.Picture:
    camera = l3d.Camera(eye, fov=30)
    camera.target = (0, 1.3, 0)
    scene = l3d.Scene(model)
    index: int = scene.add(model, at=(6, 0, 0), material=l3d.Material("#3060ff"), opacity=0.5)
    scene.place(index, numpy.eye(4))
    lights = [l3d.Light(direction=(0, 0, 1)), l3d.Light(position=(1, 2, 3), reach=2)]
    return l3d.draw(scene, (320, 240), camera=camera, lights=lights, shade="lambert", error_map=True)


def largest_doubt(picture: l3d.Picture) -> Optional[float]:
    doubts = picture.error_map
    return None if doubts is None else float(numpy.asarray(doubts).max())


def letters(text: str) -> l3d.Canvas:
    font = l3d.Font.system()
    path = font.outline(text, 40, (10, 50))
    colors = l3d.Gradient.linear((0, 0), (0, 60), [(0, 0xff0000), (1, "#0000ff", 0.5)])
    return l3d.Canvas((400, 80)).draw_path(path, gradient=colors).draw_path(path.stroked(1, join="round"))


if __name__ == "__main__":
    picture = picture_of(l3d.Model.load(pathlib.Path("teapot")), (3, 4, 7))
    print(picture.report["error_bound_px"], largest_doubt(picture), picture.words.shape)
    print(letters("typed").size, numpy.asarray(picture.words).shape)
