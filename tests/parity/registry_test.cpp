// What holds for every registered node, now and later: it is documented, its graph survives a round
// trip through the file, and the derivative of its numbers is what central differences say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "graph/write.h"
#include "ir/derive.h"
#include "ir/print.h"
#include "parity/compare.h"
#include "parity/node_graph.h"
#include "parity/points.h"

namespace wrinkle::test {
namespace {

bool is_snake_case(const std::string& name) {
    return !name.empty() && std::islower(static_cast<unsigned char>(name[0])) &&
           std::all_of(name.begin(), name.end(), [](unsigned char c) {
               return std::islower(c) || std::isdigit(c) || c == '_';
           });
}

void expect_sensible(const Port& port) {
    SCOPED_TRACE(port.name);
    EXPECT_TRUE(is_snake_case(port.name));
    EXPECT_GE(port.doc.size(), 2U);
    EXPECT_EQ(port.doc.find('\n'), std::string::npos);
    EXPECT_LE(port.soft_min, port.soft_max);
    EXPECT_LE(port.hard_min, port.hard_max);
    if (port.has_soft_range() && port.has_hard_range()) {
        EXPECT_GE(port.soft_min, port.hard_min);
        EXPECT_LE(port.soft_max, port.hard_max);
    }
    if (port.default_kind == Port::Default::constant && port.has_hard_range()) {
        EXPECT_GE(port.default_value[0], port.hard_min);
        EXPECT_LE(port.default_value[0], port.hard_max);
    }
    if (port.kind == Port::Kind::choice) {
        EXPECT_GE(port.choices.size(), 2U);
        for (const std::string& choice : port.choices)
            EXPECT_TRUE(is_snake_case(choice)) << choice;
    }
}

TEST(EveryNode, IsDocumented) {
    ASSERT_GE(all_nodes().list().size(), 20U);
    for (const NodeType& type : all_nodes().list()) {
        SCOPED_TRACE(type.id);
        EXPECT_TRUE(is_snake_case(type.id));
        EXPECT_FALSE(type.title.empty());
        EXPECT_FALSE(type.family.empty());
        EXPECT_TRUE(type.doc.ends_with('.')) << type.doc;
        size_t outputs = 0;
        for (const Port& port : type.ports) {
            expect_sensible(port);
            outputs += port.kind == Port::Kind::output ? 1 : 0;
        }
        EXPECT_GE(outputs, 1U);
    }
}

TEST(EveryNode, SurvivesARoundTrip) {
    for (const NodeType& type : all_nodes().list()) {
        for (const Inputs inputs : {Inputs::defaults, Inputs::numbers, Inputs::mixed}) {
            const Subject subject = compile_around(type, inputs, 5);
            ASSERT_TRUE(subject.compiled.ok);
            SCOPED_TRACE(subject.text);
            Diagnostics diagnostics;
            const std::string canonical = canonical_text(subject.project.top());
            Document again = read_document(canonical, "subject.json", diagnostics);
            EXPECT_EQ(canonical_text(again), canonical);
            const Project project = load_project(std::move(again), image_folder(), {}, diagnostics);
            MaterialOptions options;
            options.uniform_parameters = true;
            options.given_differentials = true;
            const Compiled compiled = compile_material(project, all_nodes(), options, diagnostics);
            EXPECT_TRUE(compiled.ok) << to_text(diagnostics);
            EXPECT_EQ(print(compiled.module), print(subject.compiled.module));
        }
    }
}

// Central differences at two steps: where they disagree there is a jump or a kink.
struct Slope {
    double value;
    bool smooth;
};
Slope slope_of(double wide, double narrow, double scale) {
    const double size = std::max(std::fabs(narrow), 1e-3 * scale);
    return {(4 * narrow - wide) / 3, std::fabs(wide - narrow) <= 1e-5 * size};
}

struct Tally {
    size_t compared = 0;
    size_t left_out = 0;
};

// Outputs come in pairs: a value, and its derived change to the next pixel in x.
Tally compare_derivatives(const Module& module, const PointSet& points) {
    constexpr double step = 1e-4;
    Tally tally;
    const auto at = [&](double pixels) {
        return on_cpu<double>(module, moved_in_x(points, pixels), test_image);
    };
    const Values here = at(0), right = at(step), left = at(-step), right2 = at(step / 2),
                 left2 = at(-step / 2);
    for (size_t pair = 0; pair < module.outputs.size(); pair += 2) {
        const std::vector<double>& derived = here[pair + 1];
        double scale = 0;
        for (const double each : derived)
            scale = std::max(scale, std::fabs(each));
        for (size_t k = 0; k < derived.size(); ++k) {
            const double wide = (right[pair][k] - left[pair][k]) / (2 * step);
            const double narrow = (right2[pair][k] - left2[pair][k]) / step;
            const Slope slope = slope_of(wide, narrow, scale);
            if (!slope.smooth) {
                ++tally.left_out;
                continue;
            }
            ++tally.compared;
            EXPECT_NEAR(derived[k], slope.value,
                        1e-4 * std::max(std::fabs(slope.value), 1e-3 * scale) + 1e-9)
                << module.outputs[pair].name << ", number " << k;
        }
    }
    return tally;
}

// The numbers among the outputs (a normal is constant under differentiation), with derivatives.
Module with_derivatives(const Module& source) {
    Module module = source;
    module.outputs.clear();
    Direction direction = screen_direction(module, Variant::dx, false);
    for (const ModuleOutput& output : source.outputs) {
        const bool number = output.port_type != WR_PORT_normal &&
                            output.port_type != WR_PORT_gradient &&
                            output.port_type != WR_PORT_derivative;
        if (!number) continue;
        module.outputs.push_back(output);
        const Id tangent = direction.tangent_or_zero(output.value);
        module.outputs.push_back({output.name + " derived", output.port_type, tangent});
    }
    return module;
}

TEST(EveryNode, HasTheDerivativeThatDifferencesSay) {
    const PointSet points = random_points(200, 23);
    Tally all;
    size_t nodes = 0;
    for (const NodeType& type : all_nodes().list()) {
        bool tested = false;
        for (const Inputs inputs : {Inputs::defaults, Inputs::wires, Inputs::mixed}) {
            const Subject subject = compile_around(type, inputs, 31);
            ASSERT_TRUE(subject.compiled.ok);
            // The derivative of a texture is a filtered one, by definition not that of its texels.
            if (!subject.compiled.module.resources.empty()) continue;
            SCOPED_TRACE(subject.text);
            const Module module = with_derivatives(subject.compiled.module);
            if (module.outputs.empty()) continue;
            const Tally tally = compare_derivatives(module, points);
            all.compared += tally.compared;
            all.left_out += tally.left_out;
            tested = true;
        }
        nodes += tested ? 1 : 0;
    }
    EXPECT_GE(nodes, 40U);
    EXPECT_GE(all.compared, 20000U);
    EXPECT_LE(static_cast<double>(all.left_out), 0.02 * static_cast<double>(all.compared));
}

// Written into the text or in a uniform, a number means the same; frames and errors do not depend
// on it.
TEST(EveryNode, MeansTheSameBakedAndUniform) {
    const PointSet points = random_points(60, 37);
    for (const NodeType& type : all_nodes().list())
        for (const Inputs inputs : {Inputs::defaults, Inputs::zeros, Inputs::mixed}) {
            const Subject subject = compile_around(type, inputs, 43);
            SCOPED_TRACE(subject.text);
            MaterialOptions options;
            options.given_differentials = true;
            Diagnostics diagnostics;
            const Compiled baked =
                compile_material(subject.project, all_nodes(), options, diagnostics);
            ASSERT_TRUE(baked.ok) << to_text(diagnostics);
            const Values a = on_cpu<double>(baked.module, points, test_image);
            const Values b = on_cpu<double>(subject.compiled.module, points, test_image);
            ASSERT_EQ(a.size(), b.size());
            for (size_t output = 0; output < a.size(); ++output)
                for (size_t k = 0; k < a[output].size(); ++k)
                    EXPECT_NEAR(a[output][k], b[output][k], 1e-9 * (1 + std::fabs(b[output][k])))
                        << baked.module.outputs[output].name << ", number " << k;
        }
}

// In single precision, from as close up as anyone looks: eq. 3 divides by (pixel size)^2.
TEST(HeightGradient, IsTheSameAtEveryPixelSize) {
    const Subject subject =
        compile_around(*all_nodes().find("gradient_from_height"), Inputs::wires, 41);
    ASSERT_TRUE(subject.compiled.ok);
    const PointSet points = random_points(100, 29);
    Values expected;
    for (const double size : {1.0, 1e-3, 1e-6}) {
        PointSet scaled = points;
        for (auto& input : scaled.values)
            for (const Variant variant : {Variant::dx, Variant::dy})
                for (double& each : input[static_cast<size_t>(variant)])
                    each = static_cast<double>(static_cast<float>(each * size));
        const Values values = on_cpu<float>(subject.compiled.module, scaled, test_image);
        if (expected.empty()) expected = values;
        for (size_t k = 0; k < values[0].size(); ++k)
            EXPECT_NEAR(values[0][k], expected[0][k], 2e-5) << "pixel size " << size;
    }
}

}  // namespace
}  // namespace wrinkle::test
