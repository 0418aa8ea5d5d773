#include "lower/override.h"

#include <gtest/gtest.h>

#include "json/parse.h"
#include "json/write.h"
#include "lower/fixture.h"
#include "registry/reference.h"

namespace wrinkle {
namespace {

std::string values(const char* text) {
    Diagnostics diagnostics;
    const auto parsed = parse_override(text, diagnostics);
    if (!parsed) return to_text(diagnostics);
    std::string list = parsed->target.text() + " =";
    for (const json::Value& value : parsed->values)
        list += " " + json::one_line(value);
    return list;
}

TEST(Override, IsReadFromText) {
    EXPECT_EQ(values("n.value=0.25"), "n.value = 0.25");
    EXPECT_EQ(values("input.height=-1e3"), "input.height = -1000");
    EXPECT_EQ(values("v.scale=[8, 8]"), "v.scale = [8, 8]");
    EXPECT_EQ(values("o.mode=third"), "o.mode = \"third\"");
    EXPECT_EQ(values("o.tile=true"), "o.tile = true");
    EXPECT_EQ(values("p.image=a=b.png"), "p.image = \"a=b.png\"");
    EXPECT_EQ(values("p.image=C:/x:y"), "p.image = \"C:/x:y\"");
    EXPECT_EQ(values("n.value=0:2:5"), "n.value = 0 0.5 1 1.5 2");
    EXPECT_EQ(values("n.value=1:-1:2"), "n.value = 1 -1");
}

TEST(Override, SaysWhatIsNotOne) {
    const std::string form = " (expected NODE.PORT=VALUE or input.NAME=VALUE)\n";
    EXPECT_EQ(values("n.value"), "error: --set n.value: this sets nothing" + form);
    EXPECT_EQ(values("value=1"), "error: --set value=1: this sets nothing" + form);
    EXPECT_EQ(values(".value=1"), "error: --set .value=1: this sets nothing" + form);
    EXPECT_EQ(values("n.=1"), "error: --set n.=1: this sets nothing" + form);
    EXPECT_EQ(values("n.value="),
              "error: --set n.value=: the value is empty (expected JSON or a word)\n");
    EXPECT_EQ(values("n.value=0:1:1"),
              "error: --set n.value=0:1:1: the value is neither JSON nor a sweep (a sweep is "
              "A:B:N, N from 2 to 10000)\n");
}

// Rejects from_chars' "nan" and "inf", and an overflow of the difference between the ends.
TEST(Override, HoldsFiniteNumbersAlone) {
    for (const char* text : {"n.value=0:1:nan", "n.value=0:1:inf"})
        EXPECT_NE(values(text).find("neither JSON nor a sweep"), std::string::npos) << text;
    for (const char* text : {"n.value=nan:1:3", "n.value=0:inf:3", "n.value=-infinity:0:3"})
        EXPECT_EQ(values(text), "n.value = \"" + std::string(text + 8) + "\"");
    EXPECT_EQ(values("n.value=-1e308:1e308:3"), "n.value = -1e+308 0 1e+308");
    EXPECT_EQ(values("n.value=1:2:11"), "n.value = 1 1.1 1.2 1.3 1.4 1.5 1.6 1.7 1.8 1.9 2");
}

const std::string sample = test::graph(
    R"("n": {"type": "number", "in": {"value": {"from": "input.k"}}}, "o": {"type": "options"})",
    R"("a": {"from": "n.value"}, "b": {"from": "o.value"})",
    R"("inputs": {"k": {"type": "float", "default": 0.25}}, )");

std::string applied(const char* text, size_t run = 0) {
    Diagnostics diagnostics;
    const Project project = test::project(sample, diagnostics);
    const auto change = parse_override(text, diagnostics);
    const Project changed =
        with_overrides(project, test::registry(), std::span(&*change, 1), run, diagnostics);
    if (diagnostics.has_errors()) return to_text(diagnostics);
    EXPECT_FALSE(project.top().edited) << "the original stays";
    const Link& target = change->target;
    if (target.is_input())
        return json::one_line(changed.top().inputs.find(target.port)->default_value);
    return json::one_line(changed.top().find(target.node)->find(target.port)->value);
}

TEST(Override, ReplacesAValueOrAWire) {
    EXPECT_EQ(applied("n.value=0.75"), "0.75");
    EXPECT_EQ(applied("o.mode=first"), "\"first\"");
    EXPECT_EQ(applied("input.k=3"), "3");
    EXPECT_EQ(applied("input.k=0:1:3", 1), "0.5");
}

TEST(Override, NamesWhatDoesNotFit) {
    EXPECT_EQ(applied("m.value=1"),
              "error: --set m.value=1: there is no node 'm' (did you mean 'n'?)\n");
    EXPECT_EQ(applied("n.valu=1"),
              "error: --set n.valu=1: node 'n' has no port 'valu' (did you mean 'value'?)\n");
    EXPECT_EQ(applied("input.q=1"),
              "error: --set input.q=1: the graph has no input 'q' (did you mean 'k'?)\n");
    EXPECT_EQ(applied("n.value=high"),
              "error: --set n.value=high: the value holds a string (expected a number)\n");
    EXPECT_EQ(applied("o.mode=thir"),
              "error: --set o.mode=thir: the value has no choice \"thir\" (did you mean "
              "'third'?)\n");
    EXPECT_EQ(applied("o.octaves=2.5"),
              "error: --set o.octaves=2.5: the value holds 2.5 (expected an integer from 1 to "
              "8)\n");
}

TEST(Schema, IsJson) {
    Diagnostics diagnostics;
    json::parse(graph_schema(test::registry()), "schema", diagnostics);
    json::parse(graph_schema(Registry()), "schema", diagnostics);
    json::parse(list_json(test::registry()), "list", diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
}

}  // namespace
}  // namespace wrinkle
