#include "graph/order.h"

#include <gtest/gtest.h>

#include "sample.h"

namespace wrinkle {
namespace {

std::string node(const std::string& id, const std::string& from) {
    return "\"" + id + "\": {\"type\": \"t\", \"in\": {\"x\": {\"from\": \"" + from + ".y\"}}}";
}

std::string chain(size_t count, const std::string& first) {
    std::string nodes = node("n0", first);
    for (size_t i = 1; i < count; ++i)
        nodes += ",\n" + node("n" + std::to_string(i), "n" + std::to_string(i - 1));
    return graph_of(nodes);
}

std::string order(const Document& document) {
    std::string ids;
    for (const uint32_t i : evaluation_order(document))
        ids += document.nodes[i]->id + " ";
    return ids;
}

TEST(Order, ReadersComeLater) {
    EXPECT_EQ(order(read_quietly(sample_text())), "base tile weave softer sum normal plain ");
    EXPECT_EQ(order(read_quietly(
                  graph_of(node("a", "c") + "," + node("b", "a") + "," + node("c", "surface")))),
              "c a b ");
}

TEST(Order, CyclesNameTheirNodes) {
    EXPECT_EQ(
        problems_of(graph_of(node("a", "b") + ",\n" + node("b", "c") + ",\n" + node("c", "a") +
                             ",\n" + node("self", "self"))),
        "g.json:4:32: error: node 'c': the wires form a cycle: 'a' reads 'b' reads 'c' reads "
        "'a' (remove one of these wires)\n"
        "g.json:5:35: error: node 'self': the wires form a cycle: 'self' reads 'self' (remove "
        "one of these wires)\n");
    EXPECT_EQ(problems_of(graph_of(node("self", "self"))),
              "g.json:2:35: error: node 'self': the wires form a cycle: 'self' reads 'self' "
              "(remove one of these wires)\n");
}

TEST(Order, ACycleStillHasAnOrder) {
    EXPECT_EQ(order(read_quietly(graph_of(node("a", "b") + "," + node("b", "a")))), "b a ");
}

TEST(Order, LongChainsNeedNoStack) {
    const Document document = read_quietly(chain(100000, "surface"));
    const std::vector<uint32_t> order = evaluation_order(document);
    ASSERT_EQ(order.size(), 100000u);
    for (uint32_t i = 0; i < order.size(); ++i)
        ASSERT_EQ(order[i], i);
    EXPECT_EQ(problems_of(chain(100000, "surface")), "");
}

TEST(Order, ALongCycleIsReportedShort) {
    EXPECT_EQ(problems_of(chain(100000, "n99999")),
              "g.json:3:33: error: node 'n1': the wires form a cycle: 'n0' reads 'n99999' reads "
              "'n99998' reads 'n99997' reads ... (99992 more) reads 'n4' reads 'n3' reads 'n2' "
              "reads 'n1' reads 'n0' (remove one of these wires)\n");
}

TEST(Order, LostNodesAreSuggested) {
    EXPECT_EQ(problems_of(graph_of(node("weave", "surface") + ",\n" + node("b", "weav") + ",\n" +
                                   node("c", "nothing"))),
              "g.json:3:32: error: node 'b': there is no node 'weav' (did you mean 'weave'?)\n"
              "g.json:4:32: error: node 'c': there is no node 'nothing' (expected the id of a "
              "node)\n");
}

TEST(Order, AThousandProblemsThenACount) {
    std::string nodes;
    for (int i = 0; i < 20000; ++i)
        nodes += (i ? ",\n" : "") + node("n" + std::to_string(i), "m" + std::to_string(i));
    Diagnostics diagnostics;
    read_document(graph_of(nodes), "g.json", diagnostics);
    EXPECT_EQ(diagnostics.list().size(), 1000u);
    EXPECT_EQ(diagnostics.dropped(), 19000u);
}

}  // namespace
}  // namespace wrinkle
