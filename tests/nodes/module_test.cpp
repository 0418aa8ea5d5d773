// The nodes as a plugin: loaded as a shared object, through the loader, they are what they are
// linked in, to the byte.
#include <gtest/gtest.h>

#include <filesystem>

#include "glsl/emit.h"
#include "graph/subgraph.h"
#include "lower/material.h"
#include "nodes/plane.h"
#include "registry/plugin_loader.h"
#include "registry/reference.h"
#include "support/linked_nodes.h"

namespace wrinkle::test {
namespace {

namespace fs = std::filesystem;
const fs::path graphs = fs::path(WRINKLE_SOURCE_DIR) / "graphs";

const Registry& loaded() {
    static const Registry registry = [] {
        Registry made;
        Diagnostics diagnostics;
        const std::vector<std::string> places{WRINKLE_NODES_MODULE};
        load_plugins(made, places, diagnostics);
        EXPECT_EQ(to_text(diagnostics), "");
        return made;
    }();
    return registry;
}

// What a material becomes, or what is wrong with it.
std::string glsl(const Project& project, const Registry& registry, bool uniform, bool given) {
    Diagnostics diagnostics;
    MaterialOptions options;
    options.uniform_parameters = uniform;
    options.given_differentials = given;
    const Compiled material = compile_material(project, registry, options, diagnostics);
    EmitOptions form;
    form.differentials = given ? Differentials::given : Differentials::screen;
    return to_text(diagnostics) + (material.ok ? emit(material.module, form).source : "");
}

void expect_same(const Project& project, const std::string& name) {
    for (const bool uniform : {false, true})
        for (const bool given : {false, true}) {
            const std::string text = glsl(project, linked_nodes(), uniform, given);
            EXPECT_NE(text, "") << name;
            EXPECT_EQ(glsl(project, loaded(), uniform, given), text) << name;
        }
}

TEST(NodesAsAPlugin, HaveTheSameDescriptors) {
    EXPECT_EQ(loaded().ids(), linked_nodes().ids());
    EXPECT_EQ(graph_schema(loaded()), graph_schema(linked_nodes()));
    EXPECT_EQ(list_markdown(loaded()), list_markdown(linked_nodes()));
    std::string with_origins = list_json(loaded());
    const std::string path = WRINKLE_NODES_MODULE;
    for (size_t at = 0; (at = with_origins.find(path)) != with_origins.npos;)
        with_origins.replace(at, path.size(), Registry::built_in);
    EXPECT_EQ(with_origins, list_json(linked_nodes()));
}

TEST(NodesAsAPlugin, AreOtherCode) {
    for (const NodeType& type : loaded().list()) {
        EXPECT_EQ(type.build, nullptr) << type.id;
        EXPECT_NE(type.code, nullptr) << type.id;
    }
}

// The golden texts beside the graphs are those of the nodes linked in.
TEST(NodesAsAPlugin, WriteTheSameGlslOfEverySample) {
    size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(graphs)) {
        const fs::path& file = entry.path();
        if (file.extension() != ".json" || file.stem().extension() == ".test") continue;
        if (file.parent_path().filename() == "golden") continue;
        Diagnostics diagnostics;
        ProjectOptions options;
        options.root = graphs;
        const Project project = load_project(file, options, diagnostics);
        ASSERT_EQ(to_text(diagnostics), "") << file;
        expect_same(project, file.string());
        ++count;
    }
    EXPECT_GT(count, 30u);
}

TEST(NodesAsAPlugin, WriteTheSameGlslOfEveryNodeAndChoice) {
    for (const NodeType& type : linked_nodes().list())
        for (const Port& port : type.ports) {
            if (port.kind != Port::Kind::choice && port.kind != Port::Kind::output) continue;
            const std::vector<std::string> none{""};
            for (const std::string& choice : port.choices.empty() ? none : port.choices) {
                const std::string in =
                    choice.empty() ? "" : "\"" + port.name + "\": \"" + choice + "\"";
                std::string outputs;
                for (const Port& output : type.ports)
                    if (output.kind == Port::Kind::output && output.type != PortType::image_)
                        outputs += (outputs.empty() ? "\"" : ", \"") + output.name +
                                   R"(": {"from": "n.)" + output.name + "\"}";
                Diagnostics diagnostics;
                const Project project =
                    load_project(read_document(R"({"wrinkle": 1, "nodes": {)" + one(type.id, in) +
                                                   R"(}, "outputs": {)" + outputs + "}}",
                                               "test.json", diagnostics),
                                 graphs, {}, diagnostics);
                ASSERT_EQ(to_text(diagnostics), "") << type.id;
                expect_same(project, type.id + " " + in);
            }
        }
}

}  // namespace
}  // namespace wrinkle::test
