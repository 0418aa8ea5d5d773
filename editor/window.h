// The window: GLFW with a GL 3.3 core context through EGL, its events as input events, and the
// frames that draw_ui() fills. It draws when something has happened, and otherwise sleeps.
#pragma once

#include <memory>
#include <string>

#include "editor/input/script.h"
#include "editor/state.h"

namespace wrinkle::editor {

struct WindowOptions {
    int width = 1600, height = 900;
    bool hidden_input = false;  // ignores the real mouse and keyboard: a script has the hand
};

// Makes the window look for news; from any thread, while there is one.
void wake_window();

class Window {
public:
    // Nothing, with one sentence, when there is no display or no GL.
    static std::unique_ptr<Window> open(const WindowOptions& options, std::string& why);
    ~Window();

    // Until the state wants to quit. With a script until it is done; false when it failed, with
    // the reason in `why`. `shot` is a file for a last picture, "" for none.
    bool run(State& state, Script* script, const std::string& shot, std::string& why);

private:
    Window() = default;
    bool listen(State& state, bool playing);
    void draw_frame(State& state);
    bool is_lost(const State& state) const;
    bool renew(State& state, std::string& why);
    void dress(const State& state);
    bool save_picture(const std::string& file) const;

    struct Handle;
    std::unique_ptr<Handle> handle_;
};

}  // namespace wrinkle::editor
