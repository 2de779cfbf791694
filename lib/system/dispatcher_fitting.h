// SPDX-License-Identifier: MIT
// l3d_dispatcher_fitting: a dispatcher for screens that may or may not be windows.
#ifndef L3D_SYSTEM_DISPATCHER_FITTING_H
#define L3D_SYSTEM_DISPATCHER_FITTING_H

#include "base/public.h"
#include "system/dispatcher.h"

/// Once it knows the screen, it works as the dispatcher of windows or as the one without a display.
class L3D_PUBLIC l3d_dispatcher_fitting final : public l3d_dispatcher {
public:
    /// Errors:  as l3d_frame_writer.
    explicit l3d_dispatcher_fitting(const l3d_frame_settings& settings);

private:
    l3d_exit do_start(l3d_pipeline& pipeline, l3d_screen& screen) override;

    l3d_frame_settings settings_;
    std::unique_ptr<l3d_dispatcher> fitting_; ///< kept until the screen is closed
};

/// Makes dispatchers for a back-end whose screens are windows where there is a display.
class L3D_PUBLIC l3d_dispatcher_factory_fitting final : public l3d_dispatcher_factory {
private:
    /// Errors:  as l3d_frame_writer.
    std::unique_ptr<l3d_dispatcher> do_create(const l3d_frame_settings& settings) const override;
};

#endif
