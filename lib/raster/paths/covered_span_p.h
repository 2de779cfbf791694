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

/// The coverage of columns first <= column < last in a row. The columns share one value, or have a
/// value each.
struct covered_run {
    std::int32_t row, first, last;
    std::int32_t value; ///< value of all columns; -1: each column has a value of its own
    std::size_t values; ///< index of the first column's value, if each column has its own
};

/// The coverage of columns first <= column < last in a row. Columns before `between`, and from
/// `beyond` on, have a value each; the columns in the middle share one value.
struct covered_span {
    std::int32_t row, first, between, beyond, last;
    std::int32_t value; ///< the value of each column in the middle
    /// Index of the span's first value. The values of columns before `between` come first. The
    /// values of columns from `beyond` on follow.
    std::size_t values;

    std::size_t values_before() const { return static_cast<std::size_t>(between - first); }

    /// Calls take(covered_run) for the span's runs from left to right, except empty ones.
    template <class Take> void visit_runs(const Take& take) const {
        if (first < between)
            take(covered_run{row, first, between, -1, values});
        if (between < beyond)
            take(covered_run{row, between, beyond, value, 0});
        if (beyond < last)
            take(covered_run{row, beyond, last, -1, values + values_before()});
    }
};

/// A list that keeps its memory when its items are removed, and does not set memory to 0 before
/// use.
template <class T> class kept_list {
public:
    void clear() { used_ = 0; }
    std::size_t size() const { return used_; }
    /// Makes room for `more` items after the last one. Lives: until the next call.
    T* room(std::size_t more) {
        if (room_.size() < used_ + more)
            room_.resize(std::max(2 * room_.size(), used_ + more));
        return room_.data() + used_;
    }
    /// Adds the first `more` items of the room to the list.
    void use(std::size_t more) { used_ += more; }
    void push(const T& last) {
        *room(1) = last;
        use(1);
    }
    /// Keeps only the first items of the list. Expects: the list has at least `first` items.
    void keep(std::size_t first) { used_ = first; }
    T& back() { return room_[used_ - 1]; }
    T& operator[](std::size_t i) { return room_[i]; }
    const T& operator[](std::size_t i) const { return room_[i]; }
    T* begin() { return room_.data(); }
    T* end() { return room_.data() + used_; }
    const T* data() const { return room_.data(); }
    std::span<const T> all() const { return {room_.data(), used_}; }

private:
    std::vector<T> room_;
    std::size_t used_ = 0;
};

} // namespace l3d_detail

#endif
