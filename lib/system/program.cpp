// SPDX-License-Identifier: MIT
// l3d_program: step 1, and the way out.
#include "system/program.h"

#include <utility>

l3d_program::l3d_program(std::string name, const std::string& purpose, l3d_size default_size)
    : options_(std::move(name), purpose, default_size) {}

int l3d_program::run(int argc, const char* const* argv, const std::function<l3d_exit()>& steps) {
    try {
        if (!options_.parse(argc, argv) || !goes_on_() || !factories_.choose(options_))
            return static_cast<int>(l3d_exit::well);
        return l3d_report(options_.command(), steps());
    } catch (const std::exception& error) {
        return l3d_report(options_.command(), error);
    }
}

std::unique_ptr<l3d_dispatcher> l3d_program::create_dispatcher() const {
    return factories_.create_dispatcher(options_.frame_settings());
}

l3d_canvas l3d_program::create_canvas() const {
    return {factories_.create_screen(options_.screen_request()),
            factories_.chosen().rasterizer_factory};
}
