// Tests of the differences of two graphs and of their texts.
#include "difference/changes.h"

#include "difference/graphs.h"
#include "difference/renames.h"

namespace wrinkle::difference {
namespace {

std::string text_of(const Document& a, const Document& b) {
    return changes_text(changes_between(a, b));
}

TEST(Changes, AreListedBySectionAndId) {
    const Document a = graph_with(R"("name": "x", "nodes": {
        "gone": {"type": "t"},
        "a": {"type": "t", "in": {"p": 8, "q": {"from": "gone.x"}, "r": true}}},
        "outputs": {"normal": {"from": "a.n"}})");
    const Document b = graph_with(R"("name": "x", "back_faces": "flip", "nodes": {
        "a": {"type": "u", "muted": true, "in": {"p": 16, "q": {"from": "new.x"}, "s": "rgb"}},
        "new": {"type": "v", "in": {"p": [1, 2], "q": {"from": "a.n"}}}},
        "outputs": {"color": {"from": "new.c"}, "normal": {"from": "new.n"}})");
    EXPECT_EQ(text_of(a, b),
              "+ graph back_faces: \"flip\"\n"
              "  node a: type: \"t\" -> \"u\"\n"
              "  node a.p: 8 -> 16\n"
              "  node a.q rewired: gone.x -> new.x\n"
              "  node a.r: true -> unset\n"
              "  node a: muted: unset -> true\n"
              "  node a.s: unset -> \"rgb\"\n"
              "- node gone: \"t\"\n"
              "+ node new: \"v\", p = [1, 2], q <- a.n\n"
              "+ output color: new.c\n"
              "  output normal rewired: a.n -> new.n\n"
              "different\n");
}

TEST(Changes, RenamedNodesAreFollowed) {
    const Document a = graph_with(R"("nodes": {
        "a": {"type": "t", "in": {"p": 1}}, "b": {"type": "t", "in": {"p": {"from": "a.x"}}},
        "c": {"type": "t", "in": {"p": {"from": "b.x"}, "q": 1}}},
        "outputs": {"normal": {"from": "b.x"}}, "layout": {"a": [1, 2]})");
    const Document b = graph_with(R"("nodes": {
        "A": {"type": "t", "in": {"p": 1}}, "B": {"type": "t", "in": {"p": {"from": "A.x"}}},
        "c": {"type": "t", "in": {"p": {"from": "B.x"}, "q": 2}}},
        "outputs": {"normal": {"from": "B.x"}}, "layout": {"A": [1, 2]})");
    EXPECT_EQ(text_of(a, b),
              "  node a renamed A\n  node b renamed B\n  node c.q: 1 -> 2\ndifferent\n");
}

TEST(Changes, ARenameNeedsEqualContentAndAllWires) {
    const std::string reader = R"(, "r": {"type": "t", "in": {"p": {"from": ")";
    const Document a = nodes(R"("a": {"type": "t"})" + reader + R"(a.x"}}})");
    const auto renames = [&](const Document& after) {
        return find_renames(entries_of(a), entries_of(after));
    };
    EXPECT_EQ(renames(nodes(R"("b": {"type": "t"})" + reader + R"(b.x"}}})")).size(), 1U);
    EXPECT_EQ(renames(nodes(R"("b": {"type": "u"})" + reader + R"(b.x"}}})")).size(), 0U);
    EXPECT_EQ(renames(nodes(R"("b": {"type": "t"})" + reader + R"(b.y"}}})")).size(), 0U);
    EXPECT_EQ(renames(nodes(R"("b": {"type": "t"})" + reader + R"(a.x"}}})")).size(), 0U);
    EXPECT_EQ(
        renames(nodes(R"("b": {"type": "t"}, "c": {"type": "t"})" + reader + R"(b.x"}}})")).size(),
        0U);
}

TEST(Changes, OneOfTwoEqualNodesIsNotRenamed) {
    const Entries two = entries_of(nodes(R"("a": {"type": "t"}, "b": {"type": "t"})"));
    const Entries one = entries_of(nodes(R"("c": {"type": "t"})"));
    EXPECT_EQ(find_renames(two, one).size(), 0U);
    EXPECT_EQ(find_renames(one, two).size(), 0U);
}

TEST(Changes, LayoutIsOneLineAndTheSameMaterial) {
    const Document a = graph_with(R"("nodes": {"a": {"type": "t"}, "b": {"type": "t"}},
        "layout": {"a": [0, 0], "b": [1, 1], "$frames": {"f": {"title": "x", "rect": [0, 0, 1, 1]}}})");
    const Document b = graph_with(R"("nodes": {"b": {"type": "t"}, "a": {"type": "t"}},
        "layout": {"a": [5, 0], "b": [1, 2], "$frames": {"f": {"title": "y", "rect": [0, 0, 2, 1]}},
        "$notes": {"n": {"text": "z", "rect": [0, 0, 1, 1]}}})");
    const Changes changes = changes_between(a, b);
    EXPECT_TRUE(changes.same_material());
    EXPECT_EQ(changes_text(changes),
              "layout: 2 positions changed, 1 frame changed, 1 note added, another order in the "
              "file\nother layout, same material\n");
}

TEST(Changes, OtherSpellingsAreTheSameMaterial) {
    const Document a = nodes(R"("a": {"type": "t", "in": {"p": 1, "q": "x"}})");
    const Document b = nodes(
        R"("a": {"in": {"q": "\u0078", "p": 1.0}, "muted": false, "version": 1, "type": "t"})");
    EXPECT_EQ(text_of(a, a), "same\n");
    EXPECT_EQ(text_of(a, b), "other text, same material\n");
}

TEST(Changes, NamesAreEscaped) {
    const std::string text =
        text_of(nodes(""), nodes("\"\u202e\": {\"type\": \"\u202e\", \"x\\ny\": 1}"));
    EXPECT_EQ(text, "+ node \\u202e: \"\\u202e\", x\\ny = 1\ndifferent\n");
}

TEST(Listing, HasALinePerValueSortedById) {
    const Document document = graph_with(R"("name": "x", "inputs": {
        "wear": {"type": "float", "default": 1}}, "presets": {"Old": {"wear": 2}}, "nodes": {
        "b": {"type": "t", "in": {"q": 1, "p": {"from": "a.x"}}, "mine": [1]},
        "a": {"type": "t", "muted": true}, "odd": 5},
        "outputs": {"normal": {"from": "b.n"}}, "layout": {"a": [1, 2]})");
    EXPECT_EQ(listing(document),
              "graph name = \"x\"\n"
              "input wear: type = \"float\"\n"
              "input wear: default = 1\n"
              "preset Old: wear = 2\n"
              "node a: type = \"t\"\n"
              "node a: muted = true\n"
              "node b: type = \"t\"\n"
              "node b: mine = [1]\n"
              "node b.p <- a.x\n"
              "node b.q = 1\n"
              "node odd = 5\n"
              "output normal <- b.n\n");
}

TEST(Entries, ADamagedSectionIsAFault) {
    EXPECT_EQ(entries_fault(nodes("")), "");
    EXPECT_EQ(entries_fault(graph_with("\"nodes\": 5")), "\"nodes\" is not an object");
    EXPECT_EQ(entries_fault(nodes("\"a\": {\"in\": []}")), "\"in\" of node \"a\" is not an object");
    EXPECT_EQ(entries_fault(graph_with("\"layout\": {\"$notes\": 1}")),
              "\"$notes\" is not an object");
    Diagnostics ignored;
    EXPECT_NE(entries_fault(read_document("{", "g.json", ignored)), "");
}

}  // namespace
}  // namespace wrinkle::difference
