#include "gpu/context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <stdlib.h>

#include <array>
#include <utility>
#include <vector>

namespace wrinkle::gpu {
namespace {

std::vector<EGLDisplay> candidate_displays() {
    const auto has = [](const char* name) { return epoxy_has_egl_extension(EGL_NO_DISPLAY, name); };
    std::vector<EGLDisplay> displays;
    if (!has("EGL_EXT_platform_base")) return displays;
    if (has("EGL_MESA_platform_surfaceless"))
        displays.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    const bool can_list = has("EGL_EXT_device_enumeration") || has("EGL_EXT_device_base");
    if (!can_list || !has("EGL_EXT_platform_device")) return displays;
    std::array<EGLDeviceEXT, 32> devices{};
    EGLint count = 0;
    eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
    for (size_t i = 0; i < static_cast<size_t>(count); ++i)
        displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    return displays;
}

EGLConfig choose_config(EGLDisplay display) {
    const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                       EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = EGL_NO_CONFIG_KHR;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count == 0)
        return EGL_NO_CONFIG_KHR;
    return config;
}

bool is_robust_gl() {
    return epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness");
}

// Contexts of a share group must have the same reset notification strategy.
bool has_reset_notification(EGLContext context) {
    if (context == EGL_NO_CONTEXT || !is_robust_gl()) return false;
    GLint strategy = GL_NO_RESET_NOTIFICATION;
    glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY, &strategy);
    return strategy == GL_LOSE_CONTEXT_ON_RESET;
}

EGLContext create_context(EGLDisplay display, EGLConfig config, EGLContext share) {
    const std::array<EGLint, 9> wanted{EGL_CONTEXT_MAJOR_VERSION,
                                       3,
                                       EGL_CONTEXT_MINOR_VERSION,
                                       3,
                                       EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                       EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                       has_reset_notification(share)
                                           ? EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_KHR
                                           : EGL_NONE,
                                       EGL_LOSE_CONTEXT_ON_RESET_KHR,
                                       EGL_NONE};
    return eglCreateContext(display, config, share, wanted.data());
}

// Makes the context that was current at construction current again at destruction.
class CurrentGuard {
public:
    CurrentGuard() = default;
    CurrentGuard(const CurrentGuard&) = delete;
    CurrentGuard& operator=(const CurrentGuard&) = delete;
    ~CurrentGuard() {
        if (context_ != EGL_NO_CONTEXT) eglMakeCurrent(display_, draw_, read_, context_);
    }

private:
    EGLDisplay display_ = eglGetCurrentDisplay();
    EGLContext context_ = eglGetCurrentContext();
    EGLSurface draw_ = eglGetCurrentSurface(EGL_DRAW);
    EGLSurface read_ = eglGetCurrentSurface(EGL_READ);
};

}  // namespace

std::optional<Context> Context::on_display(void* display, void* share, std::string& why) {
    if (!eglBindAPI(EGL_OPENGL_API)) {
        why = "the driver has no desktop OpenGL";
        return std::nullopt;
    }
    const EGLConfig config = choose_config(display);
    Context context;
    context.display_ = display;
    context.context_ = create_context(display, config, share);
    if (context.context_ == EGL_NO_CONTEXT) {
        why = "the driver has no OpenGL 3.3 core profile";
        return std::nullopt;
    }
    if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context")) {
        const std::array<EGLint, 5> size{EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
        context.surface_ = eglCreatePbufferSurface(display, config, size.data());
    }
    const CurrentGuard guard;
    if (!context.make_current()) {
        why = "the driver cannot draw without a window";
        return std::nullopt;
    }
    context.release_current();
    return context;
}

std::optional<Context> Context::offscreen(Diagnostics& diagnostics) {
    std::string why = "no EGL platform without a display was found";
    if (!epoxy_has_egl()) why = "libEGL is missing";
    for (EGLDisplay display : epoxy_has_egl() ? candidate_displays() : std::vector<EGLDisplay>{}) {
        if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
            why = "no graphics driver could be started";
            continue;
        }
        if (std::optional<Context> context = on_display(display, EGL_NO_CONTEXT, why))
            return context;
    }
    diagnostics.error(RuleId::opengl, "OpenGL is not available: " + why,
                      "an EGL driver with OpenGL 3.3, such as Debian's libegl-mesa0");
    return std::nullopt;
}

std::optional<Context> Context::sharing_current(Diagnostics& diagnostics) {
    const bool has_egl = epoxy_has_egl() && eglBindAPI(EGL_OPENGL_API);  // per API
    const EGLContext share = has_egl ? eglGetCurrentContext() : EGL_NO_CONTEXT;
    if (share == EGL_NO_CONTEXT) {
        diagnostics.error(RuleId::opengl, "there is no EGL context on this thread to share with");
        return std::nullopt;
    }
    std::string why;
    std::optional<Context> context = on_display(eglGetCurrentDisplay(), share, why);
    if (!context) diagnostics.error(RuleId::opengl, "OpenGL cannot draw on another thread: " + why);
    return context;
}

Context::Context(Context&& other) noexcept {
    *this = std::move(other);
}

Context& Context::operator=(Context&& other) noexcept {
    std::swap(display_, other.display_);
    std::swap(context_, other.context_);
    std::swap(surface_, other.surface_);
    return *this;
}

Context::~Context() {
    if (context_ && eglGetCurrentContext() == context_) release_current();
    if (surface_) eglDestroySurface(display_, surface_);
    if (context_) eglDestroyContext(display_, context_);
}

bool Context::make_current() {
    eglBindAPI(EGL_OPENGL_API);  // per-thread state
    return eglMakeCurrent(display_, surface_, surface_, context_);
}

void Context::release_current() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

std::string Context::renderer_name() {
    const GLubyte* name = glGetString(GL_RENDERER);
    return name ? reinterpret_cast<const char*>(name) : "";
}
void Context::prefer_quick_programs() {
    setenv("GALLIVM_PERF", "nopt", 0);
}

bool Context::was_lost() {
    return is_robust_gl() && glGetGraphicsResetStatus() != GL_NO_ERROR;
}
void Context::finish() {
    glFinish();
}

}  // namespace wrinkle::gpu
