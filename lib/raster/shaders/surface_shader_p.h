// SPDX-License-Identifier: MIT
// The shaders: numbers interpolated over a polygon, and the pixel word made of them.
#ifndef L3D_RASTER_SHADERS_SURFACE_SHADER_P_H
#define L3D_RASTER_SHADERS_SURFACE_SHADER_P_H

#include "raster/surfaces/away_from_eye_p.h"
#include "raster/surfaces/wide_rows_p.h"
#include "raster/surface_part.h"
#include "raster/surface_rasterizer.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

// A shader is a class with
//   components         how many numbers are interpolated beside inv_w
//   begin_polygon(v)   told the corners
//   corner(v, out)     the numbers of one corner
//   word(values)       the pixel word for interpolated numbers
//
// If a shader's rows may be filled in lanes, in_lanes() says how lanes make the same words.

namespace l3d_detail {

using vector3 = std::array<float, 3>;

inline float dot(const vector3& a, const float* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The square of a normal's length as a divisor. It is bounded from below, so that a zero normal
/// has cosine 0 instead of NaN.
inline float safe_square(float square) {
    return square > FLT_MIN ? square : FLT_MIN;
}

/// The cosine of the angle between a unit vector and a vector of any length.
inline float cosine(const vector3& light, const float* normal) {
    const float square = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
    return dot(light, normal) / std::sqrt(safe_square(square));
}

/// The intensity 0.1 + 0.9 max(0, cosine). NaN gives 0.1.
inline float intensity(float cosine) {
    const float lit = cosine > 0.0f ? cosine : 0.0f;
    return 0.1f + 0.9f * (lit < 1.0f ? lit : 1.0f);
}

/// The word of a grey pixel. Expects: intensity in [0, 1].
inline std::uint32_t grey_word(float intensity) {
    const auto level = static_cast<std::uint32_t>(static_cast<int>(255.0f * intensity + 0.5f));
    return level * 0x010101u;
}

/// The intensity at a vertex, from its normal turned to the eye.
inline float vertex_intensity(const l3d_micro_vertex& vertex, const l3d_shading& shading) {
    const float lit = cosine(shading.light, vertex.normal);
    return intensity(away_from_eye(vertex, shading) > 0 ? -lit : lit);
}

/// The intensity of a polygon, from the sum of its corners' normals.
inline float polygon_intensity(std::span<const l3d_micro_vertex> corners,
                               const l3d_shading& shading) {
    vector3 sum{0, 0, 0};
    float away = 0;
    for (const l3d_micro_vertex& vertex : corners) {
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += vertex.normal[i];
        away += away_from_eye(vertex, shading);
    }
    const float lit = cosine(shading.light, sum.data());
    return intensity(away > 0 ? -lit : lit);
}

/// Writes the components of a vertex's normal to `out`, and then the normal's product with the ray
/// from the eye. The product is positive if the normal points away from the eye.
inline void put_normal(const l3d_micro_vertex& vertex, const l3d_shading& shading, float* out) {
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = vertex.normal[i];
    out[3] = away_from_eye(vertex, shading);
}

/// Mode `lambert`: grey from the interpolated normal, turned to the eye.
class lambert_shader {
public:
    static constexpr std::size_t components = 4;

    explicit lambert_shader(const l3d_shading& shading) : shading_(shading) {}

    void begin_polygon(std::span<const l3d_micro_vertex>) {}
    void corner(const l3d_micro_vertex& vertex, float* out) const {
        put_normal(vertex, shading_, out);
    }
    std::uint32_t word(const float* normal) const {
        const float lit = cosine(shading_.light, normal);
        return grey_word(intensity(normal[3] > 0 ? -lit : lit));
    }

    row_light in_lanes() const { return {.by = row_light::kind::normal, .light = shading_.light}; }

private:
    const l3d_shading& shading_;
};

/// Mode `gouraud`: grey interpolated from the corners' greys.
class gouraud_shader {
public:
    static constexpr std::size_t components = 1;

    explicit gouraud_shader(const l3d_shading& shading) : shading_(shading) {}

    void begin_polygon(std::span<const l3d_micro_vertex> corners) {
        darkest_ = 1;
        brightest_ = 0;
        for (const l3d_micro_vertex& vertex : corners) {
            darkest_ = std::min(darkest_, grey(vertex));
            brightest_ = std::max(brightest_, grey(vertex));
        }
    }
    void corner(const l3d_micro_vertex& vertex, float* out) const { *out = grey(vertex); }

    /// The pixel word of an interpolated intensity. If the intensities at four corners do not lie
    /// in one plane, the plane that stands for them exceeds the corners' intensities near a corner.
    /// So the intensity is clamped to the corners' range.
    std::uint32_t word(const float* value) const {
        const float least = *value > darkest_ ? *value : darkest_;
        return grey_word(least < brightest_ ? least : brightest_);
    }

    row_light in_lanes() const {
        return {.by = row_light::kind::held, .darkest = darkest_, .brightest = brightest_};
    }

private:
    float grey(const l3d_micro_vertex& vertex) const { return vertex_intensity(vertex, shading_); }

    const l3d_shading& shading_;
    float darkest_ = 0, brightest_ = 1;
};

/// Mode `flat`: one grey for the whole polygon, from the sum of its corners' normals.
class flat_shader {
public:
    static constexpr std::size_t components = 0;

    explicit flat_shader(const l3d_shading& shading) : shading_(shading) {}

    void begin_polygon(std::span<const l3d_micro_vertex> corners) {
        word_ = grey_word(polygon_intensity(corners, shading_));
    }
    void corner(const l3d_micro_vertex&, float*) const {}
    std::uint32_t word(const float*) const { return word_; }

    row_light in_lanes() const { return {.word = word_}; }

private:
    const l3d_shading& shading_;
    std::uint32_t word_ = 0;
};

/// Mode `normals`: the interpolated unit normal, turned to the eye, as a colour.
class normals_shader {
public:
    static constexpr std::size_t components = 4;

    explicit normals_shader(const l3d_shading& shading) : shading_(shading) {}

    void begin_polygon(std::span<const l3d_micro_vertex>) {}
    void corner(const l3d_micro_vertex& vertex, float* out) const {
        put_normal(vertex, shading_, out);
    }
    std::uint32_t word(const float* normal) const {
        std::uint32_t word = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            vector3 axis{0, 0, 0};
            axis[i] = normal[3] > 0 ? -1.0f : 1.0f;
            word = word << 8 | level(cosine(axis, normal));
        }
        return word;
    }

private:
    static std::uint32_t level(float component) {
        const float least = component > -1.0f ? component : -1.0f;
        const float inside = least < 1.0f ? least : 1.0f;
        return static_cast<std::uint32_t>(static_cast<int>(127.5f * (inside + 1.0f) + 0.5f));
    }

    const l3d_shading& shading_;
};

/// Gives all pixels of a polygon the same word, as mode `error` does.
class constant_shader {
public:
    static constexpr std::size_t components = 0;

    explicit constant_shader(std::uint32_t word) : word_(word) {}

    void begin_polygon(std::span<const l3d_micro_vertex>) {}
    void corner(const l3d_micro_vertex&, float*) const {}
    std::uint32_t word(const float*) const { return word_; }

private:
    std::uint32_t word_;
};

} // namespace l3d_detail

#endif
