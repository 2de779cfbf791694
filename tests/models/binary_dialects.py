# SPDX-License-Identifier: MIT
"""Dialects of .ply and glTF: each gives a shape as the bytes of a file."""

import base64
import json
import struct

from shapes import strips
from text_dialects import made, normal_of

# ---- .ply ---------------------------------------------------------------------------------------

CODES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
         "float": "f", "double": "d", "int8": "b", "uint8": "B", "int16": "h", "uint16": "H",
         "int32": "i", "uint32": "I", "float32": "f", "float64": "d"}


class Rows:
    """The body of a .ply file in one of its three forms."""

    def __init__(self, form):
        self.form = form
        self.body = b""

    def row(self, *typed):
        """Values with their types, (type, value) each."""
        if self.form == "ascii":
            self.body += (" ".join("%.9g" % value for _, value in typed) + "\n").encode()
        else:
            order = "<" if self.form == "binary_little_endian" else ">"
            self.body += b"".join(struct.pack(order + CODES[kind], value) for kind, value in typed)

    def file(self, header, end="\n"):
        lines = ["ply", "format %s 1.0" % self.form, *header, "end_header", ""]
        body = self.body.replace(b"\n", end.encode()) if self.form == "ascii" else self.body
        return end.join(lines).encode() + body


def ply(form, place="float", length="uchar", index="int", listed="vertex_indices", before=(),
        behind=(), of_face=(), comments=(), end="\n", others=False):
    """`before` and `behind` a point's place, and `of_face`: more properties, (type, name) each."""
    def more(properties, point):
        values = {"nx": normal_of(point)[0], "ny": normal_of(point)[1], "nz": normal_of(point)[2]}
        return [(kind, values.get(name, 7)) for kind, name in properties]

    def write(shape):
        header = [*comments, "element vertex %d" % len(shape.points)]
        header += ["property %s %s" % p for p in (*before, *((place, c) for c in "xyz"), *behind)]
        if others:
            header += ["element edge 2", "property int a", "property int b"]
        header += ["element face %d" % len(shape.faces)]
        header += ["property list %s %s %s" % (length, index, listed)]
        header += ["property %s %s" % p for p in of_face]
        rows = Rows(form)
        for point in shape.points:
            rows.row(*more(before, point), *((place, c) for c in point), *more(behind, point))
        if others:
            rows.row(("int", 0), ("int", 1))
            rows.row(("int", 1), ("int", 2))
        for face in shape.faces:
            rows.row((length, len(face)), *((index, i) for i in face),
                     *more(of_face, (0, 0, 1)))
        return made("model.ply", rows.file(header, end), shape.polygons())
    return write


def ply_of_strips(form):
    """All strips in one list, each ended by -1, as scans of statues have them."""
    def write(shape):
        del shape
        bands, wanted = strips()
        joined = [number for band in bands for number in (*band, -1)]
        header = ["element vertex %d" % len(wanted.points)]
        header += ["property float %s" % c for c in "xyz"]
        header += ["element tristrips 1", "property list int int vertex_indices"]
        rows = Rows(form)
        for point in wanted.points:
            rows.row(*(("float", c) for c in point))
        rows.row(("int", len(joined)), *(("int", i) for i in joined))
        return made("model.ply", rows.file(header), wanted.polygons())
    return write


COLORS = (("uchar", "red"), ("uchar", "green"), ("uchar", "blue"))
NORMALS = (("float", "nx"), ("float", "ny"), ("float", "nz"))


def ply_dialects():
    found = {}
    for form, name in (("ascii", "text"), ("binary_little_endian", "low byte first"),
                       ("binary_big_endian", "high byte first")):
        found.update({
            name: ply(form),
            name + ", double": ply(form, place="double"),
            name + ", normals and colours": ply(form, behind=(*NORMALS, *COLORS)),
            name + ", properties before and behind": ply(
                form, before=(("uchar", "flags"), ("double", "time")),
                behind=(("short", "confidence"), ("float", "intensity"))),
            name + ", lists of other types": ply(form, length="ushort", index="uint",
                                                 listed="vertex_index"),
            name + ", new names of types": ply(form, "float32", "uint8", "int32"),
            name + ", faces with properties": ply(form, of_face=(*COLORS, ("float", "quality"))),
            name + ", other elements": ply(form, others=True),
            name + ", strips": ply_of_strips(form)})
    found["text, carriage returns"] = ply("ascii", end="\r\n")
    found["text, comments"] = ply("ascii", comments=("comment made", "obj_info none"))
    return found


PLY = ply_dialects()

# ---- glTF ---------------------------------------------------------------------------------------

FLOAT, BYTES, SHORTS, INTS = 5126, 5121, 5123, 5125
ARRAY, ELEMENTS = 34962, 34963


class Document:
    """A document and its one buffer."""

    def __init__(self, **more):
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
                     "nodes": [{"mesh": 0}], "meshes": [], "bufferViews": [], "accessors": [],
                     **more}
        self.buffer = b""

    def view(self, data, **more):
        self.buffer += b"\0" * (-len(self.buffer) % 4)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.buffer),
                                         "byteLength": len(data), **more})
        self.buffer += data
        return len(self.json["bufferViews"]) - 1

    def accessor(self, view, component, count, kind, **more):
        self.json["accessors"].append({"bufferView": view, "componentType": component,
                                       "count": count, "type": kind, **more})
        return len(self.json["accessors"]) - 1

    def places(self, points, pad=0):
        data = b"".join(struct.pack("<3f", *point) + b"\x7f" * pad for point in points)
        stride = {"byteStride": 12 + pad} if pad else {}
        return self.accessor(self.view(data, target=ARRAY, **stride), FLOAT, len(points), "VEC3",
                             min=[min(p[c] for p in points) for c in range(3)],
                             max=[max(p[c] for p in points) for c in range(3)])

    def indices(self, numbers_, component):
        code = {BYTES: "B", SHORTS: "H", INTS: "I"}[component]
        data = struct.pack("<%d%s" % (len(numbers_), code), *numbers_)
        return self.accessor(self.view(data, target=ELEMENTS), component, len(numbers_), "SCALAR")

    def files(self, how):
        self.json["buffers"] = [{"byteLength": len(self.buffer)}]
        if how == "in the text":
            self.json["buffers"][0]["uri"] = ("data:application/octet-stream;base64,"
                                              + base64.b64encode(self.buffer).decode())
        elif how == "beside":
            self.json["buffers"][0]["uri"] = "model.bin"
        text = json.dumps(self.json).encode()
        if how != "container":
            return {"model.gltf": text, **({"model.bin": self.buffer} if how == "beside" else {})}
        text += b" " * (-len(text) % 4)
        data = self.buffer + b"\0" * (-len(self.buffer) % 4)
        return {"model.glb": struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(data))
                + struct.pack("<I4s", len(text), b"JSON") + text
                + struct.pack("<I4s", len(data), b"BIN\0") + data}


def gltf(how="in the text", component=SHORTS, node=None, moved=lambda p: p, pad=0, more=(),
         indexed=True):
    """`more`: attributes besides the place. `moved`: what the node does to a point."""
    def write(shape):
        shape = shape.triangles()
        document = Document()
        points = shape.points if indexed else [p for t in shape.polygons() for p in t]
        attributes = {"POSITION": document.places(points, pad)}
        if "NORMAL" in more:
            data = b"".join(struct.pack("<3f", *normal_of(p)) for p in points)
            attributes["NORMAL"] = document.accessor(document.view(data, target=ARRAY), FLOAT,
                                                     len(points), "VEC3")
        if "COLOR_0" in more:
            data = b"\x20\x40\x80\xff" * len(points)
            attributes["COLOR_0"] = document.accessor(document.view(data, target=ARRAY), BYTES,
                                                      len(points), "VEC4", normalized=True)
        primitive = {"attributes": attributes}
        if indexed:
            primitive["indices"] = document.indices([i for f in shape.faces for i in f], component)
        document.json["meshes"].append({"primitives": [primitive]})
        document.json["nodes"] = node or [{"mesh": 0}]
        wanted = [tuple(map(moved, polygon)) for polygon in shape.polygons()]
        files = document.files(how)
        name = next(iter(files))
        return made(name, files.pop(name), wanted, files)
    return write


def gltf_of_strips(mode):
    """Mode 5: strips, one primitive each. Mode 6: fans, the first triangles around a point."""
    def write(shape):
        bands, wanted = strips()
        if mode == 6:
            bands = [list(face) for face in shape.faces]
            wanted = shape.triangles()
        document = Document()
        places = document.places(wanted.points)
        document.json["meshes"].append({"primitives": [
            {"attributes": {"POSITION": places}, "mode": mode,
             "indices": document.indices(band, SHORTS)} for band in bands]})
        return made("model.gltf", document.files("in the text")["model.gltf"], wanted.polygons())
    return write


def gltf_with_sparse_places(shape):
    """Every other point is zero in the buffer, and given apart."""
    shape = shape.triangles()
    document = Document()
    given = list(range(0, len(shape.points), 2))
    places = document.places([(0, 0, 0) if i % 2 == 0 else p for i, p in enumerate(shape.points)])
    chosen = document.view(struct.pack("<%dH" % len(given), *given))
    values = document.view(b"".join(struct.pack("<3f", *shape.points[i]) for i in given))
    document.json["accessors"][places]["sparse"] = {
        "count": len(given), "indices": {"bufferView": chosen, "componentType": SHORTS},
        "values": {"bufferView": values}}
    faces = document.indices([i for f in shape.faces for i in f], SHORTS)
    document.json["meshes"].append({"primitives": [{"attributes": {"POSITION": places},
                                                    "indices": faces}]})
    return made("model.gltf", document.files("in the text")["model.gltf"], shape.polygons())


def gltf_drawn_twice(shape):
    """One mesh by two nodes, the second the child of the first."""
    nodes = [{"mesh": 0, "translation": [1, 0, 0], "children": [1]},
             {"mesh": 0, "translation": [0, 16, 0], "scale": [2, 2, 2]}]
    one = gltf(node=nodes)(shape)
    polygons = shape.triangles().polygons()
    first = [tuple((x + 1, y, z) for x, y, z in polygon) for polygon in polygons]
    second = [tuple((2 * x + 1, 2 * y + 16, 2 * z) for x, y, z in polygon) for polygon in polygons]
    return made("model.gltf", one.files["model.gltf"], first + second)


QUARTER = 0.5 ** 0.5
GLTF = {
    "in the text": gltf(), "beside": gltf("beside"), "container": gltf("container"),
    "8-bit indices": gltf(component=BYTES), "32-bit indices": gltf(component=INTS),
    "no indices": gltf(indexed=False), "strips": gltf_of_strips(5), "fans": gltf_of_strips(6),
    "normals": gltf(more=("NORMAL",)), "colours": gltf(more=("COLOR_0",)),
    "strides": gltf(pad=4), "container, strides and normals": gltf("container", pad=8,
                                                                  more=("NORMAL",)),
    "sparse places": gltf_with_sparse_places, "one mesh twice": gltf_drawn_twice,
    "a matrix": gltf(node=[{"mesh": 0, "matrix": [0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0,
                                                  1, 2, 3, 1]}],
                     moved=lambda p: (1 - 2 * p[1], 2 + 2 * p[0], 3 + 2 * p[2])),
    "a rotation": gltf(node=[{"mesh": 0, "rotation": [0, 0, QUARTER, QUARTER],
                              "translation": [0, 0, 5]}],
                       moved=lambda p: (-p[1], p[0], p[2] + 5)),
}
