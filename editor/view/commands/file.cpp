#include "editor/model/bake/bake.h"
#include "editor/model/document/files.h"
#include "editor/model/document/library.h"
#include "editor/view/commands/groups.h"
#include "editor/view/panels/bake_dialog.h"
#include "editor/view/panels/browser.h"
#include "editor/view/panels/host_dialog.h"
#include "editor/view/preview/feed.h"

namespace wrinkle::editor {
namespace {

void reload(State& state) {
    for (const Use use : {Use::image, Use::mesh, Use::light})
        forget_files(state, use);
    state.is_synced = false;
    state.status = "Images, meshes and sub-graphs are read again.";
}

void save_as(State& state) {
    browse(state, Browser::Purpose::save_graph,
           state.path.empty() ? state.folder() / state.file_name() : state.path);
}

void open(State& state) {
    browse(state, Browser::Purpose::open_graph, state.folder() / "x");
}

std::string_view no_recoverable(const State& state) {
    return state.keeping.recoverable.empty() ? "Nothing is left to recover." : "";
}

std::string_view no_plugins(const State& state) {
    return state.plugins.places.empty() ? "No plugin or folder of plugins was given." : "";
}

void ask_recover(State& state) {
    request_action(state, {PendingAction::Kind::recover, state.keeping.recoverable.front().file});
}

constexpr Command file_table[] = {
    {"new", "New", "Ctrl+N", always,
     [](State& s) {
         s.start.left = true;
         request_action(s, {PendingAction::Kind::new_graph, {}});
     }},
    {"open", "Open...", "Ctrl+O", always, open},
    {"save", "Save", "Ctrl+S", always, [](State& s) { save_file(s); }},
    {"save-as", "Save as...", "Ctrl+Shift+S", always, save_as},
    {"add-to-library", "Add to the library", "",
     [](const State& s) { return why_not_in_library(s); }, [](State& s) { add_to_library(s); }},
    {"recover", "Recover unsaved graph...", "", no_recoverable, ask_recover},
    {"export-glsl", "Export GLSL...", "Ctrl+E", always,
     [](State& s) { browse(s, Browser::Purpose::export_text, usual_export(s)); }},
    {"export-host", "Export to a host...", "Ctrl+Shift+E",
     [](const State& s) { return no_maps(s); }, open_host_dialog},
    {"bake", "Bake maps...", "Ctrl+B", [](const State& s) { return no_maps(s); }, open_bake_dialog},
    {"reload", "Read files again", "F5", always, reload},
    {"reload-plugins", "Reload plugins", "", no_plugins,
     [](State& s) {
         reload_plugins(s);
         s.offer = {};
     }},
    {"quit", "Quit", "Ctrl+Q", always,
     [](State& s) {
         request_action(s, {PendingAction::Kind::quit, {}});
     }},
};

}  // namespace

const std::span<const Command> file_commands = file_table;

}  // namespace wrinkle::editor
