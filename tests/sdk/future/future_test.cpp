// A host of years to come, whose structs have grown at their ends, takes a plugin that was built
// with the frozen header. This program is compiled with such a header (CMakeLists.txt makes it).
#include <dlfcn.h>
#include <gtest/gtest.h>

#include "registry/descriptor.h"
#include "sdk/recorder.h"

namespace wrinkle::testing {
namespace {

static_assert(sizeof(wr_node::later) > 0 && sizeof(wr_builder::later) > 0);

const wr_plugin* plugin_of_version_1() {
    void* library = dlopen(PLUGIN_V1, RTLD_NOW | RTLD_LOCAL);
    if (!library) return nullptr;
    const auto entry = reinterpret_cast<wr_plugin_entry>(dlsym(library, "wrinkle_plugin"));
    return entry ? entry() : nullptr;
}

TEST(Future, GrownHostReadsDescriptorsOfVersion1) {
    const wr_plugin* plugin = plugin_of_version_1();
    ASSERT_NE(plugin, nullptr) << dlerror();
    ASSERT_LT(plugin->size, sizeof(wr_plugin));
    std::vector<NodeType> types;
    Diagnostics diagnostics;
    EXPECT_TRUE(read_descriptors(plugin, "plugin_v1.so", types, diagnostics))
        << to_text(diagnostics);
    ASSERT_EQ(types.size(), 1u);
    EXPECT_EQ(types[0].id, "v1_octaves");
    ASSERT_EQ(types[0].ports.size(), 7u);
    EXPECT_EQ(types[0].ports[2].choices, (std::vector<std::string>{"sum", "highest"}));
    EXPECT_EQ(types[0].ports[6].name, "sum");
    ASSERT_EQ(types[0].renames.size(), 1u);
    EXPECT_EQ(types[0].renames[0].new_name, "amount");
}

TEST(Future, MembersThatAPluginDoesNotHaveAreZero) {
    wr_plugin copy;
    ASSERT_TRUE(read_plugin(plugin_of_version_1(), copy));
    for (const uint64_t member : copy.later)
        EXPECT_EQ(member, 0u);
    wr_plugin smaller{};
    smaller.size = plugin_of_version_1()->size - 1;
    EXPECT_FALSE(read_plugin(&smaller, copy));
}

TEST(Future, PluginOfVersion1BuildsWithAGrownBuilder) {
    Recorder host;
    host.options = {{2, 1}, {3, 4}, {4, 1}};
    host.run(plugin_of_version_1()->nodes[0]);
    EXPECT_TRUE(host.errors.empty());
    EXPECT_EQ(host.open_regions, 0);
    EXPECT_NE(host.outputs[6].find("max("), std::string::npos) << host.outputs[6];
    EXPECT_TRUE(host.outputs[6].starts_with("neg(mul(")) << host.outputs[6];
}

}  // namespace
}  // namespace wrinkle::testing
