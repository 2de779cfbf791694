// SPDX-License-Identifier: MIT
// Pictures: their pixels as arrays, as files and in notebooks.
#include "docs.h"
#include "types.h"

#include <l3d/error.h>

#include <bit>
#include <fstream>

namespace python {

namespace {

reference load(arguments& a) {
    a.are("Picture.load", "file |");
    const std::string file = path_of(a.need("file"), a.what("file"));
    try {
        auto image = std::make_shared<l3d_image>(l3d_read_image(file));
        bool is_transparent = false;
        const l3d_pixels pixels = image->pixels();
        for (int y = 0; y < pixels.height && !is_transparent; ++y)
            for (const std::uint32_t word : pixels.row(y))
                is_transparent = is_transparent || word >> 24 != 0;
        return made(picture_of(std::move(image), is_transparent));
    } catch (const l3d_error& error) {
        throw file_failure{file, error.what(), !std::ifstream(file).good()};
    }
}

/// Pictures of one channel are grey, and a fourth one is alpha.
reference from_array(arguments& a) {
    a.are("Picture.from_array", "pixels |");
    const number_array array(a.need("pixels"), a.what("pixels"));
    const auto& shape = array.shape();
    const std::size_t channels = shape.size() == 3 ? shape[2] : 1;
    if (shape.size() < 2 || shape.size() > 3 || (channels != 1 && channels != 3 && channels != 4))
        throw value_error(a.what("pixels") + ": the shape is height x width, or height x width x 3 "
                                             "or 4");
    for (std::size_t i = 0; i < 2; ++i)
        if (shape[i] < 1 || shape[i] > l3d_largest_side)
            throw value_error(a.what("pixels") + ": sides are from 1 to " +
                              std::to_string(l3d_largest_side) + " pixels");
    const l3d_size size{static_cast<int>(shape[1]), static_cast<int>(shape[0])};
    const std::vector<std::uint32_t> levels = array.indices(255);
    auto image = std::make_shared<l3d_image>(size, l3d_padded_stride(size.width));
    const std::uint32_t* level = levels.data();
    for (int y = 0; y < size.height; ++y)
        for (std::uint32_t& word : image->pixels().row(y)) {
            word = channels == 1 ? level[0] * 0x010101 : level[0] << 16 | level[1] << 8 | level[2];
            if (channels == 4)
                word |= (255 - level[3]) << 24;
            level += channels;
        }
    return made(picture_of(std::move(image), channels == 4));
}

reference save(picture& self, arguments& a) {
    a.are("Picture.save", "file |");
    save_picture(self.image->pixels(), self.is_transparent,
                 path_of(a.need("file"), a.what("file")));
    return reference::none();
}

reference png(picture& self, arguments& a) {
    a.are("Picture._repr_png_", "");
    return png_of(self.image->pixels(), self.is_transparent);
}

reference size(const picture& self) {
    return sides(self.image->size());
}

reference words(const picture& self) {
    return memory_of(words_of(self.image));
}

reference report(const picture& self) {
    if (!self.report)
        return dictionary().get();
    const reference json = reference::taken(PyImport_ImportModule("json"));
    return reference::taken(PyObject_CallMethod(json.get(), "loads", "s", self.report().c_str()));
}

reference map_of(const picture& self, const std::shared_ptr<const std::vector<float>>& numbers) {
    if (!numbers)
        return reference::none();
    const auto side = [](int n) { return static_cast<std::size_t>(n); };
    return memory_of(
        array_view::of(numbers, numbers->data(),
                       {side(self.image->size().height), side(self.image->size().width)}));
}
reference depth(const picture& self) {
    return map_of(self, self.depth);
}
reference doubts(const picture& self) {
    return map_of(self, self.doubts);
}

int export_pixels(PyObject* self, Py_buffer* buffer, int flags) noexcept {
    return export_view(value_of<picture>(self).rgb, self, buffer, flags);
}

reference picture_text(const picture& self) {
    return text("<l3d.Picture: " + std::to_string(self.image->size().width) + " x " +
                std::to_string(self.image->size().height) + ">");
}

} // namespace

static_assert(std::endian::native == std::endian::little); // words are bytes blue, green, red

picture picture_of(std::shared_ptr<l3d_image> image, bool is_transparent) {
    picture result{std::move(image), is_transparent};
    result.rgb = words_of(result.image);
    // Red is the third byte of a word, and blue the first.
    result.rgb.data = static_cast<const std::uint8_t*>(result.rgb.data) + 2;
    result.rgb.format = "B";
    result.rgb.item = 1;
    result.rgb.shape.push_back(3);
    result.rgb.strides.push_back(-1);
    return result;
}

array_view words_of(const std::shared_ptr<l3d_image>& image) {
    const l3d_pixels pixels = image->pixels();
    array_view result{image, pixels.words, "I", sizeof(std::uint32_t), {}, {}};
    result.shape = {pixels.height, pixels.width};
    result.strides = {pixels.stride * static_cast<Py_ssize_t>(sizeof(std::uint32_t)),
                      sizeof(std::uint32_t)};
    return result;
}

reference png_of(const l3d_pixels& pixels, bool is_transparent) {
    std::string bytes;
    {
        const unlocked while_packing;
        bytes = l3d_encoded_png(pixels, is_transparent ? l3d_alpha::transparency : l3d_alpha::none);
    }
    return reference::taken(
        PyBytes_FromStringAndSize(bytes.data(), static_cast<Py_ssize_t>(bytes.size())));
}

void save_picture(const l3d_pixels& pixels, bool is_transparent, const std::string& path) {
    try {
        const unlocked while_writing;
        l3d_write_image(path, pixels, is_transparent ? l3d_alpha::transparency : l3d_alpha::none);
    } catch (const l3d_error& error) {
        throw file_failure{path, error.what(), error.code() == l3d_exit::failure};
    }
}

PyTypeObject* add_picture_type(PyObject* module) {
    using p = picture;
    static PyMethodDef methods[] = {
        function<load>("load", doc("Picture.load"), METH_STATIC),
        function<from_array>("from_array", doc("Picture.from_array"), METH_STATIC),
        method<p, save>("save", doc("Picture.save")),
        method<p, png>("_repr_png_", doc("Picture._repr_png_")),
        {}};
    static PyGetSetDef attributes[] = {attribute<p, size>("size", doc("Picture.size")),
                                       attribute<p, words>("words", doc("Picture.words")),
                                       attribute<p, report>("report", doc("Picture.report")),
                                       attribute<p, depth>("depth", doc("Picture.depth")),
                                       attribute<p, doubts>("error_map", doc("Picture.error_map")),
                                       {}};
    return new_type<p>(
        module, "l3d.Picture", doc("Picture"), methods, attributes,
        {slot(Py_bf_getbuffer, export_pixels), slot(Py_tp_repr, call_text<p, picture_text>)});
}

} // namespace python
