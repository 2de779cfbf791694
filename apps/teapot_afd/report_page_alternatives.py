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
              f"take up to {most('folds', 'blinn')[1]} of all rounds. On the teapot, these shares are "
              f"{most('teapot', 'blinn')[0]} and {most('teapot', 'blinn')[1]}. Whitted's iteration fails for up to "
              f"{most('folds', 'whitted')[0]} on the folds and {most('teapot', 'whitted')[0]} on the teapot. It runs along "
              "curves alone, where a start is rarely wrong. Lane and Carpenter's method does not iterate, but leaves cracks.")
    cracks = [r for r in report.frames if r["model"] == "folds" and r["method"] == "lane-carpenter"]
    if cracks:
        answer += f" On the folds, up to {int(max(r['holes'] for r in cracks))} pixels of a picture are missing in these cracks."
    return Conclusion("scans", "What do failed iterations cost?", answer,
                      ["model", "view", "method", "solved", "rounds a solved one", "failed", "rounds a failed one",
                       "failed rounds of all"], table)


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
    return Conclusion("folds", "How do scan lines draw folded patches?", "At the same tolerance, they take these multiples of AFD's "
                      "time: " + ", ".join(words) + ". Only `blinn` loses whole spans. `scanline` cuts patches at silhouettes first, "
                      "and no iteration of it fails.", ["view", "method", "setting", "ms", "outline px", "levels", "holes", "failures"], table)


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
    answer = ("A step leads to a cell that shares a face. With edges or corners, diagonal steps are allowed, too. "
              f"Rays take {saved('rays', 'corners (26)')} fewer steps with corners than with faces alone, and "
              f"{saved('rays', 'edges (18)')} fewer with edges. Curves that take diagonals first need "
              f"{saved('curves', 'corners (26) diagonals first')} fewer steps with corners. Steps that stay near the line save "
              f"{saved('curves', 'corners (26)')}. Diagonals first have a small price: cells are farther from the chord, as the "
              "last column says.")
    return Conclusion("cells", "What do diagonal steps from cell to cell save?", answer,
                      ["along", "cells share", "steps", "ns", "pixels seen otherwise", "farthest from the chord, cells"], table)


def smoke(tables):
    rows = tables["smoke"]
    if not rows:
        return None
    r = rows[0]
    answer = (f"Drawing a jet of {r['polygons']} polygons takes {short(float(r['polygons_ms']))} ms. Laying a cloud of "
              f"{r['cells_a_side']} cells a side over it takes {short(float(r['cloud_ms']))} ms. A pixel's ray meets "
              f"{short(float(r['cells_a_pixel']))} cells on average, at {short(float(r['ns_a_cell']))} ns each. Neither polygons "
              "nor cells are converted: a ray through the cloud ends at the depth of the polygon in its pixel.")
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
        words.append(f"In the flight `{flight}` it takes {short(ratio)} times as long and dices {100 * diced:.0f} % as many vertices.")
    memory = max(float(by[f, "kept"]["megabytes"]) for f in dict.fromkeys(r["flight"] for r in rows))
    return Conclusion("keeps", "Does it pay to keep micropolygons?", "`kept` is compared with `micropolygons`, which dices "
                      "every frame anew. " + " ".join(words)
                      + f" Its buffers take up to {short(memory)} MB. It makes quads a quarter finer than they must be, "
                      "so that they have room to grow. So it fills more of them.",
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
    text = ("\n## Other ways that were proposed\n\nThis section measures alternatives that papers proposed. The scan line methods "
            "of Whitted, of Blinn, and of Lane and Carpenter follow their papers. `kept` keeps micropolygons for later frames. "
            "Paths find their cells by steps across faces, edges or corners. Smoke is a cube of cells over polygons.\n\n")
    text += "".join(f"- **{c.question}** {c.answer} [rows](#{c.key})\n" for c in found)
    for c in found:
        text += f"\n### <a id=\"{c.key}\"></a>{c.question}\n\n"
        if c.key in PICTURES and os.path.exists(os.path.join(folder, PICTURES[c.key][0])):
            text += f"![{PICTURES[c.key][1]}]({PICTURES[c.key][0]})\n\n"
        text += table(c.head, c.rows)
    return text
