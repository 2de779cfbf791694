// SPDX-License-Identifier: MIT
// Forward declarations of the screens layer; its table of contents.
#ifndef L3D_TOOL_2D_TOOL_2D_FWD_H
#define L3D_TOOL_2D_TOOL_2D_FWD_H

// error.h
enum class l3d_exit : int;
class l3d_error;

// pixels.h, image.h, image_file.h: pictures in memory and in files
struct l3d_size;
struct l3d_pixels;
class l3d_image;

// event.h
enum class l3d_event_type;
struct l3d_event;
class l3d_event_source;

// screen_info.h, probe.h, screen.h
enum class l3d_color_class;
struct l3d_pixel_layout;
struct l3d_palette;
class l3d_screen_info;
struct l3d_probe;
class l3d_screen;
struct l3d_screen_request;
struct l3d_service;
class l3d_screen_factory;

// screen_memory.h: no display
class l3d_screen_memory;
class l3d_screen_factory_memory;

// screen_x11.h: a window
class l3d_screen_factory_x11;
class l3d_screen_factory_ximage;
class l3d_screen_factory_xshm;

#endif
