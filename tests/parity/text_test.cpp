// Tests that every node and every sample graph gives source that glslang accepts: on every target,
// in both forms, with both kinds of parameters and of differentials.
#include <gtest/gtest.h>

#include <set>

#include "emit/emit.h"
#include "glslang/validate.h"
#include "parity/node_graph.h"
#include "support/samples.h"

namespace wrinkle::test {
namespace {

void expect_valid(const Module& module, Form form, bool given) {
    for (const Target& target : targets()) {
        if (!has_validator(target)) continue;
        EmitOptions options;
        options.target = &target;
        options.form = form;
        options.differentials = given ? Differentials::given : Differentials::screen;
        options.name = "subject";
        EXPECT_EQ(compile_errors(emit(module, options)), "") << target.name;
    }
}

void expect_valid(const Project& project) {
    for (const bool uniform : {false, true})
        for (const bool given : {false, true}) {
            MaterialOptions options;
            options.uniform_parameters = uniform;
            options.given_differentials = given;
            Diagnostics diagnostics;
            const Compiled compiled = compile_material(project, all_nodes(), options, diagnostics);
            ASSERT_TRUE(compiled.ok) << to_text(diagnostics);
            expect_valid(compiled.module, Form::function, given);
            if (!given) expect_valid(compiled.module, Form::shader, given);
        }
}

TEST(GeneratedText, OfEverySampleIsValid) {
    for (const std::filesystem::path& path : sample_graphs()) {
        SCOPED_TRACE(path.string());
        Diagnostics diagnostics;
        expect_valid(load_project(path, {}, diagnostics));
    }
}

TEST(Samples, ShowEveryNode) {
    std::set<std::string> shown;
    for (const std::filesystem::path& path : sample_graphs()) {
        Diagnostics diagnostics;
        const Project project = load_project(path, {}, diagnostics);
        for (const NodePtr& node : project.top().nodes)
            shown.insert(node->type);
    }
    for (const NodeType& type : all_nodes().list())
        EXPECT_TRUE(shown.count(type.id) || type.origin != Registry::built_in)
            << type.id << " is in no graph";
}

}  // namespace
}  // namespace wrinkle::test
