// SPDX-License-Identifier: MIT
// Diagrams: data blocks and scripts for gnuplot.
#include "report_plots.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <spawn.h>
#include <string_view>
#include <sys/wait.h>
#include <unistd.h>

namespace {

/// One line of a diagram.
struct line {
    std::string title;
    std::vector<std::array<double, 2>> points;
    bool is_theory = false; ///< dashed, without points, and in the colour of the line before
};

struct diagram {
    std::string name, title, x_label, y_label;
    std::vector<line> lines;
};

/// Numbers below this are nothing on a logarithmic axis.
constexpr double least_shown = 1e-13;

/// Told apart from each other and from the white behind them; gnuplot has only eight of its own.
constexpr auto colors = std::to_array<std::string_view>(
    {"#000000", "#d62728", "#1f77b4", "#2ca02c", "#ff7f0e", "#9467bd", "#8c564b", "#17becf",
     "#e377c2", "#7f7f7f", "#bcbd22", "#00429d", "#93003a", "#5a7d00"});

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

/// A script that draws the same diagram as SVG and as PNG, its data inside.
std::string script_of(const diagram& d) {
    std::string script = "# gnuplot " + d.name + ".gp\n";
    for (std::size_t i = 0; i < d.lines.size(); ++i) {
        script += "$line" + std::to_string(i) + " << end\n";
        for (const auto& [x, y] : d.lines[i].points)
            if (x > 0 && y > least_shown)
                script += number(x) + ' ' + number(y) + '\n';
        script += "end\n";
    }
    script += "set logscale xy\nset grid xtics ytics lc rgb '#dddddd'\nset format y '%g'\n"
              "set key outside right top noenhanced\nset title '" +
              d.title + "' noenhanced\nset xlabel '" + d.x_label + "'\nset ylabel '" + d.y_label +
              "'\n";
    std::string plot = "plot ";
    std::size_t color = 0;
    for (std::size_t i = 0; i < d.lines.size(); ++i) {
        const line& l = d.lines[i];
        color += i > 0 && !l.is_theory;
        const std::string style = " lc rgb '" + std::string(colors[color % colors.size()]) + "'";
        const std::string width =
            l.title.starts_with("afd") ? "lw 3" : "lw 1.5"; // what it is about
        plot +=
            (i > 0 ? ", \\\n     " : "") + ("$line" + std::to_string(i)) + " using 1:2 " +
            (l.is_theory ? "with lines dt 2 lw 1" + style + " notitle"
                         : "with linespoints " + width + " pt " + std::to_string(4 + color % 10) +
                               style + " title '" + l.title + "'");
    }
    for (const auto& [terminal, ending] :
         {std::pair{"svg size 900,560 dynamic background rgb 'white'", ".svg"},
          std::pair{"png size 1100,680", ".png"}})
        script += std::string("set terminal ") + terminal + "\nset output '" + d.name + ending +
                  "'\n" + plot + '\n';
    return script;
}

bool run_gnuplot(const std::string& folder, const std::string& script) {
    const std::string change = "cd '" + folder + "'";
    const std::string load = "load '" + script + "'";
    std::string program = "gnuplot", option = "-e";
    std::array<char*, 6> arguments{program.data(),
                                   option.data(),
                                   const_cast<char*>(change.c_str()),
                                   option.data(),
                                   const_cast<char*>(load.c_str()),
                                   nullptr};
    pid_t child = 0;
    int status = 0;
    return ::posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ) ==
               0 &&
           ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

diagram work_precision(const report_contents& report, const std::string& view) {
    diagram d{"work_precision_" + view,
              "error against time, view " + view,
              "milliseconds a frame, one thread",
              "error in pixels: outlines, and depth but for a thousandth",
              {}};
    std::map<std::string, std::size_t> place;
    for (const frame_result& row : report.frames) {
        if (row.view != view)
            continue;
        // The same method asked for a tolerance and for numbers of steps is two lines.
        const std::string title =
            row.series + (row.label[0] == 'n' && row.series[0] == 'f' ? ", n steps" : "");
        if (place.emplace(title, d.lines.size()).second)
            d.lines.push_back({title, {}, false});
        d.lines[place[title]].points.push_back({row.least_ms, row.shown_px()});
    }
    for (line& l : d.lines)
        std::sort(l.points.begin(), l.points.end());
    return d;
}

/// With the slope of theory: chords of a fixed number of steps err with its power -2.
diagram error_by_steps(const report_contents& report) {
    diagram d{"error_by_steps",
              "error of n x n quads a patch; dashed: slope -2",
              "n, quads along a patch",
              "error in pixels",
              {}};
    for (const char* series : {"tessellation", "fd 16.16"}) {
        line measured{series, {}, false};
        for (const frame_result& row : report.frames)
            if (row.view == report.frames.front().view && row.series == series &&
                row.label[0] == 'n')
                measured.points.push_back({std::atof(row.label.c_str() + 4), row.shown_px()});
        if (measured.points.empty())
            continue;
        line theory{"", {}, true};
        const auto [n0, e0] = measured.points[measured.points.size() / 2];
        for (const auto& point : measured.points)
            theory.points.push_back({point[0], e0 * n0 * n0 / (point[0] * point[0])});
        d.lines.push_back(measured);
        d.lines.push_back(theory);
    }
    return d;
}

diagram chord_diagram(const curve_results& curves) {
    diagram d{"chord_error",
              "chords of random cubics over 1024 px; dashed: h^2/8 max f",
              "steps",
              "largest error in pixels",
              {}};
    line measured{"measured", {}, false}, theory{"", {}, true};
    for (const chord_row& row : curves.chords) {
        measured.points.push_back({double(row.steps), row.measured});
        theory.points.push_back({double(row.steps), row.theory});
    }
    d.lines = {measured, theory};
    return d;
}

diagram arithmetic_diagram(const curve_results& curves) {
    diagram d{"arithmetic",
              "round-off of a walk, random cubics over 1024 px; dashed: theory",
              "steps without a restart",
              "largest round-off in pixels",
              {}};
    for (const curve_numbers numbers : all_curve_numbers) {
        line measured{name_of(numbers), {}, false}, theory{"", {}, true};
        for (const growth_row& row : curves.growth)
            if (row.numbers == numbers) {
                measured.points.push_back({double(row.steps), row.measured});
                theory.points.push_back({double(row.steps), row.theory});
            }
        d.lines.push_back(measured);
        d.lines.push_back(theory);
    }
    return d;
}

} // namespace

void draw_report_plots(const std::string& folder, const report_contents& report) {
    std::vector<diagram> diagrams;
    for (const frame_result& row : report.frames)
        if (diagrams.empty() || diagrams.back().name != "work_precision_" + row.view)
            diagrams.push_back(work_precision(report, row.view));
    diagrams.push_back(error_by_steps(report));
    diagrams.push_back(chord_diagram(report.curves));
    diagrams.push_back(arithmetic_diagram(report.curves));
    for (const diagram& d : diagrams) {
        write_text(folder + '/' + d.name + ".gp", script_of(d));
        if (!run_gnuplot(folder, d.name + ".gp")) {
            std::fprintf(stderr, "gnuplot cannot be run; the diagrams' scripts are in %s\n",
                         folder.c_str());
            return;
        }
    }
}
