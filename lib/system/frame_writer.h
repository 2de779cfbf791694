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

/// Writes the frames of a program to files. The name of --output says which frames are written.
/// - "" writes nothing.
/// - name.png or name.ppm gets the last frame.
/// - name%04d.png gives every frame a file, numbered from 0 (also %d, %5d, %05d).
/// - "-" gives every frame, as a stream of PPM pictures on the standard output.
///
/// Any other percent sign is a part of the name, and %% stands for one percent sign.
class L3D_PUBLIC l3d_frame_writer {
public:
    /// Takes the name of --output, and opens no file yet.
    /// Errors:  l3d_error: usage for a name that is none of the kinds above, or if `alpha` is
    ///          transparency and the name does not end in .png; failure for a missing folder.
    explicit l3d_frame_writer(const std::string& name, l3d_alpha alpha = l3d_alpha::none);

    /// Takes a finished frame, and writes it if the name asks for every frame.
    /// Errors: l3d_error(failure) that names the file.
    void frame(const l3d_pixels& pixels);

    /// Counts a frame whose picture is not wanted, so that the next frame gets the next number.
    void skip_frame() { ++next_number_; }

    /// Whether each frame has a file of its own.
    bool is_numbered() const { return kind_ == kind::numbered; }

    /// Whether some frame is written to the file of this name. A link stands for the file that it
    /// leads to.
    bool has_frame_in(const std::string& file) const;

    /// Whether the next frame's file exists, is whole, and has a picture of this size. A program
    /// that was stopped may have left a part of a file. A picture of another size is no frame of
    /// this sequence.
    bool has_frame(l3d_size size) const;

    /// Writes `pixels`, the last frame, if the name asks for the last frame alone. Call it when no
    /// other frame will follow.
    /// Errors:  as frame().
    void finish(const l3d_pixels& pixels);

private:
    enum class kind { nothing, single, numbered, stream };

    std::string file_name(int number) const;
    void read_pattern(std::string_view name);

    l3d_alpha alpha_ = l3d_alpha::none;
    kind kind_ = kind::nothing;
    /// The parts of the name before and after the frame's number. A name without a number is all in
    /// `before_`.
    std::string before_, after_;
    std::size_t digits_ = 0; ///< least number of digits of the number
    char fill_ = ' ';
    int next_number_ = 0;
};

/// Writes a report line by line, so that a program that is stopped leaves only whole lines behind.
class L3D_PUBLIC l3d_report_writer {
public:
    /// Opens the file of this name, and empties it. If the name is -, lines go to the standard
    /// output, where other output may stand before the lines and between them.
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
    std::ostream* out_; ///< the stream for lines: file_ or the standard output
};

/// The settings with which a dispatcher is made. They tell which frames to make, when to make
/// frames, and where to write pictures.
struct L3D_PUBLIC l3d_frame_settings {
    /// The number of frames. 0 means one frame without a display; with a window, frames go on until
    /// the pipeline is done.
    int frames = 0;

    /// The first frame whose picture is wanted. During earlier frames, only time passes.
    /// Expects: less than `frames`, or 0.
    int first_frame = 0;

    /// Whether a frame is also left out if its file exists already (l3d_frame_writer::has_frame).
    bool resume = false;

    /// Frames per second. 0 stands for as many as possible; nothing for the screen's choice.
    std::optional<double> fps;

    /// Whether update_event gets step() instead of the measured time, so that a window shows the
    /// same pictures in each run. Without a display, update_event always gets step().
    bool fixed_step = false;

    /// The name of files for l3d_frame_writer; empty if nothing is to be written.
    std::string output;

    /// Whether written files hold transparency.
    l3d_alpha alpha = l3d_alpha::none;

    /// The program's name, with which lines on stderr begin.
    std::string program = "l3d";

    /// The time from frame to frame if it is not measured, in seconds: 1 / fps, or 1/60 if fps is 0
    /// or nothing. It does not depend on the screen, so that all screens show the same pictures.
    double step() const { return 1 / (fps && *fps > 0 ? *fps : 60); }
};

/// Writes a picture to a new file in the current folder: l3d-0001.png, or the next number for which
/// no file exists. It never replaces a file. Returns a line for the user that says where the file
/// is. If writing fails, the line says why, and nothing is thrown: a full disk must not end a
/// program.
L3D_PUBLIC std::string l3d_save_screenshot(const l3d_pixels& pixels);

/// Writes surfaces to a new file in the current folder: l3d-0001.obj, or the next number for which
/// no file exists (l3d_write_obj_surfaces). Returns a line for the user, as l3d_save_screenshot
/// does.
L3D_PUBLIC std::string l3d_save_surfaces(std::span<const l3d_nurbs_surface> surfaces);

#endif
