// SPDX-License-Identifier: MIT
// cad_plugin: the interface of the plug-in for STEP and IGES, and the records that it returns.
#ifndef L3D_GEOM_FILES_CAD_PLUGIN_P_H
#define L3D_GEOM_FILES_CAD_PLUGIN_P_H

#include "geom/files/plugin_p.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace l3d_detail {

/// The version of cad_plugin and of its records.
inline constexpr std::uint32_t cad_version = 2;

/// The interface of the plug-in libl3d_cad.so, which reads STEP and IGES files.
struct cad_plugin : plugin_interface {
    /// Reads the text of a STEP or an IGES file, and passes its surfaces as records to take(to,
    /// bytes, size), piece by piece. Lengths are in millimetres. A few times a second, read() calls
    /// tell(to, share) with the share of the work that is done. If tell() returns 0, read() stops.
    ///
    /// Shape:  records as cad_record lists them: the kind's number, then the record's fields. Texts
    ///         and lists begin with their length.
    /// Errors: returns 0, with one line in `why`, which has room for `room` bytes with the zero at
    ///         its end.
    int (*read)(const char* text, std::size_t size, int is_iges, void* to,
                void (*take)(void* to, const void* bytes, std::size_t size),
                int (*tell)(void* to, double share), char* why, std::size_t room);
};

/// The kinds of records. A curve is its degree, knots, and points of x, y, z and weight.
enum class cad_record : std::uint64_t {
    end,      ///< the last record of the file's content; without it, the records were cut off
    effort,   ///< seconds, bytes: time and memory of reading; follows `end`
    note,     ///< text: a remark on something left out or changed
    material, ///< colour 0xRRGGBB, opacity: for faces and curves that follow
    of_place, ///< the faces and curves that follow take the material of their shape's `place`
    shape,    ///< the faces and curves that follow are a shape; shapes count from 0
    /// Shape, name, material as `material` has it, and three rows of a 3 by 4 matrix: a place where
    /// the shape stands.
    place,
    edge,  ///< tolerance, curve: an edge; edges count from 0
    curve, ///< curve: a line in space that bounds no face
    /// Degree along u, knots, degree along v, knots, points of x, y, z and weight, u fastest;
    /// number of loops. Each loop is the number of its curves, and the curves. A curve of a loop
    /// begins with the number of its edge or l3d_no_edge, and the edge's parameters at the curve's
    /// ends. Then comes a curve record whose points are u, v, 0 and weight.
    face,
};

/// Writes records, for the plug-in.
class cad_writer {
public:
    /// Begins a record.
    void begin(cad_record kind) { count(static_cast<std::uint64_t>(kind)); }
    void count(std::uint64_t value) { append(&value, sizeof value); }
    void number(double value) { append(&value, sizeof value); }
    void numbers(const std::vector<double>& values) {
        count(values.size());
        append(values.data(), values.size() * sizeof(double));
    }
    void text(std::string_view value) {
        count(value.size());
        append(value.data(), value.size());
    }

    /// The bytes of the records so far.
    std::string bytes;

private:
    void append(const void* from, std::size_t size) {
        bytes.append(static_cast<const char*>(from), size);
    }
};

/// Reads the fields that cad_writer wrote, for the library. Beyond the end of the bytes, numbers
/// are 0 and lists empty.
class cad_reader {
public:
    explicit cad_reader(std::string_view bytes) : rest_(bytes) {}

    std::uint64_t count() { return value<std::uint64_t>(); }
    double number() { return value<double>(); }
    std::vector<double> numbers() {
        const std::uint64_t size = count();
        std::vector<double> result;
        if (size <= rest_.size() / sizeof(double)) {
            result.resize(size);
            std::memcpy(result.data(), rest_.data(), size * sizeof(double));
            rest_.remove_prefix(size * sizeof(double));
        } else
            rest_ = {};
        return result;
    }
    std::string text() {
        const std::uint64_t size = count();
        std::string result(rest_.substr(0, size));
        rest_.remove_prefix(result.size());
        return result;
    }
    bool is_over() const { return rest_.empty(); }

private:
    template <class T> T value() {
        T result{};
        if (rest_.size() >= sizeof result) {
            std::memcpy(&result, rest_.data(), sizeof result);
            rest_.remove_prefix(sizeof result);
        } else
            rest_ = {};
        return result;
    }

    std::string_view rest_;
};

} // namespace l3d_detail

#endif
