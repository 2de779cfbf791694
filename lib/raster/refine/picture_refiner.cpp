// SPDX-License-Identifier: MIT
// picture_refiner: contours and jumps are found, then pixels are mixed, then written.
#include "raster/refine/picture_refiner_p.h"

#include "raster/refine/contour_mixer_p.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace l3d_detail {

namespace {

l3d_pixel_box box_of_band(const drawn_frame& frame, int band) {
    const int top = frame.window.top + band * frame.rows;
    return {frame.window.left, top, frame.window.right,
            std::min(top + frame.rows, frame.window.bottom)};
}

/// Whether all that was drawn where an item reaches, and around, is nearer than all of it.
bool is_hidden(const drawn_frame& frame, const band_item& item) {
    return frame.coarse.hidden(item.box.grown(1).intersected(frame.window),
                               std::nextafter(item.nearest, HUGE_VALF));
}

bool is_grey(const drawn_frame& frame) {
    const l3d_background& background = frame.shading.background;
    const l3d_fog& fog = frame.shading.fog;
    const bool fog_is_grey =
        !fog.is_on() || !fog.color || l3d_background::color(*fog.color).is_grey();
    return fog_is_grey && frame.colors.empty() && !frame.shading.is_lit(frame.materials) &&
           l3d_is_light(frame.shading.mode) && background.is_grey() && !background.is_none();
}

/// Whether levels are continuous inside a surface: those of diced ones, but for mode `flat`.
bool is_smooth(const drawn_frame& frame) {
    const l3d_shading& shading = frame.shading;
    const bool is_diced = shading.ray == std::array<float, 3>{};
    return shading.mode == l3d_shade::levels ||
           (is_diced && shading.mode != l3d_shade::flat && shading.is_lit(frame.materials));
}

/// Whether contours are sides of loose triangles, such as a model's: large, and each of a level of
/// its own. A frame has contours of these or of grids.
bool is_of_facets(const contour_pixel& pixel) {
    return pixel.beside.part->grid.rows < 2;
}

} // namespace

std::int64_t picture_refiner::refine(const drawn_frame& frame, l3d_workers& workers) {
    const int bands = (frame.window.bottom - frame.window.top + frame.rows - 1) / frame.rows;
    const l3d_size size = frame.target.size();
    each_worker_.resize(static_cast<std::size_t>(workers.count()));
    bands_ = static_cast<std::size_t>(bands);
    if (each_band_.size() < static_cast<std::size_t>(bands))
        each_band_.resize(static_cast<std::size_t>(bands));
    jumps_.resize(size);
    cuts_.resize(size);
    contour_bits_.resize(size);
    others_.resize(size);
    const auto of_worker = [&](int worker) -> worker_space& {
        return each_worker_[static_cast<std::size_t>(worker)];
    };
    workers.for_each_beside(
        bands, [&](int band, int worker) { find_contours(frame, band, of_worker(worker)); });
    workers.for_each_beside(bands, [&](int band, int worker) {
        each_band_[static_cast<std::size_t>(band)].refined.clear();
        mix_contours(frame, band);
        resolve(frame, band, of_worker(worker));
    });
    std::int64_t refined = 0;
    for (int band = 0; band < bands; ++band) {
        const auto& pixels = each_band_[static_cast<std::size_t>(band)].refined;
        for (const refined_pixel& p : pixels)
            frame.target.row(p.y)[static_cast<std::size_t>(p.x)] = p.word;
        refined += static_cast<std::int64_t>(pixels.size());
    }
    return refined;
}

/// Contours and jumps of a band. A pixel beside a drawn tile may be partly covered, too.
void picture_refiner::find_contours(const drawn_frame& frame, int band, worker_space& space) {
    const l3d_pixel_box box = box_of_band(frame, band);
    jumps_.clear(box.top, box.bottom);
    cuts_.clear(box.top, box.bottom);
    contour_bits_.clear(box.top, box.bottom);
    others_.clear(box.top, box.bottom);
    const l3d_pixel_box drawn = frame.coarse.drawn_in(
        std::max(box.top - 1, frame.window.top), std::min(box.bottom + 1, frame.window.bottom));
    const l3d_pixel_box reached{drawn.left - 1, box.top, drawn.right + 1, box.bottom};
    const jump_rule rule = is_smooth(frame) ? jump_rule::smooth : jump_rule::any;
    find_jumps(frame.target, rule, reached.intersected(box), jumps_);

    contour_pixels& contours = each_band_[static_cast<std::size_t>(band)].contours;
    const drawn_depth depth(frame.depth.data(), frame.depth.pitch(), frame.window, frame.coarse);
    contours.begin(box);
    space.borders.begin(box.top, box.bottom);
    for (const std::uint32_t index : frame.list.items(band)) {
        const band_item& item = frame.list.item(index);
        space.borders.add(item);
        if (is_hidden(frame, item))
            continue;
        for (const contour_edge& edge : space.edges.find(frame.list, item, box.top, box.bottom))
            contours.add(edge, depth);
    }
    for (const contour_edge& edge : space.borders.match())
        contours.add(edge, depth);
    contours.finish(cuts_, contour_bits_);
    if (!contours.pixels().empty() && is_of_facets(contours.pixels().front()))
        cuts_.clear(box.top, box.bottom); // beside a contour of facets, others may be told by jumps
}

/// Pixels of one contour are mixed here, those of several are marked. So are all contours of large
/// facets: what a pixel beside one shows may be of another.
void picture_refiner::mix_contours(const drawn_frame& frame, int band) {
    const l3d_pixel_box box = box_of_band(frame, band);
    mark_others(frame, box);
    band_space& space = each_band_[static_cast<std::size_t>(band)];
    const drawn_picture drawn{frame.target,
                              frame.window,
                              frame.depth.data(),
                              frame.depth.pitch(),
                              is_grey(frame),
                              frame.shading.mode == l3d_shade::levels,
                              frame.shading.fog.is_on() ? &frame.shading : nullptr,
                              frame.colors,
                              frame.shading.place_error};
    const contour_mixer mixer(drawn, cuts_);
    mark_rims(box, band, mixer);
    for (const contour_pixel& pixel : space.contours.pixels()) {
        if (others_.has(pixel.x, pixel.y))
            continue;
        std::uint32_t word = 0;
        if (is_of_facets(pixel) || !pixel.simple() || !mixer.mix(pixel, word))
            others_.set(pixel.x, pixel.y);
        else
            space.refined.push_back({pixel.x, pixel.y, word});
    }
}

/// Marks pixels beside contours where light is steep. Some belong to contours of the next bands.
void picture_refiner::mark_rims(const l3d_pixel_box& box, int band, const contour_mixer& mixer) {
    const auto mark = [&](const contour_pixel& pixel) {
        contour_mixer::step to{};
        if (!mixer.shades_next(pixel, to))
            return;
        const std::int32_t x = pixel.x + to.x, y = pixel.y + to.y;
        if (y >= box.top && y < box.bottom && !contour_bits_.has(x, y))
            others_.set(x, y);
    };
    const auto of_band = [&](int of) {
        const bool is_there = of >= 0 && static_cast<std::size_t>(of) < bands_;
        return is_there ? each_band_[static_cast<std::size_t>(of)].contours.pixels()
                        : std::span<const contour_pixel>();
    };
    const auto above = of_band(band - 1), below = of_band(band + 1);
    for (auto pixel = above.rbegin(); pixel != above.rend() && pixel->y == box.top - 1; ++pixel)
        mark(*pixel);
    for (const contour_pixel& pixel : of_band(band))
        mark(pixel);
    for (auto pixel = below.begin(); pixel != below.end() && pixel->y == box.bottom; ++pixel)
        mark(*pixel);
}

/// Marks both sides of jumps between pixels that no contour divides. Beside a fold, the shading of
/// a surface that bends away is steep: jumps at a pixel of one contour are its own.
void picture_refiner::mark_others(const drawn_frame& frame, const l3d_pixel_box& box) {
    const std::size_t words = others_.row_words();
    constexpr int last = pixel_bits::word_pixels - 1;
    const bool smooth = is_smooth(frame);
    const auto steep = [&](std::int32_t y, std::size_t w) -> std::uint64_t {
        return smooth ? contour_bits_.row(y)[w] : 0;
    };
    /// The jumps of row y to the next one that nothing explains.
    const auto down_from = [&](std::int32_t y, std::size_t w) -> std::uint64_t {
        const std::uint64_t jumps = jumps_.down.row(y)[w];
        if (jumps == 0 || y + 1 >= frame.window.bottom)
            return 0;
        return jumps & ~(cuts_.down.row(y)[w] ^ cuts_.up.row(y + 1)[w]) & ~steep(y, w) &
               ~steep(y + 1, w);
    };
    /// Those to the next column.
    const auto right_from = [&](std::int32_t y, std::size_t w) -> std::uint64_t {
        const std::uint64_t jumps = jumps_.right.row(y)[w] & ~cuts_.right.row(y)[w];
        if (jumps == 0)
            return 0;
        const std::uint64_t here = steep(y, w);
        const std::uint64_t beyond = w + 1 < words ? steep(y, w + 1) << last : 0;
        return jumps & ~here & ~(here >> 1 | beyond);
    };
    for (std::int32_t y = box.top; y < box.bottom; ++y) {
        std::uint64_t* const to = others_.row(y);
        for (std::size_t w = 0; w < words; ++w) {
            const bool has_above = y > frame.window.top;
            if ((jumps_.right.row(y)[w] | jumps_.down.row(y)[w] |
                 (has_above ? jumps_.down.row(y - 1)[w] : 0)) == 0)
                continue;
            const std::uint64_t above = has_above ? down_from(y - 1, w) : 0;
            const std::uint64_t right = right_from(y, w);
            const std::uint64_t all = down_from(y, w) | above | right;
            if (all == 0)
                continue;
            // The last words of rows go on beyond the picture with its last column.
            to[w] |= (all | right << 1) &
                     pixel_bits::within(static_cast<std::int32_t>(w), 0, frame.target.width);
            if (w + 1 < words)
                to[w + 1] |= right >> last; // a pixel of the picture: none jumps to beyond its end
        }
    }
}

void picture_refiner::resolve(const drawn_frame& frame, int band, worker_space& space) {
    const l3d_pixel_box box = box_of_band(frame, band);
    const l3d_size size = frame.target.size();
    const drawn_depth depth(frame.depth.data(), frame.depth.pitch(), frame.window, frame.coarse);
    space.fragments.begin(others_, depth, size.width, box.top, box.bottom);
    if (space.fragments.pixels().empty())
        return;
    const bool levels = frame.shading.mode == l3d_shade::levels;
    const bool by_material =
        l3d_sees_patches(frame.shading.mode) || frame.shading.is_lit(frame.materials);
    space.fragments.use_colors(frame.colors, by_material);
    for (const std::uint32_t index : frame.list.items(band)) {
        const band_item& item = frame.list.item(index);
        if (!is_hidden(frame, item))
            space.fragments.add(frame.list, item, levels);
    }
    space.fragments.sort();
    auto& refined = each_band_[static_cast<std::size_t>(band)].refined;
    space.mixer.draw(space.fragments, frame.shading, frame.materials, !frame.colors.empty(),
                     size.height);
    const auto pixels = space.fragments.pixels();
    for (std::size_t i = 0; i < pixels.size(); ++i)
        refined.push_back({pixels[i].x, pixels[i].y, space.mixer.words()[i]});
}

} // namespace l3d_detail
