// SPDX-License-Identifier: MIT
// A plug-in that does what its parameters say, and most of them are wrong.
#include <l3d/object_plugin.h>

#include <cmath>
#include <cstring>
#include <memory>

namespace {

struct naughty {
    const l3d_plugin_host* host;
    l3d_plugin_object* object;
};

void* create(const l3d_plugin_host* host, l3d_plugin_object* object, const char* parameters) {
    const double vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const double infinite[] = {0, 0, 0, 1, 0, 0, 0, HUGE_VAL, 0};
    const double far[] = {0, 0, 0, 1, 0, 0, 0, -1e300, 0}, far_matrix[16] = {1, 0, 0, 1e300};
    const std::uint32_t three = 3, two = 2, corners[] = {0, 1, 2}, beyond[] = {0, 1, 3}, color = 7;
    const auto is = [parameters](const char* word) { return std::strcmp(parameters, word) == 0; };
    host->set_polygons(object, 3,
                       is("infinite") ? infinite
                       : is("far")    ? far
                                      : vertices,
                       1, is("two corners") ? &two : &three, is("beyond") ? beyond : corners,
                       &color);
    if (is("far matrix"))
        host->set_transform(object, 0, far_matrix);
    if (is("refuses"))
        host->fail(object, "not today");
    if (is("refuses") || is("silent"))
        return nullptr;
    return std::make_unique<naughty>(naughty{host, object}).release();
}

/// There are sixteen matrices.
void update(void* data, double) {
    const auto* const self = static_cast<const naughty*>(data);
    const double zero[16] = {};
    self->host->set_transform(self->object, 16, zero);
}

void* copy(const void*, l3d_plugin_object*) {
    return nullptr;
}

void destroy(void* data) {
    const std::unique_ptr<naughty> freed(static_cast<naughty*>(data));
}

} // namespace

extern "C" const l3d_plugin_interface l3d_plugin;
const l3d_plugin_interface l3d_plugin{
    sizeof(l3d_plugin_interface), L3D_PLUGIN_VERSION, create, update, copy, destroy};
