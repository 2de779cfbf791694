// SPDX-License-Identifier: MIT
// A back-end that exists only for the tests: screens that write down what is asked of them.
#ifndef L3D_TESTS_SYSTEM_PAPER_ROW_H
#define L3D_TESTS_SYSTEM_PAPER_ROW_H

#include "raster/rasterizer_factory.h"
#include "system/dispatcher.h"
#include "system/factory_manager.h"
#include "system/fakes.h"

#include <memory>
#include <string>
#include <utility>

/// Serves if it was given no reason not to, or is told; counts how often it is asked.
class paper_factory final : public l3d_screen_factory {
public:
    paper_factory(call_log& log, std::string reason)
        : how(reason.empty() ? l3d_service::level::fully : l3d_service::level::not_here), log_(log),
          reason_(std::move(reason)) {}

    mutable l3d_service::level how;

private:
    l3d_service do_service() const override {
        log_.push_back("asked");
        l3d_service service;
        service.why = reason_;
        service.how = how;
        return service;
    }
    std::unique_ptr<l3d_screen> do_create(const l3d_screen_request&, l3d_service&) const override {
        return std::make_unique<fake_screen>(log_);
    }

    void do_release() const override { log_.push_back("released"); }

    call_log& log_;
    std::string reason_;
};

inline l3d_backend paper(call_log& log, const std::string& name, const std::string& reason = "") {
    l3d_backend row;
    row.name = name;
    row.purpose = "draws on " + name;
    row.screen_factory = std::make_unique<paper_factory>(log, reason);
    row.rasterizer_factory = std::make_unique<l3d_rasterizer_factory_sw>();
    row.dispatcher_factory = std::make_unique<l3d_dispatcher_factory_script>();
    return row;
}

#endif
