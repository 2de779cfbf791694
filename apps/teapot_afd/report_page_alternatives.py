# SPDX-License-Identifier: MIT
"""What the report says of scan lines, paths of cells, smoke, and micropolygons that are kept."""

import os

from report_page_facts import Conclusion, rows_of, short

KINDS = ("scan_lines", "cells", "smoke", "kept")


def numbers(row, *names):
    return [float(row[name]) for name in names]


def scan_lines(tables, report):
    """Failures, and what part of all rounds they take."""
    table, shares = [], {}
    for row in tables["scan_lines"]:
        solved, solved_rounds, failed, failed_rounds = numbers(row, "solved", "solved_rounds", "failed", "failed_rounds")
        share = failed_rounds / max(solved_rounds + failed_rounds, 1)
        shares.setdefault((row["model"], row["method"]), []).append((failed / max(solved + failed, 1), share))
        table.append([row["model"], row["view"], row["method"], int(solved), short(solved_rounds / max(solved, 1)), int(failed),
                      short(failed_rounds / failed) if failed else "-", f"{100 * share:.2g} %"])
    if not table:
        return None

    def most(model, method):
        values = shares.get((model, method), [(0, 0)])
        return tuple(f"{100 * max(value[i] for value in values):.2g} %" for i in (0, 1))
    answer = (f"Blinn's iteration fails for up to {most('folds', 'blinn')[0]} of what it solves on folded patches, and failures "
              f"take up to {most('folds', 'blinn')[1]} of all rounds. On the teapot these are "
              f"{most('teapot', 'blinn')[0]} and {most('teapot', 'blinn')[1]}. Whitted's fails for up to "
              f"{most('folds', 'whitted')[0]} and {most('teapot', 'whitted')[0]}: it iterates along curves alone, where a "
              "start is rarely wrong. Lane and Carpenter iterate nothing; theirs leaves cracks.")
    cracks = [r for r in report.frames if r["model"] == "folds" and r["method"] == "lane-carpenter"]
    if cracks:
        answer += f" On the folds up to {int(max(r['holes'] for r in cracks))} pixels are left out in these."
    return Conclusion("scans", "What do iterations cost that fail?", answer,
                      ["model", "view", "method", "solved", "rounds each", "failed", "rounds each", "part of all rounds"], table)


def folds(report):
    rows = [r for r in report.frames if r["model"] == "folds"]
    if not rows:
        return None
    table = [[r["view"], r["method"], r["setting"], short(r["median_ms"]), short(r["outline_px"]), short(r["rms_levels"]),
              int(r["holes"]), int(r["failures"])] for r in rows]
    own = {(r["view"], r["setting"]): r["median_ms"] for r in rows if r["method"] == report.own}
    words = []
    for name in ("scanline", "whitted", "blinn", "lane-carpenter"):
        times = sorted(r["median_ms"] / own[r["view"], r["setting"]] for r in rows
                       if r["method"] == name and (r["view"], r["setting"]) in own)
        if times:
            words.append(f"`{name}` {short(times[0])} to {short(times[-1])}")
    return Conclusion("folds", "How do scan lines draw folded patches?", "At the same tolerance, times as long as AFD: "
                      + ", ".join(words) + ". Only `blinn` loses whole spans; `scanline` cuts patches at silhouettes first, "
                      "and has no failure.", ["view", "method", "setting", "ms", "outline px", "levels", "holes", "failures"], table)


def cells(tables):
    rows = tables["cells"]
    if not rows:
        return None
    table = [[r["along"], r["touch"], short(float(r["steps"])), short(float(r["ns"])),
              f"{100 * float(r['other_share']):.2g} %" if r["along"] == "rays" else "-",
              short(float(r["farthest_cells"])) if r["along"] == "curves" else "-"] for r in rows]
    steps = {(r["along"], r["touch"]): float(r["steps"]) for r in rows}

    def saved(along, touch):
        return f"{100 * (1 - steps[along, touch] / steps[along, 'faces (6)']):.0f} %"
    answer = (f"Rays across corners take {saved('rays', 'corners (26)')} fewer steps than rays across faces, those across edges "
              f"{saved('rays', 'edges (18)')}. Along curves, diagonals first save {saved('curves', 'corners (26) diagonals first')}. "
              "That is as much as steps near the line save. A knight's move takes 2 steps in place of 3. The price is small: "
              "cells are farther from the chord, as the last column says.")
    return Conclusion("cells", "What do diagonal steps from cell to cell save?", answer,
                      ["along", "cells share", "steps", "ns", "pixels seen otherwise", "farthest from the chord, cells"], table)


def smoke(tables):
    rows = tables["smoke"]
    if not rows:
        return None
    r = rows[0]
    answer = (f"A jet of {r['polygons']} polygons is drawn in {short(float(r['polygons_ms']))} ms. A cloud of "
              f"{r['cells_a_side']} cells a side is laid over it in {short(float(r['cloud_ms']))} ms. A pixel's ray meets "
              f"{short(float(r['cells_a_pixel']))} cells in the mean, {short(float(r['ns_a_cell']))} ns each. Nothing is "
              "converted: a ray through the cloud ends at the depth of the polygon in its pixel.")
    return Conclusion("smoke", "What does smoke cost?", answer, list(r), [[short(float(value)) for value in r.values()]])


def kept(tables):
    rows = tables["kept"]
    if not rows:
        return None
    table = [[r["flight"], r["method"], *(short(float(r[name])) for name in ("median_ms", "mean_ms", "worst_ms")),
              int(float(r["diced"])), int(float(r["quads"])), short(float(r["megabytes"]))] for r in rows]
    by = {(r["flight"], r["method"]): r for r in rows}
    words = []
    for flight in dict.fromkeys(r["flight"] for r in rows):
        one, other = by[flight, "kept"], by[flight, "micropolygons"]
        ratio = float(one["mean_ms"]) / float(other["mean_ms"])
        diced = float(one["diced"]) / max(float(other["diced"]), 1)
        words.append(f"In the flight `{flight}` it takes {short(ratio)} times the time of dicing in each frame, and dices {100 * diced:.0f} % of the vertices.")
    memory = max(float(by[f, "kept"]["megabytes"]) for f in dict.fromkeys(r["flight"] for r in rows))
    return Conclusion("keeps", "Does it pay to keep micropolygons?", " ".join(words)
                      + f" Buffers take up to {short(memory)} MB. Quads are a quarter finer than they must be, so that they "
                      "may grow, and each must be filled.",
                      ["flight", "method", "median ms", "mean ms", "worst ms", "vertices diced", "quads", "MB"], table)


def alternatives(report, folder):
    tables = {kind: rows_of(os.path.join(folder, kind + ".csv")) for kind in KINDS}
    found = [scan_lines(tables, report), folds(report), cells(tables), smoke(tables), kept(tables)]
    return [c for c in found if c]


PICTURES = {"folds": ("scan_folds.png", "Folded patches by three scan line methods and by AFD. Magenta pixels are off by more "
                      "than 32 levels."),
            "smoke": ("smoke.png", "A jet of polygons in a cloud of cells")}


def markdown(found, folder, table):
    """A section: answers, then rows and pictures."""
    if not found:
        return ""
    text = ("\n## Other ways that were proposed\n\nScan lines by Whitted, by Blinn, and by Lane and Carpenter are methods of "
            "their own here, true to their papers. So are micropolygons that are kept. Cells are found along paths whose steps "
            "cross faces, edges or corners.\n\n")
    text += "".join(f"- **{c.question}** {c.answer} [rows](#{c.key})\n" for c in found)
    for c in found:
        text += f"\n### <a id=\"{c.key}\"></a>{c.question}\n\n"
        if c.key in PICTURES and os.path.exists(os.path.join(folder, PICTURES[c.key][0])):
            text += f"![{PICTURES[c.key][1]}]({PICTURES[c.key][0]})\n\n"
        text += table(c.head, c.rows)
    return text
