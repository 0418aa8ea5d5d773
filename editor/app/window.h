// The window: GLFW with a GL 3.3 core context through EGL. Converts its events to input events and
// draws frames with draw_ui(). Frames are drawn only when needed; otherwise the thread sleeps.
#pragma once

#include <memory>
#include <string>

#include "editor/app/script.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

struct WindowOptions {
    int width = 1600, height = 900;
    bool hidden_input = false;  // ignores the real mouse and keyboard, for scripts
};

// Wakes the event loop to draw a frame. Callable from any thread. Precondition: a window is open.
void wake_window();

class Window {
public:
    // Returns nullptr, with one sentence in `why`, if there is no display or no OpenGL 3.3.
    static std::unique_ptr<Window> open(const WindowOptions& options, std::string& why);
    ~Window();

    // Runs until state.quit is set, the script ends or, without a script, `shot` is written. `shot`
    // is the file for a final screenshot; "": none. Returns false, with the reason in `why`, if the
    // script fails, the screenshot cannot be written or a lost context cannot be replaced.
    bool run(State& state, Script* script, const std::string& shot, std::string& why);

private:
    Window() = default;
    bool listen(State& state, bool playing);
    void draw_frame(State& state);
    bool is_lost(const State& state) const;
    bool recreate_context(State& state, std::string& why);
    void update_title_and_cursor(const State& state);
    void read_pixel(State& state) const;  // for the eyedropper
    bool save_picture(const std::string& file) const;

    struct Handle;
    std::unique_ptr<Handle> handle_;
};

}  // namespace wrinkle::editor
