#include "bake/support.h"

#include "graph/subgraph.h"
#include "support/linked_nodes.h"

namespace wrinkle::test {

Module bake_module_of(const std::string& text, bool tangents, Covariances covariances) {
    Diagnostics diagnostics;
    const Project project = load_project(read_document(text, "test.json", diagnostics),
                                         WRINKLE_SOURCE_DIR "/graphs", {}, diagnostics);
    MaterialOptions options;
    options.given_differentials = true;
    options.vertex_tangents = tangents;
    options.covariances = covariances;
    const Compiled compiled = compile_material(project, linked_nodes(), options, diagnostics);
    EXPECT_TRUE(compiled.ok) << to_text(diagnostics);
    return compiled.module;
}

Module bake_module(const std::string& nodes, const std::string& outputs, bool tangents) {
    return bake_module_of(
        R"({"wrinkle": 1, "nodes": {)" + nodes + R"(}, "outputs": {)" + outputs + "}}", tangents);
}

BakePlan plan_of(const Module& module, const std::vector<std::string>& maps,
                 const MapOptions& options, bool integers) {
    Diagnostics diagnostics;
    std::vector<MapRequest> requests;
    for (const std::string& name : maps)
        requests.push_back({name, {}, integers});
    auto plan = plan_maps(module, requests, options, diagnostics);
    EXPECT_TRUE(plan) << to_text(diagnostics);
    return plan ? std::move(*plan) : BakePlan{};
}

LanePicture bake_lanes(const Mesh& mesh, const Program& program, const BakeHow& how,
                       const std::vector<uint32_t>& unit) {
    LanePicture picture;
    picture.width = how.width;
    for (const Program::Output& output : program.outputs)
        picture.lanes += output.regs.size();
    const UvRaster raster(mesh, {how.width, how.height, glm::ivec2(0), how.samples});
    BakeInput input;
    input.mesh = &mesh;
    input.program = &program;
    input.unit = unit;
    input.textures = how.textures;
    input.dilate = how.dilate;
    const auto take = [&](const BakedRows& rows) {
        for (size_t row = 0; row < rows.count; ++row)
            for (size_t x = 0; x < how.width; ++x)
                for (size_t lane = 0; lane < picture.lanes; ++lane)
                    picture.values.push_back(
                        rows.values[(row * picture.lanes + lane) * how.width + x]);
        picture.covered.insert(picture.covered.end(), rows.covered,
                               rows.covered + size_t{rows.count} * how.width);
        picture.findings.add(rows.found);
        return true;
    };
    EXPECT_TRUE(
        bake_rows(input, raster, how.first, std::min(how.last, how.height), how.threads, take));
    return picture;
}

}  // namespace wrinkle::test
