// The parts of the preview panel.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

void draw_preview_head(State& state);
void draw_preview_strip(State& state);
void draw_preview_picture(State& state, ImVec2 at, ImVec2 size);
float compare_height(float width);
void draw_compare(State& state, ImVec2 at, float width);

// "UDN blend": what side B is compared with.
std::string against_label(const PreviewRequest& request);

// A list that opens below a button; entries are chosen by `pick`, of the index.
struct Choices {
    std::vector<std::string> labels, targets;
    int chosen = -1;
};
// The index that was picked, or -1.
int choose(State& state, const char* id, const std::string& target, const std::string& shown,
           const Choices& choices, float width);

// The shapes of the preview; `mesh` is a shape's name or a file's path.
Choices mesh_choices(const std::string& mesh);
std::string mesh_label(const std::string& mesh);  // "Sphere", "teapot.glb"

// A small text on a ground that keeps it readable over any picture; `at` is its upper left corner.
// Says how wide it is.
float draw_chip(const State& state, ImVec2 at, const std::string& text, bool right_aligned = false,
                ImU32 color = 0);

}  // namespace wrinkle::editor
