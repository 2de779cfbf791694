#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""stand_ins.py FOLDER: writes bird.off (270 vertices, 516 faces) and mask.off (656, 1234).

They have the sizes of two models of an engine of 1995, which are in no free collection. A pole and
rings around it are an open surface: 1 + a n vertices and a (2 n - 1) faces of n rings of a points
each. Each point put into the middle of a face makes two faces more.
"""

import math
import os
import sys


def rings(around, count, place):
    """The pole, then ring after ring."""
    points = [place(0, 0)]
    points += [place((i + 1) / count, 2 * math.pi * k / around) for i in range(count) for k in range(around)]
    faces = [(0, 1 + k, 1 + (k + 1) % around) for k in range(around)]
    for i in range(count - 1):
        for k in range(around):
            a, b = 1 + i * around + k, 1 + i * around + (k + 1) % around
            c, d = b + around, a + around
            faces += [(a, d, c), (a, c, b)]
    return points, faces


def with_middles(points, faces, count, step):
    """Cuts every step-th face into three."""
    for at in range(0, count * step, step):
        a, b, c = faces[at]
        points.append(tuple(sum(points[i][k] for i in (a, b, c)) / 3 for k in range(3)))
        middle = len(points) - 1
        faces[at] = (a, b, middle)
        faces += [(b, c, middle), (c, a, middle)]
    return points, faces


def bird(along, angle):
    """From the beak's tip over head, neck and body to the open tail."""
    outline = ((0, 0, 1.30, 0.00), (0.10, 0.35, 1.30, 0.10), (0.18, 0.50, 1.32, 0.32), (0.34, 0.85, 1.30, 0.42), (0.45, 1.05, 1.02, 0.30),
               (0.55, 1.15, 0.62, 0.45), (0.70, 1.60, 0.42, 0.78), (0.85, 2.40, 0.42, 0.70), (1.00, 3.20, 0.85, 0.16))
    for (t0, x0, y0, r0), (t1, x1, y1, r1) in zip(outline, outline[1:]):
        if along <= t1:
            s = (along - t0) / (t1 - t0)
            s = s * s * (3 - 2 * s)
            radius = r0 + s * (r1 - r0)
            return (x0 + s * (x1 - x0) - 1.5, 0.85 * radius * math.cos(angle), y0 + s * (y1 - y0) - 0.6 + radius * math.sin(angle))
    raise ValueError(along)


def mask(along, angle):
    """From the tip of the nose outwards."""
    x, y = 0.8 * along * math.cos(angle), 1.1 * along * math.sin(angle)
    nose = 0.35 * math.exp(-(x * x * 60 + (y + 0.05) ** 2 * 14))
    eyes = sum(0.16 * math.exp(-((x - side) ** 2 * 45 + (y - 0.3) ** 2 * 90)) for side in (-0.3, 0.3))
    mouth = 0.07 * math.exp(-(x * x * 14 + (y + 0.48) ** 2 * 260))
    return x, -(0.75 * math.sqrt(max(0, 1 - 0.97 * along * along)) + nose - eyes + mouth), y


def write(path, points, faces, wanted):
    if (len(points), len(faces)) != wanted:
        sys.exit(f"{path}: {len(points)} vertices and {len(faces)} faces, not {wanted}")
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        file.writelines(f"{x:.4f} {y:.4f} {z:.4f}\n" for x, y, z in points)
        file.writelines(f"3 {a} {b} {c}\n" for a, b, c in faces)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__.splitlines()[0])
    write(os.path.join(sys.argv[1], "bird.off"), *with_middles(*rings(22, 12, bird), 5, 97), (270, 516))
    write(os.path.join(sys.argv[1], "mask.off"), *with_middles(*rings(76, 8, mask), 47, 23), (656, 1234))
