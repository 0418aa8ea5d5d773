#include "cli/test_material.h"

#include <chrono>

#include "base/file.h"

namespace wrinkle::cli {

std::string preset_of(const TestCase& test) {
    const bool is_file = test.preset.ends_with(".json");
    return is_file ? (test.file.parent_path() / test.preset).string() : test.preset;
}

std::vector<std::string> nodes_of_lines(const CaseMaterial& material) {
    std::vector<std::string> nodes;
    for (const uint32_t node : material.shader.reflection.lines)
        nodes.emplace_back(node == no_node ? ""
                                           : material.screen->compiled.module.nodes[node].path);
    return nodes;
}

std::string cannot_run(const Diagnostics& diagnostics) {
    for (const Diagnostic& each : diagnostics.list())
        if (each.severity == Severity::error) return "cannot be run: " + to_text(each);
    return "cannot be run";
}

void refuse_outside(const TestCase& test, const std::filesystem::path& file,
                    const CommonOptions& common, Diagnostics& diagnostics) {
    const std::filesystem::path root = root_of(test, common);
    if (inside(root, link_target(file))) return;
    diagnostics.error(RuleId::outside_root,
                      file.string() + ": leads outside the root " + root.string(),
                      "a file below it, or another root with --root");
}

CaseMaterial compile_case(const TestCase& test, const ReadGraph& graph, const Registry& registry,
                          const CommonOptions& common, Diagnostics& diagnostics) {
    CaseMaterial material;
    material.common = common;
    material.common.set = test.set;
    if (!test.preset.empty()) material.common.presets = {preset_of(test)};
    if (test.preset.ends_with(".json")) refuse_outside(test, preset_of(test), common, diagnostics);
    const Overrides overrides = parse_overrides(material.common, diagnostics);
    if (overrides.is_sweep())
        diagnostics.error(RuleId::test_case, test.file.string() + ": 'set' holds a sweep",
                          "one value");
    const auto compile_to = [&](std::optional<MaterialRun>& result,
                                const MaterialOptions& options) {
        const auto keep = [&](size_t, const MaterialRun& run, Diagnostics&) { result = run; };
        if (!diagnostics.has_errors())
            compile_runs(graph, material.common, registry, overrides, options, keep, diagnostics);
    };
    const bool displaced = test.render && test.render->options.displace;
    if (test.points.count() > 0 || displaced)
        compile_to(material.given, {.given_differentials = true, .runs_calls = "eval"});
    const auto start = std::chrono::steady_clock::now();
    if (test.glsl || test.render || !test.budget.empty())
        compile_to(material.screen, {.runs_calls = "render"});
    if (material.screen && !diagnostics.has_errors())
        material.shader =
            emit_function(*material.screen, material_name(test.graph.string()), diagnostics);
    const std::chrono::duration<double, std::milli> passed =
        std::chrono::steady_clock::now() - start;
    material.compile_ms = passed.count();
    const auto read_images = [&](const MaterialRun& run) {
        if (!diagnostics.has_errors())
            read_textures(material.textures, run.compiled, run.project, diagnostics);
    };
    if (material.given) read_images(*material.given);
    if (material.screen && test.render) read_images(*material.screen);
    return material;
}

}  // namespace wrinkle::cli
