// Benchmark of an edit, its undo and its redo on the UI thread, with the compiler on its own
// thread: the command and refresh(), the write to the recovery file, and later the refresh()
// that takes the compiler's result. Processor and wall time, median and 95th percentile.
#include <imgui.h>
#include <unistd.h>

#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "editor/model/document/recovery.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/theme.h"
#include "editor/view/refresh.h"
#include "field_graph.h"
#include "graph/edit.h"
#include "graph/read.h"
#include "nodes/all.h"

namespace wrinkle::editor {
namespace {

double now(clockid_t clock) {
    timespec time;
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

struct Times {
    std::vector<double> processor, wall;

    void add(const std::function<void()>& what) {
        const double a = now(CLOCK_THREAD_CPUTIME_ID), b = now(CLOCK_MONOTONIC);
        what();
        processor.push_back(now(CLOCK_THREAD_CPUTIME_ID) - a);
        wall.push_back(now(CLOCK_MONOTONIC) - b);
    }
};

void print(const char* what, Times& times) {
    std::printf("    %-22s", what);
    for (std::vector<double>* list : {&times.processor, &times.wall}) {
        std::sort(list->begin(), list->end());
        std::printf("  %6.3f  p95 %6.3f", (*list)[list->size() / 2],
                    (*list)[list->size() * 95 / 100]);
    }
    std::printf("\n");
}

struct Edit {
    const char* name;
    std::function<Document(const Document&, int)> run;
};

std::string node(int i) {
    return "n" + std::to_string(i);
}

const Edit edits[] = {
    {"value",
     [](const Document& d, int i) {
         return set_value(d, node(i % 1000 * 4), "scale", json::Value::number(4 + i * 0.01));
     }},
    {"move", [](const Document& d, int i) { return move_node(d, node(i * 7 + 1), i, 8 * i); }},
    {"deletion", [](const Document& d, int i) { return remove_node(d, node(i * 11 + 2)); }},
    {"new wire",
     [](const Document& d, int i) {
         return connect(d, {node(i * 4), "height"}, node(i * 4 + 40), "amplitude");
     }},
};

void measure(State& state, Compiler& compiler, const Edit& edit, int times) {
    Times commit, keep, undo, redo, arrival;
    const auto settle = [&] {
        compiler.wait_idle();
        arrival.add([&] { refresh(state); });
    };
    const auto step = [&](Times& of, const std::function<void()>& what) {
        of.add([&] { what(), refresh(state); });
        keep.add([&] { keep_edits_now(state); });
        settle();
    };
    for (int i = 0; i < times; ++i) {
        Document after = edit.run(state.document(), i);
        step(commit, [&] { state.commit(edit.name, std::move(after)); });
        step(undo, [&] { state.history.undo(); });
        step(redo, [&] { state.history.redo(); });
        step(undo, [&] { state.history.undo(); });
    }
    std::printf("  %s%s\n", edit.name, state.built.uniform ? "" : " (nothing to draw)");
    print("commit, refresh", commit);
    print("undo, refresh", undo);
    print("redo, refresh", redo);
    print("kept for recovery", keep);
    print("result taken", arrival);
}

void measure_all(const Registry& registry, const Fonts& fonts, int count, int times) {
    State state;
    state.registry = &registry;
    state.fonts = fonts;
    Compiler compiler(build);
    state.follow.compiler = &compiler;
    const auto folder =
        std::filesystem::temp_directory_path() / ("wrinkle-bench-" + std::to_string(getpid()));
    state.keeping.folders.state = folder;
    Diagnostics problems;
    state.history = History(read_document(field_graph(count), "bench.json", problems));
    // From here on the text is canonical; an unedited document is written back byte by byte.
    state.commit("first", move_node(state.document(), "n0", 8, 8));
    refresh(state);
    compiler.wait_idle();
    refresh(state);
    std::printf("%d nodes, compiled in %.1f: processor, wall\n", count, state.built.milliseconds);
    for (const Edit& edit : edits)
        measure(state, compiler, edit, times);
    state.recovery_file.remove();
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace wrinkle::editor

int main(int count, char** arguments) {
    using namespace wrinkle::editor;
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1920, 1080};
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    theme::use(Theme::dark);
    Fonts fonts;
    fonts.load();
    wrinkle::Registry registry;
    wrinkle::Diagnostics problems;
    registry.add_plugin(wrinkle::built_in_nodes(), wrinkle::Registry::built_in, problems);
    std::printf("milliseconds\n");
    measure_all(registry, fonts, 5000, count > 1 ? std::atoi(arguments[1]) : 100);
}
