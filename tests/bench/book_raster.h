// SPDX-License-Identifier: MIT
// book_raster: a stand-in for the original rasterizer, which is not ours to ship.
#ifndef L3D_TESTS_BENCH_BOOK_RASTER_H
#define L3D_TESTS_BENCH_BOOK_RASTER_H

#include "tool_2d/pixels.h"

#include <array>
#include <cstdint>

namespace bench {

/// What a pixel of the target looks like, asked anew for every byte.
struct book_target {
    int bytes_per_pixel = 4;
    unsigned char* bytes = nullptr;
};

/// Size and target, kept where only a virtual base is found.
struct book_rasterizer_base {
    int width = 0;
    book_target* target = nullptr;
};

/// Lines and triangles at the price that the original paid for each pixel. It finds the address by
/// a product and writes bytes one by one, each by mask, shift and store. After each store
/// everything is loaded again, since a byte may alias anything. Nothing is clipped.
///
/// Counted there: 79 instructions a pixel of lines of 100 pixels, 81 of triangles of 10000. Here it
/// is 70 and 67: the stand-in is the faster one.
class book_raster : public virtual book_rasterizer_base {
public:
    explicit book_raster(const l3d_pixels& pixels);

    /// By repeated addition along the longer axis.
    void draw_line(int x0, int y0, int x1, int y1, std::uint32_t color);

    /// Spans between edges by repeated addition, started at each edge's first row.
    void draw_triangle(const std::array<std::array<float, 2>, 3>& corners, std::uint32_t color);

private:
    void draw_point(int x, int y, std::uint32_t color);
    void draw_span(int y, int from, int to, std::uint32_t color);

    book_target own_;
};

} // namespace bench

#endif
