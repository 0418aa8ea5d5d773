#include "lower/fixture.h"

#include <gtest/gtest.h>

#include "ir/inspect.h"
#include "lower/check.h"

const wr_plugin* test_plugin();  // nodes.cpp

namespace wrinkle::test {
namespace {

Registry make_registry() {
    Registry registry;
    Diagnostics diagnostics;
    EXPECT_TRUE(registry.add_plugin(test_plugin(), Registry::built_in, diagnostics))
        << to_text(diagnostics);
    return registry;
}

}  // namespace

const Registry& registry() {
    static const Registry registry = make_registry();
    return registry;
}

Files::Files(const std::map<std::string, std::string>& files) {
    for (const auto& [name, text] : files)
        temporary.put(name, text);
}

std::string graph(const std::string& nodes, const std::string& outputs, const std::string& more) {
    return "{\"wrinkle\": 1, " + more + "\"nodes\": {" + nodes + "}, \"outputs\": {" + outputs +
           "}}";
}

Project project(const std::string& text, Diagnostics& diagnostics) {
    Document top = read_document(text, "g.json", diagnostics);
    return load_project(std::move(top), std::filesystem::path(WRINKLE_SOURCE_DIR) / "tests/lower",
                        {}, diagnostics);
}

Lowered lowered(const Project& project, const LowerOptions& options) {
    Diagnostics diagnostics;
    check(project, registry(), Types(project, registry()), diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << to_text(diagnostics);
    if (diagnostics.has_errors()) return {};
    Diagnostics own;
    Lowered result = lower(project, Types(project, registry()), options, own);
    EXPECT_EQ(to_text(own), "");
    EXPECT_EQ(verify(result.module), "");
    EXPECT_EQ(result.module.nodes.size(), result.places.size());
    return result;
}

const Inst& value(const Module& module, size_t output) {
    return module[module.outputs.at(output).value];
}

}  // namespace wrinkle::test
