# SPDX-License-Identifier: MIT
"""Shapes that models are made of: points and faces, as every dialect of a file can hold them.

Coordinates are multiples of 1/64 below 16, so that single precision and short decimals hold them
exactly, also where a transform moves them by as much, scales by 2 or turns by 90 degrees.
"""

import math


class Shape:
    def __init__(self, name, points, faces):
        self.name = name
        self.points = [tuple(round(64 * c) / 64 for c in point) for point in points]
        self.faces = [tuple(face) for face in faces]

    def polygons(self):
        """The places of each face's corners: what a reader must find."""
        return [tuple(self.points[i] for i in face) for face in self.faces]

    def triangles(self):
        """The same with every face cut into a fan from its first corner."""
        cut = [(face[0], face[i], face[i + 1]) for face in self.faces
               for i in range(1, len(face) - 1)]
        return Shape(self.name, self.points, cut)


def tetrahedron():
    return Shape("tetrahedron", [(1, 1, 1), (-1, -1, 1), (-1, 1, -1), (1, -1, -1)],
                 [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])


def box():
    points = [(x, y, z) for z in (-0.5, 2.25) for y in (-1, 1.5) for x in (-3, 0.75)]
    return Shape("box", points, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3),
                                 (0, 4, 6, 2), (1, 3, 7, 5)])


def prism(corners=7):
    """Faces of different numbers of corners in one file; its lid is no triangle and no rectangle."""
    ring = [(3 * math.cos(2 * math.pi * i / corners), 3 * math.sin(2 * math.pi * i / corners))
            for i in range(corners)]
    points = [(x, y, z) for z in (-1, 1) for x, y in ring]
    sides = [(i, (i + 1) % corners, (i + 1) % corners + corners, i + corners)
             for i in range(corners)]
    return Shape("prism", points, [tuple(range(corners))[::-1],
                                   tuple(range(corners, 2 * corners)), *sides])


def torus(around=12, across=7):
    def point(i, j):
        a, b = 2 * math.pi * i / around, 2 * math.pi * j / across
        r = 4 + 1.5 * math.cos(b)
        return (r * math.cos(a), 1.5 * math.sin(b), r * math.sin(a))

    def number(i, j):
        return i % around * across + j % across
    return Shape("torus", [point(i, j) for i in range(around) for j in range(across)],
                 [(number(i, j), number(i, j + 1), number(i + 1, j + 1), number(i + 1, j))
                  for i in range(around) for j in range(across)])


def sheet(columns=9, rows=5):
    """Not closed; its first points are used by one face only, and the last by none."""
    points = [(x - 4, math.sin(x) + math.cos(2 * y), y) for y in range(rows)
              for x in range(columns)]
    faces = []
    for y in range(rows - 1):
        for x in range(columns - 1):
            a = y * columns + x
            faces += [(a, a + columns, a + 1), (a + 1, a + columns, a + columns + 1)]
    return Shape("sheet", [*points, (9, 9, 9)], faces)


def shapes():
    return [tetrahedron(), box(), prism(), torus(), sheet()]


def strips(rows=4, columns=6):
    """Rows of triangles as strips, and the shape that they must give."""
    points = [(x / 2, y, (x * y) / 8) for y in range(rows) for x in range(columns)]
    bands = [[number for x in range(columns) for number in (y * columns + x, (y + 1) * columns + x)]
             for y in range(rows - 1)]
    faces = []
    for band in bands:
        for i in range(len(band) - 2):
            a, b, c = band[i:i + 3]
            faces.append((a, b, c) if i % 2 == 0 else (b, a, c))
    return bands, Shape("strips", points, faces)
