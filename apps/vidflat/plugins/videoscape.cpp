// SPDX-License-Identifier: MIT
// videoscape: a plug-in whose objects are models from files of any format, placed by the parameters
//     x y z A B C D E F G H I file
// where x y z is the position, and the columns A D G, B E H and C F I are the object's axes.
#include <l3d/object_plugin.h>

#include <array>
#include <memory>
#include <locale>
#include <sstream>
#include <string>

namespace {

/// The object's place and file. Nothing moves.
struct videoscape {
    std::array<double, 3> position{};
    std::array<double, 9> axes{};
    std::string file;
};

/// Reads a number after any blanks. Returns false if there is none; then `why` tells what is
/// missing.
bool read(std::istream& text, const std::string& what, double& number, std::string& why) {
    if (text >> number)
        return true;
    why = "the parameters lack " + what + ": x y z, nine numbers row by row, a file";
    return false;
}

bool parse(const char* parameters, videoscape& model, std::string& why) {
    std::istringstream text(parameters);
    text.imbue(std::locale::classic()); // the host's locale may have decimal commas
    for (std::size_t i = 0; i < 3; ++i)
        if (!read(text, std::string("the position's ") + "xyz"[i], model.position[i], why))
            return false;
    for (std::size_t i = 0; i < 9; ++i)
        if (!read(text, std::string("the orientation's ") + "ABCDEFGHI"[i], model.axes[i], why))
            return false;
    std::string rest;
    if (text >> model.file && !(text >> rest))
        return true;
    why = rest.empty() ? "the parameters lack the name of a file"
                       : "the parameters have '" + rest + "' after the name of the file";
    return false;
}

bool place(const l3d_plugin_host& host, l3d_plugin_object* object, const videoscape& model) {
    const auto& a = model.axes;
    const auto& p = model.position;
    const double orientation[16] = {a[0], a[1], a[2], 0, a[3], a[4], a[5], 0,
                                    a[6], a[7], a[8], 0, 0,    0,    0,    1};
    const double translation[16] = {1, 0, 0, p[0], 0, 1, 0, p[1], 0, 0, 1, p[2], 0, 0, 0, 1};
    return host.set_transform(object, 0, orientation) && host.set_transform(object, 1, translation);
}

void* create(const l3d_plugin_host* host, l3d_plugin_object* object, const char* parameters) {
    if (host->size < sizeof(l3d_plugin_host)) { // load_model came later than the rest
        host->fail(object, "the program is older than this plug-in");
        return nullptr;
    }
    auto model = std::make_unique<videoscape>();
    std::string why;
    if (!parse(parameters, *model, why)) {
        host->fail(object, why.c_str());
        return nullptr;
    }
    // Faces get random colours, as in the book: Videoscape's own are often all the same.
    if (!host->load_model(object, model->file.c_str(), 1) || !place(*host, object, *model))
        return nullptr;
    return model.release();
}

void update(void*, double) {}

void* copy(const void* data, l3d_plugin_object*) {
    return std::make_unique<videoscape>(*static_cast<const videoscape*>(data)).release();
}

void destroy(void* data) {
    const std::unique_ptr<videoscape> freed(static_cast<videoscape*>(data));
}

} // namespace

extern "C" const l3d_plugin_interface l3d_plugin;
const l3d_plugin_interface l3d_plugin{
    sizeof(l3d_plugin_interface), L3D_PLUGIN_VERSION, create, update, copy, destroy};
