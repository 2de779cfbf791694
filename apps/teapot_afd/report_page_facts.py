# SPDX-License-Identifier: MIT
"""What the measured rows say: the report's conclusions, each with the rows that it is drawn from."""

import csv
import json
import math
import os
import statistics

TARGETS = (1, 0.5, 0.25, 0.1, 0.05)
# A mesh or a cube is made once, before the first frame.
MADE_BEFORE = ("tessellation", "zbuffer", "zsort", "voxels", "mesa")


def rows_of(path):
    if not os.path.exists(path):
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def number(text):
    return math.inf if text == "none" else math.nan if text == "" else float(text)


class Report:
    """The numbers of a folder."""

    def __init__(self, folder):
        with open(os.path.join(folder, "machine.json"), encoding="utf-8") as file:
            self.machine = json.load(file)
        self.frames = rows_of(os.path.join(folder, "frames.csv"))
        for row in self.frames:
            for key in row:
                if key not in ("model", "view", "method", "setting"):
                    row[key] = number(row[key])
        self.curves, self.limits, self.steps = (
            rows_of(os.path.join(folder, name + ".csv")) for name in ("curves", "limits", "steps"))
        self.peers = rows_of(os.path.join(folder, "peers.csv"))
        self.peers_picture = rows_of(os.path.join(folder, "peers_picture.csv"))
        self.real = self.machine["real"]
        self.own = "afd " + self.real
        self.named = {self.own: "afd", "fd " + self.real: "fd"}

    def scenes(self):
        return [row for row in self.frames if row["model"].startswith("hills of ")]

    def rows(self):
        """All but those of scenes of many sizes, and of the folds, which few methods draw."""
        return [row for row in self.frames if not row["model"].startswith(("hills of ", "folds"))]

    def views(self):
        return list(dict.fromkeys((row["model"], row["view"]) for row in self.rows()))

    def of_view(self, view):
        return [row for row in self.rows() if (row["model"], row["view"]) == view]

    def method(self, row):
        """The method that competes with others; None for other arithmetics than the usual one."""
        name = row["method"]
        if name in self.named:
            return None if name.startswith("fd") and row["setting"][0] == "n" else self.named[name]
        return None if name.startswith(("afd", "fd")) else name

    def methods(self):
        return list(dict.fromkeys(filter(None, map(self.method, self.frames))))

    def cheapest(self, view, error):
        """By method, the row of the least time whose outlines err by no more."""
        best = {}
        for row in self.of_view(view):
            name = self.method(row)
            if name and row["outline_px"] <= error and row["holes"] == 0 and (
                    name not in best or row["median_ms"] < best[name]["median_ms"]):
                best[name] = row
        return dict(sorted(best.items(), key=lambda item: item[1]["median_ms"]))


class Conclusion:
    def __init__(self, key, question, answer, head, rows):
        self.key, self.question, self.answer, self.head, self.rows = key, question, answer, head, rows


def short(value):
    return "-" if math.isnan(value) else "none" if math.isinf(value) else f"{value:.3g}"


def spread(values):
    """The median, and between what half of all are."""
    middle = short(statistics.median(values))
    if len(values) < 4:
        return f"{middle} times"
    low, _, high = statistics.quantiles(values)
    return f"{middle} times (half of all: {short(low)} to {short(high)})"


def listed(counts, what):
    """'`fd` in 12 views, `mesa` in 3'."""
    ordered = sorted(counts.items(), key=lambda item: -item[1])
    return ", ".join(f"`{name}` in {count}" + (f" {what}" if i == 0 else "") for i, (name, count) in enumerate(ordered))


def fastest(report):
    table, wins, ratios, next_ones = [], {}, [], {}
    for view in report.views():
        best = report.cheapest(view, 0.1)
        names = list(best)
        if len(names) < 2:
            continue
        first, second = best[names[0]], best[names[1]]
        wins[names[0]] = wins.get(names[0], 0) + 1
        if names[0] == "afd":
            ratios.append(second["median_ms"] / first["median_ms"])
            next_ones[names[1]] = next_ones.get(names[1], 0) + 1
        table.append([*view, names[0], first["setting"], short(first["median_ms"]), names[1], second["setting"],
                      short(second["median_ms"]), short(second["median_ms"] / first["median_ms"])])
    answer = f"{listed(wins, 'views')}, of {len(table)}." if wins else "No method is."
    if ratios:
        answer += (f" Where `afd` wins, the next one takes {spread(ratios)} as long. "
                   f"It is {listed(next_ones, 'views')}.")
    return Conclusion("fastest", "Which is fastest at 0.1 px?", answer,
                      ["model", "view", "fastest", "setting", "ms", "next", "setting", "ms", "times as long"], table)


def chosen(report):
    """The method for each error."""
    table = []
    for error in TARGETS:
        wins = {}
        for view in report.views():
            best = report.cheapest(view, error)
            if best:
                name = next(iter(best))
                wins[name] = wins.get(name, 0) + 1
        table.append([f"{error:g} px", *(wins.get(name, 0) for name in report.methods())])
    names = report.methods()
    words = []
    for line in table:
        top = max(range(len(names)), key=lambda i: line[i + 1])
        words.append(f"At {line[0]} it is `{names[top]}` ({line[top + 1]} of {sum(line[1:])})")
    return Conclusion("chosen", "Which method when?", "This one is fastest in most views, if outlines may err by so much. "
                      + ". ".join(words) + ".", ["outline within", *names], table)


def loses(report):
    table, by = [], {}
    compared = 0
    for view in report.views():
        for error in TARGETS:
            best = report.cheapest(view, error)
            if "afd" not in best:
                continue
            compared += 1
            for name, row in best.items():
                if row["median_ms"] < best["afd"]["median_ms"]:
                    table.append([*view, f"{error:g} px", name, row["setting"], short(row["median_ms"]),
                                  best["afd"]["setting"], short(best["afd"]["median_ms"]),
                                  short(row["median_ms"] / best["afd"]["median_ms"])])
                    by[name] = by.get(name, 0) + 1
    lost = len({tuple(line[:3]) for line in table})
    answer = f"In {lost} of {compared} pairs of a view and an error, another method is faster" + (
        f": {listed(by, 'of them')}." if by else ".")
    if table:
        made = sum(line[3] in MADE_BEFORE for line in table)
        models = {}
        for model, *_ in {tuple(line[:3]) for line in table}:
            models[model] = models.get(model, 0) + 1
        answer += " By model: " + ", ".join(
            f"{name} {count}" for name, count in sorted(models.items(), key=lambda item: (-item[1], item[0]))) + "."
        worst = min(table, key=lambda line: float(line[-1]))
        answer += (f" {made} of these {len(table)} rows use a mesh that was made before the first frame. The largest "
                   f"loss: `{worst[3]}` on {worst[0]}, {worst[1]}, at {worst[2]} takes {worst[-1]} of the time.")
    return Conclusion("loses", "When does AFD lose?", answer,
                      ["model", "view", "outline within", "method", "setting", "ms", "afd", "ms", "part of afd's time"],
                      table)


def arithmetic_ratios(report, name, usual):
    """By model: times of one arithmetic, as parts of those of the usual one at the same setting."""
    there = {(row["model"], row["view"], row["setting"]): row for row in report.rows() if row["method"] == usual}
    ratios = {}
    for row in report.rows():
        other = there.get((row["model"], row["view"], row["setting"]))
        if row["method"] == name and other:
            ratios.setdefault(row["model"], []).append(row["median_ms"] / other["median_ms"])
    return ratios


def fixed(report):
    table, afd = [], []
    models = list(dict.fromkeys(view[0] for view in report.views()))
    for name in dict.fromkeys(row["method"] for row in report.rows()):
        base = next((b for b in (report.own, "fd " + report.real) if name.split()[0] == b.split()[0]), None)
        if not base or name == base or "places" in name:
            continue
        ratios = arithmetic_ratios(report, name, base)
        values = [value for model in models for value in ratios.get(model, [])]
        if values:
            table.append([name, base, short(statistics.median(values)),
                          *(short(statistics.median(ratios[m])) if m in ratios else "-" for m in models)])
            if name.startswith("afd 32.32"):
                afd = values
    answer = (f"AFD in 32.32 takes {spread(afd)} as long as in {report.real}, at the same tolerance."
              if afd else "Not measured here.")
    return Conclusion("fixed", "Does fixed point cost anything?", answer,
                      ["arithmetic", "compared with", "times as long, median", *models], table)


def bears(report):
    table = [[row["numbers"], row["in_1024_px"], row["in_131072_px"]] for row in report.limits]
    by = {row[0]: row for row in table}
    walked = [row for row in report.rows() if row["method"] == "fd 16.16" and row["setting"][0] == "n"
              and (row["model"], row["view"]) == report.views()[0]]
    answer = ""
    if "16.16" in by:
        answer = (f"They bear {by['16.16'][1]} steps with an error below a pixel, for control points up to 1024 px apart. "
                  f"32 bits with one exponent for all registers bear {by['32-bit block'][1]} steps. With an exponent for "
                  f"each register they bear {by['32-bit graded'][1]}. 32.32 bears {by['32.32'][1]}.")
    if walked:
        best = min(walked, key=lambda row: row["outline_px"])
        answer += f" A whole patch in 16.16 is best with {best['setting'][4:]} steps ({short(best['outline_px'])} px)."
    return Conclusion("bears", "How many steps do 16.16 bits bear?", answer,
                      ["numbers", "steps in 1024 px", "steps in 131072 px"], table)


def certainty(report):
    table, loose, dear, more = [], [], [], []
    plain = {(r["model"], r["view"], r["setting"]): r for r in report.rows() if r["method"] == "afd places only"}
    for view in report.views():
        own = [r for r in report.of_view(view) if r["method"] == report.own]
        factors = [r["bound_px"] / r["outline_px"] for r in own if r["outline_px"] > 0]
        pairs = [(r, plain[(*view, r["setting"])]) for r in own if (*view, r["setting"]) in plain]
        if factors and pairs:
            costs = [r["median_ms"] / other["median_ms"] for r, other in pairs]
            quads = [r["quads"] / other["quads"] for r, other in pairs if other["quads"] > 0]
            loose, dear, more = loose + factors, dear + costs, more + quads
            table.append([*view, *(short(statistics.median(values)) for values in (factors, quads, costs))])
    answer = "Not measured here."
    if loose:
        answer = (f"AFD's bound is {spread(loose)} as large as the largest error found at outlines, so it draws finer than it "
                  f"had to. Bounds of depth and shade on top of those of places take {spread(more)} the quads and "
                  f"{spread(dear)} the time.")
    return Conclusion("certainty", "What does certainty cost?", answer,
                      ["model", "view", "bound / error of outlines", "quads / quads with places only",
                       "time / time with places only"], table)


def kept(report):
    """Whether any error is beyond its bound."""
    table = []
    broken = total = 0
    for name in dict.fromkeys(row["method"] for row in report.frames):
        rows = [r for r in report.frames if r["method"] == name and math.isfinite(r["bound_px"]) and r["bound_px"] > 0]
        if rows:
            worst = max(rows, key=lambda r: r["outline_px"] / r["bound_px"])
            beyond = sum(r["outline_px"] > r["bound_px"] for r in rows)
            broken, total = broken + beyond, total + len(rows)
            table.append([name, len(rows), beyond, short(worst["outline_px"] / worst["bound_px"]), worst["model"],
                          worst["view"], worst["setting"]])
    return Conclusion("kept", "Are bounds kept?", f"In {total - broken} of {total} rows, no outline is farther off than "
                      "the bound says.", ["method", "rows", "beyond", "largest error / bound", "model", "view", "setting"],
                      table)


def slope(points):
    """Of the logarithms, by least squares."""
    xs, ys = [math.log(x) for x, _ in points], [math.log(y) for _, y in points]
    x0, y0 = statistics.mean(xs), statistics.mean(ys)
    return sum((x - x0) * (y - y0) for x, y in zip(xs, ys)) / sum((x - x0) ** 2 for x in xs)


def size_of_scene(report):
    table, afd = [], None
    for name in report.methods():
        rows = sorted((r for r in report.scenes() if report.method(r) == name), key=lambda r: r["patches"])
        if len(rows) < 3:
            continue
        # Few large patches cost what their pixels cost, so only the latter half says how time grows.
        grown = slope([(r["patches"], r["median_ms"]) for r in rows[len(rows) // 2:]])
        table.append([name, rows[0]["setting"], *(short(r["median_ms"]) for r in rows), f"{grown:.2f}"])
        if name == "afd":
            afd = rows, grown
    sizes = sorted({int(r["patches"]) for r in report.scenes()})
    answer = "Not measured here."
    if afd:
        answer = (f"The same hills in {sizes[0]} and in {sizes[-1]} patches take AFD {short(afd[0][0]['median_ms'])} and "
                  f"{short(afd[0][-1]['median_ms'])} ms at {afd[0][0]['setting']}. From {int(afd[0][len(afd[0]) // 2]['patches'])} "
                  f"patches on, time grows with their number to the power {afd[1]:.2f}.")
    return Conclusion("size", "What does a large scene cost?", answer,
                      ["method", "setting", *(f"{n} patches" for n in sizes), "exponent"],
                      [line + ["-"] * (len(sizes) + 3 - len(line)) for line in table])


def pictures(report):
    """The least time for a picture that is no worse."""
    table, ratios, winners = [], [], {}
    for view in report.views():
        for own in (r for r in report.of_view(view) if r["method"] == report.own and r["setting"] in ("0.25 px", "0.1 px")):
            others = [r for r in report.of_view(view) if report.method(r) not in (None, "afd")
                      and r["rms_levels"] <= own["rms_levels"] * 1.02]
            if others:
                best = min(others, key=lambda r: r["median_ms"])
                ratios.append(best["median_ms"] / own["median_ms"])
                winners[best["method"]] = winners.get(best["method"], 0) + 1
                table.append([*view, own["setting"], short(own["rms_levels"]), short(own["median_ms"]), best["method"],
                              best["setting"], short(best["rms_levels"]), short(best["median_ms"]), short(ratios[-1])])
    answer = "Not measured here."
    if ratios:
        answer = (f"For a picture no more wrong than AFD's at 0.25 or 0.1 px, the fastest other method takes "
                  f"{spread(ratios)} as long. It is {listed(winners, 'cases')}.")
    return Conclusion("pictures", "And for whole pictures?", answer,
                      ["model", "view", "afd", "levels", "ms", "other", "setting", "levels", "ms", "times as long"], table)


def peers(report):
    rows = [r for r in report.peers if r["threads"] == "1"]
    if not rows:
        return None
    table, ratios = [], {"llvmpipe": [], "embree": []}
    for row in rows:
        for name, values in ratios.items():
            values.append(float(row[name + "_ms"]) / float(row["l3d_ms"]))
        table.append([row["view"], f"{row['width']} x {row['height']}", row["error_px"], row["llvmpipe_mesh"],
                      short(float(row["l3d_ms"])), *(short(values[-1]) for values in ratios.values())])
    return Conclusion("peers", "And beside other renderers?", "At the same error of places, on one thread, Mesa's llvmpipe takes "
                      f"{spread(ratios['llvmpipe'])} as long as AFD, and Embree {spread(ratios['embree'])}.",
                      ["view", "pixels", "error px", "mesh", "afd ms", "llvmpipe / afd", "Embree / afd"], table)


def conclusions(report):
    found = [fastest(report), fixed(report), loses(report), bears(report), certainty(report), chosen(report), pictures(report),
             kept(report), size_of_scene(report), peers(report)]
    return [c for c in found if c]
