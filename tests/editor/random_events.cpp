#include "random_events.h"

#include <GLFW/glfw3.h>

#include <algorithm>

#include "editor/view/commands/commands.h"

namespace wrinkle::editor {

void RandomEvents::motion(float x, float y) {
    x_ = x, y_ = y;
    queue_.motion(x, y);
    ++count_;
}

void RandomEvents::button(int button, bool down) {
    queue_.button(button, down);
    ++count_;
}

// Counts a press and a release of the key and of each modifier.
void RandomEvents::chord(std::string_view keys) {
    if (queue_.chord(keys))
        count_ += 2 * (1 + static_cast<size_t>(std::count(keys.begin(), keys.end(), '+')));
}

void RandomEvents::type(const std::string& text) {
    queue_.type(text);
    count_ += text.size();
}

bool RandomEvents::aim(const std::string& name) {
    const auto rect = state_.targets.find(name);
    if (!rect) return false;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float x = rect->middle_x() + part(4) - 2, y = rect->middle_y() + part(4) - 2;
    if (x < 0 || y < 0 || x >= size.x || y >= size.y) return false;
    motion(x, y);
    return true;
}

void RandomEvents::move_by(float x, float y) {
    motion(x_ + x, y_ + y);
}

std::string RandomEvents::any_node() {
    const auto& nodes = state_.document().nodes;
    return nodes.empty() ? "" : nodes[pick(nodes.size())]->id;
}

std::string RandomEvents::any_port(const std::string& node, Port::Kind kind) {
    const NodeType* type = node.empty() || !state_.is_synced ? nullptr : state_.type_of(node);
    std::vector<std::string> names;
    for (const Port& port : type ? type->ports : std::vector<Port>())
        if ((port.kind == Port::Kind::output) == (kind == Port::Kind::output))
            names.push_back(port.name);
    return names.empty() ? "" : names[pick(names.size())];
}

// None of the texts is a path out of the test's folder.
std::string RandomEvents::any_text() {
    static const std::string texts[] = {"0.5",   "-3",         "7",      "-1e300",
                                        "1e300", "1e-320",     "nan",    "inf",
                                        "%s%n",  "0x1p3",      "1,5",    "--1",
                                        "a.b",   "graph.json", "x y",    "\xC3\xA9\xE2\x82\xAC",
                                        "$x",    "surface",    "\"",     "\xFF\xFE",
                                        "add",   "noise",      "1e9999", std::string(300, 'w')};
    return texts[pick(pick(8) ? std::size(texts) - 1 : std::size(texts))];
}

void RandomEvents::next() {
    if (has_open_dialog(state_) && pick(4)) return chord("Escape");
    const size_t what = pick(100);
    if (what < 27) return wire();
    if (what < 47) return drag_value();
    if (what < 53) return type_value();
    if (what < 71) return move_node();
    if (what < 80) return click_node();
    if (what < 85) return add_node();
    if (what < 94) return command();
    if (what < 97) return by_the_way();
    anything();
}

void RandomEvents::wire() {
    const std::string from = any_node(), to = any_node();
    if (!aim("out:" + from + "." + any_port(from, Port::Kind::output))) return chord("Home");
    button(0, true);
    const bool there = pick(12) && aim("pin:" + to + "." + any_port(to, Port::Kind::input));
    if (!there) move_by(part(300) - 150, part(300) - 150);
    button(0, false);
    if (!there) chord(pick(3) ? "Enter" : "Escape");
}

void RandomEvents::drag_value() {
    const std::string node = any_node();
    if (!aim("field:" + node + "." + any_port(node, Port::Kind::input))) return chord("Home");
    button(0, true);
    for (size_t n = 1 + pick(2); n > 0; --n)
        move_by(part(120) - 60, part(8) - 4);
    button(0, false);
}

void RandomEvents::type_value() {
    const std::string node = any_node();
    if (!aim("field:" + node + "." + any_port(node, Port::Kind::input))) return chord("Home");
    for (int i = 0; i < 2; ++i)
        button(0, true), button(0, false);
    type(any_text());
    chord(pick(4) ? "Enter" : "Tab");
}

void RandomEvents::move_node() {
    if (!aim("node:" + any_node())) return chord("Home");
    button(0, true);
    move_by(part(200) - 100, part(200) - 100);
    button(0, false);
}

// Clicks a node and presses the keys of a command.
void RandomEvents::click_node() {
    static constexpr const char* keys[] = {"Delete", "M",      "Ctrl+D", "C",      "Alt+S",
                                           "Ctrl+C", "Ctrl+V", "Ctrl+X", "Ctrl+G", "Enter"};
    if (!aim("node:" + any_node())) return chord("Home");
    button(0, true);
    button(0, false);
    chord(keys[pick(std::size(keys))]);
}

void RandomEvents::add_node() {
    const auto& types = state_.registry->list();
    chord("Space");
    type(pick(6) ? types[pick(types.size())].title.substr(0, 5) : any_text());
    chord("Enter");
}

void RandomEvents::command() {
    if (pick(3) == 0) return chord(pick(2) ? "Ctrl+Z" : "Ctrl+Shift+Z");
    const auto all = commands();
    const Command& command = all[pick(all.size())];
    if (!command.keys.empty() && command.enabled(state_)) chord(command.keys);
}

// Clicks a random target of the screen: menu, row, button or answer.
void RandomEvents::by_the_way() {
    const auto& all = state_.targets.all();
    if (all.empty() || pick(3) == 0) return chord(pick(2) ? "Escape" : "Home");
    if (!aim(std::next(all.begin(), static_cast<int>(pick(all.size())))->first)) return;
    const int which = pick(6) ? 0 : 1;
    button(which, true);
    button(which, false);
}

void RandomEvents::anything() {
    static constexpr int keys[] = {
        GLFW_KEY_LEFT_CONTROL, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_LEFT_ALT, GLFW_KEY_SPACE,
        GLFW_KEY_DELETE,       GLFW_KEY_BACKSPACE,  GLFW_KEY_UP,       GLFW_KEY_DOWN,
        GLFW_KEY_LEFT,         GLFW_KEY_RIGHT,      GLFW_KEY_HOME,     GLFW_KEY_END,
        GLFW_KEY_F1,           GLFW_KEY_F5,         GLFW_KEY_F11,      GLFW_KEY_KP_ENTER};
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ++count_;
    switch (pick(7)) {
        case 0:
            return queue_.motion(part(size.x * 1.2F) - 50, part(size.y * 1.2F) - 50);
        case 1:
            return queue_.button(static_cast<int>(pick(3)), pick(2) == 0);
        case 2:
            return queue_.wheel(pick(4) ? 0.0F : 1.0F, static_cast<float>(pick(7)) - 3);
        case 3:
            return queue_.key(
                pick(2) ? keys[pick(std::size(keys))] : 'A' + static_cast<int>(pick(26)),
                pick(2) == 0);
        case 4:
            return type(any_text());
        case 5:
            return chord(pick(3) ? "Enter" : pick(2) ? "Escape" : "Tab");
        default:
            queue_.push({InputEvent::Kind::leave, 0, false, 0, 0});
    }
}

void RandomEvents::reset_interaction() {
    for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key)
        queue_.key(key, false);
    for (int button = 0; button < 3; ++button)
        queue_.button(button, false);
}

}  // namespace wrinkle::editor
