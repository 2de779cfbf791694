// SPDX-License-Identifier: MIT
// gltf_document: the JSON of a glTF file, its buffers, and the numbers in them.
#ifndef L3D_GEOM_FILES_GLTF_DOCUMENT_P_H
#define L3D_GEOM_FILES_GLTF_DOCUMENT_P_H

#include "geom/files/model_file.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace l3d_detail {

/// An error in a glTF file. Its message begins with the place in the document ("accessors[3].count
/// is ...") or with the line.
class gltf_error : public std::runtime_error {
public:
    /// `line` is 0 for an error inside the JSON. `what` then begins with the place in the document.
    /// A line number would tell less, since the whole JSON may be one line.
    explicit gltf_error(const std::string& what, std::size_t line = 0)
        : std::runtime_error((line > 0 ? std::to_string(line) + ": " : " ") + what) {}
};

/// A value of the JSON document, which knows its place in the document.
///
/// Every function that finds an error throws a gltf_error whose message begins with this place.
/// Lives: borrows the document.
class gltf_value {
public:
    using json = nlohmann::json;

    gltf_value(const json& value, std::string place) : value_(&value), place_(std::move(place)) {}

    bool has(const char* name) const { return value_->is_object() && value_->contains(name); }
    /// A member of this object. Errors: the member is missing, or this is not an object.
    gltf_value at(const char* name) const;
    /// An element of an array member. Errors: the element is missing.
    gltf_value element(const char* name, std::size_t index) const;
    /// The number of elements of an array member; 0 if the member is missing.
    std::size_t count(const char* name) const;
    gltf_value operator[](std::size_t index) const;
    std::size_t size() const;

    /// The value as a whole number from 0 to 2^53, up to which JSON numbers are exact.
    std::uint64_t whole() const;
    /// The whole number of a member; `missing` if the object has no such member.
    std::uint64_t whole_or(const char* name, std::uint64_t missing) const;
    double number() const;
    bool flag_or(const char* name, bool missing) const;
    const std::string& text() const;
    std::string text_or(const char* name, const std::string& missing) const;

    [[noreturn]] void fail(const std::string& what) const;
    const std::string& place() const { return place_; }
    const json& raw() const { return *value_; }

private:
    const json* value_;
    std::string place_;
};

/// The numbers of an accessor as doubles. Normalized numbers are scaled to -1 to 1, or to 0 to 1 if
/// they are unsigned.
struct gltf_numbers {
    std::size_t count = 0;      ///< the number of elements
    std::size_t components = 1; ///< components of an element
    std::vector<double> values; ///< components, element after element

    const double* at(std::size_t element) const { return &values[element * components]; }
};

/// A glTF file that has been parsed, with its buffers. Errors: every function throws gltf_error.
class gltf_document {
public:
    using json = nlohmann::json;

    /// Parses the text of a .gltf or .glb file. Lives: borrows the text.
    explicit gltf_document(std::string_view text);

    /// Reads the buffers. Call it once, before numbers(). A faulty buffer is an error only when
    /// something in the buffer is read.
    void read_buffers(const l3d_other_files& files);

    gltf_value root() const { return {json_, ""}; }

    /// The numbers of the accessor whose index is `at`. The accessor's type must be one of `types`,
    /// such as "VEC3 VEC4". If `is_index`, the numbers must be whole and not negative.
    gltf_numbers numbers(const gltf_value& at, std::string_view types, bool is_index) const;

    /// The bytes of an element of `images`: they are in another file, in the text itself, or in a
    /// bufferView.
    std::string image_bytes(const gltf_value& image, const l3d_other_files& files) const;

    /// Counts `bytes` of memory that reading takes, since a file may name the same numbers again
    /// and again.
    /// Errors: gltf_error beyond 32 times the size of the files, if this is also beyond 16 MB.
    void take_memory(std::size_t bytes) const;

private:
    struct element_shape;

    static std::string bytes_of(const gltf_value& uri, const l3d_other_files& files, bool& is_file);
    std::string_view read_buffer(std::size_t index, const l3d_other_files& files);
    void read_container(std::string_view text);
    std::string_view view_of(const gltf_value& index, std::size_t& stride) const;
    element_shape shape_of(const gltf_value& accessor, const gltf_value& type) const;
    void fill(const gltf_value& accessor, const gltf_value& view, const element_shape& shape,
              std::size_t count, gltf_numbers& out) const;
    void fill_sparse(const gltf_value& accessor, const element_shape& shape,
                     gltf_numbers& out) const;

    json json_;
    std::string_view chunk_; ///< the binary part of a .glb file
    bool has_chunk_ = false;
    std::vector<std::string> owned_; ///< bytes of buffers that were decoded, or read from files
    std::vector<std::string_view> buffers_;
    std::vector<std::optional<gltf_error>> faults_; ///< per buffer, why it cannot be read
    std::size_t bytes_ = 0; ///< the size of the file and of the files that it names
    mutable std::size_t taken_ = 0;
};

} // namespace l3d_detail

#endif
