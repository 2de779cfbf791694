// SPDX-License-Identifier: MIT
// pyramid: a plug-in whose objects are pyramids far to the right that turn about z.
#include <l3d/object_plugin.h>

#include <cmath>
#include <memory>

namespace {

/// One degree per 1/60 s.
constexpr double radians_per_second = 60 * 3.14159265358979323846 / 180;

/// The data of this plug-in for one object.
struct pyramid {
    const l3d_plugin_host* host;
    l3d_plugin_object* object;
    double angle = 0;

    bool set_geometry() const {
        constexpr double vertices[] = {0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10};
        constexpr std::uint32_t counts[] = {3, 3, 3, 3};
        constexpr std::uint32_t corners[] = {0, 1, 3, 2, 3, 1, 0, 2, 1, 3, 2, 0};
        std::uint32_t colors[4];
        for (std::uint32_t& color : colors)
            color = host->random(object) >> 8;
        constexpr double right[16] = {1, 0, 0, 70, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        constexpr double away[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 50, 0, 0, 0, 1};
        return host->set_polygons(object, 4, vertices, 4, counts, corners, colors) &&
               host->set_transform(object, 1, right) && host->set_transform(object, 2, away);
    }

    void turn(double by) {
        angle += by;
        const double c = std::cos(angle), s = std::sin(angle);
        const double about_z[16] = {c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        host->set_transform(object, 0, about_z);
    }
};

void* create(const l3d_plugin_host* host, l3d_plugin_object* object, const char*) {
    auto made = std::make_unique<pyramid>(pyramid{host, object});
    return made->set_geometry() ? made.release() : nullptr;
}

void update(void* data, double seconds) {
    static_cast<pyramid*>(data)->turn(seconds * radians_per_second);
}

void* copy(const void* data, l3d_plugin_object* copied) {
    auto made = std::make_unique<pyramid>(*static_cast<const pyramid*>(data));
    made->object = copied;
    return made.release();
}

void destroy(void* data) {
    const std::unique_ptr<pyramid> freed(static_cast<pyramid*>(data));
}

} // namespace

extern "C" const l3d_plugin_interface l3d_plugin;
const l3d_plugin_interface l3d_plugin{
    sizeof(l3d_plugin_interface), L3D_PLUGIN_VERSION, create, update, copy, destroy};
