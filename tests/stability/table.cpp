// SPDX-License-Identifier: MIT
// Tables and lines.
#include "table.h"

#include "geom/real.h"
#include "dice/patch_dicer.h"
#include "raster/parallel/simd_target.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

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

/// The text of a markdown table's cell.
std::string cell_of(const verdict& v) {
    if (v.what == outcome::refused)
        return "refused";
    return std::string(name_of(v.what)) + " " + number(v.bound) + " / " + number(v.measured);
}

/// Text without what would end a field of comma-separated values.
std::string field_of(std::string text) {
    std::ranges::replace(text, ',', ';');
    std::ranges::replace(text, '\n', ' ');
    return text;
}

class file {
public:
    explicit file(const std::string& name) : name_(name), to_(std::fopen(name.c_str(), "w")) {
        if (!to_)
            throw std::runtime_error("cannot write " + name_);
    }
    ~file() {
        if (to_)
            std::fclose(to_);
    }
    file(const file&) = delete;
    file& operator=(const file&) = delete;

    template <class... Values> void write(const char* format, Values... values) {
        if constexpr (sizeof...(values) == 0)
            std::fputs(format, to_);
        else
            std::fprintf(to_, format, values...);
    }
    void close() {
        if (std::fclose(std::exchange(to_, nullptr)) != 0)
            throw std::runtime_error("cannot write " + name_);
    }

private:
    std::string name_;
    std::FILE* to_;
};

void write_named(file& to, const suite_result& r) {
    to.write("group,case,tolerance_px,speed,third_difference,weights,aspect,stiffness");
    const auto head = [&](const char* name) {
        to.write(",%s,%s bound_px,%s measured_px,%s ratio", name, name, name, name);
    };
    for (const std::string& name : r.arithmetics)
        head(name.c_str());
    head("polygons");
    to.write(",reason\n");
    for (const named_result& n : r.named) {
        const stiffness& s = n.how_stiff;
        to.write("%s,%s,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g", n.group.c_str(), field_of(n.name).c_str(),
                 n.tolerance, s.speed, s.third, s.weights, s.aspect, s.most());
        const auto cells = [&](const verdict& v) {
            to.write(",%s,%.6g,%.6g,%.6g", name_of(v.what), v.bound, v.measured, v.ratio);
        };
        for (const verdict& v : n.verdicts)
            cells(v);
        cells(n.as_polygons);
        to.write(",%s\n", field_of(n.verdicts[0].reason).c_str());
    }
}

void write_facts(file& to, const suite_result& r) {
    to.write("what,arithmetic,value,case\n");
    for (std::size_t a = 0; a < arithmetic_count; ++a) {
        const char* const name = r.arithmetics[a].c_str();
        const tally& t = r.named_tally[a];
        to.write("bound / measured of ordinary patches; median,%s,%.4g,%llu patches\n", name,
                 r.median_looseness[a], static_cast<unsigned long long>(r.ordinary));
        to.write("most pieces,%s,%lld,of at most %zu\n", name,
                 static_cast<long long>(t.most_pieces), l3d_most_pieces);
        to.write("most vertices,%s,%lld,%s\n", name, static_cast<long long>(t.most_samples),
                 field_of(t.most_sampled).c_str());
        to.write("most ms,%s,%.0f,%s\n", name, t.slowest_ms, field_of(t.slowest).c_str());
        to.write("points looked at,%s,%lld,named cases\n", name, static_cast<long long>(t.points));
        to.write("points in 100 digits,%s,%lld,named cases\n", name,
                 static_cast<long long>(t.exactly));
        to.write("pictures judged,%s,%lld,named cases\n", name, static_cast<long long>(t.pictures));
    }
    for (const std::string& line : r.violations)
        to.write("violation,,,%s\n", field_of(line).c_str());
    to.write("processor,,,%s\nvector instructions,,,%s\ndate,,,%s\nseconds,,%.0f,\n",
             field_of(processor()).c_str(), l3d_simd_target().c_str(), today().c_str(), r.seconds);
}

} // namespace

void write_files(const std::string& folder, const suite_result& r) {
    const std::string base = folder + "/stability_" + l3d_real_name();
    file named(base + ".csv"), facts(base + "_facts.csv"), curves(base + "_curves.csv");
    file walks(base + "_walks.csv");
    write_named(named, r);
    write_facts(facts, r);
    curves.write("group,case,stiffness,chords,bound_px,measured_px\n");
    for (const curve_result& c : r.curves)
        curves.write("%s,%s,%.6g,%lld,%.6g,%.6g\n", c.group.c_str(), field_of(c.name).c_str(),
                     c.stiffness, static_cast<long long>(c.chords), c.bound, c.measured);
    walks.write("arithmetic,curve,steps,bound,measured\n");
    for (const walk_result& w : r.walks)
        walks.write("%s,%s,%d,%.6g,%.6g\n", w.arithmetic.c_str(), field_of(w.curve).c_str(),
                    w.steps, w.bound, w.measured);
    for (file* each : {&named, &facts, &curves, &walks})
        each->close();
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
        std::fprintf(to, "ok stability, curved, %lld\n", sum(r.curved_tally));
        std::fprintf(to, "ok stability, parallel projections, %lld\n", sum(r.parallel_tally));
        std::fprintf(to, "ok stability, polygons, %lld\n",
                     static_cast<long long>(r.polygon_tally.cases()));
        std::fprintf(to, "ok stability, walks, %zu\n", r.walks.size());
        std::fprintf(to, "ok stability, plane curves, %zu\n", r.curves.size());
    }
    std::fprintf(to, "%lld violations in %.1f s\n", static_cast<long long>(r.violation_count),
                 r.seconds);
}

} // namespace stability
