// SPDX-License-Identifier: MIT
// method_viewer: the key, and what a method cannot show.
#include "method_viewer.h"

#include <l3d/error.h>

#include <utility>

method_viewer::method_viewer(l3d_canvas canvas, l3d_patch_scene scene, const l3d_camera& camera,
                             const l3d_afd_settings& settings, const l3d_method_choice& first)
    : l3d_pipeline_afd_viewer(std::move(canvas), std::move(scene), camera, settings),
      method_(first) {
    controls().add({"m", "another method", {{'m', [this] { take_next_method(); }}}});
}

void method_viewer::take_next_method() {
    controls().say(show_next_method(*this, method_));
}

l3d_afd_settings as_method_can(l3d_afd_settings settings) {
    const bool is_afd = settings.method.is_default();
    settings.wireframe = settings.wireframe && is_afd;
    if ((settings.shade == l3d_shade::error && !settings.method.has_bound()) ||
        (l3d_is_inspection(settings.shade) && !is_afd))
        settings.shade = l3d_shade::lambert;
    return settings;
}

void show_method(l3d_pipeline_afd& pipeline, const l3d_method_choice& method) {
    pipeline.take_method(method.factory());
    pipeline.settings() = as_method_can(pipeline.settings());
}

/// AFD can be created everywhere, so the search ends.
std::string show_next_method(l3d_pipeline_afd& pipeline, l3d_method_choice& method) {
    std::string passed_over;
    for (;;)
        try {
            method = method.next();
            show_method(pipeline, method);
            return "method: " + method.name() + passed_over;
        } catch (const l3d_error& error) {
            passed_over += "; not " + method.name() + ": " + error.what();
        }
}
