// SPDX-License-Identifier: MIT
// Files of a program's frames: l3d_frame_writer for --output, reports and screenshots; and the
// settings that say which frames are made.
#ifndef L3D_SYSTEM_FRAME_WRITER_H
#define L3D_SYSTEM_FRAME_WRITER_H

#include "base/public.h"
#include "geom/nurbs_surface.h"
#include "tool_2d/image.h"
#include "tool_2d/pixels.h"

#include <fstream>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

/// Writes the frames of a program to files. Their name says which frames:
/// - "" writes nothing;
/// - name.png or name.ppm gets the last frame;
/// - name%04d.png gives every frame a file, numbered from 0 (also %d, %5d, %05d);
/// - "-" gives every frame, as a stream of PPM pictures on the standard output.
///
/// Any other percent sign is a part of the name, and %% stands for one.
class L3D_PUBLIC l3d_frame_writer {
public:
    /// Opens nothing yet.
    /// Errors:  l3d_error: usage for a name of none of these kinds, and with alpha for any name but
    ///          .png; failure for a missing folder.
    explicit l3d_frame_writer(const std::string& name, l3d_alpha alpha = l3d_alpha::none);

    /// Takes a finished frame. Errors: l3d_error(failure) that names the file.
    void frame(const l3d_pixels& pixels);

    /// Counts the next frame, whose picture is not wanted.
    void skip_frame() { ++next_number_; }

    /// Whether each frame has a file of its own.
    bool is_numbered() const { return kind_ == kind::numbered; }

    /// Whether a frame goes into the file of this name. If the name is a link, the file is the one
    /// that it leads to.
    bool has_frame_in(const std::string& file) const;

    /// Whether the next frame's file is there, whole and of this size. A disk may have lost a part
    /// of the file, and a picture of another size is no frame of this sequence.
    bool has_frame(l3d_size size) const;

    /// Writes the last frame, if the name asks for that alone. Call it when no other frame will
    /// follow.
    /// Errors:  as frame().
    void finish(const l3d_pixels& pixels);

private:
    enum class kind { nothing, single, numbered, stream };

    std::string file_name(int number) const;
    void read_pattern(std::string_view name);

    l3d_alpha alpha_ = l3d_alpha::none;
    kind kind_ = kind::nothing;
    std::string before_, after_; ///< the name around its number; without one, `before_` is all
    std::size_t digits_ = 0;     ///< the number's least width
    char fill_ = ' ';
    int next_number_ = 0;
};

/// Writes a report line by line, so that a program that is stopped leaves whole lines behind.
class L3D_PUBLIC l3d_report_writer {
public:
    /// Opens the file of this name. If the name is -, lines go to the standard output: earlier
    /// output stays, and the output of others may come in between.
    /// Errors: l3d_error(failure) that names the file and the system's reason.
    explicit l3d_report_writer(const std::string& path);
    l3d_report_writer(const l3d_report_writer&) = delete;
    l3d_report_writer& operator=(const l3d_report_writer&) = delete;

    /// Writes a line. Errors: as the constructor.
    void add(const std::string& line);

private:
    [[noreturn]] void refuse() const;

    std::string path_;
    std::ofstream file_;
    std::ostream* out_; ///< the file or the standard output
};

/// The settings with which a dispatcher is made.
struct L3D_PUBLIC l3d_frame_settings {
    /// The number of frames. 0 means one frame without a display; with a window, frames go on until
    /// the pipeline is done.
    int frames = 0;

    /// The first frame whose picture is wanted. For frames before it, only the time passes.
    /// Expects: less than `frames`, or 0.
    int first_frame = 0;

    /// Whether frames whose file is there already are left out, too.
    bool resume = false;

    /// Frames per second; 0: as many as possible; empty: the screen's choice.
    std::optional<double> fps;

    /// Whether update_event gets 1 / fps instead of the measured time, which makes the pictures of
    /// a window repeatable. Without a display, update_event always gets this.
    bool fixed_step = false;

    /// A name for l3d_frame_writer; empty: nothing is written.
    std::string output;

    /// Whether the written files have alpha.
    l3d_alpha alpha = l3d_alpha::none;

    /// The text that lines on stderr begin with.
    std::string program = "l3d";

    /// The time from frame to frame where it is not measured, in seconds. It is the same for every
    /// screen, so that all screens show the same pictures.
    double step() const { return 1 / (fps && *fps > 0 ? *fps : 60); }
};

/// Writes a picture as l3d-0001.png, or as the first such name that is free. An existing file is
/// never replaced. Returns a line that says where the file is, or why there is none: a full disk
/// must not end a program.
L3D_PUBLIC std::string l3d_save_screenshot(const l3d_pixels& pixels);

/// Writes surfaces as l3d-0001.obj, or as the first such name that is free
/// (l3d_write_obj_surfaces).
/// Returns a line as l3d_save_screenshot does.
L3D_PUBLIC std::string l3d_save_surfaces(std::span<const l3d_nurbs_surface> surfaces);

#endif
