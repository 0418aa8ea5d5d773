#include "editor/view/input/input_queue.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cctype>
#include <utility>

#include "base/text.h"

namespace wrinkle::editor {
namespace {

constexpr std::pair<std::string_view, int> named_keys[] = {
    {"Ctrl", GLFW_KEY_LEFT_CONTROL},
    {"Shift", GLFW_KEY_LEFT_SHIFT},
    {"Alt", GLFW_KEY_LEFT_ALT},
    {"Space", GLFW_KEY_SPACE},
    {"Enter", GLFW_KEY_ENTER},
    {"Escape", GLFW_KEY_ESCAPE},
    {"Tab", GLFW_KEY_TAB},
    {"Delete", GLFW_KEY_DELETE},
    {"Backspace", GLFW_KEY_BACKSPACE},
    {"Up", GLFW_KEY_UP},
    {"Down", GLFW_KEY_DOWN},
    {"Left", GLFW_KEY_LEFT},
    {"Right", GLFW_KEY_RIGHT},
    {"Home", GLFW_KEY_HOME},
    {"End", GLFW_KEY_END},
};

unsigned next_code_point(std::string_view text, size_t& at) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(at++);
    const int more = first < 0x80 ? 0 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
    unsigned code = more == 0 ? first : first & (0x3FU >> more);
    for (int i = 0; i < more && at < text.size(); ++i)
        code = code << 6 | (byte(at++) & 0x3FU);
    return code;
}

// Events applied in the current frame so far.
struct Frame {
    unsigned buttons = 0;
    bool moved = false, wheeled = false, typed = false, keyed = false;
    bool struck = false;  // a non-modifier key was pressed: no more key events in this frame
    int keys[16] = {};
    size_t key_count = 0;

    bool had_key(int code) const {
        for (size_t i = 0; i < key_count; ++i)
            if (keys[i] == code) return true;
        return key_count == std::size(keys);
    }

    bool takes(const InputEvent& event) const {
        switch (event.kind) {
            case InputEvent::Kind::motion:
            case InputEvent::Kind::leave:
                return !buttons && !wheeled && !keyed && !typed;
            case InputEvent::Kind::button:
                return !(buttons & 1U << event.code) && !wheeled && !keyed && !typed;
            case InputEvent::Kind::wheel:
                return !moved && !buttons && !wheeled;
            case InputEvent::Kind::key:
                return !struck && !had_key(event.code) && !typed && !buttons && !moved;
            case InputEvent::Kind::character:
                return !keyed && !buttons && !moved && !wheeled;
            case InputEvent::Kind::drop:
                return !keyed && !buttons && !moved && !wheeled && !typed;
        }
        return false;
    }

    void note(const InputEvent& event) {
        switch (event.kind) {
            case InputEvent::Kind::motion:
            case InputEvent::Kind::leave:
            case InputEvent::Kind::drop:
                moved = true;
                break;
            case InputEvent::Kind::button:
                buttons |= 1U << event.code;
                break;
            case InputEvent::Kind::wheel:
                wheeled = true;
                break;
            case InputEvent::Kind::character:
                typed = true;
                break;
            case InputEvent::Kind::key:
                keyed = true;
                struck |= event.down &&
                          (event.code < GLFW_KEY_LEFT_SHIFT || event.code > GLFW_KEY_RIGHT_SUPER);
                keys[key_count++] = event.code;
                break;
        }
    }
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
    switch (event.kind) {
        case InputEvent::Kind::key:
            return event.code >= 0 && event.code < 512;
        case InputEvent::Kind::button:
            return event.code >= 0 && event.code < 5;
        default:
            return true;
    }
}

// Returns true for characters and key presses. A delayed key release would repeat the key.
bool is_typing(const InputEvent& event) {
    return event.kind == InputEvent::Kind::character ||
           (event.kind == InputEvent::Kind::key && event.down);
}

}  // namespace

int key_named(std::string_view name) {
    for (const auto& [each, code] : named_keys)
        if (each == name) return code;
    if (name.size() == 1 && std::isalnum(static_cast<unsigned char>(name[0])))
        return std::toupper(static_cast<unsigned char>(name[0]));
    if (name.size() == 2 && name[0] == 'F' && name[1] >= '1' && name[1] <= '9')
        return GLFW_KEY_F1 + (name[1] - '1');
    if (name.size() == 3 && name.substr(0, 2) == "F1" && name[2] >= '0' && name[2] <= '2')
        return GLFW_KEY_F10 + (name[2] - '0');
    return 0;
}

bool InputQueue::chord(std::string_view text) {
    const auto parts = split(text, '+');
    for (const std::string_view part : parts)
        if (key_named(part) == 0) return false;
    for (const std::string_view part : parts)
        key(key_named(part), true);
    for (auto part = parts.rbegin(); part != parts.rend(); ++part)
        key(key_named(*part), false);
    return true;
}

void InputQueue::type(std::string_view utf8) {
    for (size_t at = 0; at < utf8.size();)
        character(next_code_point(utf8, at));
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
    constexpr std::pair<ImGuiKey, int> table[] = {
        {ImGuiKey_Tab, GLFW_KEY_TAB},
        {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
        {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
        {ImGuiKey_UpArrow, GLFW_KEY_UP},
        {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
        {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
        {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
        {ImGuiKey_Home, GLFW_KEY_HOME},
        {ImGuiKey_End, GLFW_KEY_END},
        {ImGuiKey_Insert, GLFW_KEY_INSERT},
        {ImGuiKey_Delete, GLFW_KEY_DELETE},
        {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
        {ImGuiKey_Space, GLFW_KEY_SPACE},
        {ImGuiKey_Enter, GLFW_KEY_ENTER},
        {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
        {ImGuiKey_KeyPadEnter, GLFW_KEY_KP_ENTER},
        {ImGuiKey_A, GLFW_KEY_A},
        {ImGuiKey_C, GLFW_KEY_C},
        {ImGuiKey_V, GLFW_KEY_V},
        {ImGuiKey_X, GLFW_KEY_X},
        {ImGuiKey_Y, GLFW_KEY_Y},
        {ImGuiKey_Z, GLFW_KEY_Z},
    };
    for (const auto& [key, code] : table)
        io.KeyMap[key] = code;
}

}  // namespace wrinkle::editor
