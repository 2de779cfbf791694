// SPDX-License-Identifier: MIT
// l3d_frame_writer: names, numbers and streams.
#include "system/frame_writer.h"

#include "system/number_text.h"
#include "system/output_names_p.h"
#include "tool_2d/error.h"
#include "tool_2d/image_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string_view>

namespace {

constexpr const char* no_transparency =
    "cannot hold the transparent pixels of --background none; a .png can";

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

[[noreturn]] void refuse(const std::string& name, const std::string& reason) {
    throw l3d_error(l3d_exit::usage, "--output: '" + name + "' " + reason);
}

void check_ending(const std::string& name, l3d_alpha alpha) {
    const std::string ending = l3d_detail::ending_of(name);
    if (ending != ".png" && ending != ".ppm")
        refuse(name, "ends neither in .png nor in .ppm, nor is it - for a stream");
    if (ending != ".png" && alpha == l3d_alpha::transparency)
        refuse(name, no_transparency);
}

} // namespace

l3d_frame_writer::l3d_frame_writer(const std::string& name, l3d_alpha alpha)
    : name_(name), alpha_(alpha) {
    if (name.empty())
        return;
    if (name == "-") {
        if (alpha == l3d_alpha::transparency)
            refuse(name, no_transparency);
        kind_ = kind::stream;
        return;
    }
    check_ending(name, alpha);
    const std::size_t percent = name.find('%');
    kind_ = percent == std::string::npos ? kind::single : kind::numbered;
    if (kind_ == kind::numbered)
        read_number_field(percent);
    l3d_detail::check_folder("--output", name, kind_ == kind::numbered ? numbered_name(0) : name);
}

void l3d_frame_writer::read_number_field(std::size_t percent) {
    std::size_t at = percent + 1;
    if (at < name_.size() && name_[at] == '0') {
        fill_ = '0';
        ++at;
    }
    // One digit is enough: 2^31 frames have ten.
    if (at < name_.size() && is_digit(name_[at]))
        digits_ = static_cast<std::size_t>(name_[at++] - '0');
    if (at >= name_.size() || name_[at] != 'd' || name_.find('%', at) != std::string::npos)
        refuse(name_, "needs exactly one number field, as in frame%04d.png, and no other %");
    before_ = name_.substr(0, percent);
    after_ = name_.substr(at + 1);
}

std::string l3d_frame_writer::numbered_name(int number) const {
    std::string digits = std::to_string(number);
    if (digits.size() < digits_)
        digits.insert(0, digits_ - digits.size(), fill_);
    return before_ + digits + after_;
}

/// The number of that frame stands where the field does.
bool l3d_frame_writer::has_frame_in(const std::string& file) const {
    const std::string there = l3d_detail::place_of(file).filename().string();
    const std::size_t begin = std::filesystem::path(before_).filename().string().size();
    const std::size_t rest = begin + after_.size();
    if (!is_numbered() || there.size() <= rest)
        return false;
    std::string_view digits = std::string_view(there).substr(begin, there.size() - rest);
    digits.remove_prefix(std::min(digits.find_first_not_of(' '), digits.size()));
    int number = 0;
    return l3d_read_number(digits, number) && number >= 0 &&
           l3d_detail::mean_one_file(numbered_name(number), file);
}

bool l3d_frame_writer::has_frame(l3d_size size) const {
    return is_numbered() && l3d_is_whole_image(numbered_name(next_number_), size);
}

void l3d_frame_writer::frame(const l3d_pixels& pixels) {
    if (kind_ == kind::numbered) {
        l3d_write_image(numbered_name(next_number_), pixels, alpha_);
        ++next_number_;
    } else if (kind_ == kind::stream) {
        l3d_write_ppm(stdout, "standard output", pixels);
    }
}

void l3d_frame_writer::finish(const l3d_pixels& pixels) {
    if (kind_ == kind::single)
        l3d_write_image(name_, pixels, alpha_);
}
