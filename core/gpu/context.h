// An OpenGL 3.3 core context without a window, made through EGL. A context is current on at most
// one thread, a new one on none; every other function of this folder requires a current context on
// its thread.
//
// A Program, Texture or Sampler may be used and destroyed under any context of its share group; a
// Target or Renderer only under the context it was made in, because GL does not share framebuffers
// and vertex arrays (Target::texture() is shared). The driver stays loaded until the process ends.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"

namespace wrinkle::gpu {

class Context {
public:
    // Requires no display: tries Mesa's surfaceless platform, then every EGL device. Works with any
    // driver that supports one of them (including llvmpipe). Reports one error on failure.
    static std::optional<Context> offscreen(Diagnostics& diagnostics);
    // Makes a context for drawing on another thread. It shares textures, buffers and programs with
    // the one that is current on this thread, which must come from EGL.
    static std::optional<Context> sharing_current(Diagnostics& diagnostics);

    Context(Context&& other) noexcept;
    Context& operator=(Context&& other) noexcept;
    ~Context();

    bool make_current();
    void release_current();  // no context is current on this thread afterwards

    // Name of the current context's device: "llvmpipe (LLVM 15.0.6, 256 bits)".
    static std::string renderer_name();

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
