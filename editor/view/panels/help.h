// In-editor help: the page of a node type, tooltips with the docs of the element under the pointer,
// the list of shortcuts from the table of commands.
#pragma once

#include <string>

#include "editor/view/state.h"

namespace wrinkle::editor {

// F1: opens the page of the selected node's type; the shortcuts if not exactly one is selected.
void show_help(State& state);
void show_shortcuts(State& state);

// Writes a paragraph, wrapped at the current ImGui wrap position.
void write_wrapped(const Fonts& fonts, const std::string& text, ImU32 color, bool bold = false,
                   float size = 16);

// Returns type, unit, default and range: "float, m, default 0.1, 0 to 1".
std::string port_facts(const Port& port);

// Returns the tables of docs/editor.md; a test compares them.
std::string shortcuts_markdown();

// Sections of a node's page on the images that it reads: the facts found with the measured
// values, and the warnings with buttons for their remedies.
void draw_image_sections(State& state, const Node& node);

// Returns a tooltip on the image at an input: "Tangent-space normal map, green up: curl +0.87.", or
// why it could not be examined; "" if it was not examined.
std::string image_words(const Session& session, const std::string& node, const std::string& port);

}  // namespace wrinkle::editor
