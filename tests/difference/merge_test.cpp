// Tests of the rules of merges, of conflicts and of their end.
#include "difference/merge.h"

#include "difference/graphs.h"
#include "graph/write.h"
#include "json/parse.h"

namespace wrinkle::difference {
namespace {

const std::string tail = R"("z": {"type": "t"})";

Document node_a(const std::string& text) {
    return nodes((text.empty() ? "" : "\"a\": " + text + ", ") + tail);
}

std::string sentences(const Merged& merged) {
    std::string text;
    for (const Conflict& conflict : merged.conflicts)
        text += sentence_of(conflict) + "\n";
    return text;
}

std::string sentences(const std::string& base, const std::string& ours, const std::string& theirs) {
    return sentences(merge(node_a(base), node_a(ours), node_a(theirs)));
}

bool has_text(const std::string& text, const std::string& part) {
    return text.find(part) != text.npos;
}

TEST(Merge, RulesOfAnEntry) {
    const std::string one = R"({"type": "t", "in": {"p": 1}})";
    const std::string two = R"({"type": "t", "in": {"p": 2}})";
    const std::string three = R"({"type": "t", "in": {"p": 3}})";
    EXPECT_EQ(sentences("", one, ""), "");
    EXPECT_EQ(sentences("", one, one), "");
    EXPECT_EQ(sentences("", one, two), "node a: added by both with other content\n");
    EXPECT_EQ(sentences(one, one, ""), "");
    EXPECT_EQ(sentences(one, "", ""), "");
    EXPECT_EQ(sentences(one, "", two), "node a: deleted by ours, changed by theirs\n");
    EXPECT_EQ(sentences(one, two, ""), "node a: deleted by theirs, changed by ours\n");
    EXPECT_EQ(sentences(one, two, two), "");
    EXPECT_EQ(sentences(one, two, three), "node a.p: 2 in ours, 3 in theirs; it was 1\n");
    EXPECT_EQ(sentences(one, R"({"type": "t"})", three),
              "node a.p: unset in ours, 3 in theirs; it was 1\n");
    EXPECT_EQ(sentences(one, R"({"type": "u", "in": {"p": 1}})", three), "");
    EXPECT_EQ(sentences(one, "5", three),
              "node a: 5 in ours, { \"type\": \"t\", \"in\": { \"p\": "
              "3 } } in theirs; it was { \"type\": \"t\", \"in\": { "
              "\"p\": 1 } }\n");
}

TEST(Merge, TheSideThatHasAllKeepsItsBytes) {
    const Document base = node_a(R"({"type":"t","in":{"p":1}})");
    const Document changed = node_a(R"({"type":"t","in":{"p":2.50}})");
    const Document other_text = node_a(R"({ "in": {"p": 1.0}, "type": "t" })");
    for (const Merged& merged : {merge(base, changed, base), merge(base, base, changed),
                                 merge(base, changed, other_text), merge(base, changed, changed)})
        EXPECT_EQ(merged.text, write_document(changed));
}

TEST(Merge, UntouchedPartsKeepTheirSpelling) {
    const std::string other =
        R"("b": {"type": "t", "in": {"p": 1.50e1, "q": "\u0041"}, "mine": {"x": [1.0]}})";
    const Merged merged =
        merge(nodes(R"("a": {"type": "t"}, )" + other), nodes(R"("a": {"type": "u"}, )" + other),
              nodes(R"("a": {"type": "t", "in": {"p": 7.0}}, )" + other));
    EXPECT_EQ(sentences(merged), "");
    EXPECT_TRUE(has_text(merged.text, R"("a": { "type": "u", "in": { "p": 7.0 } },)"));
    EXPECT_TRUE(has_text(merged.text, "\"p\": 1.50e1")) << merged.text;
    EXPECT_TRUE(has_text(merged.text, "\"mine\": { \"x\": [1.0] }")) << merged.text;
}

TEST(Merge, WithoutABaseEqualEntriesAreOne) {
    const Merged merged = merge(Document(), nodes(R"("a": {"type": "t"}, "b": {"type": "t"})"),
                                nodes(R"("a": {"type": "t"}, "c": {"type": "t"})"));
    EXPECT_EQ(sentences(merged), "");
    EXPECT_TRUE(has_text(merged.text, "\"b\"") && has_text(merged.text, "\"c\"")) << merged.text;
}

TEST(Merge, TheOrderIsThatOfTheSideThatReordered) {
    const auto order = [](const Merged& merged) {
        std::string ids;
        Diagnostics none;
        for (const NodePtr& node : read_document(merged.text, "", none).nodes)
            ids += node->id;
        return ids;
    };
    const auto graph = [](const std::string& ids) {
        std::string members;
        for (const char id : ids)
            members += std::string(members.empty() ? "" : ", ") + "\"" + id + "\": {\"type\": \"" +
                       id + "\"}";
        return nodes(members);
    };
    EXPECT_EQ(order(merge(graph("abc"), graph("abxc"), graph("abcy"))), "abxcy");
    EXPECT_EQ(order(merge(graph("abc"), graph("abxc"), graph("cba"))), "cbxa");
    EXPECT_EQ(order(merge(graph("abc"), graph("bac"), graph("yabc"))), "ybac");
    EXPECT_EQ(order(merge(graph("abc"), graph("bac"), graph("cab"))), "bac");
    EXPECT_EQ(order(merge(graph("abc"), graph("bc"), graph("abcy"))), "bcy");
}

TEST(Merge, LayoutHasNoConflictsOfCoordinates) {
    const auto graph = [](const std::string& position, const std::string& frame) {
        return graph_with(R"("nodes": {"a": {"type": "t"}}, "layout": {"a": )" + position +
                          R"(, "$frames": {"f": {)" + frame + "}}}");
    };
    const Document base = graph("[0, 0]", R"("title": "x", "rect": [0, 0, 1, 1])");
    const Merged moved = merge(base, graph("[1, 0]", R"("title": "x", "rect": [0, 0, 2, 1])"),
                               graph("[2, 0]", R"("title": "y", "rect": [0, 0, 3, 1])"));
    EXPECT_EQ(sentences(moved), "");
    EXPECT_TRUE(has_text(moved.text, "\"a\": [1, 0]"));
    EXPECT_TRUE(has_text(moved.text, R"("f": { "title": "y", "rect": [0, 0, 2, 1] })"));
    const Merged titled = merge(base, graph("[0, 0]", R"("title": "y", "rect": [0, 0, 1, 1])"),
                                graph("[0, 0]", R"("title": "z", "rect": [0, 0, 1, 1])"));
    EXPECT_EQ(sentences(titled), "frame f: title: \"y\" in ours, \"z\" in theirs; it was \"x\"\n");
}

TEST(Merge, ADeletedNodeHasNoPosition) {
    const auto graph = [](const std::string& members, const std::string& layout) {
        return graph_with("\"nodes\": {" + members + "}, \"layout\": {" + layout + "}");
    };
    const std::string both = R"("a": {"type": "t"}, )" + tail, positions = R"("a": [1, 2])";
    const Document base = graph(both, positions);
    for (const char* left : {R"("a": [1, 2])", R"("b": [3, 4])"}) {
        const Merged merged =
            merge(base, graph(tail, left), graph(both, R"("a": [5, 6], "z": [7, 8])"));
        EXPECT_EQ(sentences(merged), "");
        EXPECT_FALSE(has_text(merged.text, "\"a\"")) << merged.text;
        EXPECT_TRUE(has_text(merged.text, "\"z\": [7, 8]")) << merged.text;
    }
}

TEST(Merge, RenamesOfBothSides) {
    const auto graph = [](const std::string& id, const std::string& value) {
        return graph_with(R"("nodes": {")" + id + R"(": {"type": "t", "in": {"p": )" + value +
                          R"(}}}, "outputs": {"normal": {"from": ")" + id + ".n\"}}");
    };
    const Merged followed = merge(graph("a", "1"), graph("b", "1"), graph("a", "2"));
    EXPECT_EQ(sentences(followed), "");
    EXPECT_EQ(followed.text, canonical_text(graph("b", "2")));
    EXPECT_EQ(merge(graph("a", "1"), graph("a", "2"), graph("b", "1")).text, followed.text);
    EXPECT_EQ(sentences(merge(graph("a", "1"), graph("b", "1"), graph("b", "1"))), "");
    const Merged both = merge(graph("a", "1"), graph("b", "1"), graph("c", "1"));
    EXPECT_EQ(sentences(both), "node b: \"a\" was renamed \"b\" by ours, \"c\" by theirs\n");
    EXPECT_EQ(both.text, write_document(graph("b", "1")));
    ASSERT_EQ(both.conflicts.size(), 1U);
    EXPECT_EQ(with_side(graph("b", "1"), both.conflicts[0], Side::theirs),
              canonical_text(graph("c", "1")));
    EXPECT_EQ(sentences(merge(graph("a", "1"), graph("b", "1"), nodes(""))),
              "node b: deleted by theirs, changed by ours\n"
              "output normal: deleted by theirs, changed by ours\n");
}

TEST(Merge, AWireToADeletedNodeIsAConflict) {
    const std::string reader = R"("r": {"type": "t", "in": {"p": )";
    const Merged merged =
        merge(nodes(R"("a": {"type": "t"}, )" + reader + "1}}"), nodes(reader + "1}}"),
              nodes(R"("a": {"type": "t"}, )" + reader + R"({"from": "a.x"}}})"));
    ASSERT_EQ(merged.conflicts.size(), 1U);
    EXPECT_EQ(merged.conflicts[0].kind, ConflictKind::error);
    EXPECT_EQ(merged.conflicts[0].id, "r");
    EXPECT_TRUE(has_text(merged.text, "\"from\": \"a.x\""));
}

TEST(Merge, ACycleOfTwoWiresIsAConflict) {
    const auto graph = [](const std::string& a, const std::string& b) {
        return nodes(R"("a": {"type": "t", "in": {"p": )" + a +
                     R"(}}, "b": {"type": "t", "in": {"p": )" + b + "}}");
    };
    const Merged merged =
        merge(graph("1", "1"), graph(R"({"from": "b.x"})", "1"), graph("1", R"({"from": "a.x"})"));
    ASSERT_EQ(merged.conflicts.size(), 1U);
    EXPECT_EQ(merged.conflicts[0].kind, ConflictKind::error);
}

TEST(Merge, AnErrorOfASideIsNotAConflict) {
    const std::string wrong = R"("w": {"type": "t", "in": {"p": {"from": "missing.x"}}}, )";
    EXPECT_EQ(sentences(merge(node_a("{\"type\": \"t\"}"),
                              nodes(wrong + R"("a": {"type": "t"}, )" + tail),
                              node_a("{\"type\": \"u\"}"))),
              "");
}

TEST(Merge, AnAncestorInConflictEqualsNoSide) {
    const auto value = [](const char* number) {
        return node_a(R"({"type": "t", "in": {"p": )" + std::string(number) + "}}");
    };
    const Merged inner = merge(value("1"), value("2"), value("3"), MergePurpose::ancestor);
    Diagnostics none;
    const Document base = read_document(inner.text, "", none);
    EXPECT_EQ(sentences(merge(base, value("2"), value("3"))), "node a.p: 2 in ours, 3 in theirs\n");
    EXPECT_EQ(sentences(merge(base, value("3"), value("3"))), "");
    const Merged entry = merge(value("1"), node_a(""), value("3"), MergePurpose::ancestor);
    const Document outer = read_document(entry.text, "", none);
    EXPECT_EQ(sentences(merge(outer, node_a(""), value("3"))),
              "node a: deleted by ours, changed by theirs\n");
    EXPECT_EQ(merge(outer, value("3"), value("3")).text, write_document(value("3")));
}

TEST(Conflicts, AreWrittenAndRead) {
    const Merged merged = merge(
        graph_with(
            R"("name": "x", "nodes": {"a": {"type": "t", "in": {"p": 1.50}}, "b": {"type": "t"}})"),
        graph_with(R"("name": "y", "nodes": {"a": {"type": "t"}, "b": {"type": "u"}})"),
        graph_with(R"("name": "z", "nodes": {"a": {"type": "t", "in": {"p": 2}}})"));
    ASSERT_EQ(merged.conflicts.size(), 3U);
    Diagnostics diagnostics;
    const std::string text = conflicts_text(merged.conflicts);
    const auto read = read_conflicts(text, "c", diagnostics);
    ASSERT_TRUE(read) << to_text(diagnostics);
    EXPECT_EQ(conflicts_text(*read), text);
    for (const char* wrong :
         {"{", "[]", "{}", R"({"wrinkle_conflicts": 1, "conflicts": [5]})",
          R"({"wrinkle_conflicts": 1, "conflicts": [{"kind": "renamed", "section": "nodes"}]})",
          R"({"wrinkle_conflicts": 1, "conflicts": [
              {"kind": "renamed", "section": "nodes", "id": "a", "theirs": "b"}]})"}) {
        Diagnostics faults;
        EXPECT_FALSE(read_conflicts(wrong, "c", faults)) << wrong;
        EXPECT_TRUE(faults.has_errors()) << wrong;
    }
}

TEST(Conflicts, ASideIsTaken) {
    const auto graph = [](const std::string& a, const std::string& name) {
        return graph_with("\"name\": \"" + name + "\", \"nodes\": {" + a +
                          R"("b": {"type": "t"}}, "layout": {"b": [1, 2]})");
    };
    const Document theirs = graph(R"("a": {"type": "t", "in": {"p": 2}}, )", "z");
    const Merged merged =
        merge(graph(R"("a": {"type": "t", "in": {"p": 1}}, )", "x"), graph("", "y"), theirs);
    ASSERT_EQ(merged.conflicts.size(), 2U);
    const auto settled = [&](Side side) {
        std::string text = merged.text;
        for (const Conflict& conflict : merged.conflicts) {
            Diagnostics none;
            text = with_side(read_document(text, "", none), conflict, side);
        }
        return text;
    };
    EXPECT_EQ(settled(Side::ours), canonical_text(graph("", "y")));
    EXPECT_EQ(settled(Side::theirs), canonical_text(theirs));
}

TEST(Conflicts, AKeyIsSetOrUnset) {
    const std::string one = R"({"type": "t", "in": {"p": 1}})", unset = R"({"type": "t"})";
    const std::string two = R"({"type": "t", "in": {"p": 2}})";
    const auto settled = [&](const std::string& ours, const std::string& theirs, Side side) {
        const Merged merged = merge(node_a(one), node_a(ours), node_a(theirs));
        EXPECT_EQ(merged.conflicts.size(), 1U);
        Diagnostics none;
        return with_side(read_document(merged.text, "", none), merged.conflicts.at(0), side);
    };
    EXPECT_EQ(settled(two, unset, Side::ours), canonical_text(node_a(two)));
    EXPECT_EQ(settled(two, unset, Side::theirs), canonical_text(node_a(unset)));
    EXPECT_EQ(settled(unset, two, Side::theirs), canonical_text(node_a(two)));
}

}  // namespace
}  // namespace wrinkle::difference
