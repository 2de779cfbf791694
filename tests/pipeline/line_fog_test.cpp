// SPDX-License-Identifier: MIT
// Fog before lines: each pixel of a line by the exact distance of the plane that all lines lie in.
#include "hard_edged.h"
#include "words_of.h"

#include "pipeline/pipeline_afd.h"
#include "pipeline/polygons/pipeline_zbuffer.h"
#include "pipeline/wire_p.h"
#include "pipeline/zsort/pipeline_zsort.h"
#include "raster/rasterizer_factory.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace {

using vector = l3d_vector<double, 3>;

constexpr l3d_size size{131, 97};
constexpr l3d_fog fog{.from = 3.5F, .to = 6, .color = 0x904010};
const vector corner{-1.3, -0.9, -1.2}, along_u{2.4, 0.2, 2.6}, along_v{-0.3, 1.8, -0.9};

l3d_camera before_the_plane() {
    l3d_camera camera;
    camera.eye = {0.4, 0.3, 5};
    camera.target = {0.1, 0, 0};
    return camera;
}

/// Which distance along the view axis the plane has where the picture's place (x, y) shows it.
double distance_at(const l3d_polygon_view& view, double x, double y) {
    const l3d_matrix<double>& m = view.matrix();
    const auto c = m * l3d_vector<double, 4>(corner, 1.0);
    const auto u = m * l3d_vector<double, 4>(along_u, 0.0);
    const auto v = m * l3d_vector<double, 4>(along_v, 0.0);
    const double right = x - size.width / 2.0, down = y - size.height / 2.0;
    const auto off_x = [&](const auto& p) { return p[0] - right * p[3]; };
    const auto off_y = [&](const auto& p) { return p[1] - down * p[3]; };
    const double of_uv = off_x(u) * off_y(v) - off_x(v) * off_y(u);
    const double a = (off_x(v) * off_y(c) - off_x(c) * off_y(v)) / of_uv;
    const double b = (off_x(c) * off_y(u) - off_x(u) * off_y(c)) / of_uv;
    return c[2] + a * u[2] + b * v[2];
}

using picture = std::vector<std::uint32_t>;

/// Compares lines in fog with the same lines in clear air, both on black. There, the blue of a line
/// is what it covers.
void expect_each_pixel_faded(const picture& clear, const picture& faded, l3d_projection projection,
                             int least) {
    l3d_camera camera = before_the_plane();
    camera.projection = projection;
    const l3d_polygon_view view(camera, size, l3d_identity<double>());
    int judged = 0, dim = 0, off = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const auto i = static_cast<std::size_t>(y * size.width + x);
            const double cover = (clear[i] & 255) / 255.0;
            if (cover == 0) {
                EXPECT_EQ(faded[i], clear[i]);
                continue;
            }
            const auto share = [&](double column, double row) {
                const double distance = distance_at(view, column, row);
                return (distance - double{fog.from}) / (double{fog.to} - double{fog.from});
            };
            const double exact = share(x + 0.5, y + 0.5);
            const double slope = std::abs(share(x + 1.5, y + 0.5) - exact) +
                                 std::abs(share(x + 0.5, y + 1.5) - exact);
            ++judged;
            const double held = std::clamp(exact, 0.0, 1.0);
            dim += held > 0.2 && held < 0.8;
            for (const int shift : {0, 8, 16}) {
                const double line = l3d_detail::wire_color >> shift & 255;
                const double to = *fog.color >> shift & 255;
                const double shown = faded[i] >> shift & 255;
                off += std::abs(shown - cover * (line + held * (to - line))) >
                       2.5 + slope * std::abs(to - line);
            }
        }
    EXPECT_GT(judged, least);
    EXPECT_GT(dim, judged / 3);
    EXPECT_EQ(off, 0);
}

/// Squares in a plane.
l3d_polygon_model squares() {
    constexpr std::uint32_t count = 4;
    l3d_polygon_mesh mesh;
    for (std::uint32_t i = 0; i <= count; ++i)
        for (std::uint32_t k = 0; k <= count; ++k)
            mesh.vertices.push_back(corner + along_u * (double(i) / count) +
                                    along_v * (double(k) / count));
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t at = i * (count + 1) + k;
            for (const std::uint32_t vertex : {at, at + count + 1, at + count + 2, at + 1})
                mesh.corners.push_back(vertex);
            mesh.face_ends.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        }
    return l3d_polygon_model(std::move(mesh));
}

template <class Pipeline> void expect_lines_of_polygons_faded() {
    for (const l3d_polygon_style style :
         {l3d_polygon_style::wireframe, l3d_polygon_style::hidden_lines})
        for (const l3d_projection projection :
             {l3d_projection::perspective, l3d_projection::parallel})
            for (const bool smooth : {false, true}) {
                SCOPED_TRACE(testing::Message() << int(style) << int(projection) << smooth);
                const auto drawn = [&](const l3d_fog& in) {
                    l3d_polygon_settings settings = hard_edged_polygons();
                    settings.style = style;
                    l3d_camera camera = before_the_plane();
                    camera.projection = projection;
                    settings.antialias = smooth;
                    settings.background = {};
                    settings.fog = in;
                    Pipeline pipeline(l3d_memory_canvas(size), squares(), camera, settings);
                    pipeline.draw_event();
                    return words_of(pipeline.screen().pixels());
                };
                expect_each_pixel_faded(drawn({}), drawn(fog), projection, 300);
            }
}

TEST(line_fog, fades_lines_of_polygons_with_a_depth_buffer) {
    expect_lines_of_polygons_faded<l3d_pipeline_zbuffer>();
}

TEST(line_fog, fades_lines_of_sorted_polygons) {
    expect_lines_of_polygons_faded<l3d_pipeline_zsort>();
}

TEST(line_fog, fades_steps_of_patches) {
    l3d_patch_model::patch patch;
    for (std::size_t i = 0; i < 16; ++i)
        patch.points[i] = corner + along_u * (double(i % 4) / 3) + along_v * (double(i / 4) / 3);
    patch.points[5] += along_u * 0.3 - along_v * 0.4; // more than one step
    for (const bool smooth : {false, true}) {
        const auto drawn = [&](const l3d_fog& in) {
            l3d_afd_settings settings = hard_edged();
            settings.wireframe = true;
            settings.antialias = smooth;
            settings.background = {};
            settings.fog = in;
            l3d_pipeline_afd pipeline(l3d_memory_canvas(size),
                                      l3d_patch_scene(l3d_patch_model({patch})), before_the_plane(),
                                      settings);
            pipeline.draw_event();
            return words_of(pipeline.screen().pixels());
        };
        expect_each_pixel_faded(drawn({}), drawn(fog), l3d_projection::perspective, 300);
    }
}

/// The colour of two wide lines that cross, drawn in either order.
TEST(line_fog, shows_the_nearer_of_two_lines) {
    const l3d_detail::wire far{.x0 = 2560,
                               .y0 = 256,
                               .x1 = 2560,
                               .y1 = 5120,
                               .from_inv_w = 1 / 5.5F,
                               .to_inv_w = 1 / 5.5F};
    const l3d_detail::wire near{.x0 = 256,
                                .y0 = 2560,
                                .x1 = 5120,
                                .y1 = 2560,
                                .from_inv_w = 1 / 4.0F,
                                .to_inv_w = 1 / 4.0F};
    l3d_shading shading;
    shading.fog = fog;
    for (const double width : {1.0, 4.0})
        for (const bool smooth : {false, true})
            for (const bool near_first : {false, true}) {
                l3d_screen_memory screen({20, 20});
                const auto imp = l3d_rasterizer_factory_sw().create_2d(screen.pixels());
                l3d_rasterizer_2d rasterizer(*imp);
                l3d_detail::wire_picture lines_of(rasterizer, screen.pixels(), shading, smooth,
                                                  width);
                const std::vector lines{near_first ? near : far, near_first ? far : near};
                lines_of.draw(lines);
                lines_of.finish();
                const auto in_fog = [&](float distance) {
                    return shading.fogged(l3d_detail::wire_color, *fog.color, 1 / distance);
                };
                if (width == 1 && smooth)
                    continue; // no pixel is covered whole
                EXPECT_EQ(screen.pixels().row(10)[10], in_fog(4));
                EXPECT_EQ(screen.pixels().row(10)[3], in_fog(4));
                EXPECT_EQ(screen.pixels().row(3)[10], in_fog(5.5F));
            }
}

} // namespace
