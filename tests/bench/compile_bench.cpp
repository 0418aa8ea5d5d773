// Benchmark of compilation from JSON to GLSL: chains of layers, nested sub-graphs, and the samples.
// Sub-graphs are read from their files, and the presence of images is checked, as `wrinkle compile`
// does.
#include <benchmark/benchmark.h>
#include <stdlib.h>

#include <filesystem>
#include <string>

#include "base/file.h"
#include "bench/graphs.h"
#include "compile/shader.h"
#include "graph/subgraph.h"
#include "nodes/all.h"
#include "support/samples.h"

namespace {

using namespace wrinkle;
namespace fs = std::filesystem;

const fs::path graphs = WRINKLE_SOURCE_DIR "/graphs";

const Registry& registry() {
    static const Registry* nodes = [] {
        auto* made = new Registry;
        Diagnostics diagnostics;
        made->add_plugin(built_in_nodes(), Registry::built_in, diagnostics);
        return made;
    }();
    return *nodes;
}

std::string glsl_of(const std::string& text, const fs::path& file, Diagnostics& diagnostics) {
    Document top = read_document(text, file.string(), diagnostics);
    const Project project = load_project(std::move(top), file.parent_path(), {}, diagnostics);
    return make_shader(project, registry(), {}, diagnostics).shader.source;
}

size_t reads_in(const std::string& glsl) {
    size_t count = 0;
    for (size_t at = 0; (at = glsl.find("texture", at)) != glsl.npos; ++at) {
        const std::string_view rest = std::string_view(glsl).substr(at + 7);
        count += rest.starts_with("(") || rest.starts_with("Grad(") || rest.starts_with("Lod(");
    }
    return count;
}

// Returns the generated source; "" after reporting an error.
std::string measure(benchmark::State& state, const std::string& text, const fs::path& file) {
    std::string glsl;
    for (auto _ : state) {
        Diagnostics diagnostics;
        glsl = glsl_of(text, file, diagnostics);
        if (!diagnostics.has_errors()) continue;
        state.SkipWithError(to_text(diagnostics).substr(0, 200).c_str());
        return "";
    }
    state.counters["glsl_bytes"] = static_cast<double>(glsl.size());
    state.counters["json_bytes"] = static_cast<double>(text.size());
    state.counters["reads"] = static_cast<double>(reads_in(glsl));
    return glsl;
}

// Skips with an error if texture reads of different layers were merged.
void layers(benchmark::State& state, const bench::Layering& layering) {
    Diagnostics ignored;
    const fs::path file = graphs / "bench.json";
    const size_t of_one = reads_in(glsl_of(bench::chain(layering, 1), file, ignored));
    const std::string glsl = measure(state, bench::chain(layering, state.range(0)), file);
    const size_t wanted = of_one * static_cast<size_t>(state.range(0));
    if (!glsl.empty() && (of_one == 0 || reads_in(glsl) != wanted))
        state.SkipWithError(("reads merge: " + std::to_string(reads_in(glsl)) + " in place of " +
                             std::to_string(wanted))
                                .c_str());
}
void normal_maps(benchmark::State& state) {
    layers(state, bench::normal_maps);
}
void heights(benchmark::State& state) {
    layers(state, bench::heights);
}

void nested(benchmark::State& state) {
    std::string name = (fs::temp_directory_path() / "wrinkle_bench_XXXXXX").string(), why;
    const fs::path folder = mkdtemp(name.data()) ? name : "";
    for (int64_t level = 0; level <= state.range(0); ++level)
        write_file(folder / ("level_" + std::to_string(level) + ".json"),
                   bench::nested_level(level), why);
    if (why.empty())
        measure(state, bench::nested_top(state.range(0)), folder / "top.json");
    else
        state.SkipWithError(why.c_str());
    fs::remove_all(folder);
}

void sample(benchmark::State& state, const fs::path& file) {
    std::string why;
    const auto text = read_file(file, why);
    if (text)
        measure(state, *text, file);
    else
        state.SkipWithError(why.c_str());
}

constexpr auto milliseconds = benchmark::kMillisecond;
BENCHMARK(normal_maps)->Arg(2)->Arg(10)->Arg(100)->Arg(1000)->Arg(10000)->Unit(milliseconds);
BENCHMARK(heights)->Arg(2)->Arg(10)->Arg(100)->Arg(1000)->Arg(10000)->Unit(milliseconds);
BENCHMARK(nested)->Arg(10)->Arg(20)->Arg(30)->Unit(milliseconds);

}  // namespace

int main(int argc, char** argv) {
    for (const fs::path& file : test::sample_graphs())
        benchmark::RegisterBenchmark(
            ("sample/" + fs::relative(file, graphs).replace_extension().string()).c_str(), sample,
            file)
            ->Unit(milliseconds);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
}
