// SPDX-License-Identifier: MIT
// Rows of tallies.
#include "slices.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace stability {
namespace {

constexpr const char* columns =
    "first,arithmetic,within,weaker,no_bound,refused,violated,points,in_100_digits,pictures,"
    "worst_ratio,worst_case\n";

/// Cases of a row: the columns of outcomes. Nothing if the row is not whole.
struct row {
    std::uint64_t first = 0;
    bool is_whole = false, has_violations = false;

    explicit row(const std::string& text) {
        std::istringstream in(text);
        std::string field;
        int fields = 0;
        for (; std::getline(in, field, ','); ++fields) {
            if (fields == 0)
                first = std::strtoull(field.c_str(), nullptr, 10);
            has_violations |= fields == 6 && field != "0";
        }
        is_whole = fields == 1 + std::count(columns, columns + std::string(columns).size(), ',');
    }
};

} // namespace

/// A slice has as many rows as there are arithmetics. One that was stopped while it was written has
/// fewer, and is run again, as is one with a violation, which may be mended by now.
slice_file::slice_file(std::string file, const std::string& build) : file_(std::move(file)) {
    const std::string head = "# " + build + '\n' + columns;
    std::map<std::uint64_t, std::string> slices;
    std::map<std::uint64_t, std::size_t> rows;
    std::stringstream text;
    text << std::ifstream(file_, std::ios::binary).rdbuf();
    if (std::string all = text.str(); all.starts_with(head)) {
        text.str(all.substr(head.size()));
        for (std::string line; std::getline(text, line);)
            if (const row r(line); r.is_whole && !r.has_violations) {
                slices[r.first] += line + '\n';
                ++rows[r.first];
            }
    }
    std::ofstream out(file_, std::ios::binary);
    out << head;
    for (const auto& [first, lines] : slices)
        if (rows[first] == arithmetic_count) {
            out << lines;
            done_.insert(first);
        }
    if (!out.flush())
        throw std::runtime_error("cannot write " + file_);
}

void slice_file::add(std::uint64_t first, const suite_result& names,
                     const std::array<tally, arithmetic_count>& tallies) {
    std::ofstream out(file_, std::ios::binary | std::ios::app);
    for (std::size_t a = 0; a < arithmetic_count; ++a) {
        const tally& t = tallies[a];
        out << first << ',' << names.arithmetics[a];
        for (const std::int64_t n : t.outcomes)
            out << ',' << n;
        out << ',' << t.points << ',' << t.exactly << ',' << t.pictures << ',' << t.worst_ratio
            << ',' << t.worst << '\n';
    }
    if (!out.flush())
        throw std::runtime_error("cannot write " + file_);
    done_.insert(first);
}

} // namespace stability
