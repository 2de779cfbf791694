#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Models of any size, place, shape and kind of file fill the picture without any option: 60 to 95 %
of its width or of its height, and nothing is cut off."""

import json
import math
import os
import struct

import harness
from harness import Checks, expect, expect_equal, folder
from view_test import draw, moved, scaled, share_of, teapot_as, turned

SIZES = ((160, 120), (100, 300), (300, 100))
LEAST, MOST = 0.6, 0.95


# ---- shapes: vertices and triangles -------------------------------------------------------------


def torus(around=24, across=12, major=2.0, minor=0.8):
    places, faces = [], []
    for i in range(around):
        for k in range(across):
            u, v = 2 * math.pi * i / around, 2 * math.pi * k / across
            out = major + minor * math.cos(v)
            places.append([out * math.cos(u), out * math.sin(u), minor * math.sin(v)])
            a, b = i * across + k, (i + 1) % around * across + k
            c, d = (i + 1) % around * across + (k + 1) % across, i * across + (k + 1) % across
            faces += [[a, b, c], [a, c, d]]
    return places, faces


def changed(shape, *changes):
    places, faces = shape
    for change in changes:
        places = [change(place) for place in places]
    return places, faces


# ---- files --------------------------------------------------------------------------------------


def rows(format_of, items):
    return "".join(format_of % tuple(item) + "\n" for item in items)


def off(places, faces):
    head = "OFF\n%d %d 0\n" % (len(places), len(faces))
    return (head + rows("%.9g %.9g %.9g", places) + rows("3 %d %d %d", faces)).encode()


def obj(places, faces):
    one_more = [[corner + 1 for corner in face] for face in faces]
    return (rows("v %.9g %.9g %.9g", places) + rows("f %d %d %d", one_more)).encode()


def ply(places, faces):
    head = ("ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\n"
            "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % (len(places), len(faces)))
    return (head + rows("%.9g %.9g %.9g", places) + rows("3 %d %d %d", faces)).encode()


def stl(places, faces):
    triangles = b"".join(struct.pack("<12fH", 0, 0, 0, *(number for corner in face for number in places[corner]), 0)
                         for face in faces)
    return b"framing".ljust(80) + struct.pack("<I", len(faces)) + triangles


def glb(places, faces):
    place_bytes = b"".join(struct.pack("<3f", *place) for place in places)
    index_bytes = b"".join(struct.pack("<3I", *face) for face in faces)
    columns = list(zip(*places))
    description = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": len(place_bytes) + len(index_bytes)}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": len(place_bytes)},
                        {"buffer": 0, "byteOffset": len(place_bytes), "byteLength": len(index_bytes)}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(places), "type": "VEC3",
                       "min": [min(c) for c in columns], "max": [max(c) for c in columns]},
                      {"bufferView": 1, "componentType": 5125, "count": 3 * len(faces), "type": "SCALAR"}],
    }
    text = json.dumps(description).encode()
    text += b" " * (-len(text) % 4)
    parts = [(b"JSON", text), (b"BIN\0", place_bytes + index_bytes)]
    body = b"".join(struct.pack("<I4s", len(part), kind) + part for kind, part in parts)
    return b"glTF" + struct.pack("<2I", 2, 12 + len(body)) + body


def one_patch(change):
    """A sail; change moves its sixteen points."""
    places = [change([column - 1.5, 1.5 - row, 0.0 if row in (0, 3) else 2.0])
              for row in range(4) for column in range(4)]
    return ("1\n3 3\n" + rows("%.17g %.17g %.17g", places)).encode()


def keep(place):
    return place


# ---- ten models for each viewer -----------------------------------------------------------------

PATCHES = {
    "tiny.bpt": teapot_as(scaled(1e-6, 1e-6, 1e-6)).encode(),
    "huge.bpt": teapot_as(scaled(1e6, 1e6, 1e6)).encode(),
    "flat.bpt": teapot_as(scaled(1, 1e-4, 1)).encode(),
    "long.bpt": teapot_as(scaled(30, 1, 1)).encode(),
    "tall.bpt": teapot_as(scaled(1, 25, 1)).encode(),
    "rotated.bpt": teapot_as(lambda p: turned(50, 0)(turned(70, 2)(p))).encode(),
    "upside_down.bpt": teapot_as(turned(180, 0)).encode(),
    "off_centre.bpt": teapot_as(moved(1e5, -3e4, 2e5)).encode(),
    "one_patch.bpt": one_patch(keep),
    "one_tiny_patch_far_away.bpt": one_patch(lambda p: moved(5, 5, 5)(scaled(1e-3, 1e-3, 1e-3)(p))),
}
POLYGONS = {
    "tiny.obj": obj(*changed(torus(), scaled(1e-6, 1e-6, 1e-6))),
    "huge.off": off(*changed(torus(), scaled(1e6, 1e6, 1e6))),
    "flat.ply": ply(*changed(torus(), turned(90, 0), scaled(1, 1e-4, 1))),
    "long.stl": stl(*changed(torus(), scaled(30, 1, 1))),
    "rotated.glb": glb(*changed(torus(), turned(50, 0), turned(20, 1))),
    "off_centre.obj": obj(*changed(torus(), moved(3e3, -2e3, 8e3))),
    "tiny.glb": glb(*changed(torus(), scaled(1e-6, 1e-6, 1e-6))),
    "huge.stl": stl(*changed(torus(), turned(33, 2), scaled(1e6, 1e6, 1e6))),
    "one_face.off": off([[7, 7, 7], [9, 7, 7], [8, 9, 7.5]], [[0, 1, 2]]),
    "tall.ply": ply(*changed(torus(), scaled(1, 40, 1), moved(0, 1e3, 0))),
}


def fills_the_picture(viewer, name, content):
    with folder() as path:
        with open(os.path.join(path, name), "wb") as file:
            file.write(content)
        shares = []
        for size in SIZES:
            said = draw(viewer, size, name, "--output", "o.png", cwd=path)
            expect_equal(said, (0, b"", ""))
            share, is_cut = share_of(harness.read_png(os.path.join(path, "o.png")))
            shares.append(share)
            expect(LEAST <= share <= MOST and not is_cut, viewer, name, size, share, is_cut)
        return shares


def gallery_is_seen_from_above_what_is_upright():
    """The first of these directions is that in which the eye is while y is upright."""
    with folder() as path:
        for up in ("0.15,0.45,1", "0,0,1", "0,-1,0", "-1,0,0"):
            for size in SIZES:
                said = draw("gallery", size, "--up", up, "--report", "r.json", "--output", "o.png", cwd=path)
                expect_equal(said, (0, b"", ""))
                _, is_cut = share_of(harness.read_png(os.path.join(path, "o.png")))
                with open(os.path.join(path, "r.json"), encoding="utf-8") as file:
                    bound = json.load(file)["error_bound_px"]
                expect(not is_cut and bound <= 0.25, up, size, is_cut, bound)


def two_sheets(path, opacity):
    """The nearer one is red, and the other one as transparent as that. Returns the file's name."""
    def sheet(name, z, first):
        corners = rows("v %.9g %.9g %.9g", [[i / 3, k / 3, z] for k in range(4) for i in range(4)])
        points = " ".join(str(first + i) for i in range(16))
        return (corners + "g %s\nusemtl %s\ncstype bezier\ndeg 3 3\nsurf 0 1 0 1 %s\n"
                "parm u 0 1\nparm v 0 1\nend\n" % (name, name, points))

    with open(os.path.join(path, "s.obj"), "w", encoding="ascii") as file:
        file.write("mtllib s.mtl\n" + sheet("far", 0, 1) + sheet("near", 1, 17))
    with open(os.path.join(path, "s.mtl"), "w", encoding="ascii") as file:
        file.write("newmtl far\nKd 0 0 1\nd %s\nnewmtl near\nKd 1 0 0\n" % opacity)
    return "s.obj"


def modelview_says_that_transparent_patches_are_opaque():
    with folder() as path:
        said = draw("modelview", (60, 40), two_sheets(path, "0.3"), "--output", "o.png", cwd=path)
        expect_equal(said, (0, b"", "s.obj: transparent materials are opaque here; only patches are seen through, "
                                    "by --pipeline afd\n"))
        for arguments in (("--pipeline", "afd"), ()):
            name = two_sheets(path, "0.3" if arguments else "1")
            said = draw("modelview", (60, 40), name, *arguments, "--output", "o.png", cwd=path)
            expect_equal(said, (0, b"", ""), arguments)


def gallery_shows_a_files_parts_and_what_is_transparent():
    with folder() as path:
        pictures = []
        for opacity in ("1", "0.3"):
            said = draw("gallery", (400, 300), two_sheets(path, opacity), "--pick", "170,130", "--frames", "2",
                        "--output", "o.png", cwd=path)
            expect_equal((said[0], said[2]), (0, ""))
            expect(b"\npart near\n" in said[1], said[1])
            pictures.append(harness.read_png(os.path.join(path, "o.png")))
        expect(pictures[0] != pictures[1], "a transparent sheet hides what is behind it")


def main():
    checks = Checks()
    shares = []
    for viewer, models in (("teapot_afd", PATCHES), ("modelview", {**PATCHES, **POLYGONS})):
        for name, content in models.items():
            checks.run("framing.%s.%s" % (viewer, name),
                       lambda v=viewer, n=name, c=content: shares.extend(fills_the_picture(v, n, c)))
    checks.run("framing.gallery_is_seen_from_above_what_is_upright", gallery_is_seen_from_above_what_is_upright)
    checks.run("framing.modelview_says_that_transparent_patches_are_opaque",
               modelview_says_that_transparent_patches_are_opaque)
    checks.run("framing.gallery_shows_a_files_parts_and_what_is_transparent",
               gallery_shows_a_files_parts_and_what_is_transparent)
    if shares:
        print("# shares of %d pictures: %.0f to %.0f %%" % (len(shares), 100 * min(shares), 100 * max(shares)))
    checks.finish()


if __name__ == "__main__":
    main()
