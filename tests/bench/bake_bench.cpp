// Benchmark of baking one map, from a project, a mesh and images in memory to the rows of a file:
// `wrinkle_bake_bench GRAPH ROOT MESH MAP SIZE TIMES` prints wall time and processor time in
// seconds, one line per run. Every run includes lowering the graph, planning the map and
// rasterising the layout. MESH is a file or the name of a shape.
#include <time.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "bake/bake.h"
#include "bake/map_files.h"
#include "bake/maps.h"
#include "cpu/texture_store.h"
#include "graph/subgraph.h"
#include "lower/material.h"
#include "mesh/load.h"
#include "mesh/shapes.h"
#include "nodes/all.h"
#include "registry/registry.h"

namespace wrinkle {
namespace {

struct Loaded {
    Registry registry;
    Project project;
    Mesh mesh;
    TextureStore textures;
    MaterialOptions material;
};

bool load(char** words, Loaded& loaded, Diagnostics& diagnostics) {
    loaded.registry.add_plugin(built_in_nodes(), Registry::built_in, diagnostics);
    ProjectOptions options;
    options.root = words[1];
    loaded.project = load_project(words[0], options, diagnostics);
    auto mesh = make_shape(words[2]);
    if (!mesh) mesh = load_mesh(words[2], {}, diagnostics);
    if (diagnostics.has_errors() || !mesh) return false;
    loaded.mesh = std::move(*mesh);
    loaded.material.given_differentials = true;
    const Compiled compiled =
        compile_material(loaded.project, loaded.registry, loaded.material, diagnostics);
    for (const Resource& resource : compiled.module.resources)
        loaded.textures.read(texels_of(resource), diagnostics);
    return !diagnostics.has_errors();
}

// Bakes once; returns the size of all rows in bytes; 0 on errors.
size_t bake_once(const Loaded& loaded, const std::string& map, uint32_t size,
                 Diagnostics& diagnostics) {
    const Compiled compiled =
        compile_material(loaded.project, loaded.registry, loaded.material, diagnostics);
    MapOptions options;
    options.width = options.height = size;
    const auto plan = plan_maps(compiled.module, {{map, {}, true}}, options, diagnostics);
    if (!plan) return 0;
    const std::vector<Texture> textures = loaded.textures.textures_of(plan->resources);
    const UvRaster raster(loaded.mesh, {size, size});
    BakeInput input;
    input.mesh = &loaded.mesh;
    input.program = &plan->program;
    input.textures = textures;
    input.unit = plan->unit;
    input.dilate = 0;
    size_t bytes = 0;
    Clamped clamped;
    const auto take = [&](const BakedRows& rows) {
        bytes +=
            stored_rows(plan->maps[0], PixelType::float32, rows, size, plan->lanes, clamped).size();
        return true;
    };
    return bake_rows(input, raster, 0, size, 0, take) ? bytes : 0;
}

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace
}  // namespace wrinkle

int main(int count, char** words) {
    using namespace wrinkle;
    if (count != 7) return 2;
    const auto size = static_cast<uint32_t>(std::atoi(words[5]));
    Diagnostics diagnostics;
    Loaded loaded;
    bool fine = load(words + 1, loaded, diagnostics);
    for (int i = 0; fine && i < std::atoi(words[6]); ++i) {
        const double processor = processor_seconds();
        const auto start = std::chrono::steady_clock::now();
        fine = bake_once(loaded, words[4], size, diagnostics) == size_t{size} * size * 12;
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        std::printf("%.6f %.6f\n", seconds.count(), processor_seconds() - processor);
    }
    std::fputs(to_text(diagnostics).c_str(), stderr);
    return fine ? 0 : 1;
}
