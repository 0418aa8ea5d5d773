// Input events in order, passed to ImGui so that none is lost.
//
// ImGui 1.86 sees only the state of keys and buttons at the start of a frame: it misses a key that
// is pressed and released between two frames. Each frame therefore takes events only up to the
// first one that would hide another; the rest waits for the next frame. Window, scripts and tests
// all use the queue. Keys are GLFW key codes; for letters and digits, of the character that the key
// produces in the current keyboard layout.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

struct ImGuiIO;

namespace wrinkle::editor {

struct InputEvent {
    enum class Kind : uint8_t { key, character, button, motion, wheel, leave, drop };
    Kind kind = Kind::motion;
    int code = 0;                         // key, character (UTF-32) or button
    bool down = false;                    // key, button
    float x = 0, y = 0;                   // motion, drop: position; wheel: amount
    std::vector<std::string> files = {};  // drop
    bool of_key = false;                  // character: made by the key press just before
};

// Files dropped on the window. Position in logical pixels.
struct FileDrop {
    float x = 0, y = 0;
    std::vector<std::string> files;
};

class InputQueue {
public:
    void push(const InputEvent& event) { events_.push_back(event); }
    void key(int code, bool down) { push({InputEvent::Kind::key, code, down, 0, 0}); }
    void character(unsigned code) {
        const bool of_key =
            !events_.empty() && events_.back().down && events_.back().kind == InputEvent::Kind::key;
        push({InputEvent::Kind::character, static_cast<int>(code), false, 0, 0, {}, of_key});
    }
    void button(int button, bool down) { push({InputEvent::Kind::button, button, down, 0, 0}); }
    void motion(float x, float y) { push({InputEvent::Kind::motion, 0, false, x, y}); }
    // Window pixels per logical pixel (editor/view/look/look.h), for the window_ functions.
    void set_scale(float scale) { scale_ = scale; }
    void window_motion(double x, double y) {
        motion(static_cast<float>(x) / scale_, static_cast<float>(y) / scale_);
    }
    void window_drop(double x, double y, std::vector<std::string> files) {
        drop(static_cast<float>(x) / scale_, static_cast<float>(y) / scale_, std::move(files));
    }
    void wheel(float x, float y) { push({InputEvent::Kind::wheel, 0, false, x, y}); }
    void drop(float x, float y, std::vector<std::string> files) {
        push({InputEvent::Kind::drop, 0, false, x, y, std::move(files)});
    }

    // Presses the keys of "Ctrl+Shift+Z", "Delete" or "F2" in order and releases them in reverse
    // order. Returns false and queues nothing if a key is unknown.
    bool chord(std::string_view text);
    void type(std::string_view utf8);

    bool empty() const { return events_.empty(); }

    // Moves the events of one frame to `io`; call before ImGui::NewFrame(). File drops among them
    // are returned by take_drops(). With `typing_waits`, the first key press or character and all
    // later events wait for a later frame; the character of a key press that was already applied,
    // such as the one that opened a field, is discarded.
    void apply(ImGuiIO& io, bool typing_waits = false);
    std::vector<FileDrop> take_drops() { return std::exchange(drops_, {}); }

private:
    std::deque<InputEvent> events_;
    std::vector<FileDrop> drops_;
    float scale_ = 1;
};

// Returns the GLFW code of "A", "7", "F2", "Delete", "Space", "Escape", ...; 0 if unknown.
int key_named(std::string_view name);

// Maps ImGui's navigation and editing keys to GLFW codes.
void map_keys(ImGuiIO& io);

}  // namespace wrinkle::editor
