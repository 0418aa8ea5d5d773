#include "editor/view/panels/help.h"
#include "editor/view/commands/groups.h"

namespace wrinkle::editor {
namespace {

constexpr Command help_table[] = {
    {"help", "Help on the selected node", "F1", always, show_help},
    {"shortcuts", "Shortcuts", "Shift+F1", always, show_shortcuts},
};

}  // namespace

const std::span<const Command> help_commands = help_table;

}  // namespace wrinkle::editor
