// SPDX-License-Identifier: MIT
// covered_span: the coverage of a path in a row; kept_list, which collects spans.
#ifndef L3D_RASTER_PATHS_COVERED_SPAN_P_H
#define L3D_RASTER_PATHS_COVERED_SPAN_P_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Columns first <= column < last of a row, all of which have one value, or each its own.
struct covered_run {
    std::int32_t row, first, last;
    std::int32_t value; ///< value of all columns; -1: each has its own
    std::size_t values; ///< the place of the first column's value
};

/// Columns first <= column < last of a row, and the covered share of each: a value for each one
/// before `between` and from `beyond` on, and the same for all in the middle.
struct covered_span {
    std::int32_t row, first, between, beyond, last;
    std::int32_t value; ///< value of the middle
    std::size_t values; ///< the place of the first value; those from `beyond` on follow

    std::size_t values_before() const { return static_cast<std::size_t>(between - first); }

    /// Calls take(covered_run) for the span's runs that have columns, from left to right.
    template <class Take> void visit_runs(const Take& take) const {
        if (first < between)
            take(covered_run{row, first, between, -1, values});
        if (between < beyond)
            take(covered_run{row, between, beyond, value, 0});
        if (beyond < last)
            take(covered_run{row, beyond, last, -1, values + values_before()});
    }
};

/// A list that keeps its memory, and does not set it to 0 before use.
template <class T> class kept_list {
public:
    void clear() { used_ = 0; }
    std::size_t size() const { return used_; }
    /// Room for `more` items behind the last one. Lives: until the next call.
    T* room(std::size_t more) {
        if (room_.size() < used_ + more)
            room_.resize(std::max(2 * room_.size(), used_ + more));
        return room_.data() + used_;
    }
    /// Makes `more` items of the room part of the list.
    void use(std::size_t more) { used_ += more; }
    void push(const T& last) {
        *room(1) = last;
        use(1);
    }
    /// Keeps only the first items. Expects: the list has as many.
    void keep(std::size_t first) { used_ = first; }
    T& back() { return room_[used_ - 1]; }
    const T& operator[](std::size_t i) const { return room_[i]; }
    const T* data() const { return room_.data(); }
    std::span<const T> all() const { return {room_.data(), used_}; }

private:
    std::vector<T> room_;
    std::size_t used_ = 0;
};

} // namespace l3d_detail

#endif
