// SPDX-License-Identifier: MIT
// l3d_frame_writer: puts the frames of a program into files, as --output says.
#ifndef L3D_SYSTEM_FRAME_WRITER_H
#define L3D_SYSTEM_FRAME_WRITER_H

#include "base/public.h"
#include "tool_2d/image_file.h"
#include "tool_2d/pixels.h"

#include <string>
#include <string_view>

/// Writes the files that a name asks for. "" means nothing; name.png or .ppm the last frame;
/// name%04d.png every frame, numbered from 0 (as by %d, %5d, %05d);
///   -               every frame, as a stream of PPM pictures on the standard output.
/// Any other percent sign is a part of the name, and so is %%, as one.
class L3D_PUBLIC l3d_frame_writer {
public:
    /// Errors:  l3d_error: usage for a name that is none of these, failure if its folder is not
    ///          there; nothing is opened yet.
    ///          Only .png goes with alpha.
    explicit l3d_frame_writer(const std::string& name, l3d_alpha alpha = l3d_alpha::none);

    /// Takes a finished frame. Errors: l3d_error(failure) that names the file.
    void frame(const l3d_pixels& pixels);

    /// Takes no picture of this frame.
    void skip_frame() { ++next_number_; }

    /// Whether each frame has a file of its own.
    bool is_numbered() const { return kind_ == kind::numbered; }

    /// Whether a frame goes into the file of this name, or into its link's target.
    bool has_frame_in(const std::string& file) const;

    /// Whether this frame's file is there, whole and of that size. A disk may have lost a part of
    /// it, and a picture of another size is no frame of this sequence.
    bool has_frame(l3d_size size) const;

    /// Takes the last picture once more, when no other will follow. Errors: as frame().
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

#endif
