// SPDX-License-Identifier: MIT
// Measures paths of cells: rays through the teapot's cells, and its curves in cells.
#include "report_alternatives.h"
#include "report_models.h"
#include "report_rows.h"
#include "report_table.h"

#include "compare/cells/cell_path.h"
#include "compare/cells/cell_stride.h"
#include "compare/method_voxels.h"
#include "processor_time.h"
#include "scene/camera_shading.h"
#include <l3d/pipeline_afd.h>
#include <l3d/screen_memory.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace {

using vector = l3d_patch_model::vector;

/// A kind of path, and its name in tables.
struct path_kind {
    const char* name;
    l3d_cell_touch touch;
    l3d_cell_order order;
};

constexpr std::array kinds{
    path_kind{"faces (6)", l3d_cell_touch::face, l3d_cell_order::near_line},
    path_kind{"edges (18)", l3d_cell_touch::edge, l3d_cell_order::near_line},
    path_kind{"corners (26)", l3d_cell_touch::corner, l3d_cell_order::near_line},
    path_kind{"edges (18) diagonals first", l3d_cell_touch::edge, l3d_cell_order::diagonal_first},
    path_kind{"corners (26) diagonals first", l3d_cell_touch::corner,
              l3d_cell_order::diagonal_first}};

/// A ray's first and last cell in the cube, and whether the exact ray meets a filled cell.
struct cell_ray {
    l3d_cell from, to;
    bool hits;
};

l3d_cell cell_at(const vector& at, int side) {
    l3d_cell result;
    for (int i = 0; i < 3; ++i)
        result[static_cast<std::size_t>(i)] =
            std::clamp(static_cast<int>(std::floor(at[i])), 0, side - 1);
    return result;
}

/// The cells that the method `voxels` fills with the teapot, and the rays of a view through them.
class cells_of_teapot {
public:
    cells_of_teapot(const report_model& teapot, l3d_size size, int side)
        : pipeline_(l3d_memory_canvas(size), teapot.model, teapot.views[0].camera, settings(side)) {
        pipeline_.draw_event();
        const l3d_camera& camera = teapot.views[0].camera;
        const l3d_shading view =
            l3d_camera_shading(camera, size, l3d_shade::lambert, l3d_usual_light);
        const vector origin = made_->in_cells(camera.eye);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                vector ray;
                for (int i = 0; i < 3; ++i) {
                    const auto k = static_cast<std::size_t>(i);
                    ray[i] = double(view.ray[k]) + (x + 0.5) * double(view.ray_right[k]) +
                             (y + 0.5) * double(view.ray_down[k]);
                }
                add(origin, ray, side);
            }
    }

    const l3d_cubic_frame_buffer& cube() const { return made_->cube(); }
    const std::vector<cell_ray>& rays() const { return rays_; }
    vector in_cells(const vector& at) const { return made_->in_cells(at); }

private:
    l3d_afd_settings settings(int side) {
        l3d_afd_settings result{.antialias = false, .background = {}, .threads = 1};
        result.method = {"voxels", [this, side](const l3d_rasterizer_factory&, l3d_workers& all) {
                             auto method = std::make_unique<l3d_method_voxels>(side, all);
                             made_ = method.get();
                             return method;
                         }};
        return result;
    }

    void add(const vector& origin, const vector& ray, int side) {
        const l3d_cell_stride::place from{origin[0], origin[1], origin[2]};
        const l3d_cell_stride::place along{ray[0], ray[1], ray[2]};
        const auto [enters, leaves] = l3d_in_cube(from, along, side, 0);
        if (enters < leaves)
            rays_.push_back({cell_at(origin + ray * enters, side),
                             cell_at(origin + ray * leaves, side),
                             cube().first(from, along, 0).has_value()});
    }

    const l3d_method_voxels* made_ = nullptr;
    l3d_pipeline_afd pipeline_;
    std::vector<cell_ray> rays_;
};

/// Walks all rays until they hit. The row has steps, time, and the share of pixels in which exact
/// rays see something else.
std::string walk_rays(const cells_of_teapot& of, const path_kind& kind) {
    std::int64_t steps = 0, other = 0;
    double seconds = std::numeric_limits<double>::infinity();
    for (int repeat = 0; repeat < 3; ++repeat) { // the first walk finds no cells in the caches
        steps = other = 0;
        const double before = processor_seconds();
        for (const cell_ray& ray : of.rays()) {
            bool hit = false;
            steps +=
                l3d_walk_cells(ray.from, ray.to, kind.touch, kind.order, [&](const l3d_cell& at) {
                    hit = of.cube().is_filled(at);
                    return !hit;
                });
            other += hit != ray.hits;
        }
        seconds = std::min(seconds, processor_seconds() - before);
    }
    const auto count = static_cast<double>(of.rays().size());
    return table_row("rays", kind.name, static_cast<double>(steps) / count, 1e9 * seconds / count,
                     static_cast<double>(other) / count, 0);
}

double distance_from(const vector& p, const vector& a, const vector& b) {
    const vector along = b - a, there = p - a;
    const double length = l3d_dot(along, along);
    const double t = length > 0 ? std::clamp(l3d_dot(there, along) / length, 0.0, 1.0) : 0;
    return l3d_length(vector(there - along * t));
}

/// Walks curves of the teapot: points some cells apart, joined by paths. The row has cells and time
/// for each path, and the cells' largest distance from chords.
std::string walk_curves(const cells_of_teapot& of, const l3d_patch_model& model,
                        const path_kind& kind, int side) {
    constexpr int curves = 32;
    constexpr double hop = 3.5; // cells
    std::int64_t hops = 0, steps = 0;
    double farthest = 0, seconds = 0;
    std::vector<vector> points;
    for (const auto& patch : model.patches())
        for (int c = 0; c <= curves; ++c) {
            const auto curve = patch.curve_at_u(double(c) / curves);
            double length = 0;
            for (std::size_t i = 0; i < 3; ++i)
                length += l3d_length(
                    vector(of.in_cells(curve.points[i + 1]) - of.in_cells(curve.points[i])));
            const int n = std::max(1, static_cast<int>(std::ceil(length / hop)));
            points.clear();
            for (int i = 0; i <= n; ++i)
                points.push_back(of.in_cells(curve.evaluate(double(i) / n)));
            const double before = processor_seconds();
            for (std::size_t i = 1; i < points.size(); ++i)
                steps +=
                    l3d_walk_cells(cell_at(points[i - 1], side), cell_at(points[i], side),
                                   kind.touch, kind.order, [](const l3d_cell&) { return true; });
            seconds += processor_seconds() - before;
            hops += n;
            for (std::size_t i = 1; i < points.size(); ++i) {
                const l3d_cell from = cell_at(points[i - 1], side), to = cell_at(points[i], side);
                const auto middle = [](const l3d_cell& cell) {
                    return vector(cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5);
                };
                l3d_walk_cells(from, to, kind.touch, kind.order, [&](const l3d_cell& cell) {
                    farthest =
                        std::max(farthest, distance_from(middle(cell), middle(from), middle(to)));
                    return true;
                });
            }
        }
    return table_row("curves", kind.name, static_cast<double>(steps) / static_cast<double>(hops),
                     1e9 * seconds / static_cast<double>(hops), 0, farthest);
}

} // namespace

void write_cell_table(const std::string& folder, l3d_size size, bool quick) {
    const int side = quick ? 64 : 256;
    const report_model teapot = report_models().front();
    const cells_of_teapot cells(teapot, {size.width / 2, size.height / 2}, side);
    std::string text = "along,touch,steps,ns,other_share,farthest_cells\n";
    for (const path_kind& kind : kinds)
        if (kind.order == l3d_cell_order::near_line) // other kinds of paths bend away from a ray
            text += walk_rays(cells, kind);
    for (const path_kind& kind : kinds)
        text += walk_curves(cells, teapot.model, kind, side);
    write_text(folder + "/cells.csv", text);
}
