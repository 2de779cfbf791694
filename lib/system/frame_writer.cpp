// SPDX-License-Identifier: MIT
// l3d_frame_writer: writes frames to names, numbered names and streams. New files get free names.
#include "system/frame_writer.h"

#include "base/error.h"
#include "base/formatted_p.h"
#include "base/printable_p.h"
#include "geom/files/model_file.h"
#include "system/reason_p.h"
#include "system/options/number_text.h"
#include "system/options/output_names_p.h"
#include "tool_2d/image.h"
#include "tool_2d/output_file_p.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string_view>

namespace {

constexpr const char* no_transparency =
    "cannot hold the transparent pixels of --background none; a .png can";

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

/// The number field of printf at the beginning of a text, such as %d, %04d or %-4ld; empty if the
/// text begins otherwise.
std::string_view field_at_front(std::string_view text) {
    const std::size_t end = text.find_first_not_of("0123456789+-l", 1);
    return text.starts_with('%') && end != text.npos && text[end] == 'd' ? text.substr(0, end + 1)
                                                                         : std::string_view();
}

/// Lets `write` make a new file: l3d-0001 with this ending, or the next number for which no file
/// exists. Returns a line for the user.
std::string save_as_new(const std::string& ending,
                        const std::function<void(const std::string& name)>& write) {
    std::error_code unknown; // on an error, the user is told the name alone
    const std::filesystem::path folder = std::filesystem::current_path(unknown);
    constexpr int most = 9999;
    for (int number = 1; number <= most; ++number) {
        const std::string name = l3d_detail::formatted("l3d-%04d", number) + ending;
        // A name also counts as taken if it is that of a link that leads nowhere.
        std::error_code problem;
        const auto type = std::filesystem::symlink_status(name, problem).type();
        if (type == std::filesystem::file_type::none)
            return "not saved: " + problem.message();
        if (type != std::filesystem::file_type::not_found)
            continue;
        try {
            write(name);
        } catch (const std::exception& error) {
            return l3d_detail::reason_of(error);
        }
        return "saved " + l3d_detail::printable((folder / name).string());
    }
    return "not saved: l3d-0001" + ending + " to l3d-9999" + ending + " exist";
}

} // namespace

l3d_frame_writer::l3d_frame_writer(const std::string& name, l3d_alpha alpha) : alpha_(alpha) {
    if (name.empty())
        return;
    if (name == "-") {
        if (alpha == l3d_alpha::transparency)
            refuse(name, no_transparency);
        kind_ = kind::stream;
        return;
    }
    check_ending(name, alpha);
    kind_ = kind::single;
    read_pattern(name);
    l3d_detail::check_folder("--output", name, file_name(0));
}

/// Reads a name of files, which may have one number field. A percent sign stands for itself unless
/// it begins a number field, so most names need no double percent sign.
void l3d_frame_writer::read_pattern(std::string_view name) {
    for (std::size_t at = 0; at < name.size();) {
        const std::string_view rest = name.substr(at), field = field_at_front(rest);
        if (field.empty()) {
            (kind_ == kind::numbered ? after_ : before_) += rest.front();
            at += rest.starts_with("%%") ? 2 : 1;
            continue;
        }
        if (kind_ == kind::numbered)
            refuse(std::string(name), "has a second number field; %% is a percent sign");
        constexpr std::size_t widest = 2; // digits of the width, as 2^31 frames have ten
        const std::string_view width = field.substr(1, field.size() - 2);
        if (!width.empty() && (width.size() > widest || !l3d_read_number(width, digits_)))
            refuse(std::string(name), "has the number field " + std::string(field) +
                                          ", which is none of %d, %4d and %04d; %% is a percent "
                                          "sign");
        kind_ = kind::numbered;
        fill_ = width.starts_with('0') ? '0' : ' ';
        at += field.size();
    }
}

std::string l3d_frame_writer::file_name(int number) const {
    if (kind_ == kind::single)
        return before_;
    std::string digits = std::to_string(number);
    if (digits.size() < digits_)
        digits.insert(0, digits_ - digits.size(), fill_);
    return before_ + digits + after_;
}

/// Whether some frame is written to `file`. A name without a number field is the name of the only
/// file. Otherwise, a frame's file has a number in place of the number field.
bool l3d_frame_writer::has_frame_in(const std::string& file) const {
    if (kind_ == kind::single)
        return l3d_detail::mean_one_file(before_, file);
    const std::string there = l3d_detail::place_of(file).filename().string();
    const std::size_t begin = std::filesystem::path(before_).filename().string().size();
    const std::size_t rest = begin + after_.size();
    if (!is_numbered() || there.size() <= rest)
        return false;
    std::string_view digits = std::string_view(there).substr(begin, there.size() - rest);
    digits.remove_prefix(std::min(digits.find_first_not_of(' '), digits.size()));
    int number = 0;
    return l3d_read_number(digits, number) && number >= 0 &&
           l3d_detail::mean_one_file(file_name(number), file);
}

bool l3d_frame_writer::has_frame(l3d_size size) const {
    return is_numbered() && l3d_is_whole_image(file_name(next_number_), size);
}

void l3d_frame_writer::frame(const l3d_pixels& pixels) {
    if (kind_ == kind::numbered) {
        l3d_write_image(file_name(next_number_), pixels, alpha_);
        ++next_number_;
    } else if (kind_ == kind::stream) {
        l3d_write_ppm(stdout, "standard output", pixels);
    }
}

void l3d_frame_writer::finish(const l3d_pixels& pixels) {
    if (kind_ == kind::single)
        l3d_write_image(before_, pixels, alpha_);
}

l3d_report_writer::l3d_report_writer(const std::string& path) : path_(path), out_(&file_) {
    if (path == "-") {
        path_ = "standard output";
        out_ = &std::cout;
        return;
    }
    errno = 0;
    file_.open(path, std::ios::binary);
    if (!file_)
        refuse();
}

void l3d_report_writer::add(const std::string& line) {
    errno = 0;
    if (!(*out_ << line << std::endl))
        refuse();
}

void l3d_report_writer::refuse() const {
    throw l3d_error(l3d_exit::failure, path_ + ": " + std::strerror(errno ? errno : EIO));
}

std::string l3d_save_screenshot(const l3d_pixels& pixels) {
    return save_as_new(".png", [&](const std::string& name) { l3d_write_png(name, pixels); });
}

std::string l3d_save_surfaces(std::span<const l3d_nurbs_surface> surfaces) {
    return save_as_new(".obj", [&](const std::string& name) {
        const std::string text = l3d_write_obj_surfaces(surfaces);
        l3d_detail::output_file file(name);
        if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size())
            l3d_detail::throw_write_error(name);
        file.commit();
    });
}
