// JSON text in, GLSL text out: chains of N normal maps that cycle through two images, each with
// its own tiling so that no read merges.
#include <benchmark/benchmark.h>

#include <string>

#include "glsl/emit.h"
#include "graph/subgraph.h"
#include "lower/material.h"
#include "nodes/all.h"

namespace {

using namespace wrinkle;

std::string id(const char* stem, int64_t i) {
    return stem + std::to_string(i);
}

std::string normal_chain(int64_t layers) {
    static constexpr const char* images[] = {"weave_normal", "rivets_normal"};
    std::string nodes, previous;
    for (int64_t i = 0; i < layers; ++i) {
        const std::string tile = id("tile", i), map = id("map", i), sum = id("sum", i);
        nodes += "\"" + tile + "\": {\"type\": \"uv_transform\", \"in\": {\"scale\": [" +
                 std::to_string(i + 2) + ", " + std::to_string(i + 3) + "]}},\n\"" + map +
                 "\": {\"type\": \"tangent_normal_map\", \"in\": {\"image\": \"textures/" +
                 images[i % 2] + ".png\", \"uv\": {\"from\": \"" + tile + ".uv\"}}},\n";
        if (i > 0)
            nodes += "\"" + sum + "\": {\"type\": \"gradient_add\", \"in\": {\"a\": {\"from\": \"" +
                     previous + "\"}, \"b\": {\"from\": \"" + map + ".gradient\"}}},\n";
        previous = (i > 0 ? sum : map) + ".gradient";
    }
    return "{\"wrinkle\": 1, \"nodes\": {" + nodes +
           "\"end\": {\"type\": \"resolve\", \"in\": {\"gradient\": {\"from\": \"" + previous +
           "\"}}}}, \"outputs\": {\"normal\": {\"from\": \"end.normal\"}}}";
}

const Registry& registry() {
    static const Registry* nodes = [] {
        auto* made = new Registry;
        Diagnostics diagnostics;
        made->add_plugin(built_in_nodes(), Registry::built_in, diagnostics);
        return made;
    }();
    return *nodes;
}

size_t compiled_bytes(const std::string& text, Diagnostics& diagnostics) {
    Document top = read_document(text, "bench.json", diagnostics);
    const Project project =
        load_project(std::move(top), WRINKLE_SOURCE_DIR "/graphs", {}, diagnostics);
    const Compiled compiled = compile_material(project, registry(), {}, diagnostics);
    return compiled.ok ? emit(compiled.module, {}).source.size() : 0;
}

void normal_maps(benchmark::State& state) {
    const std::string text = normal_chain(state.range(0));
    size_t bytes = 0;
    for (auto _ : state) {
        Diagnostics diagnostics;
        bytes = compiled_bytes(text, diagnostics);
        if (bytes == 0) state.SkipWithError(to_text(diagnostics).c_str());
    }
    state.counters["glsl_bytes"] = static_cast<double>(bytes);
    state.counters["json_bytes"] = static_cast<double>(text.size());
}

}  // namespace

BENCHMARK(normal_maps)
    ->Arg(2)
    ->Arg(10)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond);
