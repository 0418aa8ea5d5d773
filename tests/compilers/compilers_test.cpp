// Tests that a plugin behaves the same with every compiler and standard library.
#include <gtest/gtest.h>

#include <filesystem>

#include "emit/emit.h"
#include "graph/subgraph.h"
#include "lower/material.h"
#include "registry/plugin_loader.h"
#include "registry/reference.h"

namespace wrinkle {
namespace {

struct Built {
    Registry registry;
    Diagnostics diagnostics;
};

Built load(const std::string& name) {
    Built built;
    const std::vector<std::string> places{CROSSING_PLUGINS "/" + name + ".so"};
    load_plugins(built.registry, places, built.diagnostics);
    EXPECT_EQ(to_text(built.diagnostics), "");
    return built;
}

const char* const graph = R"({"wrinkle": 1, "nodes": {
    "inner": {"type": "crossing_weave", "version": 2, "in": {"octaves": 2, "wave": "triangle"}},
    "outer": {"type": "crossing_weave", "version": 2, "in": {"shift": {"from": "inner.height"},
                                                            "sharp": true}},
    "march": {"type": "crossing_march", "in": {"stop": {"from": "outer.mask"}}},
    "bump": {"type": "crossing_bump", "in": {"image": "textures/weave_normal.png",
                                             "below": {"from": "outer.height"},
                                             "amount": {"from": "march.way"}}},
    "again": {"type": "crossing_bump", "in": {"image": "textures/rivets_normal.png",
                                              "below": {"from": "bump.gradient"}}}},
    "outputs": {"normal": {"from": "again.gradient"}, "mask": {"from": "inner.mask"}}})";

Compiled compiled(const Registry& registry, const std::string& text, bool uniform,
                  Diagnostics& diagnostics) {
    const auto folder = std::filesystem::path(WRINKLE_SOURCE_DIR) / "graphs";
    const Project project =
        load_project(read_document(text, "g.json", diagnostics), folder, {}, diagnostics);
    MaterialOptions options;
    options.uniform_parameters = uniform;
    return compile_material(project, registry, options, diagnostics);
}

std::string glsl(const Built& built, bool uniform) {
    Diagnostics diagnostics;
    const Compiled material = compiled(built.registry, graph, uniform, diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
    return material.ok ? emit(material.module, {}).source : "";
}

std::string thrown(const Built& built) {
    std::string text;
    for (const char* what : {"standard", "number", "far"}) {
        Diagnostics diagnostics;
        compiled(built.registry,
                 R"({"wrinkle": 1, "nodes": {"t": {"type": "crossing_throw", "in": {"what": ")" +
                     std::string(what) + R"("}}}, "outputs": {"a": {"from": "t.value"}}})",
                 false, diagnostics);
        EXPECT_EQ(diagnostics.list().size(), 1u) << to_text(diagnostics);
        if (!diagnostics.list().empty()) text += diagnostics.list()[0].message + "\n";
    }
    return text;
}

class Compilers : public testing::TestWithParam<const char*> {};

TEST_P(Compilers, MakeTheSameNodes) {
    const std::string name = GetParam();
    if (name.starts_with("other") && std::string_view(OTHER_COMPILER).ends_with("NOTFOUND"))
        GTEST_SKIP() << "there is one compiler alone";
    const Built own = load("own"), built = load(name);
    ASSERT_EQ(built.registry.list().size(), 4u);
    EXPECT_EQ(graph_schema(built.registry), graph_schema(own.registry));
    for (const bool uniform : {false, true}) {
        const std::string text = glsl(own, uniform);
        EXPECT_NE(text.find("WrinkleMaterial_material wrinkle_material("), text.npos) << text;
        EXPECT_EQ(glsl(built, uniform), text);
    }
}

// An exception is caught within the plugin's own standard library; the host's may be another.
TEST_P(Compilers, StopExceptionsAtTheBorder) {
    const std::string name = GetParam();
    if (name.starts_with("other") && std::string_view(OTHER_COMPILER).ends_with("NOTFOUND"))
        GTEST_SKIP() << "there is one compiler alone";
    const std::string text = thrown(load(name));
    EXPECT_TRUE(
        text.starts_with("thrown 41 times\nthe node's body threw something other than a "
                         "std::exception\nvector::"))
        << text;
}

INSTANTIATE_TEST_SUITE_P(Plugins, Compilers,
                         testing::Values("own", "own_static", "other", "other_static"),
                         [](const auto& row) { return std::string(row.param); });

}  // namespace
}  // namespace wrinkle
