#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""stability_pages.py FOLDER: makes stability.md and its diagram of the files that `make stability` wrote there."""

import csv
import math
import os
import statistics
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../apps/teapot_afd"))
from report_page_plots import STYLES, Diagram, Line, draw  # noqa: E402

ARITHMETICS = ("float", "double", "block 32", "32.32")
BUILDS = ("float", "double", "fixed")
OUTCOMES = ("within", "weaker", "no bound", "refused", "VIOLATED")
# What is infinitely stiff is drawn here, to the right of everything else.
INFINITE = 1e18
STYLES.update({"block 32": STYLES["32-bit block"], "polygons": STYLES["tessellation"], "plane curves": STYLES["scanline"]})


def rows_of(path):
    if not os.path.exists(path):
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


class Run:
    """What one build found."""

    def __init__(self, folder, real):
        self.real = real
        base = os.path.join(folder, "stability_" + real)
        self.named, self.random, self.facts, self.curves, self.walks = (
            rows_of(base + more + ".csv") for more in ("", "_random", "_facts", "_curves", "_walks"))
        self.curved = rows_of(base + "_curved.csv")
        for row in self.named:
            row["stiffness"] = float(row["stiffness"])

    def fact(self, what, arithmetic=""):
        return next((r["value"] or r["case"] for r in self.facts if (r["what"], r["arithmetic"]) == (what, arithmetic)), "-")

    def violations(self):
        return [r["case"] for r in self.facts if r["what"] == "violation"]

    @staticmethod
    def sums(rows):
        sums = {}
        for row in rows:
            into = sums.setdefault(row["arithmetic"], dict.fromkeys(
                ("within", "weaker", "no_bound", "refused", "violated", "points", "in_100_digits", "pictures"), 0))
            for key in into:
                into[key] += int(row[key])
        return sums


def table(head, rows):
    return ("| " + " | ".join(head) + " |\n|" + "---|" * len(head) + "\n"
            + "".join("| " + " | ".join(str(cell) for cell in row) + " |\n" for row in rows))


def short(value):
    return "inf" if math.isinf(value) else f"{value:.3g}"


def ratio_of(row, name):
    """Measured / bound; nothing for what has no bound or was not drawn."""
    drawn = row[name] in ("within", "weaker")
    value = float(row[name + " ratio"])
    return value if drawn and value > 0 else math.nan


def diagram(run):
    """Polygons and arithmetics, as stiff as they are."""
    lines = []
    for name in ("float", "32.32", "polygons"):
        points = [(min(row["stiffness"], INFINITE), ratio_of(row, name)) for row in run.named]
        lines.append(Line(name, [p for p in points if not math.isnan(p[1])], scattered=True))
    lines.append(Line("plane curves", [(min(float(r["stiffness"]), INFINITE), float(r["measured_px"]) / float(r["bound_px"]))
                                       for r in run.curves], scattered=True))
    lines.append(Line("the bound", [(1, 1), (INFINITE, 1)], dashed=True))
    return Diagram("every named case, and plane curves: above the dashed line, a bound would be broken", "stiffness; 1e18 stands for infinity",
                   "measured error / certified bound", lines)


def groups(run):
    """A row for each group, the stiffest first."""
    found = {}
    for row in run.named:
        found.setdefault(row["group"], []).append(row)
    lines = []
    for group, rows in found.items():
        stiff = [r["stiffness"] for r in rows if r["float"] != "refused"] or [1]
        counts = [sum(r["float"] == outcome for r in rows) for outcome in OUTCOMES]
        worst = [ratio_of(r, name) for r in rows for name in ARITHMETICS if not math.isnan(ratio_of(r, name))]
        lines.append((statistics.median(stiff), max(stiff), [group, len(rows), short(statistics.median(stiff)), short(max(stiff)),
                                                           *counts, short(max(worst)) if worst else "-"]))
    lines.sort(key=lambda line: line[:2], reverse=True)
    return table(["group", "cases", "stiffness, median", "largest", *(o.lower() for o in OUTCOMES), "largest measured / bound"],
                 [line[2] for line in lines])


def stiffest(run, count=25):
    """Drawn cases, the stiffest that are not infinitely so first."""
    drawn = [r for r in run.named if r["float"] in ("within", "weaker", "no bound") and math.isfinite(r["stiffness"])]
    drawn.sort(key=lambda r: -r["stiffness"])
    causes = ("speed", "third_difference", "weights", "aspect")
    rows = [[short(r["stiffness"]), max(causes, key=lambda c: float(r[c])).replace("_", " "), r["group"], r["case"],
             *(f"{r[n]} {short(float(r[n + ' bound_px']))} / {short(float(r[n + ' measured_px']))}" for n in (*ARITHMETICS, "polygons"))]
            for r in drawn[:count]]
    return table(["stiffness", "by", "group", "case", *ARITHMETICS, "polygons"], rows)


def conclusions(runs):
    first = runs[0]
    named = sum(len(r.named) for r in runs)
    seeds = {r.real: sum(int(row[k]) for row in r.random if row["arithmetic"] == "float"
                         for k in ("within", "weaker", "no_bound", "refused", "violated")) for r in runs}
    broken = sum(len(r.violations()) for r in runs) + sum(sums["violated"] for r in runs for rows in (r.random, r.curved) for sums in r.sums(rows).values())
    lines = [f"**{broken} violations** in {named} named cases (l3d_real = {', '.join(r.real for r in runs)}), each in four "
             "arithmetics and as polygons. So it is in random cases: "
             + ", ".join(f"{count} with l3d_real = {real}" for real, count in seeds.items() if count) + "."]
    stiff = [r for r in first.named if r["stiffness"] >= 1e3 and r["float"] != "refused"]
    kept = sum(r["float"] == "within" for r in stiff)
    weaker = sum(r["float"] == "weaker" for r in stiff)
    lines.append(f"Stiff means out of proportion 1000 times or more: {len(stiff)} cases. {kept} of them keep their tolerance in float, "
                 f"{weaker} are drawn with a weaker bound that the frame reports, and {len(stiff) - kept - weaker} with none.")
    easy = [ratio_of(r, "float") for r in first.named if r["stiffness"] < 10 and not math.isnan(ratio_of(r, "float"))]
    hard = [ratio_of(r, "float") for r in stiff if not math.isnan(ratio_of(r, "float"))]
    if easy and hard:
        lines.append(f"Stiffness does not break bounds: the median of measured / bound is {short(statistics.median(hard))} for stiff "
                     f"cases and {short(statistics.median(easy))} for those below 10.")
    worst = max(((ratio_of(r, n), n, r) for r in first.named for n in ARITHMETICS if not math.isnan(ratio_of(r, n))),
                key=lambda each: each[0], default=None)
    if worst:
        lines.append(f"The tightest named case uses {100 * worst[0]:.1f} % of its bound: {worst[2]['group']}, {worst[2]['case']} ({worst[1]}).")
    gentle = ", ".join(f"{name} {first.fact('bound / measured of ordinary patches; median', name)}" for name in ARITHMETICS)
    lines.append(f"For ordinary patches the bound is this many times the error, in the median: {gentle}.")
    polygons = [r for r in first.named if r["polygons"] != "refused"]
    lines.append(f"As polygons (8 x 8 quads a patch), {len(polygons)} cases are drawn by `tessellation`, `zbuffer` and `zsort`: "
                 f"{sum(r['polygons'] == 'VIOLATED' for r in polygons)} pictures are off by more than their bound, or differ.")
    if first.curves:
        top = max(first.curves, key=lambda r: float(r["measured_px"]) / float(r["bound_px"]))
        lines.append(f"Among {len(first.curves)} plane curves, the worst chord uses {100 * float(top['measured_px']) / float(top['bound_px']):.0f} % "
                     f"of its 1/1024 px: {top['group']}, {top['case']}.")
    return "".join(f"- {line}\n" for line in lines)


HOW = """## What is judged

Each case is a patch, a view and a tolerance. It is drawn in four arithmetics: *float*, *double* and *block 32* in vector
lanes, and *32.32* fixed point by the slow twin. *Block 32* has 32-bit integers with an exponent for each patch and
coordinate, and 64-bit ones where those are too coarse.

Drawn points are compared with the exact surface. This is done in 64 bits for all points that are looked at, and in 100
decimal digits for the worst points of each patch. Pictures are compared with the exact picture. Farther from an outline
than the bound, no pixel may be missing and none may be too many. The frame of `l3d_pipeline_afd` itself has to be the
same bits. Polygons are judged by their pictures alone; `zsort` and `zbuffer` must cover the same pixels.

*Stiffness* is the largest of four ratios, each 1 for a flat rectangle of equal steps that faces the eye:

- *speed*: largest to least distance of neighbouring control points along a row or a column;
- *third difference*: that of a row or column to its chord, plus 1;
- *weights*: largest to least distance along the view axis. A patch seen in perspective is a rational patch with these weights;
- *aspect*: longest to shortest of the mean lengths along u and along v.

*within*: drawn, its bound at most the tolerance. *weaker*: drawn, and the frame reports a larger bound. *no bound*: drawn,
and the frame reports that it knows no bound. *refused*: nothing is drawn, for a stated reason. *violated*: anything else.
"""


def random_table(runs, kind):
    rows = []
    for run in runs:
        for name, s in run.sums(getattr(run, kind)).items():
            cases = sum(s[k] for k in ("within", "weaker", "no_bound", "refused", "violated"))
            rows.append([run.real, name, cases, s["within"], s["weaker"], s["no_bound"], s["refused"], s["violated"], s["points"],
                         s["in_100_digits"], s["pictures"]])
    return table(["build", "arithmetic", "cases", "within", "weaker", "no bound", "refused", "violated", "points looked at",
                  "in 100 digits", "pictures judged"], rows)


def walks(run):
    rows = {}
    for r in run.walks:
        rows.setdefault((r["curve"], r["steps"]), {})[r["arithmetic"]] = f"{short(float(r['bound']))} / {short(float(r['measured']))}"
    return table(["curve", "steps", *ARITHMETICS], [[*key, *(cells.get(n, "-") for n in ARITHMETICS)] for key, cells in rows.items()])


def page(runs, has_diagram):
    first = runs[0]
    text = f"# Stability\n\n{conclusions(runs)}\n"
    text += "Made by `make stability`, which goes on where it was stopped: " + "; ".join(
        f"l3d_real = {r.real}: {r.fact('date')}, {r.fact('processor')}, {r.fact('vector instructions')}" for r in runs) + ".\n"
    if has_diagram:
        text += "\n![measured error and bound against stiffness](stability.svg)\n"
    text += "\n" + HOW + "\n## Groups, the stiffest first\n\nOutcomes are those in float.\n\n" + groups(first)
    text += ("\n## The stiffest cases\n\nEach cell has the outcome, the bound and the largest measured error, in pixels. Infinitely stiff "
             f"cases are left out here. Every case is in {', '.join(f'[stability_{r.real}.csv](stability_{r.real}.csv)' for r in runs)}, "
             "with the reasons of those that are refused.\n\n") + stiffest(first)
    text += ("\n## Random cases\n\nAny shape in any view, tolerances from 0.02 to 2 pixels, pictures from 1 x 1 to 8192 pixels wide, "
             "worlds of 1e-9 to 1e9 units.\n\n") + random_table(runs, "random")
    if any(run.curved for run in runs):
        text += ("\n### Rational patches, and patches of degrees 4 to 15\n\nWeights from 1e-3 to 1e3, poles and needles. Most cases are parts of "
                 "patches.\n\n") + random_table(runs, "curved")
    text += ("\n## Plane curves\n\nThe chords of paths may be 1/1024 pixel off. Samples of each curve are compared in 100 digits.\n\n"
             + table(["stiffness", "group", "case", "chords", "bound px", "measured px"],
                     [[short(float(r["stiffness"])), r["group"], r["case"], r["chords"], short(float(r["bound_px"])),
                       short(float(r["measured_px"]))] for r in sorted(first.curves, key=lambda r: -float(r["stiffness"]))]))
    text += ("\n## Forward differences alone\n\nWhole curves with values up to 2000 are walked without a restart. (The library restarts "
             "after 32 steps at most.) Each cell has the bound and the measured error.\n\n") + walks(first)
    text += "\n## Cost\n\nThe largest figures of all named cases, one patch a frame, on a machine that had other work, too.\n\n" + table(
        ["arithmetic", "most pieces", "most vertices", "most ms"],
        [[n, first.fact("most pieces", n), first.fact("most vertices", n), first.fact("most ms", n)] for n in ARITHMETICS])
    broken = [f"- {r.real}: {line}\n" for r in runs for line in r.violations()]
    return text + ("\n## Violations\n\n" + "".join(broken) if broken else "")


def main():
    if len(sys.argv) != 2 or not os.path.isdir(sys.argv[1]):
        sys.exit(__doc__)
    folder = sys.argv[1]
    runs = [run for run in (Run(folder, real) for real in BUILDS) if run.named]
    if not runs:
        sys.exit(f"{folder}: no stability_float.csv, stability_double.csv or stability_fixed.csv")
    has_diagram = draw(folder, "stability", [diagram(runs[0])])
    with open(os.path.join(folder, "stability.md"), "w", encoding="utf-8") as file:
        file.write(page(runs, has_diagram))
    print(os.path.join(folder, "stability.md"))


if __name__ == "__main__":
    main()
