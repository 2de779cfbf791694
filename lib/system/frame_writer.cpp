// SPDX-License-Identifier: MIT
// l3d_frame_writer: names, numbers and streams.
#include "system/frame_writer.h"

#include "system/output_names_p.h"
#include "tool_2d/error.h"
#include "tool_2d/image_file.h"

#include <cstdio>

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
    l3d_detail::check_folder("--output", name, kind_ == kind::numbered ? numbered_name() : name);
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

std::string l3d_frame_writer::numbered_name() const {
    std::string number = std::to_string(next_number_);
    if (number.size() < digits_)
        number.insert(0, digits_ - number.size(), fill_);
    return before_ + number + after_;
}

bool l3d_frame_writer::has_frame(l3d_size size) const {
    return is_numbered() && l3d_is_whole_image(numbered_name(), size);
}

void l3d_frame_writer::frame(const l3d_pixels& pixels) {
    if (kind_ == kind::numbered) {
        l3d_write_image(numbered_name(), pixels, alpha_);
        ++next_number_;
    } else if (kind_ == kind::stream) {
        l3d_write_ppm(stdout, "standard output", pixels);
    }
}

void l3d_frame_writer::finish(const l3d_pixels& pixels) {
    if (kind_ == kind::single)
        l3d_write_image(name_, pixels, alpha_);
}
