// SPDX-License-Identifier: MIT
// l3d_method_choice: reads names of methods, and makes the methods.
#include "compare/method_choice.h"

#include "base/did_you_mean_p.h"
#include "geom/real.h"
#include "compare/plotters/blinn_plotter.h"
#include "compare/dicers/fd_dicer.h"
#include "compare/plotters/isocurve_plotter.h"
#include "compare/dicers/lane_carpenter_dicer.h"
#include "pipeline/method_afd.h"
#include "compare/method_kept.h"
#include "compare/method_mesa.h"
#include "compare/method_mesh.h"
#include "compare/method_points.h"
#include "compare/method_tessellation.h"
#include "compare/method_voxels.h"
#include "pipeline/polygons/polygon_model.h"
#include "compare/dicers/micropolygon_dicer.h"
#include "compare/plotters/scanline_plotter.h"
#include "compare/dicers/subdivision_dicer.h"
#include "compare/plotters/whitted_plotter.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <vector>

namespace {

/// A row of the table. Methods without a resolution have most = 0.
struct method_row {
    const char* name;
    l3d_method method;
    bool has_bound, keeps_tolerance, draws_parallel;
    int usual = 0, least = 0, most = 0;
};

/// The most points or quads along a pixel. With 16, a pixel has some thousand of them.
constexpr int most_a_pixel = 16;

/// The methods, and the limits of their resolutions. 1024 x 1024 quads of fd are 2^20 for each
/// patch. With 1024 cells along each axis, a teapot fills 4 million in 600 MB of bricks.
constexpr std::array<method_row, 13> rows{{
    {"afd", l3d_method::afd, true, true, true},
    {"fd", l3d_method::fd, true, true, false, 0, 1, 1024},
    {"isocurves", l3d_method::isocurves, false, false, false, 2, 1, most_a_pixel},
    {"subdivision", l3d_method::subdivision, true, true, true},
    {"tessellation", l3d_method::tessellation, true, false, false, 16, 1, l3d_most_facets},
    {"micropolygons", l3d_method::micropolygons, true, false, true, 2, 1, most_a_pixel},
    {"kept", l3d_method::kept, false, false, false, 2, 1, most_a_pixel},
    {"scanline", l3d_method::scanline, false, true, true},
    {"whitted", l3d_method::whitted, false, true, true},
    {"blinn", l3d_method::blinn, false, true, true},
    {"lane-carpenter", l3d_method::lane_carpenter, false, true, true},
    {"voxels", l3d_method::voxels, false, false, false, 256, 8, 1024},
    {"mesa", l3d_method::mesa, false, true, false},
}};

const method_row& row_of(l3d_method method) {
    return *std::find_if(rows.begin(), rows.end(),
                         [&](const method_row& row) { return row.method == method; });
}

template <class Chosen> std::string names_of(const Chosen& chosen) {
    std::string names;
    for (const method_row& row : rows)
        if (chosen(row))
            names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

std::unique_ptr<l3d_surface_method> create_afd(l3d_arithmetic arithmetic,
                                               const l3d_rasterizer_factory& rasterizers,
                                               l3d_workers& workers) {
    switch (arithmetic) {
    case l3d_arithmetic::float_32:
        return std::make_unique<l3d_method_afd<float>>(rasterizers, workers);
    case l3d_arithmetic::float_64:
        return std::make_unique<l3d_method_afd<double>>(rasterizers, workers);
    default:
        return std::make_unique<l3d_method_afd<l3d_fixed<std::int64_t, 32>>>(rasterizers, workers);
    }
}

template <class Dicer>
std::unique_ptr<l3d_surface_method> create_mesh(const l3d_rasterizer_factory& rasterizers,
                                                l3d_workers& workers, const Dicer& dicer) {
    return std::make_unique<l3d_method_mesh<Dicer>>(rasterizers, workers, dicer);
}

std::unique_ptr<l3d_surface_method> create_method(const l3d_method_choice& choice,
                                                  const l3d_rasterizer_factory& rasterizers,
                                                  l3d_workers& workers) {
    switch (choice.method) {
    case l3d_method::fd:
        return create_mesh(rasterizers, workers,
                           l3d_fd_dicer(choice.arithmetic, choice.resolution));
    case l3d_method::isocurves:
        return std::make_unique<l3d_method_points<l3d_isocurve_plotter<l3d_real>>>(
            rasterizers, workers, l3d_isocurve_plotter<l3d_real>(choice.resolution));
    case l3d_method::scanline:
        return std::make_unique<l3d_method_points<l3d_scanline_plotter>>(rasterizers, workers);
    case l3d_method::kept:
        return std::make_unique<l3d_method_kept>(choice.resolution, rasterizers, workers);
    case l3d_method::whitted:
        return std::make_unique<l3d_method_points<l3d_whitted_plotter>>(rasterizers, workers);
    case l3d_method::blinn:
        return std::make_unique<l3d_method_points<l3d_blinn_plotter>>(rasterizers, workers);
    case l3d_method::lane_carpenter:
        return create_mesh(rasterizers, workers, l3d_lane_carpenter_dicer());
    case l3d_method::voxels:
        return std::make_unique<l3d_method_voxels>(choice.resolution, workers);
    case l3d_method::mesa:
        return l3d_create_method_mesa();
    case l3d_method::subdivision:
        return create_mesh(rasterizers, workers, l3d_subdivision_dicer());
    case l3d_method::tessellation:
        return std::make_unique<l3d_method_tessellation>(choice.resolution, rasterizers, workers);
    case l3d_method::micropolygons:
        return create_mesh(rasterizers, workers, l3d_micropolygon_dicer(choice.resolution));
    default:
        return create_afd(choice.arithmetic, rasterizers, workers);
    }
}

} // namespace

std::string l3d_method_choice::name() const {
    const method_row& row = row_of(method);
    return resolution > 0 ? std::string(row.name) + ':' + std::to_string(resolution) : row.name;
}

std::optional<l3d_method_choice> l3d_method_choice::from_name(std::string_view name,
                                                              std::string& why) {
    const std::size_t colon = std::min(name.find(':'), name.size());
    const std::string_view word = name.substr(0, colon);
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.name == word; });
    const auto refuse = [&](const std::string& reason) {
        why = '\'' + std::string(name) + "' " + reason;
        return std::nullopt;
    };
    if (found == rows.end()) {
        std::vector<std::string_view> names;
        for (const method_row& row : rows)
            names.emplace_back(row.name);
        return refuse("is unknown; there are " + all_names() +
                      l3d_detail::did_you_mean(word, names));
    }
    l3d_method_choice result;
    result.method = found->method;
    result.resolution = found->usual;
    if (colon == name.size())
        return result;
    if (found->most == 0)
        return refuse("takes no number");
    const std::string_view number = name.substr(colon + 1);
    const char* const end = number.data() + number.size();
    const auto read = std::from_chars(number.data(), end, result.resolution);
    if (read.ec != std::errc() || read.ptr != end || result.resolution < found->least ||
        result.resolution > found->most)
        return refuse("needs a number from " + std::to_string(found->least) + " to " +
                      std::to_string(found->most));
    return result;
}

l3d_method_choice l3d_method_choice::next() const {
    const auto place = static_cast<std::size_t>(&row_of(method) - rows.data());
    const method_row& following = rows[(place + 1) % rows.size()];
    return {following.method, following.usual};
}

std::string l3d_method_choice::all_names() {
    std::string names;
    for (const method_row& row : rows)
        names += std::string(names.empty() ? "" : ", ") + row.name + (row.most > 0 ? "[:N]" : "");
    return names;
}

bool l3d_method_choice::has_bound() const {
    return row_of(method).has_bound;
}

std::string l3d_method_choice::names_with_bound() {
    return names_of([](const method_row& row) { return row.has_bound; });
}

bool l3d_method_choice::keeps_tolerance() const {
    return row_of(method).keeps_tolerance && !(method == l3d_method::fd && resolution > 0);
}

bool l3d_method_choice::draws_parallel() const {
    return row_of(method).draws_parallel;
}

std::string l3d_method_choice::names_with_parallel() {
    return names_of([](const method_row& row) { return row.draws_parallel; });
}

std::string l3d_method_choice::names_with_tolerance() {
    return names_of([](const method_row& row) { return row.keeps_tolerance; });
}

l3d_method_factory l3d_method_choice::factory() const {
    if (method == l3d_method::afd && arithmetic == l3d_real_arithmetic())
        return {};
    return {name(),
            [choice = *this](const l3d_rasterizer_factory& rasterizers, l3d_workers& workers) {
                return create_method(choice, rasterizers, workers);
            },
            has_bound(), draws_parallel()};
}
