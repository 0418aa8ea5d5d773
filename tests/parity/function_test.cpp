// Tests that a project with functions gives the same numbers as the project with every use inlined:
// both are evaluated in double; the remaining difference is the order of additions.
#include <gtest/gtest.h>

#include <cmath>

#include "certify/points.h"
#include "emit/emit.h"
#include "emit/golden.h"
#include "ir/inspect.h"
#include "parity/compare.h"
#include "parity/context.h"
#include "parity/nested.h"
#include "parity/node_graph.h"

namespace wrinkle::test {
namespace {

constexpr size_t points_of_a_project = 200;

const PointSet& points() {
    static const PointSet set = certify::random_points(points_of_a_project, 5, {0, 1});
    return set;
}

struct Apart {
    double most = 0;
    std::string where;
};

// The largest difference, relative to 1 or the value.
Apart apart(const Module& a, const Module& b) {
    const Values one = on_cpu<double>(a, points(), test_image);
    const Values other = on_cpu<double>(b, points(), test_image);
    Apart result;
    EXPECT_EQ(one.size(), other.size());
    for (size_t i = 0; i < one.size() && i < other.size(); ++i)
        for (size_t k = 0; k < one[i].size(); ++k) {
            const double x = one[i][k], y = other[i][k];
            if (x == y || (std::isnan(x) && std::isnan(y))) continue;
            const double relative = std::abs(x - y) / std::max(1.0, std::abs(x));
            if (relative <= result.most) continue;
            result.most = relative;
            result.where = a.outputs[i].name + " at number " + std::to_string(k) + ": " +
                           std::to_string(x) + " and " + std::to_string(y);
        }
    return result;
}

// Compares in all modes. Returns the number of functions, summed over the modes.
uint32_t expect_same(const Nested& nested, double allowed) {
    uint32_t functions = 0;
    for (const bool uniform : {false, true})
        for (const bool tangents : {true, false}) {
            SCOPED_TRACE(std::string(uniform ? "uniform" : "baked") +
                         (tangents ? "" : ", no tangents"));
            const Compiled with = nested.compile({true, uniform, true, tangents});
            const Compiled without = nested.compile({false, uniform, true, tangents});
            if (!with.ok || !without.ok) return functions;
            EXPECT_EQ(verify(with.module), "");
            EXPECT_TRUE(with.module.open_inputs.empty());
            EXPECT_EQ(function_count(without.module), 0U);
            functions += function_count(with.module);
            const Apart found = apart(without.module, with.module);
            EXPECT_LE(found.most, allowed) << found.where;
        }
    return functions;
}

// Two uses `p` and `q` of "part" with inputs P and Q, among other nodes.
struct Pair {
    std::string inputs, part, part_outputs;
    std::string p, q, nodes, outputs;

    Texts texts() const {
        const auto use = [](const std::string& inputs_of_use) {
            return "{'type': 'graph:part.json', 'in': {" + inputs_of_use + "}}";
        };
        return {{"part", graph_text(inputs, part, part_outputs)},
                {"main", graph_text("", "'p': " + use(p) + ", 'q': " + use(q) + nodes, outputs)}};
    }
};

// A difference of 0 means the same order of operations.
void expect_same(const Pair& pair, double allowed = 1e-13) {
    EXPECT_GE(expect_same(Nested(pair.texts()), allowed), 4U);
}

TEST(Functions, OfNumbersGiveTheSameBits) {
    expect_same({.inputs = "'x': {'type': 'float', 'default': 2}",
                 .part = "'s': {'type': 'sine', 'in': {'angle': <input.x}}, 'm': {'type': "
                         "'multiply', 'in': {'a': <s.result, 'b': 0.3}}",
                 .part_outputs = "'y': <m.result",
                 .p = "'x': <uv.x",
                 .q = "",
                 .nodes = ", 'uv': {'type': 'separate_vec2', 'in': {'vector': <surface.uv0}}",
                 .outputs = "'a': <p.y, 'b': <q.y"},
                0);
}

TEST(Functions, TakeHeightsAndMakeBumpsOfThem) {
    expect_same({.inputs = "'h': {'type': 'height'}",
                 .part = "'b': {'type': 'gradient_from_height', 'in': {'height': <input.h}}",
                 .part_outputs = "'g': <b.gradient",
                 .p = "'h': <w.height",
                 .q = "'h': <f.height",
                 .nodes = ", 'w': {'type': 'waves'}, 'f': {'type': 'fbm'}",
                 .outputs = "'normal': <p.g, 'other': <q.g"});
}

TEST(Functions, GiveHeightsThatAreDifferentiatedOutside) {
    expect_same({.inputs = "'uv': {'type': 'vec2'}, 'image': {'type': 'image'}",
                 .part = "'h': {'type': 'height_map', 'in': {'image': <input.image, 'uv': "
                         "<input.uv}}, 'w': {'type': 'waves', 'in': {'uv': <input.uv}}, "
                         "'s': {'type': 'height_add', 'in': {'a': <h.height, 'b': <w.height}}",
                 .part_outputs = "'h': <s.height",
                 .p = "'uv': <t.uv, 'image': 'IMAGE_A'",
                 .q = "'uv': <surface.uv1, 'image': 'IMAGE_B'",
                 .nodes = ", 't': {'type': 'uv_transform', 'in': {'scale': [3, 2]}}",
                 .outputs = "'normal': <p.h, 'other': <q.h, 'third': <p.h"});
}

TEST(Functions, TakeAndGiveBumps) {
    expect_same({.inputs = "'g': {'type': 'gradient'}, 'amount': {'type': 'float', 'default': 3}",
                 .part = "'s': {'type': 'gradient_scale', 'in': {'gradient': <input.g, 'amount': "
                         "<input.amount}}, 'w': {'type': 'waves'}, 'a': {'type': 'gradient_add', "
                         "'in': {'a': <s.gradient, 'b': <w.height}}",
                 .part_outputs = "'g': <a.gradient",
                 .p = "'g': <m.gradient",
                 .q = "'g': <p.g, 'amount': -0.5",
                 .nodes = ", 'm': {'type': 'tangent_normal_map', 'in': {'image': 'IMAGE_A'}}",
                 .outputs = "'normal': <p.g, 'other': <q.g"});
}

TEST(Functions, TakeAndGiveNormals) {
    expect_same({.inputs = "'n': {'type': 'normal'}",
                 .part = "'b': {'type': 'gradient_from_normal', 'in': {'normal': <input.n}}, 'w': "
                         "{'type': 'waves'}, 'a': {'type': 'gradient_add', 'in': {'a': "
                         "<b.gradient, 'b': <w.height}}, 'r': {'type': 'resolve', 'in': "
                         "{'gradient': <a.gradient}}",
                 .part_outputs = "'normal': <r.normal",
                 .p = "'n': <r.normal",
                 .q = "'n': <p.normal",
                 .nodes = ", 'r': {'type': 'resolve', 'in': {'gradient': <f.height}}, 'f': "
                          "{'type': 'fbm'}",
                 .outputs = "'normal': <p.normal, 'other': <q.normal"});
}

// The variance inside a function is not available outside.
TEST(Functions, AreNoneWhereAVarianceIsAskedFor) {
    const Pair pair{.inputs = "'uv': {'type': 'vec2'}",
                    .part =
                        "'m': {'type': 'tangent_normal_map', 'in': {'image': 'IMAGE_A', "
                        "'uv': <input.uv}}",
                    .part_outputs = "'g': <m.gradient",
                    .p = "",
                    .q = "'uv': <surface.uv1",
                    .nodes =
                        ", 'a': {'type': 'gradient_add', 'in': {'a': <p.g, 'b': <q.g}}, 'r': "
                        "{'type': 'bump_roughness', 'in': {'gradient': <a.gradient}}",
                    .outputs = "'normal': <a.gradient, 'roughness': <r.roughness"};
    const Nested nested(pair.texts());
    const Compiled with = nested.compile({}), without = nested.compile({.functions = false});
    EXPECT_EQ(function_count(with.module), 0U);
    EXPECT_EQ(emit(with.module, {}).source, emit(without.module, {}).source);
}

// Frames: uv0 has vertex tangents, uv1 has none, a uv of both is exact or has a derived frame.
TEST(Functions, AreToldWhichUvSetTheyGet) {
    expect_same({.inputs = "'uv': {'type': 'vec2'}, 'image': {'type': 'image'}",
                 .part = "'m': {'type': 'tangent_normal_map', 'in': {'image': <input.image, 'uv': "
                         "<input.uv}}",
                 .part_outputs = "'g': <m.gradient",
                 .p = "'uv': <t.uv, 'image': 'IMAGE_A'",
                 .q = "'uv': <u.uv, 'image': 'IMAGE_A'",
                 .nodes = ", 't': {'type': 'uv_transform', 'in': {'scale': [3, 2], 'rotation': "
                          "20}}, 'u': {'type': 'uv_transform', 'in': {'uv': <surface.uv1, "
                          "'scale': [3, 2]}}, 'v': {'type': 'vec2_add', 'in': {'a': <t.uv, 'b': "
                          "<u.uv}}, 'r': {'type': 'graph:part.json', 'in': {'uv': <v.vector, "
                          "'image': 'IMAGE_B'}}",
                 .outputs = "'normal': <p.g, 'other': <q.g, 'third': <r.g"});
}

TEST(Functions, HaveThePicturesOfTheirOwnInputs) {
    expect_same({.inputs = "'uv': {'type': 'vec2'}, 'image': {'type': 'image', 'default': "
                           "'IMAGE_B'}",
                 .part = "'m': {'type': 'tangent_normal_map', 'in': {'image': <input.image, 'uv': "
                         "<input.uv}}",
                 .part_outputs = "'g': <m.gradient",
                 .p = "'uv': <t.uv, 'image': 'IMAGE_A'",
                 .q = "'uv': <t.uv",
                 .nodes = ", 't': {'type': 'uv_transform', 'in': {'scale': [3, 2]}}",
                 .outputs = "'normal': <p.g, 'other': <q.g"});
}

TEST(Functions, OfRandomProjectsChangeNoNumber) {
    uint32_t functions = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        functions += expect_same(Nested(random_texts(seed)), 1e-12);
    }
    EXPECT_GE(functions, 400U);
}

// Functions know the footprint only to first order.
TEST(Functions, KnowTheFootprintOfABentUvToFirstOrder) {
    const Pair bent{.inputs = "'uv': {'type': 'vec2'}",
                    .part =
                        "'m': {'type': 'height_map', 'in': {'image': 'IMAGE_A', 'uv': "
                        "<input.uv}}",
                    .part_outputs = "'g': <m.gradient",
                    .p = "'uv': <c.vector",
                    .q = "'uv': <surface.uv1",
                    .nodes =
                        ", 's': {'type': 'separate_vec2', 'in': {'vector': <surface.uv0}}, "
                        "'a': {'type': 'sine', 'in': {'angle': <s.x}}, 'c': {'type': "
                        "'combine_vec2', 'in': {'x': <a.result, 'y': <s.y}}",
                    .outputs = "'normal': <p.g, 'other': <q.g"};
    expect_same(bent, 0.02);
}

// Source that takes pixel differences: an argument that is discontinuous, a result that is
// discontinuous.
TEST(Functions, SeeJumpsAcrossTheirBorder) {
    const std::string jumpy =
        "'s': {'type': 'separate_vec2', 'in': {'vector': <input.uv}}, 'f': "
        "{'type': 'floor', 'in': {'x': <s.x}}, 'c': {'type': "
        "'combine_vec2', 'in': {'x': <f.result, 'y': <s.y}}";
    const Pair pair{.inputs = "'uv': {'type': 'vec2'}",
                    .part = jumpy,
                    .part_outputs = "'jumps': <c.vector, 'still': <input.uv",
                    .p = "'uv': <t.uv",
                    .q = "'uv': <u.uv",
                    .nodes =
                        ", 't': {'type': 'uv_transform', 'in': {'scale': [3, 2]}}, 'u': "
                        "{'type': 'uv_transform', 'in': {'scale': [2, 2]}}, 'm': {'type': "
                        "'tangent_normal_map', 'in': {'image': 'IMAGE_A', 'uv': <p.jumps}}, "
                        "'k': {'type': 'tangent_normal_map', 'in': {'image': 'IMAGE_A', "
                        "'uv': <q.still}}",
                    .outputs = "'normal': <m.gradient, 'other': <k.gradient"};
    const auto samples = [](const Module& m) {
        std::pair<int, int> count{0, 0};
        for (Id id = 1; id < m.size(); ++id) {
            count.first += m[id].op == Op::sample_;
            count.second += m[id].op == Op::sample_grad_;
        }
        return count;
    };
    const Nested nested(pair.texts());
    const Compiled with = nested.compile({true, false, false, true});
    EXPECT_EQ(samples(with.module), samples(nested.compile({false, false, false, true}).module));
    EXPECT_EQ(samples(with.module), (std::pair{1, 1}));
}

TEST(Functions, WithEqualArgumentsAreOneCall) {
    const Pair pair{.inputs = "'x': {'type': 'float'}",
                    .part = "'s': {'type': 'sine', 'in': {'angle': <input.x}}",
                    .part_outputs = "'y': <s.result",
                    .p = "'x': <uv.x",
                    .q = "'x': <uv.x",
                    .nodes =
                        ", 'uv': {'type': 'separate_vec2', 'in': {'vector': <surface.uv0}}, "
                        "'d': {'type': 'subtract', 'in': {'a': <p.y, 'b': <q.y}}",
                    .outputs = "'a': <p.y, 'b': <q.y"};
    const Module module = Nested(pair.texts()).compile({}).module;
    EXPECT_EQ(module.outputs[0].value, module.outputs[1].value);
}

TEST(Functions, OfThirtyLevelsAreAGoldenText) {
    const Nested nested(tower_texts(30));
    EmitOptions options;
    options.name = "tower";
    const Module module = nested.compile({true, false, false, true}).module;
    EXPECT_EQ(function_count(module), 30U);  // and their derivatives
    for (const Form form : {Form::function, Form::shader}) {
        options.form = form;
        EXPECT_EQ(compile_errors(emit(module, options)), "");
    }
    options.form = Form::function;
    EXPECT_TRUE(equals_golden(emit(module, options).source, "thirty_levels.glsl"));
}

TEST(Functions, OfFiveLevelsChangeNoNumber) {
    EXPECT_GE(expect_same(Nested(tower_texts(5)), 1e-12), 20U);
}

class FunctionParity : public WithGpu {};

TEST_F(FunctionParity, OfRandomProjects) {
    size_t values = 0;
    for (unsigned seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        const Nested nested(random_texts(seed));
        const Module module = nested.compile({}).module;
        const Reference reference = make_reference(module, points(), test_image);
        const Comparison result =
            reference.compare(reference.precise, on_gpu(module, points(), test_image));
        EXPECT_EQ(result.different, 0U)
            << (result.first ? result.first->a + " and " + result.first->b : "");
        values += result.values - result.unstable;
        for (const Form form : {Form::function, Form::shader}) {
            EmitOptions options;
            options.form = form;
            EXPECT_EQ(
                compile_errors(emit(nested.compile({true, true, false, true}).module, options)),
                "");
        }
    }
    EXPECT_GE(values, 12 * points_of_a_project);
}

}  // namespace
}  // namespace wrinkle::test
