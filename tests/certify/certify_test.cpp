// Tests that certification reports each fault of a node with its location and size, and that a
// correct node passes.
#include "certify/certify.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "nodes/all.h"
#include "parity/context.h"
#include "registry/plugin_loader.h"

namespace wrinkle::certify {
namespace {

const Registry& nodes() {
    static const Registry registry = [] {
        Registry made;
        Diagnostics diagnostics;
        made.add_plugin(built_in_nodes(), Registry::built_in, diagnostics);
        const std::vector<std::string> places{FAULTY_PLUGIN, GOOD_PLUGIN};
        load_plugins(made, places, diagnostics);
        EXPECT_TRUE(diagnostics.list().empty()) << to_text(diagnostics);
        return made;
    }();
    return registry;
}

class Certify : public test::WithGpu {
protected:
    static Report of(const std::string& id) {
        std::string why;
        const auto pictures = make_image_folder(why);
        EXPECT_TRUE(pictures) << why;
        const NodeType* type = nodes().find(id);
        EXPECT_TRUE(type) << id;
        return type ? certify(*type, {nodes(), *pictures, true, {}}) : Report{};
    }

    // Formats every finding as "check: port: message (remedy)".
    static std::vector<std::string> sentences(const std::string& id) {
        const Report report = of(id);
        std::vector<std::string> list;
        for (const Finding& finding : report.findings) {
            Diagnostic diagnostic = to_diagnostic(finding, report, "");
            diagnostic.node.clear();
            list.push_back(to_text(diagnostic).substr(7));
        }
        return list;
    }

    static void expect_one(const std::string& id, const std::vector<std::string>& parts) {
        const auto list = sentences(id);
        const auto fits = [&](const std::string& text) {
            return std::all_of(parts.begin(), parts.end(), [&](const std::string& part) {
                return text.find(part) != text.npos;
            });
        };
        EXPECT_EQ(std::count_if(list.begin(), list.end(), fits), 1)
            << id << ": " << testing::PrintToString(list);
    }
};

TEST_F(Certify, PassesANodeThatIsFine) {
    const Report report = of("ripples");
    EXPECT_EQ(sentences("ripples"), std::vector<std::string>{});
    EXPECT_GE(report.derivatives, 500U);
    EXPECT_GE(report.values, 1000U);
    EXPECT_EQ(to_text(report, true),
              "ripples  ok: 1200 values in float, double and on the GPU, 800 derivatives\n");
}

// Without the GPU, which the tests of parity compare with. NodesAsAPlugin in tests/nodes compares
// the nodes in a plugin with these.
TEST(CertifyNodes, PassesEveryBuiltInOne) {
    Registry built_in;
    Diagnostics diagnostics;
    built_in.add_plugin(built_in_nodes(), Registry::built_in, diagnostics);
    std::string why;
    const auto images = make_image_folder(why);
    ASSERT_TRUE(images) << why;
    for (const NodeType& type : built_in.list()) {
        const Report report = certify(type, {built_in, *images, false, {}});
        EXPECT_TRUE(report.findings.empty()) << to_text(report, false);
    }
}

TEST_F(Certify, NamesASlopeThatIsNotThatOfItsJumps) {
    expect_one("terraces", {"detach: port 'height': with default inputs, at point ",
                            ", it changes by 0 a pixel, its derivative is ", "apart are allowed",
                            "a bump leaves out a detached value"});
}

TEST_F(Certify, NamesADerivativeLostToDetach) {
    expect_one("stiff",
               {"detach: port 'height'", "it changes by ", " a pixel, its derivative is 0; "});
}

TEST_F(Certify, NamesAPatternTooFineToHaveASlope) {
    expect_one("dusty", {"derivative: port 'height': with default inputs, ",
                         " of 200 numbers lie on a jump or a kink, where there is no slope; one in "
                         "50 is allowed"});
}

TEST_F(Certify, NamesEveryPortThatIsNotDocumented) {
    EXPECT_EQ(
        sentences("undocumented"),
        (std::vector<std::string>{
            "descriptor: its doc is not a sentence: \"Says too little\" (one or two sentences "
            "that end with a full stop)",
            "descriptor: port 'amount': its doc line only repeats its name (say what it is, "
            "with its unit)",
            "descriptor: port 'angle': an angle without a unit (unit(\"deg\") or "
            "unit(\"rad\"), or the word in its doc line)",
            "descriptor: port 'level': it has no doc line (say in one line what it is, with "
            "its unit)",
            "descriptor: port 'height': a height without a unit (unit(\"m\"), or \"length "
            "units\" in its doc line)"}));
}

TEST_F(Certify, NamesWhatIsNotFiniteOnDegenerateInput) {
    expect_one("divides", {"finite: port 'height': with default inputs, where no uv changes "
                           "between pixels, it is ",
                           "guard what can be 0: divide()"});
}

TEST_F(Certify, NamesABuildThatIsNotDeterministic) {
    const auto list = sentences("counting");
    ASSERT_EQ(list.size(), 1U) << testing::PrintToString(list);
    EXPECT_TRUE(list[0].starts_with("deterministic: built a second time it differs: line "));
    EXPECT_NE(list[0].find("no statics that change"), std::string::npos) << list[0];
}

TEST_F(Certify, NamesAJumpWherePointsAre) {
    expect_one("on_the_edge", {"precision: with default inputs, ",
                               " of 300 values hang on the "
                               "last bits of their inputs; one in 2 is allowed"});
}

TEST_F(Certify, NamesBothNumbersOfCpuAndGpu) {
    expect_one("overflows", {"gpu: port 'height': with default inputs, at point ", " in the CPU, ",
                             " in the GPU", "apart are allowed", "plugin.h leaves undefined"});
}

TEST_F(Certify, NamesWhatIsTooFineForAFloat) {
    expect_one("coarse", {"precision: port 'height': ", " in float, ", " in double; ",
                          "of the range", "fract() before a large factor"});
}

TEST_F(Certify, NamesABodyThatGivesUp) {
    const auto list = sentences("throws");
    ASSERT_EQ(list.size(), 1U) << testing::PrintToString(list);
    EXPECT_TRUE(list[0].starts_with("text: no graph around it compiles: ")) << list[0];
    EXPECT_NE(list[0].find("no height today"), std::string::npos) << list[0];
}

TEST_F(Certify, ShowsTheGraphOnce) {
    const std::string text = to_text(of("stiff"), true);
    EXPECT_TRUE(text.starts_with("stiff  failed\n    detach: port 'height': ")) << text;
    const size_t graph = text.find("\n        in {\"wrinkle\": 1");
    ASSERT_NE(graph, std::string::npos) << text;
    EXPECT_EQ(text.find("\n        in ", graph + 1), std::string::npos);
}

}  // namespace
}  // namespace wrinkle::certify
