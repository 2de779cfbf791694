// SPDX-License-Identifier: MIT
// Tables: Markdown, CSV, JSON.
#include "report_files.h"

#include <l3d/real.h>
#include "raster/parallel/simd_target.h"
#include <l3d/error.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

namespace {

template <class... Values> std::string formatted(const char* format, Values... values) {
    std::array<char, 4000> text{};
    std::snprintf(text.data(), text.size(), format, values...);
    return text.data();
}

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name"))
            return line.substr(line.find(':') + 2);
    return "unknown processor";
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::array<char, 32> text{};
    std::tm utc{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d", ::gmtime_r(&now, &utc));
    return text.data();
}

double load() {
    double average = 0;
    return ::getloadavg(&average, 1) == 1 ? average : -1;
}

std::string bound_text(double bound) {
    return std::isfinite(bound) ? formatted("%.3g", bound) : "none";
}

nlohmann::ordered_json number_or_null(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

std::string head(const report_contents& report) {
    return formatted("# Error against run time\n\n%s%s, %u processors, %s, compiler %s, "
                     "l3d_real = %s; %s; load %.1f when written.\nPictures of %d x %d, one thread "
                     "for every method.\n\n",
                     report.quick ? "A quick report: few settings, short times.\n\n" : "",
                     processor().c_str(), std::thread::hardware_concurrency(),
                     l3d_simd_target().c_str(), __VERSION__, l3d_real_name(), today().c_str(),
                     load(), report.size.width, report.size.height) +
           R"(How to read it:

- Times: *ms* is the least time of a frame, from control points to finished pixels, depth included. The eye is never
  twice at the same place. *median* is the median of all frames but the first. *first* is the very first frame, in
  which `voxels` fills its cube and `mesa` makes its meshes. All are processor times: waiting for the processor does
  not count.
- Errors compare the drawn picture with an exact one, in the same way for all methods. The exact picture shares no
  code with the library (tests/reference).
- *outline* is for pixels in which only one of both pictures shows a surface: the largest distance of such a pixel's
  centre from the exact outline. Only some of these pixels, spread evenly, are measured. Where the gap behind is a sliver, it is up to
  a pixel's size too large.
- *99.9 %*, *largest* and *mean* are for pixels in which both pictures show a surface, away from outlines: the
  distance of the drawn point from the exact tangent plane. It counts along the line of sight too, which is no error
  in the picture. So it may be larger than the bound.
- *judged* is the share of the covered pixels in which that distance is known. These are all but those whose
  neighbours show another surface or none.
- *holes* are pixels left empty inside of the surface; they are counted, not measured.
- *bound* is the error of a point's place in the picture that the method certifies for every point; "none" means that
  it certifies nothing.
- *failures* are pixels that were left out because an iteration did not converge.

)";
}

std::string frame_tables(const report_contents& report) {
    std::string text;
    std::string view;
    for (const frame_result& row : report.frames) {
        if (row.view != view) {
            view = row.view;
            text += "\n## View " + view + "\n\n![error against time](work_precision_" + view +
                    ".svg)\n\n| method | setting | ms | median | first | bound px | outline px "
                    "| 99.9 % | largest | mean | judged | holes | failures | points |\n"
                    "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
        }
        text += formatted(
            "| %s | %s | %.3g | %.3g | %.3g | %s | %.3g | %.3g | %.3g | %.2g | %.1f %% | %lld "
            "| %lld | %lld |\n",
            row.series.c_str(), row.label.c_str(), row.least_ms, row.median_ms, row.first_ms,
            bound_text(row.bound_px).c_str(), row.outline_px, row.percentile_px, row.largest_px,
            row.mean_px, 100 * row.judged, static_cast<long long>(row.holes),
            static_cast<long long>(row.failures), static_cast<long long>(row.samples));
    }
    return text + '\n';
}

std::string pictures(const report_contents& report) {
    std::string text = "## Where the error sits\n\n";
    for (const report_picture& picture : report.pictures)
        text += picture.title + ":\n\n![" + picture.title + "](" + picture.file + ")\n\n";
    return text + R"(## Error against steps

![quads](error_by_steps.svg)

The diagram is for n x n quads a patch. Chords err with n^-2 (dashed). In 16.16 the error of walking,
which grows with n^3, takes over.

)";
}

std::string curves(const curve_results& c) {
    std::string text = formatted(
        "## Arithmetic\n\n![chords](chord_error.svg)\n\n![round-off](arithmetic.svg)\n\n%d random "
        "cubics, control points up to 1024 px apart, walked from end to end by forward "
        "differences.\nDashed: theory (docs/NUMERICS.md, section 5). 32-bit block has one exponent "
        "for all registers, 32-bit graded one for each.\n\n| numbers | steps | measured px | "
        "theory "
        "px | ratio |\n|---|---|---|---|---|\n",
        c.curves);
    for (const growth_row& row : c.growth)
        text += formatted("| %s | %d | %.3g | %.3g | %.2f |\n", name_of(row.numbers), row.steps,
                          row.measured, row.theory, row.measured / row.theory);
    text += R"(
## What the literature says, and what comes out here

**How many steps 32 bits bear.** Chang, Rocchetti and Shantz (*Rendering cubic curves and surfaces with integer
adaptive forward differencing*, SIGGRAPH 1989) state more than 4096 steps with less than a pixel of accumulated error.
Rappoport (*Rendering curves and surfaces with hybrid subdivision and forward differencing*, TOG 10, 1991) states up
to 2^13 steps for cubics in a space of 128K x 128K. The table has our numbers: the largest power of two with which no
random cubic is a pixel off.

| numbers | steps in 1024 px | steps in 131072 px |
|---|---|---|
)";
    for (const step_limit& row : c.limits)
        text += formatted("| %s | %d | %d |\n", name_of(row.numbers), row.in_1024, row.in_128k);
    int tried = 0;
    for (const step_limit& row : c.limits)
        tried = std::max(tried, row.in_1024);
    text += formatted(R"(
*32-bit graded* is our form of what both papers describe: each register keeps the fraction bits that its own size
leaves, and sums are rounded. One exponent for all four registers, as in 16.16, bears some hundred steps, since its
error grows with n^3 / 6.

Our figures and theirs differ in what they mean. We know the papers' figures from their abstracts, which do not say
how registers are aligned. They are meant for all curves; our curves are random, not the worst. Our registers are
sized for the range and the number of steps. We tried no more than %d steps, so that figure is a lower limit.

**Steps a pixel.** Klassen (*Exact integer hybrid subdivision and forward differencing of cubics*, TOG 13, 1994)
proves a limit for a cubic whose picture fits into w pixels. It needs at most 9 w steps with no two points more than a
pixel apart. He also states that a few halvings beforehand leave very few extra points. The table has our steps, which
come from the control points' differences, in both coordinates:

| halvings | steps / w, mean | steps / w, largest | steps / w, Chebyshev's cubic | the same, by its derivative | steps / pixels passed, mean |
|---|---|---|---|---|---|
)",
                      tried);
    for (const step_row& row : c.steps)
        text += formatted("| %d | %.2f | %.2f | %.2f | %.2f | %.2f |\n", row.halvings,
                          row.per_pixel, row.most, row.chebyshev, row.true_speed, row.extra);
    return text + R"(
The bound 9 is Markov's inequality for cubics. Chebyshev's cubic, which is the fastest, reaches it by its largest
derivative. We use the control points, which say 15 of it; one halving makes up for that. Random curves need far less,
and with each halving the excess shrinks, as he says. After five halvings, a twelfth of the steps is extra.

The step is still set by the fastest point of each piece, and it is a step in two coordinates. Therefore a surface
walked pixel by pixel (`isocurves` above) takes 20 and more points for each pixel that it covers. Lien, Shantz and
Pratt (SIGGRAPH 1987) aim at about one point a pixel *along a curve*. Curves half a pixel apart multiply with points
half a pixel apart.
)";
}

std::string frames_csv(const report_contents& report) {
    std::string text =
        "view,method,setting,least_ms,median_ms,first_ms,frames,outline_px,largest_px,"
        "percentile_999_px,mean_px,judged_share,bound_px,holes,failures,points,quads\n";
    for (const frame_result& r : report.frames)
        text += formatted(
            "%s,%s,%s,%.6g,%.6g,%.6g,%d,%.6g,%.6g,%.6g,%.6g,%.6g,%s,%lld,%lld,%lld,%lld\n",
            r.view.c_str(), r.series.c_str(), r.label.c_str(), r.least_ms, r.median_ms, r.first_ms,
            r.frames, r.outline_px, r.largest_px, r.percentile_px, r.mean_px, r.judged,
            bound_text(r.bound_px).c_str(), static_cast<long long>(r.holes),
            static_cast<long long>(r.failures), static_cast<long long>(r.samples),
            static_cast<long long>(r.quads));
    return text;
}

std::string curves_csv(const curve_results& curves) {
    std::string text = "numbers,steps,measured_px,theory_px\n";
    for (const growth_row& row : curves.growth)
        text += formatted("%s,%d,%.6g,%.6g\n", name_of(row.numbers), row.steps, row.measured,
                          row.theory);
    for (const chord_row& row : curves.chords)
        text += formatted("chord,%d,%.6g,%.6g\n", row.steps, row.measured, row.theory);
    return text;
}

std::string json(const report_contents& report) {
    nlohmann::ordered_json result{{"processor", processor()},
                                  {"date", today()},
                                  {"real", l3d_real_name()},
                                  {"simd", l3d_simd_target()},
                                  {"width", report.size.width},
                                  {"height", report.size.height},
                                  {"quick", report.quick},
                                  {"frames", nlohmann::ordered_json::array()},
                                  {"arithmetic", nlohmann::ordered_json::array()}};
    for (const frame_result& r : report.frames)
        result["frames"].push_back({{"view", r.view},
                                    {"method", r.series},
                                    {"setting", r.label},
                                    {"least_ms", r.least_ms},
                                    {"median_ms", r.median_ms},
                                    {"first_ms", r.first_ms},
                                    {"outline_px", r.outline_px},
                                    {"largest_px", r.largest_px},
                                    {"percentile_999_px", r.percentile_px},
                                    {"mean_px", r.mean_px},
                                    {"judged_share", r.judged},
                                    {"bound_px", number_or_null(r.bound_px)},
                                    {"holes", r.holes},
                                    {"failures", r.failures},
                                    {"points", r.samples},
                                    {"quads", r.quads}});
    for (const growth_row& r : report.curves.growth)
        result["arithmetic"].push_back({{"numbers", name_of(r.numbers)},
                                        {"steps", r.steps},
                                        {"measured_px", r.measured},
                                        {"theory_px", r.theory}});
    return result.dump(1) + '\n';
}

} // namespace

void write_text(const std::string& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out << text;
    if (!out.flush())
        throw l3d_error(l3d_exit::failure, "cannot write " + file);
}

void write_report_files(const std::string& folder, const report_contents& report) {
    write_text(folder + "/report.md",
               head(report) + frame_tables(report) + pictures(report) + curves(report.curves));
    write_text(folder + "/frames.csv", frames_csv(report));
    write_text(folder + "/curves.csv", curves_csv(report.curves));
    write_text(folder + "/report.json", json(report));
}
