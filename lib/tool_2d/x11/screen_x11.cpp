// SPDX-License-Identifier: MIT
// The factories that pair a window with a way of sending its pictures.
#include "tool_2d/x11/screen_x11.h"

#include "tool_2d/x11/x11_diagnosis_p.h"
#include "tool_2d/x11_window/x11_scale_p.h"
#include "tool_2d/x11/x11_screen_p.h"
#include "tool_2d/x11/x11_shm_segment_p.h"

#include <cstdlib>
#include <new>
#include <optional>
#include <utility>

namespace {

using namespace l3d_detail;

/// Errors:  none, and the reason in `refusal`.
std::optional<x11_visual> choose_visual(const x11_connection* connection, l3d_service& refusal) {
    if (connection == nullptr) {
        refusal.how = l3d_service::level::no_display;
        return {};
    }
    std::optional<x11_visual> visual;
    if (!connection->lost())
        visual = choose_x11_visual(*connection, refusal.why);
    if (connection->lost()) {
        refusal = {l3d_service::level::display_lost, x11_server_went_away};
        return {};
    }
    if (!visual)
        refusal.how = l3d_service::level::not_here;
    return visual;
}

/// Whether pictures travel sparingly.
bool is_sparing(const x11_connection& connection, l3d_remote wish) {
    return wish == l3d_remote::on || (wish == l3d_remote::automatic && !connection.is_local());
}

std::unique_ptr<l3d_screen> open_screen(std::unique_ptr<x11_connection> connection,
                                        const l3d_screen_request& request, std::string no_shm,
                                        l3d_service& refusal) {
    const auto visual = choose_visual(connection.get(), refusal);
    if (!visual)
        return nullptr;
    auto window = x11_window::open(std::move(connection), *visual, request, refusal);
    if (!window)
        return nullptr;
    try {
        const l3d_size size = x11_picture_size(window->connection(), request);
        const bool sparing = is_sparing(window->connection(), request.remote);
        return open_x11_screen(std::move(window), size, std::move(no_shm), sparing);
    } catch (const std::bad_alloc&) {
        refusal = {l3d_service::level::not_here, "not enough memory for a picture of " +
                                                     std::to_string(request.size.width) + "x" +
                                                     std::to_string(request.size.height)};
        return nullptr;
    }
}

} // namespace

l3d_screen_factory_x11::l3d_screen_factory_x11() = default;
l3d_screen_factory_x11::~l3d_screen_factory_x11() = default;

void l3d_screen_factory_x11::keep(std::unique_ptr<x11_connection> connection) const {
    kept_ = std::move(connection);
}

void l3d_screen_factory_x11::do_release() const {
    kept_.reset();
}

std::unique_ptr<x11_connection> l3d_screen_factory_x11::connect(std::string& why) const {
    auto kept = std::exchange(kept_, nullptr);
    const char* const name = std::getenv("DISPLAY");
    const bool serves = kept && name != nullptr && kept->name() == name;
    return serves ? std::move(kept) : x11_connection::open(why);
}

l3d_service l3d_screen_factory_ximage::do_service() const {
    l3d_service service;
    auto connection = x11_connection::open(service.why);
    if (choose_visual(connection.get(), service))
        keep(std::move(connection));
    return service;
}

std::unique_ptr<l3d_screen> l3d_screen_factory_ximage::do_create(const l3d_screen_request& request,
                                                                 l3d_service& refusal) const {
    return open_screen(connect(refusal.why), request, "not asked for", refusal);
}

void l3d_screen_factory_ximage::do_diagnose(l3d_probes& probes) const {
    diagnose_x11_display(probes);
}

l3d_service l3d_screen_factory_xshm::do_service() const {
    l3d_service service;
    auto connection = x11_connection::open(service.why);
    const auto visual = choose_visual(connection.get(), service);
    if (!visual)
        return service;
    std::string why;
    if (!x11_shm_segment::make(*connection, visual->visual, visual->layout, 1, why))
        service = {l3d_service::level::partly, "pictures go over the wire: " + why};
    if (connection->lost())
        return {l3d_service::level::display_lost, why};
    keep(std::move(connection));
    return service;
}

std::unique_ptr<l3d_screen> l3d_screen_factory_xshm::do_create(const l3d_screen_request& request,
                                                               l3d_service& refusal) const {
    return open_screen(connect(refusal.why), request,
                       request.remote == l3d_remote::on ? "--remote on" : "", refusal);
}

void l3d_screen_factory_xshm::do_diagnose(l3d_probes& probes) const {
    diagnose_x11_shm(probes);
}
