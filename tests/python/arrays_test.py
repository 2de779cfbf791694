#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Arrays of NumPy go in and out; those that go out are the library's own memory."""

import array
import gc

import numpy

from checks import expect, run_all

import l3d


def address(of):
    return numpy.asarray(of).__array_interface__["data"][0]


def check_patches_in_and_out():
    rng = numpy.random.default_rng(1)
    points = rng.normal(size=(50, 4, 4, 3))
    model = l3d.Model.from_patches(points)
    expect(numpy.array_equal(numpy.asarray(model.patches), points))
    for other in (points.astype(numpy.float32), numpy.asfortranarray(points), points[::-1], points.tolist(),
                  points.transpose(0, 2, 1, 3)):
        wanted = numpy.asarray(other, dtype=float)
        expect(numpy.array_equal(numpy.asarray(l3d.Model.from_patches(other).patches), wanted))
    flat = memoryview(array.array("d", points.ravel())).cast("B").cast("d", points.shape)
    expect(numpy.array_equal(numpy.asarray(l3d.Model.from_patches(flat).patches), points))


def check_a_million_vertices_go_out_without_a_copy():
    side = 1000
    x, y = numpy.meshgrid(numpy.arange(float(side)), numpy.arange(float(side)))
    vertices = numpy.stack([x, numpy.sin(x / 50) * numpy.cos(y / 50) * 20, y], axis=-1).reshape(-1, 3)
    first = (numpy.arange(side - 1)[:, None] * side + numpy.arange(side - 1)).reshape(-1, 1)
    faces = first + numpy.array([0, side, side + 1, 1])
    model = l3d.Model.from_polygons(vertices, faces)
    out = numpy.asarray(model.vertices)
    expect(numpy.array_equal(out, vertices) and out.shape == (side * side, 3))
    expect(address(model.vertices) == address(model.vertices) == address(out), "one memory")
    expect(not out.flags.writeable and not out.flags.owndata)
    expect(len(model.triangles) == 2 * len(faces))
    alias = model.painted(l3d.Material()).vertices
    expect(numpy.array_equal(numpy.asarray(alias), vertices))
    vertices[:] = 0  # the model never changes
    expect(out[side + 1].tolist() == [1, numpy.sin(0.02) * numpy.cos(0.02) * 20, 1], out[side + 1])
    del model
    gc.collect()
    expect(out[side + 1][2] == 1, "the array keeps the model")
    expect(l3d.draw(l3d.Model.from_polygons(out, faces), (64, 48)).report["faces"] == len(faces))


def check_pictures_are_memory_of_the_library():
    picture = l3d.draw(l3d.Model.load("teapot"), (64, 48), background=(0x102030, 0x405060))
    pixels, words = numpy.asarray(picture), numpy.asarray(picture.words)
    expect(pixels.shape == (48, 64, 3) and pixels.dtype == numpy.uint8 and not pixels.flags.owndata)
    expect(address(picture) == address(picture.words) + 2, "red is the third byte of a word")
    expect(pixels[0, 0].tolist() == [0x10, 0x20, 0x30] and words[0, 0] == 0x102030)
    expect(numpy.array_equal(words >> 16 & 255, pixels[..., 0]) and numpy.array_equal(words & 255, pixels[..., 2]))
    del picture
    gc.collect()
    expect(pixels[47, 0].tolist() == [0x40, 0x50, 0x60])
    again = l3d.Picture.from_array(pixels)
    expect(numpy.array_equal(numpy.asarray(again), pixels))


def check_pictures_of_arrays():
    rng = numpy.random.default_rng(2)
    for shape in ((5, 7), (5, 7, 1), (5, 7, 3), (5, 7, 4)):
        pixels = rng.integers(0, 256, shape, dtype=numpy.uint8)
        picture = l3d.Picture.from_array(pixels)
        seen = numpy.asarray(picture)
        channels = 1 if len(shape) == 2 else shape[2]
        wanted = numpy.repeat(pixels.reshape(5, 7, 1), 3, 2) if channels == 1 else pixels[..., :3]
        expect(numpy.array_equal(seen, wanted), shape)
        if channels == 4:
            expect(numpy.array_equal(255 - (numpy.asarray(picture.words) >> 24), pixels[..., 3]))


def check_maps():
    picture = l3d.draw(l3d.Model.load("teapot"), (64, 48), depth=True, error_map=True)
    depth, doubts = numpy.asarray(picture.depth), numpy.asarray(picture.error_map)
    expect(depth.shape == doubts.shape == (48, 64) and depth.dtype == doubts.dtype == numpy.float32)
    expect(numpy.isinf(depth[0, 0]) and 0 < depth[24, 32] < 100)
    expect(doubts[0, 0] < 0.01 and doubts.max() >= picture.report["color_error_bound"])


def check_numbers_of_numpy_within_lists():
    eye = [numpy.float32(1), numpy.int64(2), 3]
    expect(l3d.Camera(eye).eye == (1, 2, 3))
    rows = list(numpy.eye(4))
    scene = l3d.Scene(l3d.Model.load("teapot"))
    scene.place(0, rows)
    expect(l3d.Material(tuple(numpy.uint8([1, 2, 3]))).color == 0x010203)


def check_heights_and_curves():
    heights = numpy.full((4, 5), 1.0)
    heights[0, 0] = numpy.nan
    expect(len(l3d.Model.from_heights(heights, 2).patches) == 11, "one of twelve is a hole")
    circle = l3d.Curve.circle(2)
    places = numpy.array([circle.evaluate(t) for t in numpy.linspace(*circle.range, 20)])
    expect(numpy.allclose(numpy.hypot(places[:, 0], places[:, 1]), 2))
    vase = l3d.Model.from_surfaces(l3d.revolved(l3d.Curve([(1, 0, 0), (2, 1, 0), (1, 2, 0), (1, 3, 0)])))
    expect(vase.kind == "patches" and abs(vase.bounds[1][1] - 3) < 1e-9, vase.bounds)


if __name__ == "__main__":
    run_all(globals(), "python_arrays")
