// Modal prompt: a title, a text below it and a row of buttons. Enter presses the first button,
// Escape the last.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "editor/view/state.h"

namespace wrinkle::editor {

struct PromptButton {
    const char* label;
    const char* target;  // its name for scripts
    std::function<void(State&)> press;
};

struct Prompt {
    std::string title, text;  // the text may be empty
    std::vector<PromptButton> buttons;
    std::string error = {};  // empty: none
};

// Draws the prompt; the first call opens it. A button closes it and calls its `press`. `id` is that
// of the popup, such as "##question".
void draw_prompt(State& state, const char* id, const Prompt& prompt);

}  // namespace wrinkle::editor
