// Modal prompt: a title, a text below it and a row of buttons. Enter presses the first button,
// Escape the last.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/view/state.h"

namespace wrinkle::editor {

struct PromptButton {
    const char* label;
    const char* target;  // its name for scripts
};

struct Prompt {
    std::string title, text, error;  // text and error may be empty
    std::vector<PromptButton> buttons;
};

// Draws the prompt; the first call opens it, and a press of a button closes it. Returns the index
// of the pressed button. `id` is that of the popup, such as "##question".
std::optional<size_t> draw_prompt(Interface& interface, const char* id, const Prompt& prompt);

}  // namespace wrinkle::editor
