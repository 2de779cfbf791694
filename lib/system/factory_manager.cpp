// SPDX-License-Identifier: MIT
// l3d_factory_manager: keeps the table of back-ends, and chooses one of them.
#include "system/factory_manager.h"

#include "tool_2d/screen_memory.h"
#include "tool_2d/mesa/screen_mesa.h"
#include "tool_2d/x11/screen_x11.h"
#include "raster/rasterizer_factory.h"
#include "base/error.h"
#include "base/printable_p.h"
#include "system/backend_survey_p.h"
#include "system/dispatcher.h"
#include "system/dispatcher_window.h"
#include "system/options/options.h"
#include "system/standard_output_p.h"
#include "system/terminal_lines_p.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <iostream>
#include <unistd.h>
#include <utility>

namespace {

/// Makes a back-end for the table from its three factories. The caller sets its flags.
template <class ScreenFactory, class RasterizerFactory, class DispatcherFactory>
l3d_backend row(std::string name, std::string purpose) {
    l3d_backend made;
    made.name = std::move(name);
    made.purpose = std::move(purpose);
    made.screen_factory = std::make_unique<ScreenFactory>();
    made.rasterizer_factory = std::make_shared<RasterizerFactory>();
    made.dispatcher_factory = std::make_unique<DispatcherFactory>();
    return made;
}

/// The value of an environment variable; empty if the variable is not set.
std::string environment(const char* variable) {
    const char* const value = std::getenv(variable);
    return value ? value : "";
}

/// The name of the back-end that the user or the program wants; empty if neither names one.
std::string wanted_name(const l3d_common_options& common) {
    std::string name = common.backend.empty() ? environment("L3D_BACKEND") : common.backend;
    return name.empty() ? common.usual_backend : name;
}

} // namespace

l3d_factory_manager::l3d_factory_manager() {
    auto xshm =
        row<l3d_screen_factory_xshm, l3d_rasterizer_factory_sw, l3d_dispatcher_factory_window>(
            "xshm", "window, pixels in shared memory: a local display, the fast one");
    xshm.automatic = true;
    xshm.on_display = true;
    add(std::move(xshm));

    auto ximage =
        row<l3d_screen_factory_ximage, l3d_rasterizer_factory_sw, l3d_dispatcher_factory_window>(
            "ximage", "window, pixels sent over the wire: any display, remote too");
    ximage.automatic = true;
    ximage.on_display = true;
    add(std::move(ximage));

    for (const char* const library : {"", "egl", "osmesa"}) {
        l3d_backend mesa;
        mesa.variant = *library != 0;
        mesa.name = mesa.variant ? std::string("mesa:") + library : "mesa";
        mesa.purpose = "Mesa software GL: polygons, a second opinion on every picture";
        if (mesa.variant)
            mesa.purpose = std::string("the same, by lib") + (*library == 'e' ? "EGL" : "OSMesa");
        mesa.screen_factory = std::make_unique<l3d_screen_factory_mesa>(library);
        mesa.rasterizer_factory = std::make_shared<l3d_rasterizer_factory_mesa>(library);
        mesa.dispatcher_factory = std::make_unique<l3d_dispatcher_factory_fitting>();
        add(std::move(mesa));
    }

    auto memory =
        row<l3d_screen_factory_memory, l3d_rasterizer_factory_sw, l3d_dispatcher_factory_script>(
            "memory", "no display: pictures into files");
    memory.automatic = true;
    memory.unseen = true;
    add(std::move(memory));
}

l3d_factory_manager::~l3d_factory_manager() = default;

void l3d_factory_manager::add(l3d_backend row) {
    assert(chosen_ == nullptr); // the choice points into the rows
    if (!row.screen_factory || !row.rasterizer_factory || !row.dispatcher_factory)
        throw l3d_error(l3d_exit::failure, "back-end '" + row.name + "' lacks a factory");
    if (std::ranges::find(rows_, row.name, &l3d_backend::name) != rows_.end())
        throw l3d_error(l3d_exit::failure, "back-end '" + row.name + "' is in the table already");
    rows_.push_back(std::move(row));
}

bool l3d_factory_manager::choose(l3d_options& options) {
    constexpr int patience = 10; // seconds, enough to read five lines
    const bool may_ask = isatty(STDIN_FILENO) && isatty(STDOUT_FILENO);
    l3d_detail::terminal_lines typed(STDIN_FILENO, std::cout, patience);
    std::istream lines(&typed);
    return choose(options, may_ask ? lines : std::cin, std::cout, may_ask);
}

bool l3d_factory_manager::choose(l3d_options& options, std::istream& in, std::ostream& out,
                                 bool may_ask) {
    const l3d_common_options& common = options.common();
    l3d_detail::backend_survey survey(rows_);
    if (common.diagnose) {
        for (const char* const variable :
             {"DISPLAY", "L3D_BACKEND", "L3D_NO_SHM", "L3D_MESA", "L3D_FONT"})
            out << variable << "='" << l3d_detail::printable(environment(variable)) << "' ";
        out << "terminal=" << (may_ask ? "yes" : "no") << '\n';
        survey.diagnose(out);
        l3d_detail::check_written(out);
        return false;
    }
    if (common.list_backends) {
        survey.list(out, true);
        l3d_detail::check_written(out);
        return false;
    }
    const bool by_option = !common.backend.empty();
    const std::string name = wanted_name(common);
    verbose_ = common.verbose;
    const bool named = !name.empty() && name != "ask" && name != "auto";
    const bool ask = may_ask && !common.no_input && name != "auto";
    chosen_ = named ? &survey.named(name, by_option ? "--backend" : "L3D_BACKEND")
              : ask ? survey.asked(in, out)
                    : &survey.automatic();
    if (!chosen_)
        return false;
    for (const l3d_backend& row : rows_)
        if (&row != chosen_)
            row.screen_factory->release();
    if (survey.is_seen(*chosen_) || chosen_->writes_files || !common.output.empty())
        return true;
    if (named && chosen_->unseen) {
        if (options.wants_result())
            return true;
        std::cerr << options.command() << ": nobody will see a picture: back-end '" << chosen_->name
                  << "' has no window, and no --output names a file\n";
    } else {
        options.set_output(options.program() + ".png");
        std::cerr << options.command() << ": no window; the picture goes to "
                  << l3d_detail::printable(common.output) << '\n';
    }
    return true;
}

const l3d_backend& l3d_factory_manager::chosen() const {
    if (!chosen_)
        throw l3d_error(l3d_exit::failure,
                        "no back-end is chosen yet: canvas and dispatcher are made within run()");
    return *chosen_;
}

std::unique_ptr<l3d_screen>
l3d_factory_manager::create_screen(const l3d_screen_request& request) const {
    l3d_service refusal;
    auto screen = chosen().screen_factory->create(request, refusal);
    // The back-end was chosen because there was a display. So the display was lost since then.
    if (chosen().on_display && refusal.how == l3d_service::level::no_display)
        refusal.how = l3d_service::level::display_lost;
    if (!screen)
        l3d_detail::backend_survey::fail("back-end '" + chosen().name + "'", refusal);
    if (verbose_) {
        std::cerr << chosen().name << ": " << screen->describe() << '\n';
        if (const std::string drawn_by = chosen().rasterizer_factory->describe(); !drawn_by.empty())
            std::cerr << chosen().name << ": " << drawn_by << '\n';
    }
    return screen;
}

std::unique_ptr<l3d_screen>
l3d_factory_manager::create_notice(const l3d_options& options,
                                   const l3d_screen_request& request) const {
    const std::string name = wanted_name(options.common());
    const auto is_named = [&](const l3d_backend& row) { return row.name == name && row.unseen; };
    if (std::ranges::any_of(rows_, is_named))
        return nullptr;
    for (const l3d_backend& row : rows_) {
        l3d_service refusal;
        if (auto screen = row.automatic && row.on_display
                              ? row.screen_factory->create(request, refusal)
                              : nullptr)
            return screen;
    }
    return nullptr;
}

std::unique_ptr<l3d_dispatcher>
l3d_factory_manager::create_dispatcher(const l3d_frame_settings& settings) const {
    return chosen().dispatcher_factory->create(settings);
}
