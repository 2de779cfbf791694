// SPDX-License-Identifier: MIT
// Tables and lines.
#include "table.h"

#include "geom/real.h"
#include "dice/patch_dicer.h"
#include "raster/parallel/simd_target.h"

#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <map>
#include <string>

namespace stability {
namespace {

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0)
            return line.substr(line.find(':') + 2);
    return "unknown processor";
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    char text[40];
    std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
    return text;
}

std::string number(double value) {
    if (value == std::numeric_limits<double>::infinity())
        return "inf";
    char text[40];
    std::snprintf(text, sizeof text, value != 0 && value < 0.001 ? "%.2g" : "%.4g", value);
    return text;
}

/// Of a markdown table's cell.
std::string cell_of(const verdict& v) {
    if (v.what == outcome::refused)
        return "refused";
    return std::string(name_of(v.what)) + " " + number(v.bound) + " / " + number(v.measured);
}

void write_tallies(std::FILE* to, const suite_result& r,
                   const std::array<tally, arithmetic_count>& tallies) {
    std::fprintf(to, "| arithmetic | cases | within | weaker | no bound | refused | violated | "
                     "points looked at | in 100 digits | pictures judged |\n"
                     "|---|---|---|---|---|---|---|---|---|---|\n");
    for (std::size_t a = 0; a < arithmetic_count; ++a) {
        const tally& t = tallies[a];
        std::fprintf(to, "| %s | %lld |", r.arithmetics[a].c_str(),
                     static_cast<long long>(t.cases()));
        for (const std::int64_t n : t.outcomes)
            std::fprintf(to, " %lld |", static_cast<long long>(n));
        std::fprintf(to, " %lld | %lld | %lld |\n", static_cast<long long>(t.points),
                     static_cast<long long>(t.exactly), static_cast<long long>(t.pictures));
    }
}

void write_costs(std::FILE* to, const suite_result& r) {
    std::fprintf(to,
                 "\n## Cost\n\nA patch is cut into at most %zu pieces with at most %lld vertices. "
                 "A patch that would need more is\ndrawn with a larger bound, which the frame "
                 "reports. The table has the largest figures of all named cases.\nTimes are of "
                 "the whole frame, of one patch, on one thread of a machine that had other work, "
                 "too.\n\n"
                 "| arithmetic | most pieces | most vertices, edges included | case | most ms | "
                 "case |\n"
                 "|---|---|---|---|---|---|\n",
                 l3d_most_pieces, static_cast<long long>(l3d_most_samples));
    for (std::size_t a = 0; a < arithmetic_count; ++a) {
        const tally& t = r.named_tally[a];
        std::fprintf(to, "| %s | %lld | %lld | %s | %.0f | %s |\n", r.arithmetics[a].c_str(),
                     static_cast<long long>(t.most_pieces), static_cast<long long>(t.most_samples),
                     t.most_sampled.c_str(), t.slowest_ms, t.slowest.c_str());
    }
}

void write_tightness(std::FILE* to, const suite_result& r) {
    std::fprintf(to, "\n## How tight\n\nThe table has the five largest ratios of all cases. "
                     "Grids are compared with their own bound, triangles with the frame's.\n\n| "
                     "measured / bound | measured px | bound px | arithmetic | "
                     "case |\n|---|---|---|---|---|\n");
    for (const worst_case& w : r.worst)
        std::fprintf(to, "| %.4f | %s | %s | %s | %s: %s |\n", w.ratio, number(w.measured).c_str(),
                     number(w.bound).c_str(), w.arithmetic.c_str(), w.group.c_str(),
                     w.name.c_str());
    std::fprintf(to,
                 "\nFor %llu ordinary patches, one a frame, we divide the frame's bound by the "
                 "largest measured error. The\nmedian is:",
                 static_cast<unsigned long long>(r.ordinary));
    for (std::size_t a = 0; a < arithmetic_count; ++a)
        std::fprintf(to, " %s %.2f%s", r.arithmetics[a].c_str(), r.median_looseness[a],
                     a + 1 < arithmetic_count ? "," : ".\n");
}

void write_walks(std::FILE* to, const suite_result& r) {
    std::fprintf(
        to, "\n## Forward differences alone\n\nWhole curves with values up to "
            "2000 are walked without a restart. (The library restarts after 32 steps\n"
            "at most.) Each cell has the bound and the measured error. 32 bits are no more "
            "accurate than these bounds\nsay: their error grows with the cube of the steps.\n\n"
            "| curve | steps |");
    for (const std::string& name : r.arithmetics)
        std::fprintf(to, " %s |", name.c_str());
    std::fprintf(to, "\n|---|---|---|---|---|---|\n");
    for (std::size_t i = 0; i + arithmetic_count <= r.walks.size(); i += arithmetic_count) {
        std::fprintf(to, "| %s | %d |", r.walks[i].curve.c_str(), r.walks[i].steps);
        for (std::size_t a = 0; a < arithmetic_count; ++a)
            std::fprintf(to, " %s / %s |", number(r.walks[i + a].bound).c_str(),
                         number(r.walks[i + a].measured).c_str());
        std::fprintf(to, "\n");
    }
}

void write_named(std::FILE* to, const suite_result& r) {
    std::fprintf(to,
                 "\n## Every named case\n\nEach cell has the outcome, the bound and the largest "
                 "measured error, in pixels.\n\n| group | case | tolerance |");
    for (const std::string& name : r.arithmetics)
        std::fprintf(to, " %s |", name.c_str());
    std::fprintf(to, "\n|---|---|---|---|---|---|---|\n");
    for (const named_result& n : r.named) {
        std::fprintf(to, "| %s | %s | %s |", n.group.c_str(), n.name.c_str(),
                     number(n.tolerance).c_str());
        for (const verdict& v : n.verdicts)
            std::fprintf(to, " %s |", cell_of(v).c_str());
        std::fprintf(to, "\n");
    }
    std::fprintf(to, "\n## Why cases are refused\n\n");
    for (const named_result& n : r.named)
        if (n.verdicts[0].what == outcome::refused)
            std::fprintf(to, "- %s, %s: `%s`\n", n.group.c_str(), n.name.c_str(),
                         n.verdicts[0].reason.c_str());
}

} // namespace

void write_table(std::FILE* to, const suite_result& r) {
    std::fprintf(
        to,
        "# Stability\n\nMade by `make stability` on %s, %s, vector instructions %s, "
        "l3d_real = %s, in %.0f s.\n\n"
        "Each case is a patch, a view and a tolerance. It is drawn in four arithmetics: "
        "*float*, *double* and\n*block 32* in vector lanes, and *32.32* fixed point by the "
        "slow twin. *Block 32* has 32-bit integers with an\nexponent for each patch and "
        "coordinate, and 64-bit ones where those are too coarse.\n\n"
        "Drawn points are compared with the exact surface. This is done in 64 bits for all "
        "points that are looked at,\nand in 100 decimal digits for the worst point of each "
        "patch. Pictures are compared with the exact picture.\nFarther from an outline than "
        "the bound, no pixel may be missing and none may be too many. The frame of\n"
        "`l3d_pipeline_afd` itself has to be the same bits.\n\n"
        "*within*: drawn, its bound at most the tolerance. *weaker*: drawn, and the frame "
        "reports a larger bound.\n*no bound*: drawn, and the frame reports that it knows "
        "no bound. *refused*: nothing is drawn, for a stated\nreason. *violated*: anything "
        "else. Weights are distances: a patch seen in perspective is a rational patch.\n\n",
        today().c_str(), processor().c_str(), l3d_simd_target().c_str(), l3d_real_name(),
        r.seconds);
    std::fprintf(to,
                 "**%lld violations** in %lld named and %lld random cases in each "
                 "arithmetic.\n\n## Named cases\n\n",
                 static_cast<long long>(r.violation_count),
                 static_cast<long long>(r.named_tally[0].cases()),
                 static_cast<long long>(r.random_tally[0].cases()));
    write_tallies(to, r, r.named_tally);
    std::fprintf(to,
                 "\n## Random cases\n\nAny shape in any view, tolerances from 0.02 to 2 pixels, "
                 "pictures from 1 x 1 to 8192 pixels wide, worlds of\n1e-9 to 1e9 units.\n\n");
    write_tallies(to, r, r.random_tally);
    for (const std::string& line : r.violations)
        std::fprintf(to, "\n- VIOLATED %s\n", line.c_str());
    write_tightness(to, r);
    write_costs(to, r);
    write_walks(to, r);
    write_named(to, r);
}

void write_cases(std::FILE* to, const suite_result& r) {
    for (const named_result& n : r.named)
        for (std::size_t a = 0; a < arithmetic_count; ++a) {
            const verdict& v = n.verdicts[a];
            std::fprintf(to,
                         "%s, %s, %s: %s px, ratio %.3f, %lld pieces, %lld vertices, %lld pixels "
                         "missing, %lld extra%s, %.1f ms %s\n",
                         n.group.c_str(), n.name.c_str(), r.arithmetics[a].c_str(),
                         cell_of(v).c_str(), v.ratio, static_cast<long long>(v.pieces),
                         static_cast<long long>(v.samples), static_cast<long long>(v.missing),
                         static_cast<long long>(v.extra), v.picture_judged ? "" : " (not judged)",
                         v.milliseconds, v.reason.c_str());
        }
}

void write_lines(std::FILE* to, const suite_result& r) {
    const auto sum = [](const std::array<tally, arithmetic_count>& tallies) {
        std::int64_t cases = 0;
        for (const tally& t : tallies)
            cases += t.cases();
        return static_cast<long long>(cases);
    };
    for (const std::string& line : r.violations)
        std::fprintf(to, "not ok stability: %s\n", line.c_str());
    for (const worst_case& w : r.worst)
        std::fprintf(to, "measured / bound %.4f: %s px of %s px, %s, %s, %s\n", w.ratio,
                     number(w.measured).c_str(), number(w.bound).c_str(), w.arithmetic.c_str(),
                     w.group.c_str(), w.name.c_str());
    for (std::size_t a = 0; a < arithmetic_count; ++a)
        std::fprintf(to, "bound / measured of ordinary patches, median: %s %.2f\n",
                     r.arithmetics[a].c_str(), r.median_looseness[a]);
    if (r.violation_count == 0) {
        std::fprintf(to, "ok stability, named, %lld\n", sum(r.named_tally));
        std::fprintf(to, "ok stability, random, %lld\n", sum(r.random_tally));
        std::fprintf(to, "ok stability, walks, %zu\n", r.walks.size());
    }
    std::fprintf(to, "%lld violations in %.1f s\n", static_cast<long long>(r.violation_count),
                 r.seconds);
}

} // namespace stability
