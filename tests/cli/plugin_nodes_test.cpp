// Tests of a plugin's nodes next to the built-in ones, and of a graph with a missing plugin.
#include "cli/support.h"

namespace wrinkle::test {
namespace {

const std::string plugin = WRINKLE_BINARY_DIR "/lib/wrinkle/plugins/ripples.so";
const fs::path sample = WRINKLE_SOURCE_DIR "/plugins/ripples/ripples.json";

using PluginNodesTest = CliTest;

TEST_F(PluginNodesTest, StandInTheListThePageAndTheSchema) {
    for (const char* form : {"--schema", "--markdown", "--json"}) {
        const std::string without = run({"nodes", form}).out;
        const Ran with = run({"nodes", form, "--plugin-path", plugin});
        EXPECT_EQ(with.code, 0) << with.err;
        EXPECT_EQ(without.find("ripples"), without.npos) << form;
        EXPECT_TRUE(says(with.out, "ripples")) << form;
        EXPECT_TRUE(says(with.out, "Rings per length unit")) << form;
    }
    EXPECT_EQ(run({"nodes", "ripples"}).code, 1);
    EXPECT_TRUE(says(run({"nodes", "ripples", "--plugin-path", plugin}).out, "Rings around"));
}

TEST_F(PluginNodesTest, AreNamedWhenTheirPluginIsMissing) {
    put("g.json", bytes_of(sample));
    for (const char* command : {"check", "compile"}) {
        const Ran ran = run({command, "g.json"});
        EXPECT_EQ(ran.code, 1);
        EXPECT_EQ(ran.out, "");
        EXPECT_TRUE(says(ran.err,
                         "g.json:5:5: error: node 'rings': unknown node type 'ripples' (a plugin "
                         "may be missing; 'wrinkle plugins' lists those found)\n"));
    }
    EXPECT_EQ(run({"compile", "g.json", "-o", "g.glsl"}).code, 1);
    EXPECT_EQ(files(), std::vector<std::string>{"g.json"});
    EXPECT_EQ(run({"check", "g.json", "--plugin-path", plugin}).code, 0);
}

// Ports, versions and unknown keys of the nodes are preserved.
TEST_F(PluginNodesTest, AreKeptWhenTheirPluginIsMissing) {
    const std::string canonical = bytes_of(sample);
    put("g.json", canonical);
    EXPECT_EQ(run({"format", "--check", "g.json"}).code, 0);
    EXPECT_EQ(run({"format", "g.json"}).code, 0);
    EXPECT_EQ(run({"upgrade", "g.json"}).code, 0);
    EXPECT_EQ(get("g.json"), canonical);

    const std::string node =
        R"("a": { "type": "weathering", "version": 7, "seeds": [1, 2.50, "x"], "in": { "wet": { "from": "b.mist" } } })";
    const std::string loose =
        "{\"nodes\": {" + node + ", \"b\": {\"type\": \"fog\"}}, \"wrinkle\": 1}";
    put("h.json", loose);
    EXPECT_EQ(run({"format", "h.json"}).code, 0);
    const std::string written = get("h.json");
    for (const char* kept : {"\"weathering\"", "\"version\": 7", "2.50", "\"x\"", "\"b.mist\"",
                             "\"fog\"", "\"seeds\""})
        EXPECT_TRUE(says(written, kept));
    EXPECT_EQ(run({"format", "h.json"}).code, 0);
    EXPECT_EQ(get("h.json"), written);
}

}  // namespace
}  // namespace wrinkle::test
