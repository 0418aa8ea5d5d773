// An OpenGL 3.3 core context without a window, made through EGL.
//
// offscreen() requires no display: it tries Mesa's surfaceless platform, then every EGL device, and
// works with any driver that supports one of them (including llvmpipe). sharing_current() makes a
// second context that shares textures, buffers and programs with the one that is current on the
// calling thread, for drawing on another thread; the current context must come from EGL.
//
// A new context is not current. A context is current on at most one thread; every other function of
// this folder requires a current context on its thread. A Program, Texture or Sampler may be used
// and destroyed under any context of its share group; a Target or Renderer only under the context
// it was made in, because GL does not share framebuffers and vertex arrays (Target::texture() is
// shared). The driver stays loaded until the process ends. On failure, one error of one sentence is
// reported.
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

    // Strings of the current context, such as "llvmpipe (LLVM 15.0.6, 256 bits)" and
    // "4.5 (Core Profile) Mesa 22.3.6".
    static std::string renderer_name();
    static std::string version_name();

    // Returns true if the current context was lost, for example after a GPU hang or reset. The
    // context and its objects are then unusable and must be destroyed. Always false for drivers
    // without GL_KHR_robustness (core in GL 4.5).
    static bool was_lost();

    // For processes that draw small images of many different materials. Halves the time that
    // Mesa's software driver spends on compiling a program to machine code; images remain
    // bit-identical and take about as long to draw. Precondition: no context and no thread exists
    // yet. Does not overwrite a GALLIVM_PERF set by the user; other drivers ignore it.
    static void prefer_quick_programs();

    // Waits until all drawing of the current context is visible to the contexts that share with it.
    static void finish();

private:
    Context() = default;
    static std::optional<Context> on_display(void* display, void* share, std::string& why);

    void* display_ = nullptr;  // EGLDisplay
    void* context_ = nullptr;  // EGLContext
    void* surface_ = nullptr;  // EGLSurface; a 1 x 1 buffer if the driver requires one
};

}  // namespace wrinkle::gpu
