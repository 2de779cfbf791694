#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reads models of every dialect by our readers and by assimp, and compares each with what was made.

L3D_TESTS names the folder of model_polygons. Prints `ok` or `not ok` for each file, and a table.
`--folder PATH` also compares all models of a folder, such as assimp's own, where nothing but assimp
knows the truth.
"""

import argparse
import collections
import math
import os
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

from binary_dialects import GLTF, PLY
from shapes import shapes
from text_dialects import OBJ, OFF, STL

FORMATS = {".off": OFF, ".ply": PLY, ".obj": OBJ, ".stl": STL, "glTF": GLTF}
ENDS = (".off", ".ply", ".obj", ".stl", ".gltf", ".glb")
# Readers round to single precision, some twice; a share of the model's size.
CLOSE = 1e-5


def our_polygons(paths):
    """For each path its polygons, or the message as text."""
    program = os.path.join(os.environ["L3D_TESTS"], "model_polygons")
    out = subprocess.run([program, *paths], check=True, stdout=subprocess.PIPE).stdout.decode()
    found = []
    for line in out.splitlines():
        word, _, rest = line.partition(" ")
        if word == "file":
            found.append([])
        elif word == "error":
            found[-1] = rest
        else:
            values = list(map(float, rest.split()))
            found[-1].append(tuple(zip(*[iter(values)] * 3)))
    return found


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def assimp_polygons(path):
    """The polygons that assimp finds without any of its repairs, or the message as text."""
    with tempfile.NamedTemporaryFile(suffix=".assxml") as dump:
        run = subprocess.run(["assimp", "dump", path, dump.name], stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT)
        try:
            scene = xml.etree.ElementTree.parse(dump.name).getroot().find("Scene")
        except xml.etree.ElementTree.ParseError:
            said = run.stdout.decode(errors="replace").strip().splitlines()
            return said[-1] if said else "exit status %d" % run.returncode
    meshes = [mesh_of(mesh) for mesh in scene.iter("Mesh")]
    found = []

    def walk(node, above):
        rows = list(map(float, node.find("Matrix4").text.split()))
        here = times(above, [rows[i:i + 4] for i in range(0, 16, 4)])
        for number in (node.findtext("MeshRefs") or "").split():
            places, faces = meshes[int(number)]
            moved = [tuple(sum(row[k] * v[k] for k in range(3)) + row[3] for row in here[:3])
                     for v in places]
            found.extend(tuple(moved[i] for i in face) for face in faces if len(face) >= 3)
        for child in node.findall("NodeList/Node"):
            walk(child, here)

    walk(scene.find("Node"), [[float(i == j) for j in range(4)] for i in range(4)])
    return found


def mesh_of(mesh):
    values = list(map(float, (mesh.findtext("Positions") or "").split()))
    faces = [list(map(int, face.text.split())) for face in mesh.iter("Face")]
    return list(zip(*[iter(values)] * 3)), faces


def size_of(polygons):
    return max([1e-30, *(abs(c) for polygon in polygons for p in polygon for c in p)])


def merged(polygons):
    """How many places the corners have."""
    unit = CLOSE * size_of(polygons)
    return len({tuple(round(c / unit) for c in p) for polygon in polygons for p in polygon})


def counts(polygons):
    corners = sum(len(polygon) - 2 for polygon in polygons)
    places = [p for polygon in polygons for p in polygon]
    box = [f(p[c] for p in places) for c in range(3) for f in (min, max)] if places else []
    return merged(polygons), corners, " ".join("%.6g" % (b + 0.0) for b in box)


def same(a, b, close):
    """Whether the corners are the same ones, from whichever on."""
    return len(a) == len(b) and any(
        all(math.dist(a[i], b[(i + turn) % len(b)]) <= close for i in range(len(a)))
        for turn in range(len(a)))


def missing(wanted, found, close):
    """How many of the wanted polygons are not found among as many; each found one counts once."""
    def bucket(polygon):
        return tuple(round(sum(p[c] for p in polygon) / len(polygon) / (64 * close))
                     for c in range(3))
    # Most readers keep the order of the file.
    pairs = [pair for pair in zip(wanted, found) if not same(*pair, close)]
    left = collections.defaultdict(list)
    for _, polygon in pairs:
        left[bucket(polygon)].append(polygon)
    absent = 0
    for polygon, _ in pairs:
        x, y, z = bucket(polygon)
        near = [left[x + i, y + j, z + k] for i in (0, -1, 1) for j in (0, -1, 1)
                for k in (0, -1, 1) if (x + i, y + j, z + k) in left]
        for some in near:
            match = next((i for i, other in enumerate(some) if same(polygon, other, close)), None)
            if match is not None:
                del some[match]
                break
        else:
            absent += 1
    return absent


def difference(wanted, found):
    """In words; empty if both have the same polygons."""
    if isinstance(found, str):
        return "refuses: " + found
    if len(wanted) != len(found):
        return "%d polygons for %d" % (len(found), len(wanted))
    absent = missing(wanted, found, CLOSE * size_of(wanted))
    return "%d polygons of %d differ" % (absent, len(wanted)) if absent else ""


def made_models(folder):
    """Writes a file for each shape and dialect: (format, dialect, path, polygons)."""
    for kind, dialects in FORMATS.items():
        for dialect, make in dialects.items():
            for shape in shapes():
                made = make(shape)
                place = os.path.join(folder, "%s %s %s" % (kind, dialect.replace("/", "_"),
                                                           shape.name))
                os.mkdir(place)
                for name, data in made.files.items():
                    with open(os.path.join(place, name), "wb") as file:
                        file.write(data)
                yield kind, dialect, os.path.join(place, next(iter(made.files))), made.polygons


def compare_made(folder):
    """How many files failed."""
    models = list(made_models(folder))
    ours = our_polygons([path for _, _, path, _ in models])
    table = collections.defaultdict(lambda: [0, 0, 0, 0])
    apart, failed = {}, 0
    for (kind, dialect, path, wanted), found in zip(models, ours):
        name = "models." + os.path.basename(os.path.dirname(path)).replace(" ", "_")
        wrong = difference(wanted, found)
        other = assimp_polygons(path)
        theirs = difference(wanted, other)
        row = table[kind]
        row[0] += 1
        row[1] += not wrong
        row[2] += not theirs
        row[3] += not wrong and not theirs and counts(found)[:2] == counts(other)[:2]
        if theirs:
            apart.setdefault((kind, dialect), theirs.replace(folder, "").strip())
        failed += bool(wrong)
        print("ok " + name if not wrong else "not ok %s %s" % (name, wrong), flush=True)
    print("# format, files, read by us as made, by assimp, by both with the same counts")
    for kind, row in table.items():
        print("# | `%s` | %s |" % (kind, " | ".join(map(str, row))))
    for (kind, dialect), why in apart.items():
        print("# assimp differs: %s, %s: %s" % (kind, dialect, why))
    return failed


def compare_found(folder):
    """Models whose truth only the two readers know. How many differ where both read."""
    paths = sorted(os.path.join(at, name) for at, _, names in os.walk(folder) for name in names
                   if name.lower().endswith(ENDS))
    differ = 0
    for path, found in zip(paths, our_polygons(paths)):
        theirs = assimp_polygons(path)
        name = os.path.relpath(path, folder).replace(" ", "_")
        if isinstance(found, str) or isinstance(theirs, str):
            words = [value if isinstance(value, str) else "read" for value in (found, theirs)]
            print("# apart %s we: %s; assimp: %s" % (name, words[0].replace(path, ""), words[1]))
            continue
        wrong = difference(theirs, found)
        differ += bool(wrong)
        print("ok %s" % name if not wrong else "not ok %s %s: we %s, assimp %s"
              % (name, wrong, counts(found), counts(theirs)), flush=True)
    return differ


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--folder", help="also compare the models of this folder")
    options = parser.parse_args()
    if not shutil.which("assimp"):
        print("skipped: assimp is not installed")
        return
    with tempfile.TemporaryDirectory(prefix="l3d_models_") as folder:
        failed = compare_made(folder)
    if options.folder:
        failed += compare_found(options.folder)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
