#include "editor/commands/groups.h"

namespace wrinkle::editor {
namespace {

template <gpu::View Which>
void show(State& state) {
    state.view.preview_view.view = Which;
}
template <gpu::View Which>
bool shown(const State& state) {
    return state.view.preview_view.view == Which;
}

constexpr Command table[] = {
    {"shaded", "Shaded", "1", "Preview", always, show<gpu::View::shaded>, shown<gpu::View::shaded>},
    {"normal", "Normal", "2", "Preview", always, show<gpu::View::normal>, shown<gpu::View::normal>},
    {"gradient", "Gradient", "3", "Preview", always, show<gpu::View::gradient>,
     shown<gpu::View::gradient>},
    {"height", "Height", "4", "Preview", always, show<gpu::View::height>, shown<gpu::View::height>},
    {"uv", "UV", "5", "Preview", always, show<gpu::View::uv>, shown<gpu::View::uv>},
    {"difference", "Difference", "6", "Preview", always, show<gpu::View::difference>,
     shown<gpu::View::difference>},
};

}  // namespace

std::span<const Command> preview_commands() {
    return table;
}

}  // namespace wrinkle::editor
