// SPDX-License-Identifier: MIT
// painter_tiles: counted and filled, by each worker for its share of the triangles.
#include "pipeline/polygons/painter_tiles_p.h"

#include "raster/parallel/chunks_p.h"
#include "raster/shapes/scan_edge_p.h"

#include <cmath>
#include <utility>

namespace l3d_detail {

pixel_range range_of(const std::array<l3d_micro_vertex, 3>& v, l3d_size size) {
    const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
    const auto [farthest, nearest] = std::minmax({v[0].inv_w, v[1].inv_w, v[2].inv_w});
    return {std::max(first_centre(left), 0),
            std::max(first_centre(top), 0),
            std::min(first_centre(right), size.width),
            std::min(first_centre(bottom), size.height),
            farthest,
            nearest};
}

void painter_tiles::make(std::span<const pixel_range> ranges, l3d_size size, l3d_workers& workers) {
    double area = 0;
    for (const pixel_range& r : ranges)
        area += double(r.right - r.left) * (r.bottom - r.top);
    const double side = 2 * std::sqrt(area / std::max<double>(1, double(ranges.size())));
    constexpr int least = 2, most = 7; // 4 to 128 pixels
    shift_ = std::clamp(static_cast<int>(std::lround(std::log2(std::max(side, 1.0)))), least, most);
    columns_ = ((size.width - 1) >> shift_) + 1;
    rows_ = ((size.height - 1) >> shift_) + 1;
    const std::size_t tiles = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);

    // As many shares as workers, each with counters of its own. A share's members of a tile follow
    // those of the share before, so they rise.
    const std::size_t share = std::max<std::size_t>(
        1, chunks_of(ranges.size(), static_cast<std::size_t>(workers.count())));
    ends_.resize(chunks_of(ranges.size(), share));
    for_each_chunk(workers, ranges.size(), share,
                   [&](std::size_t begin, std::size_t end, std::size_t number) {
                       std::vector<std::uint32_t>& counts = ends_[number];
                       counts.assign(tiles, 0);
                       for (const pixel_range& r : ranges.subspan(begin, end - begin))
                           for_each(r, [&](const painter_tile& tile) { ++counts[tile.index]; });
                   });
    begins_.resize(tiles + 1);
    std::uint32_t sum = 0;
    for (std::size_t t = 0; t < tiles; ++t) {
        begins_[t] = sum;
        for (std::vector<std::uint32_t>& counts : ends_)
            sum += std::exchange(counts[t], sum);
    }
    begins_[tiles] = sum;
    entries_.resize(sum);
    for_each_chunk(workers, ranges.size(), share,
                   [&](std::size_t begin, std::size_t end, std::size_t number) {
                       std::vector<std::uint32_t>& ends = ends_[number];
                       for (std::size_t i = begin; i < end; ++i)
                           for_each(ranges[i], [&](const painter_tile& tile) {
                               entries_[ends[tile.index]++] = static_cast<std::uint32_t>(i);
                           });
                   });
    heads_.assign(begins_.begin(), begins_.end() - 1);
}

} // namespace l3d_detail
