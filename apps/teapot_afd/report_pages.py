#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""report_pages.py FOLDER: makes pages and diagrams of the numbers that --error-report wrote there.

report.md has the conclusions, one diagram for each question and the rows behind them. report.html
needs no network: it has all rows, which sort, and diagrams that tell values under the pointer.
Every number in either comes from the folder's files.
"""

import json
import math
import os
import sys

import report_page_alternatives
from report_page_facts import Report, conclusions
from report_page_plots import STYLES, Diagram, Line, draw

CHARTS = "/usr/share/javascript/chart.js/chart.min.js"
HERE = os.path.dirname(os.path.abspath(__file__))


def joined(report, view, x, y, named=True, dashed_bound=False):
    """A line for each method, its settings in order."""
    lines = []
    for name in report.methods():
        rows = [r for r in report.of_view(view) if report.method(r) == name]
        lines.append(Line(name, [(r[x], r[y]) for r in rows]))
        if dashed_bound and any(math.isfinite(r["bound_px"]) for r in rows):
            lines.append(Line(name, [(r[x], r["bound_px"]) for r in rows if math.isfinite(r["bound_px"])], True))
    return lines


def error_time(report, view, small=False):
    title = ", ".join(view) if small else f"{', '.join(view)}: solid, the error measured; dashed, the bound certified"
    return Diagram(title, "milliseconds a frame" + ("" if small else ", one thread"),
                   "pixels" if small else "largest error of outlines, pixels",
                   joined(report, view, "median_ms", "outline_px", dashed_bound=not small))


def picture_time(report, view):
    lines = joined(report, view, "median_ms", "rms_levels")
    size = str(report.machine["width"]), str(report.machine["height"])
    for name in ("llvmpipe", "embree"):
        rows = [r for r in report.peers_picture if r["threads"] == "1" and r["view"] == view[1]
                and r["equal_over"] == "all" and (r["width"], r["height"]) == size]
        if view[0] == "teapot" and rows:
            label = name if name == "llvmpipe" else "Embree"
            lines.append(Line(label, [(float(r[name + "_ms"]), float(r[name + "_all"])) for r in rows]))
    return Diagram(f"{', '.join(view)}: how wrong a picture is", "milliseconds a frame, one thread",
                   "root of the mean square error, grey levels of 255", lines)


def bound_diagram(report):
    lines = []
    for name in ("afd", "fd", "subdivision", "tessellation", "micropolygons"):
        rows = [r for r in report.rows() if report.method(r) == name and math.isfinite(r["bound_px"])]
        lines.append(Line(name, [(r["bound_px"], r["outline_px"]) for r in rows], scattered=True))
    return Diagram("all views: the error measured, and the bound that was certified", "certified bound, pixels",
                   "largest error of outlines, pixels", lines, diagonal=True)


def arithmetic_diagram(report):
    lines = []
    for name in dict.fromkeys(r["numbers"] for r in report.curves if r["numbers"] != "chord"):
        rows = [r for r in report.curves if r["numbers"] == name]
        lines.append(Line(name, [(int(r["steps"]), float(r["measured_px"])) for r in rows]))
        lines.append(Line(name, [(int(r["steps"]), float(r["theory_px"])) for r in rows], True))
    return Diagram("round-off of cubics over 1024 pixels: solid, measured; dashed, theory", "steps without a restart",
                   "largest round-off, pixels", lines)


def chord_diagram(report):
    rows = [r for r in report.curves if r["numbers"] == "chord"]
    return Diagram("chords of cubics over 1024 pixels: solid, measured; dashed, by the second derivative", "steps",
                   "largest error, pixels",
                   [Line("chord", [(int(r["steps"]), float(r["measured_px"])) for r in rows]),
                    Line("chord", [(int(r["steps"]), float(r["theory_px"])) for r in rows], True)])


def steps_diagram(report):
    """Chords of a fixed number of steps err with its power -2; walks in 16.16 with its power 3."""
    lines = []
    for name, method in (("tessellation", "tessellation"), ("16.16", "fd 16.16")):
        rows = [r for r in report.of_view(report.views()[0]) if r["method"] == method and r["setting"][0] == "n"]
        points = [(float(r["setting"][4:]), r["outline_px"]) for r in rows]
        lines.append(Line(name, points))
        if points:
            n, error = points[len(points) // 2]
            lines.append(Line(name, [(x, error * n * n / (x * x)) for x, _ in points], True))
    return Diagram("n x n quads a patch: exact corners, and corners walked in 16.16; dashed, slope -2", "n, quads along a patch",
                   "largest error of outlines, pixels", lines)


def scene_diagram(report):
    lines = []
    for name in report.methods():
        rows = sorted((r for r in report.scenes() if report.method(r) == name), key=lambda r: r["patches"])
        lines.append(Line(name, [(r["patches"], r["median_ms"]) for r in rows]))
    return Diagram("the same hills, cut into more and more patches", "patches", "milliseconds a frame, one thread", lines)


def diagrams(report, folder):
    """The names of those that gnuplot drew."""
    views = report.views()
    wanted = {"error_time": ([error_time(report, views[0])],), "picture_time": ([picture_time(report, views[0])],),
              "arithmetic": ([arithmetic_diagram(report)],), "scene_size": ([scene_diagram(report)],),
              "error_and_bound": ([bound_diagram(report)],), "error_by_steps": ([steps_diagram(report)],),
              "chord_error": ([chord_diagram(report)],),
              "error_time_all": ([error_time(report, view, True) for view in views], 3, 1.4)}
    drawn = {name for name, what in wanted.items() if draw(folder, name, *what)}
    if not drawn:
        print("gnuplot cannot be run; the diagrams' scripts are in " + folder, file=sys.stderr)
    return drawn


def heading(machine):
    quick = "A quick report: small pictures, few settings, short times.\n\n" if machine["quick"] else ""
    return (f"{quick}{machine['processor']}, {machine['processors']} processors, {machine['simd']}, compiler "
            f"{machine['compiler']}, l3d_real = {machine['real']}, {machine['date']}. Pictures of {machine['width']} x "
            f"{machine['height']} pixels, one thread.")


READING = """## How to read it

- A *time* is the median of a method's frames but the first, from control points to finished pixels, in processor time.
  The eye is never twice at the same place. A mesh, or the cells of `voxels`, are made before the first frame. `kept` finds
  the micropolygons of the frame before in its buffers.
- An *error* is that of outlines. It is the largest distance of a falsely covered or uncovered pixel's centre from the
  exact outline. Some 60 of these pixels are measured, spread evenly. The exact picture shares no code with the library.
  Where there is no such pixel the error is 0, which has no place in a diagram of powers.
- A *bound* is what a method certifies: no point is drawn farther from its place in the picture.
- A *level* is one of 255 steps of grey. A picture's error is the root of the mean square over all covered pixels.
- *99.9 %*, *largest* and *mean*, in the tables of all rows, compare surfaces away from outlines. They also count along the
  line of sight, where the bound above says nothing. So they may be larger than it.
"""

SECTIONS = (
    ("error_time", "Error against time", "Each line joins a method's settings, from coarse to fine. Lower and farther left is "
     "better. A dashed line is the bound that the method certifies; methods without one have no dashed line."),
    ("picture_time", "Picture error against time", "Here each pixel counts: its place, and its shade. Those of llvmpipe and "
     "Embree were measured by `tests/bench/peers_picture_bench`, on another day."),
    ("error_and_bound", "Error and bound", "Each point is a setting of a method in a view. None may lie above the dashed line."),
    ("arithmetic", "Arithmetic against steps", "Forward differences add up their rounding. One exponent for all registers errs "
     "with the cube of the steps; one for each register errs in proportion to them (docs/NUMERICS.md, section 5)."),
    ("error_by_steps", "Quads and 16.16", "More quads make chords better. In 16.16 the error of walking takes over from some "
     "number of steps on."),
    ("chord_error", "Chords", "The theory's bound is nearly reached, so it wastes little."),
    ("scene_size", "Cost against size of scene", "The same surface in the same view is cut into more patches. At 0.25 px, or "
     "with the number that the table names."),
    ("error_time_all", "All models and views", "The same diagram as the first, for five models in three views each. The band is "
     "thin and twisted. The lampshade has creases. The knot has 384 patches, and the hills have 2304, near and far."),
)


def table(head, rows):
    return ("| " + " | ".join(head) + " |\n|" + "---|" * len(head) + "\n"
            + "".join("| " + " | ".join(str(cell) for cell in row) + " |\n" for row in rows))


def markdown(report, found, drawn, others):
    text = "# Error against run time\n\n"
    text += "".join(f"- **{c.question}** {c.answer} [rows](#{c.key})\n" for c in found)
    text += ("\nAll rows, with values under the pointer and tables that sort, are in [report.html](report.html), which works "
             "without network. The numbers are in [frames.csv](frames.csv), [curves.csv](curves.csv), "
             "[limits.csv](limits.csv), [steps.csv](steps.csv), [scan_lines.csv](scan_lines.csv), "
             "[cells.csv](cells.csv), [smoke.csv](smoke.csv) and [kept.csv](kept.csv).\n\n" + heading(report.machine) + "\n\n" + READING)
    for name, title, words in SECTIONS:
        if name in drawn:
            text += f"\n## {title}\n\n{words}\n\n![{title}]({name}.svg)\n"
    text += "\n## Where the error sits\n\n"
    for name, words in (("error_afd.png", "AFD at 0.25 px"), ("error_tessellation.png", "A mesh of 16 x 16 quads a patch")):
        text += f"{words}:\n\n![{words}]({name})\n\n"
    text += "## The rows behind the conclusions\n"
    for c in found:
        text += f"\n### <a id=\"{c.key}\"></a>{c.question}\n\n" + table(c.head, c.rows)
    return text + others + literature(report)


def literature(report):
    rows = [[r["halvings"], *(f"{float(r[key]):.2f}" for key in ("mean", "largest", "chebyshev", "by_derivative", "per_pixel"))]
            for r in report.steps]
    with open(os.path.join(HERE, "report_page_literature.md"), encoding="utf-8") as file:
        return "\n" + file.read() + "\n" + table(
            ["halvings", "steps / w, mean", "steps / w, largest", "steps / w, Chebyshev's cubic", "the same, by its derivative",
             "steps / pixels passed, mean"], rows)


def html(report, found):
    with open(os.path.join(HERE, "report_page.html"), encoding="utf-8") as file:
        page = file.read()
    charts = ""
    if os.path.exists(CHARTS):
        with open(CHARTS, encoding="utf-8") as file:
            charts = file.read().replace("</script", "<\\/script")
    else:
        print(f"report.html has tables only: {CHARTS} is missing (Debian's libjs-chart.js)", file=sys.stderr)
    columns = list(report.frames[0])
    plain = [[None if isinstance(v, float) and math.isnan(v) else "none" if v == math.inf else
              int(v) if isinstance(v, float) and v.is_integer() else v for v in row.values()] for row in report.frames]
    data = {"heading": heading(report.machine), "columns": columns, "rows": plain, "named": report.named,
            "styles": {name: style[0] for name, style in STYLES.items()},
            "curves": [[r["numbers"], int(r["steps"]), float(r["measured_px"]), float(r["theory_px"])] for r in report.curves],
            "conclusions": [{"key": c.key, "question": c.question, "answer": c.answer, "head": c.head, "rows": c.rows}
                            for c in found]}
    return page.replace("/*DATA*/null", json.dumps(data).replace("</", "<\\/")).replace("/*CHARTS*/", charts)


def write(folder, name, text):
    with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
        file.write(text)


def main():
    if len(sys.argv) != 2 or not os.path.isdir(sys.argv[1]):
        sys.exit(__doc__.splitlines()[0])
    folder = sys.argv[1]
    report = Report(folder)
    if not report.frames:
        sys.exit(f"report_pages.py: {folder}/frames.csv has no rows")
    found = conclusions(report)
    others = report_page_alternatives.alternatives(report, folder)
    write(folder, "report.md", markdown(report, found, diagrams(report, folder),
                                        report_page_alternatives.markdown(others, folder, table)))
    write(folder, "report.html", html(report, found + others))
    print(os.path.join(folder, "report.md"))


if __name__ == "__main__":
    main()
