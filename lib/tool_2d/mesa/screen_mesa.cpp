// SPDX-License-Identifier: MIT
// l3d_screen_factory_mesa: finds out whether there is GL in software, and whether there is a
// display.
#include "tool_2d/mesa/screen_mesa.h"

#include "tool_2d/mesa/mesa_context_p.h"

#include <cstdlib>

using level = l3d_service::level;

l3d_service l3d_screen_factory_mesa::do_service() const {
    l3d_service service;
    if (!l3d_detail::mesa_context::open(library_, service.why)) {
        service.how = level::not_here;
        return service;
    }
    l3d_service window = windows_.service();
    if (window.how == level::display_lost)
        return window;
    service.is_seen = window.serves();
    return service;
}

std::unique_ptr<l3d_screen> l3d_screen_factory_mesa::do_create(const l3d_screen_request& request,
                                                               l3d_service& refusal) const {
    auto window = windows_.create(request, refusal);
    if (window || refusal.how == level::display_lost)
        return window;
    return memory_.create(request, refusal);
}

void l3d_screen_factory_mesa::do_diagnose(l3d_probes& probes) const {
    using verdict = l3d_probe::verdict;
    const std::size_t first = probes.size();
    bool any = false;
    for (const l3d_detail::mesa_way way : l3d_detail::mesa_ways) {
        l3d_probe probe{name_of(way), {}, verdict::good, {}};
        if (!may_try(way, library_)) {
            probe.result = std::string("left out by L3D_MESA=") + std::getenv("L3D_MESA");
            probe.outcome = verdict::limited;
        } else if (const auto context = l3d_detail::mesa_context::open(way, probe.result)) {
            probe.result = context->renderer();
            any = true;
        } else {
            probe.outcome = verdict::bad;
            probe.remedy = l3d_detail::packages_of(way);
        }
        probes.push_back(probe);
    }
    if (any) // one is enough
        for (std::size_t i = first; i < probes.size(); ++i)
            if (probes[i].outcome == verdict::bad)
                probes[i].outcome = verdict::limited;
}
