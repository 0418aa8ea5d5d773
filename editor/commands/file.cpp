#include "editor/code/export.h"
#include "editor/commands/groups.h"
#include "editor/document/files.h"
#include "editor/panels/browser.h"

namespace wrinkle::editor {
namespace {

void reload(State& state) {
    if (state.preview) state.preview->forget_images();
    state.fresh = false;
    state.status = "Read the images and sub-graphs again";
}

void quit(State& state) {
    (state.dirty() ? state.quit_asked : state.quit) = true;
}

constexpr Command table[] = {
    {"save", "Save", "Ctrl+S", "File", always, [](State& s) { save_file(s); }},
    {"export-glsl", "Export GLSL...", "Ctrl+E", "File", always,
     [](State& s) { browse(s, Browser::Purpose::export_text, usual_export(s)); }},
    {"reload", "Read images again", "F5", "File", always, reload},
    {"quit", "Quit", "Ctrl+Q", "File", always, quit},
};

}  // namespace

std::span<const Command> file_commands() {
    return table;
}

}  // namespace wrinkle::editor
