// Tests of reading graphs, with the exact report for each error.
#include "graph/read.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sample.h"

namespace wrinkle {
namespace {

TEST(Read, TheSample) {
    Diagnostics diagnostics;
    const Document document = read_document(sample_text(), "g.json", diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
    EXPECT_EQ(document.name, "Woven strap over a baked shape");
    ASSERT_EQ(document.nodes.size(), 7u);
    EXPECT_EQ(document.nodes[2]->id, "weave");
    const Node& weave = *document.find("weave");
    EXPECT_EQ(weave.type, "tangent_normal_map");
    EXPECT_EQ(weave.version, 2);
    EXPECT_TRUE(weave.muted);
    ASSERT_EQ(weave.inputs.size(), 3u);
    EXPECT_EQ(weave.find("uv")->link.text(), "tile.uv");
    EXPECT_EQ(weave.find("image")->kind, Input::Kind::literal);
    EXPECT_EQ(weave.find("image")->value.find("encoding").as_string(), "normal_dx");
    EXPECT_TRUE(document.find("tile")->find("uv")->link.is_surface());
    EXPECT_TRUE(document.find("softer")->find("amount")->link.is_input());
    EXPECT_EQ(document.inputs.find("amount")->default_value.as_number(), 0.5);
    EXPECT_EQ(document.outputs.find("normal")->from.link.node, "normal");
    EXPECT_EQ(document.positions.find("weave")->x, 220);
    EXPECT_EQ(document.frames.find("f1")->rect, (Rectangle{0, 0, 400, 300}));
    EXPECT_EQ(document.notes.find("n1")->text, "Scan 12");
    EXPECT_EQ(document.find("nobody"), nullptr);
}

TEST(Read, SubgraphTypes) {
    const Document document =
        read_quietly(graph_of(R"("a": {"type": "graph:dir/weave.json"}, "b": {"type": "graphs"})"));
    EXPECT_EQ(document.find("a")->subgraph(), "dir/weave.json");
    EXPECT_FALSE(document.find("b")->subgraph().has_value());
}

TEST(Read, EveryProblemInOneGo) {
    EXPECT_EQ(problems_of(R"({
  "wrinkle": 2,
  "name": 3,
  "back_faces": "both",
  "inputs": { "a.b": { "type": 1 }, "c": 2 },
  "nodes": {
    "x.y": { "type": "t" },
    "input": { "type": "t" },
    "n": { "in": 3, "version": 1.5, "muted": "no" },
    "m": { "type": "", "in": { "a": { "from": "weave" }, "b": { "from": 1 }, "c": { "from": "a.b.c" } } },
    "o": 7
  },
  "outputs": { "normal": 1, "height": { "from": "nn.height" }, "color": { "from": "input.cc" } },
  "layout": { "n": [1], "$frames": { "f": { "rect": [1, 2, 3] } }, "$notes": [] }
})"),
              R"(g.json:2:14: error: the format version is 2 (this program reads version 1)
g.json:3:11: error: "name" is a number (expected a string)
g.json:4:17: error: "back_faces" is "both" (expected "mirror", "flip" or "none")
g.json:5:15: error: the input name "a.b" contains a '.' (expected 1 to 128 characters without '.', not beginning with '$')
g.json:5:32: error: "type" is a number (expected a string)
g.json:5:42: error: the graph input is a number (expected an object)
g.json:7:5: error: the id "x.y" contains a '.' (expected 1 to 128 characters without '.', not beginning with '$')
g.json:8:5: error: the id "input" is a reserved word (expected 1 to 128 characters without '.', not beginning with '$')
g.json:9:10: error: node 'n': the node has no "type" (expected "type": "NAME")
g.json:9:18: error: node 'n': "in" is a number (expected an object)
g.json:9:32: error: node 'n': "version" is 1.5 (expected an integer from 1 on)
g.json:9:46: error: node 'n': "muted" is a string (expected a boolean)
g.json:10:20: error: node 'm': "type" is empty (expected the name of a node type)
g.json:10:47: error: node 'm': "weave" is not a link (expected "NODE.OUTPUT", "surface.NAME" or "input.NAME")
g.json:10:73: error: node 'm': "from" is a number (expected a string)
g.json:10:93: error: node 'm': "a.b.c" is not a link (expected "NODE.OUTPUT", "surface.NAME" or "input.NAME")
g.json:11:10: error: node 'o': the node is a number (expected an object)
g.json:13:26: error: output "normal" is not a link (expected { "from": "NODE.OUTPUT" })
g.json:13:39: error: there is no node 'nn' (did you mean 'n'?)
g.json:13:73: error: the graph has no input 'cc' (did you mean 'c'?)
g.json:14:20: error: node 'n': the position is not two numbers (expected [x, y])
g.json:14:53: error: a frame or note has no rectangle (expected "rect": [x, y, width, height])
g.json:14:78: error: "$notes" is an array (expected an object)
)");
}

TEST(Read, PointersAndNodes) {
    Diagnostics diagnostics;
    read_document(graph_of(R"("a/b": {"type": "t", "in": {"x": {"from": "lost.y"}}})"), "g.json",
                  diagnostics);
    ASSERT_EQ(diagnostics.list().size(), 1u);
    EXPECT_EQ(diagnostics.list()[0].pointer, "/nodes/a~1b/in/x");
    EXPECT_EQ(diagnostics.list()[0].node, "a/b");
}

TEST(Read, NotAGraph) {
    EXPECT_EQ(problems_of("{}"),
              "g.json:1:1: error: the file does not say that it is a graph (expected \"wrinkle\": "
              "1)\n");
    EXPECT_EQ(problems_of("[1]"),
              "g.json:1:1: error: the graph is an array (expected an object)\n");
    EXPECT_EQ(problems_of("null"), "g.json:1:1: error: the graph is null (expected an object)\n");
    EXPECT_EQ(problems_of(R"({"wrinkle": 1, "nodes": []})"),
              "g.json:1:25: error: \"nodes\" is an array (expected an object)\n");
}

TEST(Read, DuplicateNodesAndPorts) {
    Diagnostics diagnostics;
    const Document document = read_document(
        graph_of(
            "\"a\": {\"type\": \"t\", \"in\": {\"x\": 1, \"x\": 2}},\n\"a\": {\"type\": \"u\"}"),
        "g.json", diagnostics);
    EXPECT_EQ(to_text(diagnostics),
              "g.json:2:35: error: key \"x\" occurs twice (first at line 2, column 27)\n"
              "g.json:3:1: error: key \"a\" occurs twice (first at line 2, column 1)\n");
    ASSERT_EQ(document.nodes.size(), 1u);
    EXPECT_EQ(document.nodes[0]->inputs.size(), 1u);
}

TEST(Read, SyntaxErrorEndsTheReportAfterWhatStoodBefore) {
    EXPECT_EQ(problems_of("{\"wrinkle\": 1, \"nodes\": {\n"
                          "\"a\": {\"type\": 3, \"in\": {\"x\": {\"from\": \"later.y\"}}},\n"
                          "\"b\": {\"in\": {\"y\": 1e999"),
              "g.json:2:15: error: node 'a': \"type\" is a number (expected a string)\n"
              "g.json:3:19: error: the number 1e999 is out of range (expected a finite number)\n");
}

TEST(Read, EveryTruncationIsReportedInsideTheText) {
    const std::string& text = sample_text();
    for (size_t n = 0; n + 2 < text.size(); ++n) {
        Diagnostics diagnostics;
        const Document document = read_document(text.substr(0, n), "g.json", diagnostics);
        ASSERT_EQ(diagnostics.error_count(), 1u) << n << "\n" << to_text(diagnostics);
        const Location where = diagnostics.list()[0].where;
        const auto lines =
            static_cast<size_t>(std::count(text.begin(), text.begin() + n, '\n')) + 1;
        const size_t last = text.rfind('\n', n == 0 ? 0 : n - 1);
        const size_t column = n - (last == text.npos ? 0 : last + 1) + 1;
        EXPECT_LE(where.line, lines);
        EXPECT_GE(where.line, 1u);
        if (where.line == lines) {
            EXPECT_LE(where.column, column) << n;
        }
        canonical_text(document);
    }
}

TEST(Read, EveryChangedByteIsSurvived) {
    const std::string& text = sample_text();
    for (size_t n = 0; n < text.size(); ++n)
        for (const char c : {'\0', '"', '}', '[', '.', '\xFF', '9'}) {
            std::string broken = text;
            broken[n] = c;
            Diagnostics diagnostics;
            const Document document = read_document(broken, "g.json", diagnostics);
            EXPECT_EQ(write_document(document), broken);
            canonical_text(document);
        }
}

TEST(Read, DeepArrays) {
    const std::string deep(100000, '[');
    EXPECT_EQ(problems_of(graph_of("\"a\": {\"type\": \"t\", \"in\": {\"x\": " + deep)),
              "g.json:2:92: error: nested more than 64 deep (arrays and objects nest at most 64 "
              "deep)\n");
}

TEST(Read, NodeLimitIsAdjustable) {
    const std::string text = graph_of(
        "\"a\": {\"type\": \"t\"},\n\"b\": {\"type\": \"t\", \"in\": {\"x\": {\"from\": "
        "\"c.y\"}}},\n\"c\": {\"type\": \"t\"}");
    EXPECT_EQ(problems_of(text), "");
    EXPECT_EQ(problems_of(text, {2, 0}),
              "g.json:4:1: error: the graph has more nodes than are allowed (the limit is 2)\n");
}

TEST(Read, UnknownKeysAreErrorsOnlyWhenAsked) {
    const std::string text = R"({"$schema": "s", "wrinkle": 1, "autor": "me",
"inputs": {"i": {"type": "float", "min": 0}},
"nodes": {"a": {"type": "t", "mutd": true, "in": {"x": {"from": "surface.uv0", "k": 1}}}},
"outputs": {}, "layouts": {}})";
    EXPECT_EQ(problems_of(text), "");
    Diagnostics diagnostics;
    report_unknown(read_quietly(text), diagnostics);
    EXPECT_EQ(to_text(diagnostics),
              R"(g.json:1:32: error: unknown key "autor"
g.json:2:35: error: unknown key "min"
g.json:3:30: error: node 'a': unknown key "mutd" (did you mean "muted"?)
g.json:3:80: error: node 'a': unknown key "k" beside "from" (a link has no other key)
g.json:4:16: error: unknown key "layouts" (did you mean "layout"?)
)");
}

TEST(Ids, Rules) {
    EXPECT_EQ(id_problem("weave"), "");
    EXPECT_EQ(id_problem("a b/c~\"\xC3\xA9"), "");
    EXPECT_EQ(id_problem(""), "is empty");
    EXPECT_EQ(id_problem("a.b"), "contains a '.'");
    EXPECT_EQ(id_problem("a\nb"), "contains a control character");
    EXPECT_EQ(id_problem("a\xC2\x85"), "contains a control character");
    EXPECT_EQ(id_problem("\xC2\xA0"), "");
    EXPECT_EQ(id_problem("$a"), "begins with '$'");
    EXPECT_EQ(id_problem("surface"), "is a reserved word");
    EXPECT_EQ(id_problem("surface", false), "");
    EXPECT_EQ(id_problem("\xFF"), "is not valid UTF-8");
    std::string long_id;
    for (int i = 0; i < 128; ++i)
        long_id += "\xC3\xA9";
    EXPECT_EQ(id_problem(long_id), "");
    EXPECT_EQ(id_problem(long_id + "x"), "is longer than 128 characters");
}

TEST(Diagnose, AtEachThing) {
    const Document d = read_quietly(sample_text());
    const Node& weave = *d.find("weave");
    EXPECT_EQ(to_text(diagnose(d, weave, RuleId::cycle, "is odd", "be even")),
              "g.json:10:5: error: node 'weave': is odd (be even)");
    EXPECT_EQ(to_text(diagnose_port(d, weave, "uv", RuleId::invalid_value, "no")),
              "g.json:16:15: error: node 'weave': no");
    EXPECT_EQ(diagnose_port(d, weave, "uv", RuleId::invalid_value, "no").pointer,
              "/nodes/weave/in/uv");
    EXPECT_EQ(to_text(diagnose_port(d, weave, "absent", RuleId::invalid_value, "no")),
              "g.json:10:5: error: node 'weave': no");
    EXPECT_EQ(to_text(diagnose(d, *d.outputs.find("normal"), RuleId::cycle, "no")),
              "g.json:26:15: error: no");
    EXPECT_EQ(to_text(diagnose(d, *d.inputs.find("amount"), RuleId::cycle, "no")),
              "g.json:5:5: error: no");
    EXPECT_EQ(to_text(diagnose(weave.find("image")->value.find("encoding"), "weave", RuleId::cycle,
                               "no")),
              "g.json:15:62: error: node 'weave': no");
    EXPECT_EQ(to_text(diagnose(d, RuleId::cycle, "no")), "g.json: error: no");
}

// Writing such a document would lose the parts that were not read.
TEST(Read, SaysWhatItLost) {
    Diagnostics ignored;
    const auto lost = [&](const std::string& text, ReadLimits limits = {}) {
        return read_document(text, "g.json", ignored, limits).lost;
    };
    EXPECT_EQ(lost(sample_text()), "");
    EXPECT_EQ(lost(R"({"wrinkle": 1, "nodes": {"a": {"type": "x", "odd": []}}, "more": 1})"), "");
    EXPECT_NE(lost(sample_text().substr(0, 900)), "");
    EXPECT_NE(lost(R"({"wrinkle": 1, "nodes": {}, "nodes": {}})"), "");
    EXPECT_EQ(lost(sample_text(), {7, 0}), "");
    EXPECT_EQ(lost(sample_text(), {6, 0}), "it has more nodes than are allowed");
    EXPECT_EQ(lost("[1, 2]"), "it is not a JSON object");
}

// Ports are searched linearly, as those of a node are, so their number is limited.
TEST(Read, InputsAndOutputsHaveALimit) {
    const auto problems = [](size_t count) {
        std::string inputs, outputs;
        for (size_t i = 0; i < count; ++i) {
            const std::string name = (i ? ", \"p" : "\"p") + std::to_string(i) + "\": ";
            inputs += name + "{\"type\": \"float\"}";
            outputs += name + "{\"from\": \"input.p0\"}";
        }
        return problems_of("{\"wrinkle\": 1, \"inputs\": {" + inputs + "}, \"outputs\": {" +
                           outputs + "}}");
    };
    EXPECT_EQ(problems(256), "");
    const std::string text = problems(257);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
    EXPECT_NE(text.find("the limit is 256"), text.npos);
}

}  // namespace
}  // namespace wrinkle
