// SPDX-License-Identifier: MIT
// linear_light: converts levels of a picture to amounts of light, and back.
#ifndef L3D_RASTER_COLOR_LINEAR_LIGHT_P_H
#define L3D_RASTER_COLOR_LINEAR_LIGHT_P_H

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// Tables of the sRGB curve. A level that is converted to light, and then back to a level, stays
/// the same.
/// Real: float for many pixels, or double where the nearest level must be exact.
template <class Real> class linear_light_of {
public:
    linear_light_of();

    /// The light of a level from 0 to 255; level 255 has light 1.
    Real light(std::uint32_t level) const { return light_[level]; }

    /// The grey level of a surface that only ambient light reaches, and the largest number of
    /// levels that lamps add.
    static constexpr Real ambient = Real(25.5), most_lit = Real(229.5);

    /// The level of a surface that is lit by lamps. `lit` is the level above the ambient one, as in
    /// l3d_micro_vertex.
    static Real level_of(Real lit) {
        return ambient + (lit > 0 ? (lit < most_lit ? lit : most_lit) : Real(0));
    }

    /// The light of level_of(lit).
    Real light_between(Real lit) const { return light_at_level(level_of(lit)); }

    /// The light of a level that need not be whole, linear between the tables' levels. Levels below
    /// 0 or above 255 count as 0 or 255.
    Real light_at_level(Real level) const {
        const Real held = level > 0 ? level : Real(0);
        const auto below = static_cast<std::size_t>(held);
        if (below + 1 >= light_.size())
            return light_.back();
        return light_[below] +
               (held - static_cast<Real>(below)) * (light_[below + 1] - light_[below]);
    }

    /// The lights of all levels from 0 to 255.
    const std::array<Real, 256>& lights() const { return light_; }

    /// The level nearest to a light. The light lies between the lights of level - 1/2 and level +
    /// 1/2.
    std::uint32_t level(Real light) const {
        const Real held = light > 0 ? (light < 1 ? light : Real(1)) : Real(0);
        std::uint32_t found = first_[static_cast<std::size_t>(held * (guesses - 1))];
        while (found < 255 && held >= begins_[found + 1])
            ++found;
        return found;
    }

    /// The number of entries in the table from which level() takes its first guess. Near black a
    /// level spans 1 / (255 * 12.92) = 1 / 3295 of white, so a guess errs by less than two levels.
    static constexpr std::size_t guesses = 4096;

    /// For each level, the light at which it begins.
    const std::array<Real, 256>& begins() const { return begins_; }

private:
    std::array<Real, 256> light_{}, begins_{};
    std::array<std::uint8_t, guesses> first_{};
};

using linear_light = linear_light_of<float>;

/// The sRGB tables, in float and in double, each made at the first call of its function.
const linear_light& linear_light_tables();
const linear_light_of<double>& exact_light_tables();

} // namespace l3d_detail

#endif
