# SPDX-License-Identifier: MIT
"""Diagrams by gnuplot: lines that join settings in their order, and names beside their ends."""

import math
import os
import subprocess

# Told apart from each other by everybody, whichever colours they see (after Okabe and Ito).
BLACK, ORANGE, SKY, GREEN, BLUE, RED, PINK, GREY, BROWN, OLIVE, VIOLET = (
    "#000000", "#e69f00", "#56b4e9", "#009e73", "#0072b2", "#d55e00", "#e377c2", "#8a8a8a", "#7a4a1e",
    "#8a8500", "#6a3d9a")

# Colour, width of the line, gnuplot's shape of its points.
STYLES = {
    "afd": (BLACK, 3, 7), "fd": (BLUE, 1.6, 5), "subdivision": (GREEN, 1.6, 9),
    "tessellation": (ORANGE, 1.6, 13), "zbuffer": (OLIVE, 1.2, 12), "zsort": (RED, 1.6, 11),
    "micropolygons": (PINK, 1.6, 4), "isocurves": (SKY, 1.6, 6), "scanline": (BROWN, 1.6, 8),
    "whitted": ("#c7a17a", 1.2, 8), "blinn": ("#a0522d", 1.2, 14), "lane-carpenter": ("#66c2a5", 1.2, 9), "kept": ("#f4a6d7", 1.2, 4),
    "voxels": (GREY, 1.6, 10), "mesa": (VIOLET, 1.6, 15), "llvmpipe": ("#1b1b8f", 1.6, 2),
    "Embree": ("#c51b7d", 1.6, 3), "16.16": (RED, 1.6, 5), "32-bit block": (ORANGE, 1.6, 9),
    "32-bit graded": (PINK, 1.6, 11), "32.32": (GREEN, 1.6, 13), "float": (BLACK, 2.4, 7),
    "double": (BLUE, 1.6, 4), "chord": (BLACK, 2, 7)}
SVG, PNG = (900, 560), (1100, 680)
# Numbers below this are nothing on a logarithmic axis.
LEAST = 1e-13


class Line:
    """One line of a diagram; theory and bounds are dashed and have no points."""

    def __init__(self, name, points, dashed=False, scattered=False):
        self.name, self.dashed, self.scattered = name, dashed, scattered
        self.points = [(x, y) for x, y in points if x > 0 and y > LEAST]

    def style(self):
        return STYLES.get(self.name, (GREY, 1.2, 1))


class Diagram:
    def __init__(self, title, x_label, y_label, lines, diagonal=False):
        self.title, self.x_label, self.y_label = title, x_label, y_label
        self.lines = [line for line in lines if line.points]
        self.diagonal = diagonal


def spans(lines):
    """The decades of both axes, with room to the right for names."""
    def ends(values, more):
        low, high = math.log10(min(values)), math.log10(max(values))
        edge = 0.05 * max(high - low, 1)
        return low - edge, high + edge + more * max(high - low, 1)
    points = [point for line in lines for point in line.points]
    return ends([x for x, _ in points], 0.16), ends([y for _, y in points], 0.02)


def labels(lines, size, font):
    """Names at the ends of lines, moved up or down until none touches another. Size: pixels of the panel."""
    (left, right), (low, high) = spans(lines)
    # Titles and numbers at the axes take the rest of a panel, the more the smaller it is.
    wide, tall = size[0] - 7 * font, size[1] - 7 * font
    apart, letter = 1.25 * font / tall, 0.62 * font / wide
    wanted = []
    for line in lines:
        if line.dashed or line.scattered or len(lines) == 1:
            continue
        x, y = line.points[-1]
        wanted.append([(math.log10(x) - left) / (right - left), (math.log10(y) - low) / (high - low), line])
    wanted.sort(key=lambda each: each[1])
    reach = [(len(line.name) + 2) * letter for *_, line in wanted]
    for _ in range(1000):
        for i, one in enumerate(wanted):
            for k, other in enumerate(wanted[i + 1:], i + 1):
                beside = one[0] > other[0] + reach[k] or other[0] > one[0] + reach[i]
                if not beside and abs(one[1] - other[1]) < apart:
                    push = (apart - abs(one[1] - other[1])) / 2 + 1e-4
                    sign = 1 if one[1] <= other[1] else -1
                    one[1], other[1] = one[1] - sign * push, other[1] + sign * push
            one[1] = min(max(one[1], 0.02), 0.98)
    text = ""
    for x, y, line in wanted:
        text += (f"set label '{line.name}' at graph {x:.4f},{y:.4f} left offset 0.9,0 "
                 f"tc rgb '{line.style()[0]}' noenhanced front\n")
    return text


def panel(d, data, size, font, small=False):
    """The commands of one diagram; its data blocks are named by `data`."""
    (left, right), (low, high) = spans(d.lines)
    text = "unset label\nunset key\n" if not any(line.scattered for line in d.lines) else \
        "unset label\nset key outside right top noenhanced\n"
    text += f"set title '{d.title}' noenhanced\nset xlabel '{d.x_label}'\nset ylabel '{d.y_label}'\n"
    text += f"set xrange [{10 ** left:.6g}:{10 ** right:.6g}]\nset yrange [{10 ** low:.6g}:{10 ** high:.6g}]\n"
    text += labels(d.lines, size, font)
    parts = []
    if d.diagonal:
        parts.append("x with lines lw 1 dt 2 lc rgb '#444444' title 'measured = bound'")
    for i, line in enumerate(d.lines):
        color, width, shape = line.style()
        point = 0.5 if small else 0.9
        how = (f"lines dt 2 lw 1.4 lc rgb '{color}' notitle" if line.dashed else
               f"points pt {shape} ps {point} lc rgb '{color}' title '{line.name}'" if line.scattered else
               f"linespoints lw {width if not small else width * 0.7} pt {shape} ps {point} lc rgb '{color}' notitle")
        parts.append(f"${data}{i} using 1:2 with {how}")
    return text + "plot " + ", \\\n     ".join(parts) + "\n"


def blocks(d, data):
    text = ""
    for i, line in enumerate(d.lines):
        text += f"${data}{i} << end\n" + "".join(f"{x:.6g} {y:.6g}\n" for x, y in line.points) + "end\n"
    return text


def script(name, diagrams, columns=1, size_factor=1):
    """A script that draws the same diagrams as SVG and as PNG, their data inside."""
    text = f"# gnuplot {name}.gp\n" + "".join(blocks(d, f"d{k}_") for k, d in enumerate(diagrams))
    text += ("set logscale xy\nset grid xtics ytics lt 1 lw 1 lc rgb '#dddddd'\nset format xy '%g'\n"
             "set border 3\nset tics nomirror\n")
    rows = (len(diagrams) + columns - 1) // columns
    for kind, ending, (width, height), font in (("svg", "svg", SVG, 13), ("pngcairo", "png", PNG, 12)):
        width, height = int(width * size_factor), int(height * size_factor * (rows / columns if rows > 1 else 1))
        font = font if rows == 1 else font - 4
        more = "dynamic background rgb 'white'" if kind == "svg" else "background rgb 'white'"
        text += f"set terminal {kind} size {width},{height} font 'sans,{font}' {more}\nset output '{name}.{ending}'\n"
        if len(diagrams) > 1:
            text += f"set multiplot layout {rows},{columns}\n"
        for k, d in enumerate(diagrams):
            text += panel(d, f"d{k}_", (width / columns, height / rows), font, rows > 1)
        text += "unset multiplot\n" if len(diagrams) > 1 else ""
        text += "set output\n"
    return text


def draw(folder, name, diagrams, columns=1, size_factor=1):
    """Whether gnuplot drew them; its script stays in any case."""
    diagrams = [d for d in diagrams if d.lines]
    if not diagrams:
        return False
    with open(os.path.join(folder, name + ".gp"), "w", encoding="utf-8") as file:
        file.write(script(name, diagrams, columns, size_factor))
    try:
        subprocess.run(["gnuplot", name + ".gp"], cwd=folder, check=True, capture_output=True, text=True)
    except FileNotFoundError:
        return False
    return True
