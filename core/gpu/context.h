// An OpenGL 3.3 core context without a window, made through EGL.
//
// offscreen() needs no display: it tries Mesa's surfaceless platform, then every EGL device, and
// works with any driver that offers one of them (llvmpipe included). sharing_current() makes a
// second context that shares textures, buffers and programs with the one that is current on the
// calling thread, for drawing on another thread; that context must come from EGL.
//
// A new context is not current. A context is current on at most one thread; every other function of
// this folder wants one current on its thread. A Program, Texture or Lookup may be used and
// destroyed under any context that shares with its own; a Target or Renderer only under the one it
// was made in, because GL does not share framebuffers and vertex arrays (a Target's texture() is
// shared). The driver stays loaded until the process ends. Failing gives one error of one sentence.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"

namespace wrinkle::gpu {

class Context {
public:
    static std::optional<Context> offscreen(Diagnostics& diagnostics);
    static std::optional<Context> sharing_current(Diagnostics& diagnostics);

    Context(Context&& other) noexcept;
    Context& operator=(Context&& other) noexcept;
    ~Context();

    bool make_current();
    void release_current();  // no context is current on this thread afterwards

    // "llvmpipe (LLVM 15.0.6, 256 bits)" and "4.5 (Core Profile) Mesa 22.3.6"; of a current
    // context.
    static std::string renderer_name();
    static std::string version_name();

    // Whether the driver has dropped the current context, as after a hang or a reset: nothing that
    // was made in it can be used again, it is to be destroyed. Drivers without robustness
    // (GL_KHR_robustness) never say so.
    static bool was_lost();

    // For programs that draw small pictures of ever new materials. Mesa's software driver then
    // spends half the time on a program's machine code; pictures keep their bits and take about as
    // long. To be called before the first context and the first thread; a GALLIVM_PERF that the
    // user has set stands, other drivers do not read it.
    static void prefer_quick_programs();

    // Waits until all that was drawn here can be seen by contexts that share with this one.
    static void finish();

private:
    Context() = default;
    static std::optional<Context> on_display(void* display, void* share, std::string& why);
    void destroy();

    void* display_ = nullptr;  // EGLDisplay
    void* context_ = nullptr;  // EGLContext
    void* surface_ = nullptr;  // EGLSurface; a 1 x 1 buffer where the driver wants one
};

}  // namespace wrinkle::gpu
