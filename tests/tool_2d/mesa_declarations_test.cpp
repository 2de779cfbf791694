// SPDX-License-Identifier: MIT
// What we declare of EGL and OSMesa is what their headers say, where these are installed.
#include "tool_2d/mesa/mesa_egl_p.h"
#include "tool_2d/mesa/mesa_osmesa_p.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace {

/// The same type, or two kinds of pointer.
template <class A, class B>
constexpr bool alike = std::is_same_v<A, B> || (std::is_pointer_v<A> && std::is_pointer_v<B>);

template <class R1, class... A1, class R2, class... A2>
constexpr bool same_shape(R1 (*)(A1...), R2 (*)(A2...)) {
    if constexpr (sizeof...(A1) != sizeof...(A2))
        return false;
    else
        return alike<R1, R2> && (alike<A1, A2> && ...);
}

/// Whether our function type Ours fits a pointer of theirs.
template <class Ours, class Theirs> constexpr bool fits() {
    return same_shape(static_cast<Ours*>(nullptr), static_cast<Theirs>(nullptr));
}

TEST(MesaDeclarations, CanTellShapesApart) {
    EXPECT_FALSE((fits<int(int), int (*)(int, int)>()));
    EXPECT_FALSE((fits<int(int), int (*)(unsigned)>()));
    EXPECT_FALSE((fits<int(int), void (*)(int)>()));
    EXPECT_FALSE((fits<int(void*), int (*)(int)>()));
    EXPECT_TRUE((fits<void*(int, char*), int* (*)(int, float*)>()));
}

} // namespace

#if __has_include(<GL/osmesa.h>)
#include <GL/osmesa.h>

namespace {
namespace ours = l3d_detail::osmesa;

static_assert(ours::bgra == OSMESA_BGRA);
static_assert(fits<ours::create_context_ext, decltype(&OSMesaCreateContextExt)>());
static_assert(fits<ours::destroy_context, decltype(&OSMesaDestroyContext)>());
static_assert(fits<ours::make_current, decltype(&OSMesaMakeCurrent)>());
static_assert(fits<ours::get_current_context, decltype(&OSMesaGetCurrentContext)>());
static_assert(fits<ours::get_proc_address, decltype(&OSMesaGetProcAddress)>());
} // namespace
#endif

#if __has_include(<EGL/egl.h>) && __has_include(<EGL/eglext.h>)
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace {
namespace egl = l3d_detail::egl;

static_assert(egl::platform_surfaceless == EGL_PLATFORM_SURFACELESS_MESA);
static_assert(egl::platform_device == EGL_PLATFORM_DEVICE_EXT);
static_assert(egl::opengl_api == EGL_OPENGL_API);
static_assert(egl::extensions == EGL_EXTENSIONS);
static_assert(egl::none == EGL_NONE);
static_assert(std::is_same_v<egl::attribute, EGLAttrib>);
static_assert(fits<egl::get_platform_display, decltype(&eglGetPlatformDisplay)>());
static_assert(fits<egl::initialize, decltype(&eglInitialize)>());
static_assert(fits<egl::query_string, decltype(&eglQueryString)>());
static_assert(fits<egl::bind_api, decltype(&eglBindAPI)>());
static_assert(fits<egl::create_context, decltype(&eglCreateContext)>());
static_assert(fits<egl::destroy_context, decltype(&eglDestroyContext)>());
static_assert(fits<egl::make_current, decltype(&eglMakeCurrent)>());
static_assert(fits<egl::get_current_context, decltype(&eglGetCurrentContext)>());
static_assert(fits<egl::get_error, decltype(&eglGetError)>());
static_assert(fits<egl::get_proc_address, decltype(&eglGetProcAddress)>());
static_assert(fits<egl::query_devices, PFNEGLQUERYDEVICESEXTPROC>());
static_assert(fits<egl::query_device_string, PFNEGLQUERYDEVICESTRINGEXTPROC>());
} // namespace
#endif
