# SPDX-License-Identifier: MIT
"""Dialects of .off, .obj and .stl: each gives a shape as the bytes of a file.

A dialect is a function of a shape that returns a Made: the files' bytes by name, the first of
which is the model, and the polygons that a reader must find.
"""

import struct


class Made:
    def __init__(self, files, polygons):
        self.files = files
        self.polygons = polygons


def made(name, text, polygons, others=None):
    data = text if isinstance(text, bytes) else text.encode()
    return Made({name: data, **(others or {})}, polygons)


def numbers(values):
    return " ".join("%.9g" % value for value in values)


def exponents(values):
    return " ".join("%.9e" % value for value in values)


def normal_of(point):
    length = sum(c * c for c in point) ** 0.5 or 1
    return tuple(c / length for c in point)


# ---- .off ---------------------------------------------------------------------------------------


def off(word="OFF", join="\n", before="", edges=" 0", face_color="", shown=numbers, end="\n"):
    def vertex(point):
        line = shown(point)
        if "N" in word:
            line += " " + shown(normal_of(point))
        if word.replace("ST", "").startswith("C"):
            line += " 0.25 0.5 0.75 1"
        if word.startswith("ST"):
            line += " 0.5 0.5"
        return line

    def write(shape):
        lines = [vertex(point) for point in shape.points]
        lines += [" ".join(map(str, (len(face), *face))) + face_color for face in shape.faces]
        counts = "%d %d%s" % (len(shape.points), len(shape.faces), edges)
        text = before + word + join + counts + "\n" + "\n".join(lines) + "\n"
        return made("model.off", text.replace("\n", end), shape.polygons())
    return write


def off_with_gaps(shape):
    rows = ["OFF # a word about it", "", "# another", "%d %d 0" % (len(shape.points),
                                                                 len(shape.faces)), ""]
    rows += ["\t%s  # a point" % numbers(point) for point in shape.points]
    rows += ["", "# faces"] + ["%d   %s" % (len(face), "  ".join(map(str, face)))
                               for face in shape.faces]
    return made("model.off", "\n".join(rows), shape.polygons())


OFF = {
    "OFF": off(), "COFF": off("COFF"), "NOFF": off("NOFF"), "CNOFF": off("CNOFF"),
    "STOFF": off("STOFF"), "STCNOFF": off("STCNOFF"),
    "counts beside the word": off(join=" "), "no count of edges": off(edges=""),
    "carriage returns": off(end="\r\n"), "colours 0 to 255": off(face_color=" 255 128 0"),
    "colours 0 to 1": off(face_color=" 0.5 0.25 1.0 1.0"), "index of a colour": off(face_color=" 3"),
    "exponents": off(shown=exponents), "comments and gaps": off_with_gaps,
}

# ---- .obj ---------------------------------------------------------------------------------------


def obj(corner="v", back=False, head="", tail="", before_face=None, shown=numbers, end="\n",
        vertex_tail="", others=None, break_lines=False):
    """`corner`: which numbers a corner has, such as v/t/n."""
    def write(shape):
        count = len(shape.points)

        def numbered(index):
            number = index - count if back else index + 1
            return corner.replace("v", str(number)).replace("t", str(number)).replace(
                "n", str(number))
        rows = [head] if head else []
        rows += ["v %s%s" % (shown(point), vertex_tail) for point in shape.points]
        if "t" in corner:
            rows += ["vt 0.5 0.25"] * count
        if "n" in corner:
            rows += ["vn " + numbers(normal_of(point)) for point in shape.points]
        glue = " \\\n " if break_lines else " "
        for i, face in enumerate(shape.faces):
            rows += before_face(i) if before_face else []
            rows.append(glue.join(["f", *map(numbered, face)]))
        text = "\n".join(rows) + "\n" + tail
        return made("model.obj", text.replace("\n", end), shape.polygons(), others)
    return write


def obj_face_by_face(shape):
    """Points just before each face, counted back, as scanners write them."""
    rows = []
    for polygon in shape.polygons():
        rows += ["v " + numbers(point) for point in polygon]
        rows.append("f " + " ".join(str(i - len(polygon)) for i in range(len(polygon))))
    return made("model.obj", "\n".join(rows) + "\n", shape.polygons())


LOOKS = b"newmtl red\nKd 0.8 0.1 0.1\nNs 20\nillum 2\n\nnewmtl blue\nKd 0.1 0.1 0.8\nd 0.5\n"


def two_materials(i):
    return ["usemtl " + ("red", "blue")[i // 2 % 2]] if i % 2 == 0 else []


def groups(word):
    return lambda i: ["%s part_%d" % (word, i // 3)] if i % 3 == 0 else []


OBJ = {
    "v": obj(), "v/t": obj("v/t"), "v//n": obj("v//n"), "v/t/n": obj("v/t/n"),
    "v counted back": obj(back=True), "v//n counted back": obj("v//n", back=True),
    "v/t/n counted back": obj("v/t/n", back=True), "face by face": obj_face_by_face,
    "lines continued": obj(break_lines=True), "carriage returns": obj(end="\r\n"),
    "materials": obj(head="mtllib looks.mtl", before_face=two_materials,
                     others={"looks.mtl": LOOKS}),
    "materials that are missing": obj(head="mtllib none.mtl", before_face=two_materials),
    "objects": obj(before_face=groups("o")), "groups": obj(before_face=groups("g")),
    "several groups at once": obj(before_face=lambda i: ["g a b c%d" % i]),
    "smoothing groups": obj(before_face=lambda i: ["s %s" % ("off", "1", "2")[i % 3]]),
    "comments": obj(head="# made\n#\n", before_face=lambda i: ["# face %d" % i, ""]),
    "colours of vertices": obj(vertex_tail=" 0.5 0.25 1"), "weights": obj(vertex_tail=" 1.0"),
    "exponents": obj(shown=exponents),
    "points and lines besides": obj(tail="p 1\nl 1 2 3\n"),
}

# ---- .stl ---------------------------------------------------------------------------------------


def stl_rows(shape, shown=numbers, name="thing", indent="  "):
    rows = ["solid " + name]
    for triangle in shape.triangles().polygons():
        rows += ["%sfacet normal 0 0 0" % indent, "%souter loop" % (2 * indent)]
        rows += ["%svertex %s" % (3 * indent, shown(point)) for point in triangle]
        rows += ["%sendloop" % (2 * indent), "%sendfacet" % indent]
    return [*rows, "endsolid " + name]


def stl(end="\n", capital=False, **how):
    def write(shape):
        text = end.join(stl_rows(shape, **how)) + end
        return made("model.stl", text.upper() if capital else text, shape.triangles().polygons())
    return write


def stl_of_two(shape):
    moved = type(shape)(shape.name, [(x + 16, y, z) for x, y, z in shape.points], shape.faces)
    rows = stl_rows(shape, name="first") + stl_rows(moved, name="second")
    both = shape.triangles().polygons() + moved.triangles().polygons()
    return made("model.stl", "\n".join(rows) + "\n", both)


def stl_binary(header=b"", attribute=0):
    def write(shape):
        triangles = shape.triangles().polygons()
        data = header.ljust(80, b" ") + struct.pack("<I", len(triangles))
        for triangle in triangles:
            data += struct.pack("<12fH", 0, 0, 0, *[c for p in triangle for c in p], attribute)
        return made("model.stl", data, triangles)
    return write


STL = {
    "text": stl(), "text, carriage returns": stl(end="\r\n"), "text, capitals": stl(capital=True),
    "text, no name": stl(name=""), "text, a name of words": stl(name="a thing of words"),
    "text, exponents": stl(shown=exponents), "text, tabs": stl(indent="\t"),
    "text, two solids": stl_of_two, "binary": stl_binary(b"made"), "binary, empty header": stl_binary(),
    "binary, begins with solid": stl_binary(b"solid thing"),
    "binary, with colours": stl_binary(b"COLOR=\xff\x80\x40\xff", 0x7FFF),
}
