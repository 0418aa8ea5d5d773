// What the editor says about itself and about nodes: the page of a node's type, the docs of what is
// under the pointer, the list of shortcuts from the table of commands.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "editor/state.h"

namespace wrinkle::editor {

// F1: the page of the selected node's type, else the shortcuts.
void show_help(State& state);
void show_shortcuts(State& state);
void draw_help(State& state);

// A tooltip once the pointer has rested on a node, a pin or a value.
void draw_hover_docs(State& state);

// A paragraph of such a page, wrapped where the page says.
void write_wrapped(const State& state, const std::string& text, ImU32 color, bool bold = false,
                   float size = 16);

// "float, m, default 0.1, 0 to 1"
std::string port_facts(const Port& port);

// What the hand does on the canvas, beside the commands.
struct GestureHelp {
    std::string_view hand, what;
};
std::span<const GestureHelp> gesture_help();

// The table of docs/editor.md, written by the test that compares it.
std::string shortcuts_markdown();

}  // namespace wrinkle::editor
