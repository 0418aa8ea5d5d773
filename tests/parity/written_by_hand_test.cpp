// Tests that generated text is about as short as text that a person wrote for the same graph
// (tests/parity/written_by_hand), and that both give the numbers of the evaluator.
#include <gtest/gtest.h>

#include "base/file.h"
#include "base/text.h"
#include "certify/points.h"
#include "parity/compare.h"
#include "parity/context.h"
#include "parity/node_graph.h"

namespace wrinkle::test {
namespace {

using WrittenByHand = WithGpu;

constexpr double most_lines = 1.15;  // relative to the lines by hand

std::string text_of(const std::filesystem::path& file) {
    std::string why;
    const auto text = read_file(file, why);
    EXPECT_TRUE(text) << why;
    return text.value_or("");
}

// Lines of code, without blank lines and comments.
size_t lines_of_code(const std::string& text) {
    size_t lines = 0;
    for (const std::string_view line : split(text, '\n')) {
        const size_t first = line.find_first_not_of(' ');
        lines += first != line.npos && !line.substr(first).starts_with("//");
    }
    return lines;
}

TEST_F(WrittenByHand, IsAboutAsLongAndGivesTheSameNumbers) {
    const std::filesystem::path graphs = WRINKLE_SOURCE_DIR "/graphs";
    const PointSet points = certify::random_points(2000, 7, {0, 1});
    for (const char* graph : {"noise_rock", "nodes/brick", "rusty_steel", "displaced_rock",
                              "nodes/worley_noise", "nodes/scratches", "nodes/pyramids",
                              "plain_height", "nodes/domes", "nodes/simplex_noise"}) {
        SCOPED_TRACE(graph);
        Diagnostics diagnostics;
        const Project project =
            load_project(graphs / (graph + std::string(".json")), {}, diagnostics);
        MaterialOptions options;
        options.given_differentials = true;
        const Compiled compiled = compile_material(project, all_nodes(), options, diagnostics);
        ASSERT_TRUE(compiled.ok) << to_text(diagnostics);

        EmitOptions form;
        form.differentials = Differentials::given;
        form.name = std::filesystem::path(graph).filename();
        const Shader generated = emit(compiled.module, form);
        Shader by_hand = generated;
        by_hand.source =
            text_of(WRINKLE_SOURCE_DIR "/tests/parity/written_by_hand/" + form.name + ".glsl");
        EXPECT_LE(static_cast<double>(lines_of_code(generated.source)),
                  most_lines * static_cast<double>(lines_of_code(by_hand.source)));

        const Reference reference = make_reference(compiled.module, points, test_image);
        for (const Shader* shader : std::initializer_list<const Shader*>{&generated, &by_hand}) {
            const Values values = on_gpu(*shader, points, test_image);
            ASSERT_EQ(values.size(), reference.precise.size());
            const Comparison found = reference.compare(values, reference.precise);
            EXPECT_EQ(found.different, 0U) << (shader == &by_hand ? "by hand" : "generated");
            EXPECT_LE(100 * found.unstable, found.values);
            if (found.first)
                ADD_FAILURE() << "output " << found.first->output << ": " << found.first->a
                              << ", precisely " << found.first->precise;
        }
    }
}

}  // namespace
}  // namespace wrinkle::test
