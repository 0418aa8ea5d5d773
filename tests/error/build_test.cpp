// Tests that errors of nodes in build() are reported at the node and never crash.
#include <gtest/gtest.h>

#include "lower/fixture.h"

namespace wrinkle {
namespace {

std::string build_reports(const std::string& text) {
    Diagnostics diagnostics;
    const Project project = test::project(text, diagnostics);
    const Compiled compiled = compile_material(project, test::registry(), {}, diagnostics);
    EXPECT_NE(compiled.ok, diagnostics.has_errors());
    return to_text(diagnostics);
}

std::string report_of(const std::string& type) {
    const std::string text = build_reports(
        test::graph("\"n\": {\"type\": \"" + type + "\"}", R"("a": {"from": "n.value"})"));
    const std::string prefix = "g.json:1:26: error: node 'n': ";
    EXPECT_EQ(text.substr(0, prefix.size()), prefix);
    return text.substr(prefix.size());
}

const std::string mend = " (report it to the author of the node)\n";

TEST(Build, OutputsAreGivenOnceAndRightly) {
    EXPECT_EQ(report_of("forgets"), "gives no value to its output 'value'" + mend);
    EXPECT_EQ(report_of("twice"), "gives its output 'value' twice" + mend);
    EXPECT_EQ(report_of("wrong_type"), "gives vec2 to its output 'value', which is float" + mend);
}

TEST(Build, ANodesOwnErrorIsPassedOn) {
    EXPECT_EQ(report_of("complains"), "the moon is not full\n");
}

TEST(Build, OperandsThatMakeNoSense) {
    const std::string text = report_of("bad_operands");
    EXPECT_EQ(text.substr(0, 38), "dot of (float, float) makes no sense: ");
}

TEST(Build, AGuessedFrameHasADirectionAndNoOtherHas) {
    const std::string sentence =
        "gives a frame a direction where there is none, or none to 'guess'" + mend;
    EXPECT_EQ(report_of("guess_nowhere"), sentence);
    EXPECT_EQ(report_of("vertex_somewhere"), sentence);
}

TEST(Build, RegionsAreClosedAndKeptTogether) {
    EXPECT_EQ(report_of("open_region"), "leaves a loop or a function open" + mend);
    EXPECT_EQ(report_of("leaks_region"),
              "uses a value of a loop or a function outside of it" + mend);
}

TEST(Build, EveryLieIsFoundOut) {
    const std::string text = report_of("lies");
    for (const char* part : {"uses op 9999, which does not exist",
                             "emits the op 'literal', which only the host makes",
                             "gives the op 'add' 1 operands",
                             "uses a value that does not exist",
                             "gives the op 'column' an impossible detail",
                             "asks for a literal that is not finite",
                             "requests a literal that is not a number",
                             "input() asks for port 77, which does not exist",
                             "reads port 'value' as a value, which it is not",
                             "reads port 'value' as an image, which it is not",
                             "reads port 'value' as an option, which it is not",
                             "reads port 'value' as a field, which it is not",
                             "asks for surface property 10, which does not exist",
                             "samples with op 21, which is none for it",
                             "samples an image that does not exist",
                             "ends a loop or a function that it did not begin",
                             "applies a loop or a function that does not exist",
                             "begins a loop or a function in an impossible way",
                             "gives a value to port 'value', which is not an output",
                             "output() asks for port 99, which does not exist"})
        EXPECT_NE(text.find(part), text.npos) << part << "\n" << text;
}

TEST(Build, PoisonIsSilent) {
    const std::string text = build_reports(test::graph(
        R"("n": {"type": "complains"}, "b": {"type": "bump", "in": {"height": {"from": "n.value"}}},
                       "s": {"type": "scale", "in": {"gradient": {"from": "b.gradient"}}})",
        R"("normal": {"from": "s.gradient"})"));
    EXPECT_EQ(text, "g.json:1:26: error: node 'n': the moon is not full\n");
}

TEST(Build, ReportsInASubgraphNameTheInstance) {
    const test::Files files({{"main.json", test::graph(R"("outer": {"type": "graph:s.json"})",
                                                       R"("a": {"from": "outer.v"})")},
                             {"s.json", test::graph(R"("inner": {"type": "complains"})",
                                                    R"("v": {"from": "inner.value"})")}});
    Diagnostics diagnostics;
    const Project project = load_project(files.folder / "main.json", {}, diagnostics);
    EXPECT_FALSE(compile_material(project, test::registry(), {}, diagnostics).ok);
    EXPECT_EQ(to_text(diagnostics), (files.folder / "s.json").string() +
                                        ":1:26: error: node 'outer/inner': the moon is not full\n");
}

TEST(Build, NothingIsCompiledAfterAnError) {
    Diagnostics diagnostics;
    const Project project = test::project(
        test::graph(R"("n": {"type": "number"})", R"("a": {"from": "n.value"})"), diagnostics);
    diagnostics.error(RuleId::option, "something before");
    EXPECT_FALSE(compile_material(project, test::registry(), {}, diagnostics).ok);
    EXPECT_EQ(diagnostics.list().size(), 1u);
}

TEST(Build, AWrongFrameIsReportedAtItsNode) {
    EXPECT_EQ(build_reports(test::graph(R"("n": {"type": "wrong_frame"})",
                                        R"("normal": {"from": "n.gradient"})")),
              "g.json:1:26: error: node 'n': the frame 'exact' goes with the scale 'surface' (set "
              "the frame to 'auto', or change the scale)\n");
}

}  // namespace
}  // namespace wrinkle
