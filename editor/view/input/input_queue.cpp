#include "editor/view/input/input_queue.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include "base/text.h"

namespace wrinkle::editor {
namespace {

struct Key {
    std::string_view name;
    int code;
    int imgui = ImGuiKey_COUNT;  // ImGui's navigation and editing key, if it is one
};
constexpr Key keys[] = {
    {"Ctrl", GLFW_KEY_LEFT_CONTROL},
    {"Shift", GLFW_KEY_LEFT_SHIFT},
    {"Alt", GLFW_KEY_LEFT_ALT},
    {"Space", GLFW_KEY_SPACE, ImGuiKey_Space},
    {"Enter", GLFW_KEY_ENTER, ImGuiKey_Enter},
    {"KeypadEnter", GLFW_KEY_KP_ENTER, ImGuiKey_KeyPadEnter},
    {"Escape", GLFW_KEY_ESCAPE, ImGuiKey_Escape},
    {"Tab", GLFW_KEY_TAB, ImGuiKey_Tab},
    {"Insert", GLFW_KEY_INSERT, ImGuiKey_Insert},
    {"Delete", GLFW_KEY_DELETE, ImGuiKey_Delete},
    {"Backspace", GLFW_KEY_BACKSPACE, ImGuiKey_Backspace},
    {"Up", GLFW_KEY_UP, ImGuiKey_UpArrow},
    {"Down", GLFW_KEY_DOWN, ImGuiKey_DownArrow},
    {"Left", GLFW_KEY_LEFT, ImGuiKey_LeftArrow},
    {"Right", GLFW_KEY_RIGHT, ImGuiKey_RightArrow},
    {"PageUp", GLFW_KEY_PAGE_UP, ImGuiKey_PageUp},
    {"PageDown", GLFW_KEY_PAGE_DOWN, ImGuiKey_PageDown},
    {"Home", GLFW_KEY_HOME, ImGuiKey_Home},
    {"End", GLFW_KEY_END, ImGuiKey_End},
    {"A", GLFW_KEY_A, ImGuiKey_A},
    {"C", GLFW_KEY_C, ImGuiKey_C},
    {"V", GLFW_KEY_V, ImGuiKey_V},
    {"X", GLFW_KEY_X, ImGuiKey_X},
    {"Y", GLFW_KEY_Y, ImGuiKey_Y},
    {"Z", GLFW_KEY_Z, ImGuiKey_Z},
};

// Kinds of events applied in a frame, as bits.
enum Applied : unsigned { moved = 1, pressed = 2, wheeled = 4, typed = 8, keyed = 16 };

struct Rule {
    Applied applies;
    unsigned waits_for;  // kinds that hide the event from ImGui in one frame
};
// By InputEvent::Kind.
constexpr Rule rules[] = {
    {keyed, typed | pressed | moved},                    // key
    {typed, keyed | pressed | moved | wheeled},          // character
    {pressed, wheeled | keyed | typed},                  // button
    {moved, pressed | wheeled | keyed | typed},          // motion
    {wheeled, moved | pressed | wheeled},                // wheel
    {moved, pressed | wheeled | keyed | typed},          // leave
    {moved, moved | pressed | wheeled | keyed | typed},  // drop
};

// Events applied in the current frame so far.
class Frame {
public:
    bool takes(const InputEvent& event) const {
        if (applied_ & rules[static_cast<size_t>(event.kind)].waits_for) return false;
        if (event.kind == InputEvent::Kind::key) return !struck_ && !keys_.contains(event.code);
        // ImGui's sliders ignore a motion in the frame of the release.
        if (event.kind == InputEvent::Kind::button && !event.down && (applied_ & moved))
            return false;
        return event.kind != InputEvent::Kind::button || !buttons_.contains(event.code);
    }
    void note(const InputEvent& event) {
        applied_ |= rules[static_cast<size_t>(event.kind)].applies;
        if (event.kind == InputEvent::Kind::button) buttons_.insert(event.code);
        if (event.kind != InputEvent::Kind::key) return;
        keys_.insert(event.code);
        struck_ |=
            event.down && (event.code < GLFW_KEY_LEFT_SHIFT || event.code > GLFW_KEY_RIGHT_SUPER);
    }

private:
    unsigned applied_ = 0;
    bool struck_ = false;  // a non-modifier key was pressed: no more key events in this frame
    std::set<int> keys_, buttons_;
};

void write(const InputEvent& event, ImGuiIO& io) {
    switch (event.kind) {
        case InputEvent::Kind::motion:
        case InputEvent::Kind::drop:
            io.MousePos = ImVec2(event.x, event.y);
            break;
        case InputEvent::Kind::leave:
            io.MousePos = ImVec2(-FLT_MAX, -FLT_MAX);
            break;
        case InputEvent::Kind::button:
            io.MouseDown[event.code] = event.down;
            break;
        case InputEvent::Kind::wheel:
            io.MouseWheelH += event.x;
            io.MouseWheel += event.y;
            break;
        case InputEvent::Kind::key:
            io.KeysDown[event.code] = event.down;
            break;
        case InputEvent::Kind::character:
            io.AddInputCharacter(static_cast<unsigned>(event.code));
            break;
    }
}

bool is_valid(const InputEvent& event) {
    const int codes = event.kind == InputEvent::Kind::key ? 512 : 5;
    const bool coded =
        event.kind == InputEvent::Kind::key || event.kind == InputEvent::Kind::button;
    return !coded || (event.code >= 0 && event.code < codes);
}

// Returns true for characters and key presses. A delayed key release would repeat the key.
bool is_typing(const InputEvent& event) {
    return event.kind == InputEvent::Kind::character ||
           (event.kind == InputEvent::Kind::key && event.down);
}

}  // namespace

int key_named(std::string_view name) {
    for (const Key& key : keys)
        if (key.name == name) return key.code;
    if (name.size() == 1 && std::isalnum(static_cast<unsigned char>(name[0])))
        return std::toupper(static_cast<unsigned char>(name[0]));
    for (int number = 1; number <= 12; ++number)
        if (name == "F" + std::to_string(number)) return GLFW_KEY_F1 + number - 1;
    return 0;
}

bool InputQueue::chord(std::string_view text) {
    const auto parts = split(text, '+');
    if (!std::ranges::all_of(parts, key_named)) return false;
    for (const std::string_view part : parts)
        key(key_named(part), true);
    for (auto part = parts.rbegin(); part != parts.rend(); ++part)
        key(key_named(*part), false);
    return true;
}

void InputQueue::type(std::string_view utf8) {
    const char* const end = utf8.data() + utf8.size();
    for (const char* at = utf8.data(); at < end;) {
        unsigned code = 0;
        at += ImTextCharFromUtf8(&code, at, end);
        character(code);
    }
}

void InputQueue::apply(ImGuiIO& io, bool typing_waits) {
    Frame frame;
    while (!events_.empty() && frame.takes(events_.front())) {
        if (typing_waits && events_.front().of_key) {
            events_.pop_front();
            continue;
        }
        if (typing_waits && is_typing(events_.front())) break;
        if (is_valid(events_.front())) {
            frame.note(events_.front());
            write(events_.front(), io);
        }
        if (InputEvent& event = events_.front(); event.kind == InputEvent::Kind::drop)
            drops_.push_back({event.x, event.y, std::move(event.files)});
        events_.pop_front();
    }
    const auto down = [&](int left, int right) { return io.KeysDown[left] || io.KeysDown[right]; };
    io.KeyCtrl = down(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    io.KeyShift = down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    io.KeyAlt = down(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
    io.KeySuper = down(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
}

void map_keys(ImGuiIO& io) {
    for (const Key& key : keys)
        if (key.imgui != ImGuiKey_COUNT) io.KeyMap[key.imgui] = key.code;
}

}  // namespace wrinkle::editor
