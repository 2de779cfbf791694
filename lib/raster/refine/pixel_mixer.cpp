// SPDX-License-Identifier: MIT
// pixel_mixer: samples tell what is seen, areas how much of it.
#include "raster/refine/pixel_mixer_p.h"

#include "raster/refine/mean_level_p.h"
#include "raster/refine/pixel_centroid_p.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace l3d_detail {

namespace {

/// Light that may be shared out by samples: what is the same but for 1/256 of white, or for an
/// eighth of the brightest. If 3 of 64 samples are wrong, that is 3/512 of the light. A level goes
/// as the 2.4th root, so it is a quarter of that off: by 0.6 levels at most.
constexpr float harmless_contrast = 1.0f / 256, harmless_part = 1.0f / 8;

/// Levels that differ by no more, times the polygon's area, are told by the one in the middle. The
/// pixel is then off by half of that, by the two levels that shades are allowed.
constexpr float calm = 4;

/// Slivers, which no sample meets, may be missing up to this area in all.
constexpr float harmless_area = 1.0f / 64;

/// The least and the most light of several.
struct light_range {
    light_sum least{{1, 1, 1}}, most;

    void add(const light_sum& light) {
        for (std::size_t i = 0; i < light.of.size(); ++i) {
            least.of[i] = std::min(least.of[i], light.of[i]);
            most.of[i] = std::max(most.of[i], light.of[i]);
        }
    }

    /// How far apart they are, in the channel where that is most.
    float contrast() const {
        float result = most.of[0] - least.of[0];
        for (std::size_t i = 1; i < most.of.size(); ++i)
            result = std::max(result, most.of[i] - least.of[i]);
        return result;
    }

    /// Whether they may be shared out by samples.
    bool harmless() const {
        const float brightest = *std::ranges::max_element(most.of);
        return contrast() <= std::max(harmless_contrast, harmless_part * brightest);
    }
};

/// The sample whose cell a place lies in.
std::uint64_t sample_at(float x, float y) {
    const auto cell = [](float place) {
        return std::clamp(static_cast<int>(place * mask_side), 0, mask_side - 1);
    };
    return std::uint64_t{1} << (cell(y) * mask_side + cell(x));
}

/// Whether two polygons have the same corners, in any order.
bool coincide(const fragment_polygon& one, const fragment_polygon& other) {
    const auto is_one_of = [](const fragment_polygon& from, int i, const fragment_polygon& in) {
        for (int k = 0; k < in.corners; ++k)
            if (from.x[i] == in.x[k] && from.y[i] == in.y[k] && from.inv_w[i] == in.inv_w[k])
                return true;
        return false;
    };
    for (int i = 0; i < one.corners; ++i)
        if (!is_one_of(one, i, other))
            return false;
    for (int i = 0; i < other.corners; ++i)
        if (!is_one_of(other, i, one))
            return false;
    return true;
}

} // namespace

void pixel_mixer::draw(const band_fragments& band, const l3d_shading& shading,
                       std::span<const l3d_material> materials, bool has_color, int height) {
    has_color_ = has_color;
    const fragment_fog fog{shading, height};
    fog_ = &fog;
    measure_pairs(band, measures_);
    with_shader(shading, materials, 0,
                [&](auto shader) { draw_by(shader, band, shading.background, height); });
    fog_ = nullptr;
}

pixel_mixer::ground pixel_mixer::ground_of(std::uint32_t word) {
    return {word, light_sum::of_word(word, linear_light_tables())};
}

template <class Shader>
void pixel_mixer::draw_by(Shader shader, const band_fragments& band,
                          const l3d_background& background, int height) {
    const linear_light& tables = linear_light_tables();
    const auto pixels = band.pixels();
    words_.clear();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const scan_point corner{pixels[i].x * l3d_subpixel_one, pixels[i].y * l3d_subpixel_one};
        collect(band, i);
        hide();
        const ground behind = ground_of(background.word(pixels[i].y, height));
        mixture sum;
        if (!mix(shader, band, corner, band.closed(i), behind, sum)) {
            ++sampled_;
            sampler_.begin(corner);
            for (const fragment& f : fragments_)
                sampler_.add(band.polygons()[f.polygon]);
            sum.light = sampler_.light(shader, *fog_, has_color_, band.closed(i), sum.empty);
        }
        words_.push_back(sum.light.word_before(behind.word, sum.empty, tables));
    }
}

/// Of facets or quads in the same place, the first is seen: slivers that no sample meets would else
/// add up. Patches close a slit from both sides, by the same triangles. These stay, as their area
/// tells how much is uncertain there.
void pixel_mixer::collect(const band_fragments& band, std::size_t pixel) {
    fragments_.clear();
    const std::size_t end = band.begin_of(pixel + 1);
    for (std::size_t pair = band.begin_of(pixel); pair < end; ++pair) {
        const std::uint64_t mask = measures_.samples(pair);
        const float area = measures_.area[pair];
        if (mask == 0 && !(area > 0))
            continue;
        const std::uint32_t name = band.pairs()[pair].polygon;
        const fragment_polygon& polygon = band.polygons()[name];
        const auto hides = [&](const fragment& before) {
            return before.farthest == polygon.farthest && before.nearest == polygon.nearest &&
                   coincide(band.polygons()[before.polygon], polygon);
        };
        if (polygon.counts_once && std::ranges::any_of(fragments_, hides))
            continue;
        fragments_.push_back({static_cast<std::uint32_t>(pair), name, area, mask, mask,
                              polygon.farthest, polygon.nearest, polygon.area2() > 0});
    }
}

/// Takes from each fragment the samples where another one is nearer; of equals, the first is seen.
/// No two of those seen so far share a sample, so there are 64 of them at most.
void pixel_mixer::hide() {
    seen_.clear();
    for (std::size_t i = 0; i < fragments_.size(); ++i) {
        fragment& later = fragments_[i];
        if (later.seen == 0)
            continue;
        for (const std::size_t k : seen_) {
            fragment& first = fragments_[k];
            const std::uint64_t both = later.seen & first.seen;
            if (both == 0)
                continue;
            std::uint64_t nearer = 0; // the later one
            if (!(first.farthest >= later.nearest))
                nearer =
                    later.farthest > first.nearest ? both : both & nearer_samples(later, first);
            first.seen &= ~nearer;
            later.seen &= ~(both & ~nearer);
        }
        std::erase_if(seen_, [this](std::size_t k) { return fragments_[k].seen == 0; });
        if (later.seen != 0)
            seen_.push_back(i);
    }
}

/// The samples where one polygon's plane is nearer than another's.
std::uint64_t pixel_mixer::nearer_samples(const fragment& one, const fragment& other) const {
    const auto at_corner = [&](std::uint32_t pair) {
        return measures_.inv_w[pair] - measures_.x[pair] * measures_.of_x[pair] -
               measures_.y[pair] * measures_.of_y[pair];
    };
    return samples_above(at_corner(one.pair) - at_corner(other.pair),
                         measures_.of_x[one.pair] - measures_.of_x[other.pair],
                         measures_.of_y[one.pair] - measures_.of_y[other.pair]);
}

/// Whether a polygon that no sample meets lies behind one that is seen around it.
bool pixel_mixer::is_hidden(const fragment& sliver) const {
    const std::uint64_t there = sample_at(measures_.x[sliver.pair], measures_.y[sliver.pair]);
    for (const std::size_t k : seen_) {
        const fragment& f = fragments_[k];
        if ((f.seen & there) == 0)
            continue;
        if (f.farthest >= sliver.nearest)
            return true;
        if (sliver.farthest >= f.nearest || f.clockwise == sliver.clockwise)
            continue;
        return (nearer_samples(f, sliver) & there) != 0;
    }
    return false;
}

template <class Shader>
light_sum pixel_mixer::light_of(Shader& shader, const band_fragments& band, const fragment& of,
                                scan_point corner) const {
    const fragment_polygon& polygon = band.polygons()[of.polygon];
    if constexpr (has_bends<Shader>) {
        constexpr std::uint32_t white = 0xffffff;
        const double x = corner.x + double{l3d_subpixel_one * measures_.x[of.pair]};
        const double y = corner.y + double{l3d_subpixel_one * measures_.y[of.pair]};
        const bool is_calm = of.seen == 0 || of.area * measures_.spread[of.pair] <= calm;
        const float level =
            is_calm ? measures_.level[of.pair] : mean_level(polygon, corner, of.seen);
        const light_sum light =
            light_sum::of_level(level, has_color_ ? polygon.color : white, linear_light_tables());
        return fog_->over(light, polygon, x, y);
    } else {
        const auto [x, y] = centroid_in_pixel(polygon, corner);
        return fog_->over(light_at(shader, polygon, has_color_, x, y), polygon, x, y);
    }
}

/// False if the areas do not tell enough.
template <class Shader>
bool pixel_mixer::mix(Shader& shader, const band_fragments& band, scan_point corner, bool closed,
                      const ground& behind, mixture& sum) {
    std::uint64_t seen = 0;
    std::array<float, 2> of_slivers{};
    float known = 0;
    for (const fragment& f : fragments_) {
        seen |= f.seen;
        const bool is_sliver = f.mask == 0;
        if (is_sliver ? is_hidden(f) : f.seen != f.mask)
            continue;
        if (is_sliver)
            of_slivers[f.clockwise ? 1 : 0] += f.area;
        known += f.area;
        sum.light.add(light_of(shader, band, f, corner), f.area);
    }
    // Slivers of both turns may lie before each other.
    if (of_slivers[0] > 0 && of_slivers[1] > 0 && of_slivers[0] + of_slivers[1] > harmless_area)
        return false;
    return add_rest(shader, band, corner, closed, known, seen, behind, sum);
}

/// Adds what shares the area that is not known: polygons that are hidden in part, and the empty
/// background.
template <class Shader>
bool pixel_mixer::add_rest(Shader& shader, const band_fragments& band, scan_point corner,
                           bool closed, float known, std::uint64_t seen, const ground& behind,
                           mixture& sum) {
    const float rest = 1 - known;
    const int empty = closed ? 0 : bits_in(~seen);
    light_sum in_part;
    light_range range;
    int samples = empty;
    if (empty > 0)
        range.add(behind.light);
    for (const fragment& f : fragments_) {
        if (f.seen == 0 || f.seen == f.mask)
            continue;
        const light_sum here = light_of(shader, band, f, corner);
        const int count = bits_in(f.seen);
        in_part.add(here, static_cast<float>(count));
        samples += count;
        range.add(here);
    }
    if (samples == 0) {
        if (std::abs(rest) > harmless_area / 4 && !(closed && known > 0.5f && rest > 0))
            return false;
        light_sum whole;
        whole.add(sum.light, 1 / known);
        sum.light = whole;
        return true;
    }
    const bool is_mixed = samples > empty && empty > 0;
    if (!range.harmless() || (is_mixed && behind.is_none()))
        return false;
    if (rest > 0) {
        const float share = rest / static_cast<float>(samples);
        sum.light.add(in_part, share);
        sum.empty = share * static_cast<float>(empty);
    }
    return rest > -harmless_area / 4;
}

} // namespace l3d_detail
