// SPDX-License-Identifier: MIT
// gltf_document: reads containers, buffers and accessors, and checks every bound.
#include "geom/files/gltf_document_p.h"

#include "base/counted_p.h"
#include "geom/files/text_cursor_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace l3d_detail {

namespace {

std::string named(const std::string& place, const char* name) {
    return place.empty() ? name : place + '.' + name;
}

std::uint32_t word_at(std::string_view text, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = sizeof word; i-- > 0;)
        word = word << 8 | static_cast<unsigned char>(text[at + i]);
    return word;
}

/// Appends the bytes that base64 text stands for; padding may be missing. Returns false if the text
/// has any other character.
bool decode_base64(std::string_view text, std::string& out) {
    while (text.ends_with('='))
        text.remove_suffix(1);
    out.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                          : c >= 'a' && c <= 'z' ? c - 'a' + 26
                          : c >= '0' && c <= '9' ? c - '0' + 52
                          : c == '+'             ? 62
                          : c == '/'             ? 63
                                                 : -1;
        if (digit < 0)
            return false;
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count >= 8) {
            count -= 8;
            out += static_cast<char>(bits >> count & 255);
        }
    }
    return true;
}

/// The name of a file that a URI encodes: %20 stands for a blank.
std::string decoded_name(std::string_view uri) {
    std::string result;
    const auto digit = [](char c) {
        return c >= '0' && c <= '9'   ? c - '0'
               : c >= 'a' && c <= 'f' ? c - 'a' + 10
               : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                      : -1;
    };
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 &&
            digit(uri[i + 2]) >= 0) {
            result += static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2]));
            i += 2;
        } else {
            result += uri[i];
        }
    }
    return result;
}

template <class T> double little(const char* bytes) {
    char turned[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i)
        turned[std::endian::native == std::endian::little ? i : sizeof(T) - 1 - i] = bytes[i];
    T value;
    std::memcpy(&value, turned, sizeof(T));
    return static_cast<double>(value);
}

/// A type of components of accessors, with OpenGL's code for it.
struct component_type {
    std::uint64_t code;
    std::size_t bytes;
    double (*read)(const char*);
    double most; ///< the number that stands for 1 if normalized; 0 if the type cannot be normalized
};
constexpr std::array<component_type, 6> component_types{{{5120, 1, little<std::int8_t>, 127},
                                                         {5121, 1, little<std::uint8_t>, 255},
                                                         {5122, 2, little<std::int16_t>, 32767},
                                                         {5123, 2, little<std::uint16_t>, 65535},
                                                         {5125, 4, little<std::uint32_t>, 0},
                                                         {5126, 4, little<float>, 0}}};

} // namespace

gltf_value gltf_value::at(const char* name) const {
    if (!value_->is_object())
        fail("is no object");
    const auto found = value_->find(name);
    if (found == value_->end())
        fail("has no " + std::string(name));
    return {*found, named(place_, name)};
}

gltf_value gltf_value::element(const char* name, std::size_t index) const {
    const std::size_t all = count(name);
    if (index >= all)
        throw gltf_error(named(place_, name) + ": number " + std::to_string(index) + " of " +
                         std::to_string(all) + " is asked for");
    return at(name)[index];
}

std::size_t gltf_value::count(const char* name) const {
    return has(name) ? at(name).size() : 0;
}

gltf_value gltf_value::operator[](std::size_t index) const {
    return {(*value_)[index], place_ + '[' + std::to_string(index) + ']'};
}

std::size_t gltf_value::size() const {
    if (!value_->is_array())
        fail("is no array");
    return value_->size();
}

std::uint64_t gltf_value::whole() const {
    constexpr double most = 0x1p53;
    const double value = number();
    if (!(value >= 0 && value <= most && value == std::floor(value)))
        fail("is no whole number from 0 on");
    return static_cast<std::uint64_t>(value);
}

std::uint64_t gltf_value::whole_or(const char* name, std::uint64_t missing) const {
    return has(name) ? at(name).whole() : missing;
}

double gltf_value::number() const {
    if (!value_->is_number())
        fail("is no number");
    return value_->get<double>();
}

bool gltf_value::flag_or(const char* name, bool missing) const {
    if (!has(name))
        return missing;
    const gltf_value flag = at(name);
    if (!flag.value_->is_boolean())
        flag.fail("is neither true nor false");
    return flag.value_->get<bool>();
}

const std::string& gltf_value::text() const {
    if (!value_->is_string())
        fail("is no text");
    return value_->get_ref<const std::string&>();
}

std::string gltf_value::text_or(const char* name, const std::string& missing) const {
    return has(name) ? at(name).text() : missing;
}

void gltf_value::fail(const std::string& what) const {
    throw gltf_error((place_.empty() ? "the document" : place_) + ' ' + what);
}

gltf_document::gltf_document(std::string_view text) : bytes_(text.size()) {
    read_container(text);
}

/// Reads a .glb file: a header of three words, then chunks. A chunk is a length, a type and bytes.
/// The first chunk is JSON; at most one more chunk, with binary data, is read.
void gltf_document::read_container(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    constexpr std::size_t header = 12, chunk_header = 8;
    constexpr std::uint32_t json_type = 0x4E4F534A, bytes_type = 0x004E4942;
    std::string_view part = text;
    std::size_t begin = 0;
    if (text.starts_with("glTF")) {
        if (text.size() < header + chunk_header)
            throw gltf_error("the file ends in its header", 1);
        if (word_at(text, 4) != 2)
            throw gltf_error("version " + std::to_string(word_at(text, 4)) +
                                 " of the container; 2 can be read",
                             1);
        if (word_at(text, 8) > text.size())
            throw gltf_error("the header promises " + std::to_string(word_at(text, 8)) +
                                 " bytes; there are " + std::to_string(text.size()),
                             1);
        text = text.substr(0, word_at(text, 8));
        for (std::size_t at = header; at + chunk_header <= text.size();) {
            const std::uint32_t size = word_at(text, at), type = word_at(text, at + 4);
            at += chunk_header;
            if (size > text.size() - at)
                throw gltf_error("a chunk at byte " + std::to_string(at) + " promises " +
                                     std::to_string(size) + " bytes; there are " +
                                     std::to_string(text.size() - at),
                                 1);
            if (at == header + chunk_header) {
                if (type != json_type)
                    throw gltf_error("the first chunk is no JSON", 1);
                part = text.substr(at, size);
                begin = at;
            } else if (type == bytes_type && !has_chunk_) {
                chunk_ = text.substr(at, size);
                has_chunk_ = true;
            }
            at += size;
        }
        if (begin == 0)
            throw gltf_error("the header promises no chunk", 1);
    } else if (part.starts_with(mark)) {
        part.remove_prefix(mark.size());
    }
    try {
        json_ = json::parse(part);
    } catch (const json::exception& error) {
        const auto* const syntax = dynamic_cast<const json::parse_error*>(&error);
        const std::size_t byte = std::min(syntax ? syntax->byte : 0, part.size());
        const auto line = std::ranges::count(part.substr(0, byte), '\n');
        throw gltf_error("no JSON is possible at byte " + std::to_string(begin + byte),
                         static_cast<std::size_t>(line) + 1);
    }
    if (!json_.is_object())
        throw gltf_error("the document is no object", 1);
}

void gltf_document::read_buffers(const l3d_other_files& files) {
    const std::size_t count = root().count("buffers");
    owned_.resize(count);
    buffers_.resize(count);
    faults_.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        try {
            buffers_[i] = read_buffer(i, files);
        } catch (const gltf_error& error) {
            faults_[i] = error;
        }
}

std::string gltf_document::bytes_of(const gltf_value& uri, const l3d_other_files& files,
                                    bool& is_file) {
    const std::string& text = uri.text();
    constexpr std::string_view base64 = ";base64,";
    std::string bytes;
    if (const std::size_t comma = text.find(base64);
        text.starts_with("data:") && comma != text.npos) {
        if (!decode_base64(std::string_view(text).substr(comma + base64.size()), bytes))
            uri.fail("is no base64");
        return bytes;
    }
    if (text.starts_with("data:"))
        uri.fail("is data in another form than base64");
    is_file = true;
    std::string why = "cannot be read from a text alone", ignored;
    auto read = files ? files(decoded_name(text), why) : std::nullopt;
    if (!read && files) // some programs do not encode names
        read = files(text, ignored);
    if (!read)
        uri.fail(l3d_detail::quoted(text) + ": " + why);
    return *std::move(read);
}

std::string gltf_document::image_bytes(const gltf_value& image,
                                       const l3d_other_files& files) const {
    bool is_file = false;
    if (image.has("uri"))
        return bytes_of(image.at("uri"), files, is_file);
    std::size_t stride = 0;
    const std::string_view view = view_of(image.at("bufferView"), stride);
    take_memory(view.size());
    return std::string(view);
}

std::string_view gltf_document::read_buffer(std::size_t index, const l3d_other_files& files) {
    const gltf_value buffer = root().element("buffers", index);
    const std::uint64_t length = buffer.at("byteLength").whole();
    std::string& owned = owned_[index];
    std::string_view bytes = chunk_;
    if (buffer.has("uri")) {
        bool is_file = false;
        owned = bytes_of(buffer.at("uri"), files, is_file);
        if (is_file)
            bytes_ += owned.size();
        bytes = owned;
    } else if (index > 0 || !has_chunk_) {
        buffer.fail("has no uri, and no chunk holds its bytes");
    }
    if (bytes.size() < length)
        buffer.fail("promises " + std::to_string(length) + " bytes; there are " +
                    std::to_string(bytes.size()));
    return bytes.substr(0, length);
}

void gltf_document::take_memory(std::size_t bytes) const {
    // The 16 MB are for small files, which may well draw one thing hundreds of times.
    constexpr std::size_t most_per_byte = 32, always = std::size_t{16} << 20;
    taken_ += bytes;
    if (taken_ > std::max(always, most_per_byte * bytes_))
        throw gltf_error("what the scene names again and again takes more than " +
                         std::to_string(most_per_byte) +
                         " times the memory of the file, and more than 16 MB");
}

/// The bytes of the buffer view that `index` names, and its stride: 0 if elements are packed.
std::string_view gltf_document::view_of(const gltf_value& index, std::size_t& stride) const {
    const gltf_value view = root().element("bufferViews", index.whole());
    const std::uint64_t buffer = view.at("buffer").whole();
    if (buffer >= buffers_.size())
        view.fail("names buffer " + std::to_string(buffer) + " of " +
                  std::to_string(buffers_.size()));
    if (faults_[buffer])
        throw gltf_error(*faults_[buffer]);
    const std::string_view bytes = buffers_[buffer];
    const std::uint64_t offset = view.whole_or("byteOffset", 0);
    const std::uint64_t length = view.at("byteLength").whole();
    if (offset > bytes.size() || length > bytes.size() - offset)
        view.fail("reaches to byte " + std::to_string(offset + length) + " of " +
                  std::to_string(bytes.size()));
    stride = view.whole_or("byteStride", 0);
    return bytes.substr(offset, length);
}

struct gltf_document::element_shape {
    const component_type* type;
    std::size_t components;
    bool normalized;

    std::size_t bytes() const { return type->bytes * components; }
    double read(const char* from) const {
        const double value = type->read(from);
        return normalized ? std::max(value / type->most, -1.0) : value;
    }
};

gltf_document::element_shape gltf_document::shape_of(const gltf_value& accessor,
                                                     const gltf_value& type) const {
    const std::uint64_t code = type.whole();
    const auto found = std::ranges::find(component_types, code, &component_type::code);
    if (found == component_types.end())
        type.fail("is no type of numbers: " + std::to_string(code));
    const bool normalized = accessor.flag_or("normalized", false);
    if (normalized && found->most == 0)
        accessor.fail("has numbers that cannot be normalized");
    return {&*found, 1, normalized};
}

/// Reads `count` elements of a view, packed or at the view's stride.
void gltf_document::fill(const gltf_value& accessor, const gltf_value& view,
                         const element_shape& shape, std::size_t count, gltf_numbers& out) const {
    std::size_t stride = 0;
    const std::string_view bytes = view_of(view, stride);
    stride = stride == 0 ? shape.bytes() : stride;
    const std::uint64_t offset = accessor.whole_or("byteOffset", 0);
    if (stride < shape.bytes())
        accessor.fail("has elements of " + std::to_string(shape.bytes()) +
                      " bytes, and its bufferView a stride of " + std::to_string(stride));
    const bool fits =
        count == 0 || (offset <= bytes.size() && bytes.size() - offset >= shape.bytes() &&
                       (bytes.size() - offset - shape.bytes()) / stride >= count - 1);
    if (!fits)
        accessor.fail("has " + std::to_string(count) +
                      " elements, more than the bytes of its bufferView, " +
                      std::to_string(bytes.size()));
    take_memory(count * shape.components * sizeof(double));
    out.values.resize(count * shape.components);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < shape.components; ++k)
            out.values[i * shape.components + k] =
                shape.read(bytes.data() + offset + i * stride + k * shape.type->bytes);
}

/// Replaces the elements that a sparse accessor lists.
void gltf_document::fill_sparse(const gltf_value& accessor, const element_shape& shape,
                                gltf_numbers& out) const {
    const gltf_value sparse = accessor.at("sparse");
    const gltf_value indices = sparse.at("indices"), values = sparse.at("values");
    const std::size_t count = sparse.at("count").whole();
    element_shape index_shape = shape_of(indices, indices.at("componentType"));
    index_shape.normalized = false;
    gltf_numbers at, with;
    fill(indices, indices.at("bufferView"), index_shape, count, at);
    fill(values, values.at("bufferView"), shape, count, with);
    for (std::size_t i = 0; i < count; ++i) {
        const double index = at.values[i];
        if (!(index >= 0 && index < static_cast<double>(out.count)))
            sparse.fail("names element " + std::to_string(static_cast<std::int64_t>(index)) +
                        " of " + std::to_string(out.count));
        std::copy_n(with.values.begin() + static_cast<std::ptrdiff_t>(i * shape.components),
                    shape.components,
                    out.values.begin() + static_cast<std::ptrdiff_t>(
                                             static_cast<std::size_t>(index) * shape.components));
    }
}

gltf_numbers gltf_document::numbers(const gltf_value& at, std::string_view types,
                                    bool is_index) const {
    const gltf_value accessor = root().element("accessors", at.whole());
    const std::string& type = accessor.at("type").text();
    const bool is_one = type == "SCALAR" || type == "VEC2" || type == "VEC3" || type == "VEC4";
    if (!is_one || types.find(type) == types.npos)
        accessor.fail("has the type " + l3d_detail::quoted(type) + ", where " + at.place() +
                      " needs " + std::string(types));
    element_shape shape = shape_of(accessor, accessor.at("componentType"));
    shape.components = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
    constexpr std::uint64_t whole_types[] = {5121, 5123, 5125};
    if (is_index && std::ranges::find(whole_types, shape.type->code) == std::end(whole_types))
        accessor.fail("has numbers that are no indices");
    gltf_numbers result;
    result.count = accessor.at("count").whole();
    result.components = shape.components;
    if (accessor.has("bufferView")) {
        fill(accessor, accessor.at("bufferView"), shape, result.count, result);
    } else {
        if (result.count > bytes_) // an accessor without bytes must not outgrow the file
            accessor.fail("has " + counted(result.count, "elements") + " and no bufferView");
        take_memory(result.count * shape.components * sizeof(double));
        result.values.resize(result.count * shape.components);
    }
    if (accessor.has("sparse"))
        fill_sparse(accessor, shape, result);
    return result;
}

} // namespace l3d_detail
