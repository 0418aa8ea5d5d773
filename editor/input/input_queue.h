// Input events in the order they happened, handed to Dear ImGui so that none is lost.
//
// Dear ImGui 1.86 sees only the state of keys and buttons at the start of a frame: a key that goes
// down and up between two frames was never pressed. The queue gives a frame only as many events as
// leave every change visible; the rest waits for the next frame. Window, scripts and tests all
// speak through it. Keys are GLFW key codes, letters by the character they produce.
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
    bool of_key = false;                  // character: of the key that went down just before
};

// Files let go over the window; logical pixels.
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
    // Of the window: `scale` of its pixels make one of the interface's (editor/look/look.h).
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

    // "Ctrl+Shift+Z", "Delete", "F2": modifiers down, the key down and up, modifiers up. False for
    // a chord that names no key.
    bool chord(std::string_view text);
    void type(std::string_view utf8);

    bool empty() const { return events_.empty(); }

    // Writes one frame's worth into `io`; before ImGui::NewFrame(). What was dropped in that frame
    // is left for take_drops(). With `typing_waits` the first key that goes down or character, and
    // what follows it, stays for a later frame; the letter of a key that has gone down before, the
    // one that opened a field, is dropped.
    void apply(ImGuiIO& io, bool typing_waits = false);
    std::vector<FileDrop> take_drops() { return std::exchange(drops_, {}); }

private:
    std::deque<InputEvent> events_;
    std::vector<FileDrop> drops_;
    float scale_ = 1;
};

// The GLFW code of "A", "7", "F2", "Delete", "Space", "Escape", ...; 0 for none.
int key_named(std::string_view name);

// Tells ImGui which of our codes are its navigation and editing keys.
void map_keys(ImGuiIO& io);

}  // namespace wrinkle::editor
