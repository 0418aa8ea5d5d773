// Tests of the types of nodes without a fixed type: the type carried by a reroute.
#include "lower/types.h"

#include <gtest/gtest.h>

#include <array>

#include "graph/edit.h"
#include "lower/fixture.h"

namespace wrinkle {
namespace {

constexpr std::array nodes = {
    R"("n": {"type": "bump", "in": {"height": {"from": "c.out"}}})",
    R"("a": {"type": "reroute", "in": {"in": {"from": "n.gradient"}}})",
    R"("b": {"type": "reroute", "in": {"in": {"from": "a.out"}}})",
    R"("c": {"type": "reroute", "in": {"in": {"from": "b.out"}}})",
    R"("x": {"type": "reroute", "in": {"in": {"from": "y.out"}}})",
    R"("y": {"type": "reroute", "in": {"in": {"from": "x.out"}}})",
    R"("z": {"type": "reroute", "in": {"in": {"from": "y.out"}}})",
    R"("free": {"type": "reroute"})",
    R"("lost": {"type": "reroute", "in": {"in": {"from": "nobody.out"}}})",
};

// The wires form cycles, which are reported; the types can be inferred nevertheless.
TEST(Types, OfReroutesDoNotDependOnTheOrderOfTheNodes) {
    std::array<size_t, nodes.size()> order{};
    for (size_t turn = 0; turn < 2 * nodes.size(); ++turn) {
        std::string text;
        for (size_t i = 0; i < nodes.size(); ++i) {
            order[i] = (turn + i) % nodes.size();
            if (turn >= nodes.size()) order[i] = nodes.size() - 1 - order[i];
            text += (i ? ", " : "") + std::string(nodes[order[i]]);
        }
        Diagnostics problems;
        const Project project =
            test::project("{\"wrinkle\": 1, \"nodes\": {" + text + "}}", problems);
        const Types types(project, test::registry());
        for (const char* id : {"a", "b", "c"})
            EXPECT_EQ(types.link(0, {id, "out"}), PortType::gradient_) << id << " in " << text;
        for (const char* id : {"x", "y", "z", "lost"})
            EXPECT_EQ(types.link(0, {id, "out"}), std::nullopt) << id << " in " << text;
        EXPECT_EQ(types.link(0, {"free", "out"}), PortType::float_);
    }
}

// Reading a text resolves wires to node indices; removing a node changes these indices.
TEST(Types, OfAnEditedGraphReadTheNodesThatItHas) {
    Diagnostics problems;
    Project project =
        test::project(test::graph(R"("gone": {"type": "number"}, "b": {"type": "bump"},
                       "s": {"type": "scale", "in": {"gradient": {"from": "b.gradient"}}})",
                                  R"("g": {"from": "s.gradient"})"),
                      problems);
    const auto source = [&] {
        const size_t reader = project.top().nodes.index_of("s");
        return Types(project, test::registry()).inputs(0, reader)[0].source.node;
    };
    EXPECT_EQ(source(), project.top().nodes.index_of("b"));
    project = load_project(remove_node(project.top(), "gone"), project.root, {}, problems);
    ASSERT_EQ(project.top().nodes.size(), 2u);
    EXPECT_EQ(source(), project.top().nodes.index_of("b"));
    EXPECT_EQ(to_text(problems), "");
}

}  // namespace
}  // namespace wrinkle
