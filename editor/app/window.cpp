#include "editor/app/window.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <utility>

#include "editor/view/commands/commands.h"
#include "editor/view/lifecycle.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"
#include "editor/view/refresh.h"
#include "gpu/context.h"
#include "gpu/target.h"
#include "image/load.h"

namespace wrinkle::editor {

struct Window::Handle {
    GLFWwindow* window = nullptr;
    InputQueue queue;
    bool scripted = false;
    double last = 0;
    std::string title;
    std::array<GLFWcursor*, ImGuiMouseCursor_COUNT> cursors = {};  // nullptr: the default arrow
    ImGuiMouseCursor cursor = ImGuiMouseCursor_Arrow;
    int drawn = 0;      // frames drawn in this context
    int awake = 3;      // frames still to draw
    bool lost = false;  // the driver dropped the context
};

namespace {

constexpr int min_width = 800, min_height = 500;

std::atomic<bool> woken = false;  // set by wake_window(), cleared by the event loop

InputQueue& queue_of(GLFWwindow* window) {
    return *static_cast<InputQueue*>(glfwGetWindowUserPointer(window));
}

// Returns letters and digits as the key produces them in the current keyboard layout, so that
// Ctrl+Z is the key labelled Z; other keys as `key`.
int produced(int key, int scancode) {
    const char* name = glfwGetKeyName(key, scancode);
    if (name && name[0] && !name[1] && std::isalnum(static_cast<unsigned char>(name[0])))
        return std::toupper(static_cast<unsigned char>(name[0]));
    return key;
}

// Also enabled while a script plays, for tests that drop files from another program.
void listen_for_drops(GLFWwindow* window) {
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** files) {
        double x = 0, y = 0;
        glfwGetCursorPos(w, &x, &y);
        queue_of(w).window_drop(x, y, {files, files + count});
    });
}

void listen(GLFWwindow* window) {
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int) {
        if (action != GLFW_REPEAT) return queue_of(w).key(produced(key, scancode), action);
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned code) { queue_of(w).character(code); });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
        queue_of(w).button(button, action == GLFW_PRESS);
    });
    glfwSetCursorPosCallback(
        window, [](GLFWwindow* w, double x, double y) { queue_of(w).window_motion(x, y); });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        queue_of(w).wheel(static_cast<float>(x), static_cast<float>(y));
    });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
        const bool held = glfwGetMouseButton(w, 0) || glfwGetMouseButton(w, 2);
        if (!entered && !held) queue_of(w).push({InputEvent::Kind::leave, 0, false, 0, 0});
    });
}

// Shapes missing in GLFW 3.3 remain the arrow.
void make_cursors(std::array<GLFWcursor*, ImGuiMouseCursor_COUNT>& cursors) {
    constexpr std::pair<ImGuiMouseCursor, int> shapes[] = {
        {ImGuiMouseCursor_TextInput, GLFW_IBEAM_CURSOR},
        {ImGuiMouseCursor_ResizeEW, GLFW_HRESIZE_CURSOR},
        {ImGuiMouseCursor_ResizeNS, GLFW_VRESIZE_CURSOR},
        {ImGuiMouseCursor_Hand, GLFW_HAND_CURSOR}};
    for (const auto& [which, shape] : shapes)
        cursors[static_cast<size_t>(which)] = glfwCreateStandardCursor(shape);
}

void use_clipboard(GLFWwindow* window) {
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = window;
    io.SetClipboardTextFn = [](void* w, const char* text) {
        glfwSetClipboardString(static_cast<GLFWwindow*>(w), text);
    };
    io.GetClipboardTextFn = [](void* w) {
        return glfwGetClipboardString(static_cast<GLFWwindow*>(w));
    };
}

std::string glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "unknown reason";
}

GLFWwindow* make_window(const WindowOptions& options) {
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    // Not every driver supports reset notification.
    for (const int robustness : {GLFW_LOSE_CONTEXT_ON_RESET, GLFW_NO_ROBUSTNESS}) {
        glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, robustness);
        GLFWwindow* window =
            glfwCreateWindow(std::max(options.width, min_width),
                             std::max(options.height, min_height), "Wrinkle", nullptr, nullptr);
        if (!window) continue;
        glfwSetWindowSizeLimits(window, min_width, min_height, GLFW_DONT_CARE, GLFW_DONT_CARE);
        return window;
    }
    return nullptr;
}

// Initialises everything bound to one window and its context. ImGui's own state outlives them.
void adopt(GLFWwindow* window, InputQueue& queue, bool scripted) {
    glfwMakeContextCurrent(window);
    glfwSwapInterval(scripted ? 0 : 1);
    glfwSetWindowUserPointer(window, &queue);
    use_clipboard(window);
    ImGui_ImplOpenGL3_Init("#version 330 core");
    listen_for_drops(window);
    if (!scripted) listen(window);
}

// Some drivers recompile a program for the first texture of a different kind. Draws one pixel of
// such a texture in the second frame, so that they recompile at startup, not when the first
// rendering appears.
// The returned texture must exist until the frame is drawn; std::nullopt if it cannot be made.
std::optional<gpu::Target> warm_up_textures() {
    Diagnostics ignored;  // without the texture a later frame takes longer
    std::optional<gpu::Target> texture = gpu::Target::make({.width = 3, .height = 3}, ignored);
    if (!texture) return texture;
    const auto id = reinterpret_cast<ImTextureID>(static_cast<intptr_t>(texture->texture()));
    ImGui::GetBackgroundDrawList()->AddImage(id, {0, 0}, {1, 1}, {0, 0}, {1, 1},
                                             IM_COL32(0, 0, 0, 1));
    return texture;
}

// The most seconds to wait for an event before the next frame.
double wait_time(const State& state) {
    if (state.play.moves()) return 0.01;
    return state.help.waiting || state.tasks.running ? 0.1 : 0.5;
}

}  // namespace

void wake_window() {
    woken = true;
    glfwPostEmptyEvent();
}

std::unique_ptr<Window> Window::open(const WindowOptions& options, std::string& why) {
    if (!glfwInit()) {
        why = "no window can be opened: " + glfw_error();
        return nullptr;
    }
    GLFWwindow* window = make_window(options);
    if (!window) {
        why = "no OpenGL 3.3 window can be opened: " + glfw_error();
        glfwTerminate();
        return nullptr;
    }
    std::unique_ptr<Window> result(new Window);
    result->handle_ = std::make_unique<Handle>();
    result->handle_->window = window;
    result->handle_->scripted = options.hidden_input;
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    // Seconds. Clicks of a script follow each other within a few frames of 1/60 s.
    io.MouseDoubleClickTime = options.hidden_input ? 0.06F : 0.4F;
    map_keys(io);
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    make_cursors(result->handle_->cursors);
    theme::use(Theme::dark);
    adopt(window, result->handle_->queue, options.hidden_input);
    return result;
}

Window::~Window() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(handle_->window);
    glfwTerminate();
}

bool Window::is_lost(const State& state) const {
    return handle_->lost || gpu::Context::was_lost() ||
           (state.preview && state.preview->shown().lost);
}

// Replaces the window by one of the same size, because a context cannot be recreated in the same
// window. Returns false, with the reason in `why`, if no window can be opened.
bool Window::recreate_context(State& state, std::string& why) {
    Handle& h = *handle_;
    h.lost = false;
    WindowOptions options;
    glfwGetWindowSize(h.window, &options.width, &options.height);
    if (state.preview) state.preview->leave_context();
    state.thumbnails.forget();
    state.graph_images.forget();
    state.node_feed.atlas.forget();
    state.node_feed.forget();
    state.flat.texture = 0;
    state.flat.forget();
    ImGui_ImplOpenGL3_Shutdown();
    GLFWwindow* window = make_window(options);
    if (!window) {
        why = "the graphics driver stopped, and no window can be opened any more: " + glfw_error();
        return false;
    }
    glfwDestroyWindow(h.window);
    h.window = window;
    h.title.clear();
    h.drawn = 0;
    adopt(window, h.queue, h.scripted);
    if (state.preview) state.preview->recreate_context();
    state.status = "The graphics driver was reset; everything is drawn again.";
    h.awake = 3;
    return true;
}

void Window::draw_frame(State& state) {
    ImGuiIO& io = ImGui::GetIO();
    int width = 0, height = 0, pixels_x = 0, pixels_y = 0;
    glfwGetWindowSize(handle_->window, &width, &height);
    glfwGetFramebufferSize(handle_->window, &pixels_x, &pixels_y);
    if (width < 1 || height < 1) return;
    if (apply_look(state.look, state.fonts)) {
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    const float scale = state.look.scale;
    handle_->queue.set_scale(scale);
    io.DisplaySize = {static_cast<float>(width) / scale, static_cast<float>(height) / scale};
    io.DisplayFramebufferScale = {static_cast<float>(pixels_x) / io.DisplaySize.x,
                                  static_cast<float>(pixels_y) / io.DisplaySize.y};
    const double now = glfwGetTime();
    io.DeltaTime = handle_->scripted
                       ? 1.0F / 60
                       : std::clamp(static_cast<float>(now - handle_->last), 0.001F, 0.2F);
    handle_->last = now;
    handle_->queue.apply(io, typing_waits(state));
    state.dropped.arrived = handle_->queue.take_drops();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    draw_ui(state);
    const auto rehearsal = ++handle_->drawn == 2 ? warm_up_textures() : std::nullopt;
    ImGui::Render();
    sharpen(*ImGui::GetDrawData(), io.DisplayFramebufferScale.x);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, pixels_x, pixels_y);
    const ImVec4 ground = ImGui::ColorConvertU32ToFloat4(theme::canvas);
    glClearColor(ground.x, ground.y, ground.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (state.eyedropper.on) read_pixel(state);
    update_title_and_cursor(state);
}

void Window::read_pixel(State& state) const {
    const ImGuiIO& io = ImGui::GetIO();
    state.eyedropper.pixel.reset();
    if (!ImGui::IsMousePosValid()) return;
    const ImVec2 scale = io.DisplayFramebufferScale;
    const auto x = static_cast<int>(io.MousePos.x * scale.x);
    const auto y = static_cast<int>(io.DisplaySize.y * scale.y) - 1 -
                   static_cast<int>(io.MousePos.y * scale.y);
    glReadBuffer(GL_BACK);
    glReadPixels(x, y, 1, 1, GL_RGB, GL_FLOAT, state.eyedropper.pixel.emplace().data());
}

// Updates the window title and the cursor shape if they changed.
void Window::update_title_and_cursor(const State& state) {
    const ImGuiMouseCursor cursor = ImGui::GetMouseCursor();
    if (cursor != handle_->cursor && cursor >= 0) {
        handle_->cursor = cursor;
        glfwSetCursor(handle_->window, handle_->cursors[static_cast<size_t>(cursor)]);
    }
    if (state.title() != handle_->title) {
        handle_->title = state.title();
        glfwSetWindowTitle(handle_->window, handle_->title.c_str());
    }
}

bool Window::save_picture(const std::string& file) const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(handle_->window, &width, &height);
    Image image =
        make_image(static_cast<uint32_t>(width), static_cast<uint32_t>(height), 3, PixelType::u8);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, width, height, GL_RGB, GL_FLOAT, image.data.data());
    Diagnostics problems;
    return save_image(image, file, {}, problems);
}

// Processes the events, sleeping while there are none. Returns true if a frame must be drawn.
bool Window::listen(State& state, bool playing) {
    Handle& h = *handle_;
    if (h.awake > 0 || !h.queue.empty() || playing)
        glfwPollEvents();
    else
        glfwWaitEventsTimeout(wait_time(state));
    // Files are also read while a frame is drawn, after its refresh(): the next frame shows them.
    if (state.help.waiting || state.thumbnails.waiting() || state.tasks.running ||
        state.play.moves() || !state.is_synced)
        h.awake = std::max(h.awake, 1);
    if (autosave_and_check_files(state)) h.awake = 3;
    if (!h.queue.empty() || state.gesture.panning) h.awake = 3;
    if (woken.exchange(false)) h.awake = std::max(h.awake, 1);  // one frame shows a result
    if (glfwWindowShouldClose(h.window)) {
        glfwSetWindowShouldClose(h.window, GLFW_FALSE);
        run_command(state, "quit");
        h.awake = 3;
    }
    if (h.awake <= 0 && !ImGui::GetIO().WantTextInput && !playing) return false;
    --h.awake;
    return true;
}

bool Window::run(State& state, Script* script, const std::string& shot, std::string& why) {
    Handle& h = *handle_;
    const Script::Screen screen{[&](const std::string& file) { return save_picture(file); },
                                [&h] { h.lost = true; }};
    const bool playing = script || !shot.empty();
    for (int frames = 1; !state.quit; ++frames) {
        // Also while playing, the loop sleeps while a build or a rendering is pending.
        if (!listen(state, playing && is_settled(state))) continue;
        const FrameGate::Frame frame = state.preview->frame();
        if (state.timings) state.timings->frame_begins();
        draw_frame(state);
        const auto progress = script              ? script->step(state, h.queue, screen)
                              : is_settled(state) ? Script::Progress::done
                                                  : Script::Progress::running;
        if (progress == Script::Progress::failed) {
            why = script->why();
            return false;
        }
        const bool finished = playing && frames > 3 && progress == Script::Progress::done;
        if (finished && !shot.empty() && !save_picture(shot)) {
            why = shot + " cannot be written";
            return false;
        }
        if (finished) return true;
        glfwSwapBuffers(h.window);
        if (state.timings) state.timings->frame_ends(state.preview->shown().version);
        if (is_lost(state) && !recreate_context(state, why)) return false;
    }
    return true;
}

}  // namespace wrinkle::editor
