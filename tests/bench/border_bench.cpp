// Benchmark of the plugin interface: lowers every sample graph with the nodes linked in, and with
// the same nodes loaded as a plugin. Both record through the same C builder (wrinkle/plugin.h);
// they differ in the code that calls it and in the lookup of a loaded node's code. Reading,
// checking and writing source are not measured. The two alternate; the medians are compared.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "graph/subgraph.h"
#include "lower/lower.h"
#include "nodes/all.h"
#include "registry/plugin_loader.h"

namespace {

using namespace wrinkle;
namespace fs = std::filesystem;

constexpr int rounds = 41;
constexpr int times = 3;  // lowerings of a graph per round

struct Kind {
    Registry registry;
    std::vector<Types> types;  // one per project
    std::vector<double> milliseconds;
};

std::vector<Project> projects(Diagnostics& diagnostics) {
    std::vector<Project> all;
    for (const auto& entry : fs::directory_iterator(WRINKLE_SOURCE_DIR "/graphs"))
        if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".test")
            all.push_back(load_project(entry.path(), {}, diagnostics));
    return all;
}

// Lowers every graph once; returns the number of instructions.
size_t lower_all(const std::vector<Project>& all, const Kind& kind, Diagnostics& diagnostics) {
    size_t instructions = 0;
    for (size_t i = 0; i < all.size(); ++i)
        instructions += lower(all[i], kind.types[i], {}, diagnostics).module.size();
    return instructions;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace

int main() {
    Diagnostics diagnostics;
    Kind linked, loaded;
    linked.registry.add_plugin(built_in_nodes(), Registry::built_in, diagnostics);
    const std::vector<std::string> places{WRINKLE_NODES_MODULE};
    load_plugins(loaded.registry, places, diagnostics);
    const std::vector<Project> all = projects(diagnostics);
    size_t instructions[2] = {};
    for (Kind* kind : {&linked, &loaded}) {
        for (const Project& project : all)
            kind->types.emplace_back(project, kind->registry);
        instructions[kind == &loaded] = lower_all(all, *kind, diagnostics);  // loads, warms up
    }
    for (int round = 0; round < rounds; ++round)
        for (Kind* kind : {&linked, &loaded}) {
            const auto start = std::chrono::steady_clock::now();
            for (int i = 0; i < times; ++i)
                lower_all(all, *kind, diagnostics);
            const std::chrono::duration<double, std::milli> took =
                std::chrono::steady_clock::now() - start;
            kind->milliseconds.push_back(took.count() / times);
        }
    if (diagnostics.has_errors() || instructions[0] != instructions[1] || instructions[0] == 0) {
        std::fputs(to_text(diagnostics).c_str(), stderr);
        return 1;
    }
    const double here = median(linked.milliseconds), there = median(loaded.milliseconds);
    std::printf("lowering %zu graphs, %zu instructions: linked in %.2f ms, as a plugin %.2f ms\n",
                all.size(), instructions[0], here, there);
    std::printf("cost of the border: %.3f (at most 1.15)\n", there / here);
}
