// Benchmark of the canvas on the UI thread, without a window: milliseconds per frame at several
// sizes and zooms, hit tests, layout, and the work after an edit. Every frame pans or zooms and
// moves the pointer; times are processor time of draw_canvas() only, without rasterising.
#include <imgui.h>

#include <time.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/look/theme.h"
#include "editor/view/refresh.h"
#include "field_graph.h"
#include "graph/edit.h"
#include "graph/read.h"
#include "nodes/all.h"

namespace wrinkle::editor {
namespace {

double now() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

double timed(const std::function<void()>& what) {
    const double start = now();
    what();
    return now() - start;
}

struct Spread {
    double median = 0, p95 = 0;
};

Spread spread(std::vector<double> times) {
    std::sort(times.begin(), times.end());
    return {times[times.size() / 2], times[times.size() * 95 / 100]};
}

double draw(State& state) {
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({1344, 884});
    ImGui::Begin("canvas", nullptr, ImGuiWindowFlags_NoDecoration);
    state.targets.clear();
    const double time = timed([&] { draw_canvas(state); });
    ImGui::End();
    ImGui::Render();
    return time;
}

void put_pointer(float x, float y) {
    ImGui::GetIO().MousePos = {x, y};
}

void measure_view(State& state, const char* name, float zoom) {
    View& view = state.view;
    fit(view, state.layout, false);
    if (zoom > 0) zoom_at(view, state.layout, {672, 442}, zoom / view.zoom);
    draw(state);
    std::vector<double> panning, zooming;
    size_t vertices = 0;
    for (int i = 0; i < 200; ++i) {
        const auto step = static_cast<float>(i);
        view.pan.x += i % 100 < 50 ? 9.0F : -9.0F;
        put_pointer(200 + 4 * step, 100 + 3 * step);
        panning.push_back(draw(state));
        vertices = std::max(vertices, static_cast<size_t>(ImGui::GetDrawData()->TotalVtxCount));
    }
    for (int i = 0; i < 200; ++i) {
        zoom_at(view, state.layout, {672, 442}, i % 20 < 10 ? 1.03F : 1 / 1.03F);
        zooming.push_back(draw(state));
    }
    const Spread pan = spread(panning), zooms = spread(zooming);
    std::printf("  zoom %-5s panning %6.3f  p95 %6.3f   zooming %6.3f  p95 %6.3f   %zu vertices\n",
                name, pan.median, pan.p95, zooms.median, zooms.p95, vertices);
}

void measure_picking(State& state) {
    std::vector<double> times;
    for (int i = 0; i < 500; ++i) {
        const ImVec2 at(static_cast<float>(i * 37 % 1344), static_cast<float>(i * 91 % 884));
        times.push_back(timed([&] { pick(state, at); }));
    }
    const Spread picks = spread(times);
    std::printf("  picking %.4f  p95 %.4f\n", picks.median, picks.p95);
}

void measure_edits(State& state) {
    state.layout_stale = true;
    std::printf("  laying out again %.3f\n", timed([&] { refresh(state); }));
    state.view.selected = {"n7"};
    state.gesture.kind = Gesture::Kind::move;
    std::vector<double> drags;
    for (int i = 0; i < 100; ++i) {
        state.gesture.offset = {static_cast<float>(i * 8), 8};
        drags.push_back(draw(state));
    }
    state.gesture = {};
    std::printf("  dragging one node %.3f  p95 %.3f\n", spread(drags).median, spread(drags).p95);
    std::vector<double> moves;
    for (int i = 0; i < 20; ++i) {
        state.commit("Move", move_node(state.document(), "n7", i * 8, 8));
        moves.push_back(timed([&] { refresh(state); }));
    }
    std::printf("  refresh after a move %.3f  p95 %.3f\n", spread(moves).median, spread(moves).p95);
}

void measure(const Registry& registry, const Fonts& fonts, int count) {
    const std::string text = field_graph(count);
    State state;
    state.registry = &registry;
    state.fonts = fonts;
    Diagnostics problems;
    const double reading =
        timed([&] { state.history = History(read_document(text, "bench.json", problems)); });
    const double following = timed([&] { refresh(state); });
    const double first = draw(state);
    std::printf(
        "%d nodes, %zu wires: reading %.1f, model, texts and layout %.1f, first frame %.1f\n",
        count, state.layout.wires.size(), reading, following, first);
    measure_view(state, "all", 0);
    for (const auto& [name, zoom] : {std::pair{"0.3", 0.3F}, {"1", 1.0F}, {"4", 4.0F}})
        measure_view(state, name, zoom);
    fit(state.view, state.layout, false);
    measure_picking(state);
    measure_edits(state);
}

}  // namespace
}  // namespace wrinkle::editor

int main() {
    using namespace wrinkle::editor;
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1920, 1080};
    io.DeltaTime = 1.0F / 60;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    theme::use(Theme::dark);
    Fonts fonts;
    std::printf("milliseconds; fonts %.1f\n", timed([&] { fonts.load(); }));
    wrinkle::Registry registry;
    wrinkle::Diagnostics problems;
    registry.add_plugin(wrinkle::built_in_nodes(), wrinkle::Registry::built_in, problems);
    for (const int count : {500, 2000, 5000})
        measure(registry, fonts, count);
}
