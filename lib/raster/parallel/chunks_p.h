// SPDX-License-Identifier: MIT
// for_each_chunk: shares a range of items among the workers, a chunk at a time.
#ifndef L3D_RASTER_PARALLEL_CHUNKS_P_H
#define L3D_RASTER_PARALLEL_CHUNKS_P_H

#include "raster/parallel/workers.h"

#include <algorithm>
#include <cstddef>

namespace l3d_detail {

/// The number of chunks into which items are divided; the last chunk may be shorter.
constexpr std::size_t chunks_of(std::size_t items, std::size_t chunk) {
    return (items + chunk - 1) / chunk;
}

/// Calls work(begin, end, number of the chunk) once for each chunk, on any worker. In repeated
/// calls with the same number of items, most chunks meet the same worker each time.
/// Expects: as l3d_workers::for_each_beside; chunk > 0.
template <class Work>
void for_each_chunk(l3d_workers& workers, std::size_t items, std::size_t chunk, const Work& work) {
    workers.for_each_beside(static_cast<int>(chunks_of(items, chunk)), [&](int number, int) {
        const std::size_t begin = static_cast<std::size_t>(number) * chunk;
        work(begin, std::min(begin + chunk, items), static_cast<std::size_t>(number));
    });
}

} // namespace l3d_detail

#endif
