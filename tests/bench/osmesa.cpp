// SPDX-License-Identifier: MIT
// osmesa: the few GL calls that a static mesh needs.
#include "bench/osmesa.h"

#include <cstdlib>
#include <dlfcn.h>

namespace {

// From the OpenGL registry and Mesa's documentation of OSMesa.
constexpr unsigned gl_unsigned_byte = 0x1401, gl_unsigned_int = 0x1405, gl_float = 0x1406;
constexpr unsigned gl_rgba = 0x1908, gl_triangles = 4, gl_depth_test = 0x0B71;
constexpr unsigned gl_greater = 0x0204, gl_renderer = 0x1F01;
constexpr unsigned gl_color_bit = 0x4000, gl_depth_bit = 0x0100;
constexpr unsigned gl_projection = 0x1701, gl_modelview = 0x1700;
constexpr unsigned gl_array_buffer = 0x8892, gl_element_buffer = 0x8893, gl_static_draw = 0x88E4;
constexpr unsigned gl_vertex_array = 0x8074, gl_color_array = 0x8076;
constexpr int osmesa_y_up = 0x11, osmesa_depth_bits = 24;

} // namespace

/// The functions, each found by name.
struct osmesa::api {
    void* library = nullptr;
    void* context = nullptr;

    void* (*create_context)(unsigned, int, int, int, void*);
    void (*destroy_context)(void*);
    unsigned char (*make_current)(void*, void*, unsigned, int, int);
    void (*pixel_store)(int, int);
    void* (*get_proc)(const char*);

    const unsigned char* (*get_string)(unsigned);
    void (*enable)(unsigned);
    void (*depth_func)(unsigned);
    void (*clear_depth)(double);
    void (*clear)(unsigned);
    void (*finish)();
    void (*viewport)(int, int, int, int);
    void (*matrix_mode)(unsigned);
    void (*load_identity)();
    void (*load_matrix)(const float*);
    void (*gen_buffers)(int, unsigned*);
    void (*delete_buffers)(int, const unsigned*);
    void (*bind_buffer)(unsigned, unsigned);
    void (*buffer_data)(unsigned, std::ptrdiff_t, const void*, unsigned);
    void (*enable_client_state)(unsigned);
    void (*vertex_pointer)(int, unsigned, int, const void*);
    void (*color_pointer)(int, unsigned, int, const void*);
    void (*draw_elements)(unsigned, int, unsigned, const void*);

    api() = default;
    api(const api&) = delete;
    api& operator=(const api&) = delete;
    // The library stays loaded: its compiler's threads and destructors outlive a dlclose badly.
    ~api() {
        if (context)
            destroy_context(context);
    }

    template <class Function> bool find(Function& function, const char* name, bool in_library) {
        void* found = in_library ? dlsym(library, name) : get_proc(name);
        function = reinterpret_cast<Function>(found);
        return found != nullptr;
    }

    bool load(std::string& why) {
        for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6"})
            if (!library)
                library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (!library) {
            why = "no libOSMesa (Debian: libosmesa6)";
            return false;
        }
        const bool all =
            find(create_context, "OSMesaCreateContextExt", true) &&
            find(destroy_context, "OSMesaDestroyContext", true) &&
            find(make_current, "OSMesaMakeCurrent", true) &&
            find(pixel_store, "OSMesaPixelStore", true) &&
            find(get_proc, "OSMesaGetProcAddress", true) &&
            find(get_string, "glGetString", false) && find(enable, "glEnable", false) &&
            find(depth_func, "glDepthFunc", false) && find(clear_depth, "glClearDepth", false) &&
            find(clear, "glClear", false) && find(finish, "glFinish", false) &&
            find(viewport, "glViewport", false) && find(matrix_mode, "glMatrixMode", false) &&
            find(load_identity, "glLoadIdentity", false) &&
            find(load_matrix, "glLoadMatrixf", false) && find(gen_buffers, "glGenBuffers", false) &&
            find(delete_buffers, "glDeleteBuffers", false) &&
            find(bind_buffer, "glBindBuffer", false) && find(buffer_data, "glBufferData", false) &&
            find(enable_client_state, "glEnableClientState", false) &&
            find(vertex_pointer, "glVertexPointer", false) &&
            find(color_pointer, "glColorPointer", false) &&
            find(draw_elements, "glDrawElements", false);
        if (!all)
            why = "libOSMesa lacks a function";
        return all;
    }
};

osmesa::osmesa(std::unique_ptr<api> gl, l3d_size size)
    : gl_(std::move(gl)), size_(size),
      picture_(4 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)) {}

osmesa::~osmesa() {
    if (buffers_[0])
        gl_->delete_buffers(3, buffers_);
}

std::unique_ptr<osmesa> osmesa::create(l3d_size size, int threads, std::string& why) {
    setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
    auto gl = std::make_unique<api>();
    if (!gl->load(why))
        return nullptr;
    std::unique_ptr<osmesa> made(new osmesa(std::move(gl), size));
    api& g = *made->gl_;
    g.context = g.create_context(gl_rgba, osmesa_depth_bits, 0, 0, nullptr);
    if (!g.context || !g.make_current(g.context, made->picture_.data(), gl_unsigned_byte,
                                      size.width, size.height)) {
        why = "libOSMesa made no context";
        return nullptr;
    }
    g.pixel_store(osmesa_y_up, 0);
    g.enable(gl_depth_test);
    g.depth_func(gl_greater); // 1 / w, as l3d has it
    g.clear_depth(0);
    g.viewport(0, 0, size.width, size.height);
    return made;
}

std::string osmesa::renderer() const {
    return reinterpret_cast<const char*>(gl_->get_string(gl_renderer));
}

void osmesa::set_projection(std::span<const float, 16> matrix) {
    gl_->matrix_mode(gl_modelview);
    gl_->load_identity();
    gl_->matrix_mode(gl_projection);
    gl_->load_matrix(matrix.data());
}

void osmesa::upload(const gl_mesh& mesh) {
    api& g = *gl_;
    if (!buffers_[0])
        g.gen_buffers(3, buffers_);
    const auto fill = [&](unsigned target, unsigned buffer, const auto& values) {
        g.bind_buffer(target, buffer);
        g.buffer_data(target, static_cast<std::ptrdiff_t>(values.size() * sizeof(values[0])),
                      values.data(), gl_static_draw);
    };
    fill(gl_array_buffer, buffers_[0], mesh.positions);
    g.enable_client_state(gl_vertex_array);
    g.vertex_pointer(3, gl_float, 0, nullptr);
    fill(gl_array_buffer, buffers_[1], mesh.colors);
    g.enable_client_state(gl_color_array);
    g.color_pointer(4, gl_unsigned_byte, 0, nullptr);
    fill(gl_element_buffer, buffers_[2], mesh.indices);
    index_count_ = static_cast<int>(mesh.indices.size());
}

void osmesa::draw() {
    gl_->clear(gl_color_bit | gl_depth_bit);
    gl_->draw_elements(gl_triangles, index_count_, gl_unsigned_int, nullptr);
    gl_->finish();
}
