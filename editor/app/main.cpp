// wrinkle-editor FILE: the visual editor. Exit codes: 0 success, 1 the script failed or a file
// cannot be read or written, 2 wrong usage, 3 no window or no OpenGL.
#include <signal.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <atomic>
#include <cstdio>

#include "base/file.h"
#include "base/printable.h"
#include "editor/app/window.h"
#include "editor/model/document/files.h"
#include "editor/model/document/recovery.h"
#include "editor/view/lifecycle.h"
#include "gpu/context.h"
#include "registry/plugin_loader.h"

namespace wrinkle::editor {
namespace {

struct Arguments {
    std::string file;
    std::string script, shot, timings, state;
    std::vector<std::string> plugin_paths;
    std::vector<int> size;
};

int print_error(const std::string& sentence, int code) {
    std::fprintf(stderr, "wrinkle-editor: %s\n", printable(sentence).c_str());
    return code;
}

// With --script or --shot but without --state, no user settings are read and nothing is stored.
Folders folders_of(const Arguments& arguments) {
    if (!arguments.state.empty()) return folders_below(std::filesystem::absolute(arguments.state));
    return arguments.script.empty() && arguments.shot.empty() ? user_folders() : Folders();
}

void begin(State& state, const Arguments& arguments) {
    if (arguments.file.empty())
        new_file(state);
    else
        open_file(state, arguments.file);
    look_for_recoverable(state);
    offer_recovery(state);
}

void add_nodes(State& state, const Arguments& arguments) {
    state.plugins.places = plugin_places(arguments.plugin_paths);
    state.plugins.cache = plugin_cache();
    load_plugins(state);
    const Diagnostics& problems = state.plugins.problems;
    if (!problems.list().empty()) std::fputs(to_text(problems).c_str(), stderr);
}

bool write_timings(const State& state, const std::string& file) {
    std::string why;
    const Counters& counters = state.counters;
    if (write_file(file, state.timings->to_json(counters.builds, counters.programs), why))
        return true;
    print_error(file + " " + why, 1);
    return false;
}

// Worker threads. Destroyed before the state, which they refer to.
struct Workers {
    Preview preview{wake_window};
    Compiler compiler{build, wake_window};
    CostCounter counter{count, wake_window};
    CodeMaker code{make_code, wake_window};
    NodePreviewMaker pictures{NodePainter(), wake_window};
    FlatMaker flat{FlatPainter(), wake_window};
    GraphImageMaker graph_images{draw_graph_image, wake_window};
    std::atomic<bool> closing = false;
    ImageExaminer examiner{[this](std::filesystem::path&& file) {
                               const auto stopped = [this] { return closing.load(); };
                               return ImageAnswer{file, examine_file(file, stopped)};
                           },
                           wake_window};
    FileLooker looker{look_at_files};  // no wake callback, which would draw a frame

    explicit Workers(State& state) {
        state.preview = &preview;
        state.follow.compiler = &compiler;
        state.follow.counter = &counter;
        state.code.maker = &code;
        state.node_feed.maker = &pictures;
        state.flat.maker = &flat;
        state.graph_images.maker = &graph_images;
        state.used.looker = &looker;
        state.images.examiner = &examiner;
        state.tasks.wake = wake_window;
    }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    ~Workers() { closing = true; }
};

int run(const Arguments& arguments) {
    Timings timings;  // starts the clock
    std::optional<Script> script;
    std::string why;
    if (!arguments.script.empty()) {
        const auto text = read_file(arguments.script, why);
        if (!text) return print_error(arguments.script + " " + why, 1);
        script.emplace(*text);
    }
    State state;
    add_nodes(state, arguments);
    std::string settings_error;
    Persistence& keeping = state.keeping;
    keeping.folders = folders_of(arguments);
    use_settings(state, read_settings(keeping.folders, settings_error));
    const bool sized = arguments.size.size() == 2;
    WindowOptions options{sized ? arguments.size[0] : keeping.settings.width,
                          sized ? arguments.size[1] : keeping.settings.height,
                          script.has_value() || !arguments.shot.empty()};
    const auto window = Window::open(options, why);
    if (!window) return print_error(why, 3);
    Workers workers(state);
    state.fonts.load();
    state.thumbnails.use_gl();
    state.node_feed.atlas.use_gl();
    state.flat.gl = state.graph_images.gl = true;
    begin(state, arguments);
    if (!settings_error.empty()) state.status = settings_error;
    if (!arguments.timings.empty()) state.timings = &timings;
    const bool good = window->run(state, script ? &*script : nullptr, arguments.shot, why);
    state.tasks = {};                       // stops running tasks
    if (!good) return print_error(why, 1);  // unsaved edits remain in the recovery file
    finish(state);
    return !state.timings || write_timings(state, arguments.timings) ? 0 : 1;
}

}  // namespace
}  // namespace wrinkle::editor

int main(int argc, char** argv) {
    wrinkle::editor::Arguments arguments;
    CLI::App app("Edits a graph in a window", "wrinkle-editor");
    app.add_option("FILE", arguments.file, "The graph; a new one when it does not exist");
    app.add_option("--script", arguments.script, "Plays a script (editor/app/script.h) and ends");
    app.add_option("--shot", arguments.shot, "Writes a screenshot of the window and ends");
    app.add_option("--timings", arguments.timings,
                   "Writes how long frames took, and edits until their pixels were there");
    app.add_option("--size", arguments.size, "Width and height of the window")->expected(2);
    app.add_option("--state", arguments.state,
                   "Keeps settings, recovery files and the library here");
    app.add_option("--plugin-path", arguments.plugin_paths, "A plugin, or a folder of plugins")
        ->allow_extra_args(false)  // one per option: the next argument may be FILE
        ->take_all();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    signal(SIGXFSZ, SIG_IGN);  // a write past the size limit fails instead, and is reported
    wrinkle::gpu::Context::prefer_quick_programs();
    return wrinkle::editor::run(arguments);
}
