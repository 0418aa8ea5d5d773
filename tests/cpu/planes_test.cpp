// Tests that planar evaluation equals evaluate<float>() bit by bit, for every split and instruction
// set.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "cpu/float_columns.h"
#include "cpu/support.h"
#include "ir/value.h"

namespace wrinkle::test {
namespace {

constexpr size_t many = 1000;

MipChain gradient_picture() {
    Image image = make_image(16, 8, 3);
    for (size_t k = 0; k < image.data.size(); ++k)
        image.data[k] = static_cast<float>(k * 37 % 256) / 255;
    return build_mips(std::move(image));
}

// Outputs of every kind: floats with several components, an integer, a bool; a texture, a loop.
void write_outputs(Scene& s) {
    Module& m = s.m;
    const Value x{&m, s.numbers([](size_t k) { return std::sin(0.1 * static_cast<double>(k)); })};
    const Value y{&m, s.numbers([](size_t k) { return 0.013 * static_cast<double>(k); })};
    const uint32_t picture = m.add_resource({"picture", "", {}, {}});
    const Id uv = m.construct(Type::vec2_, {y.id, x.id});
    s.output(m.add(Op::sample_lod_, {uv, m.add(Op::abs_, {x.id})}, picture));
    const Type types[] = {Type::float_, Type::float_};
    const std::vector<Id> p = m.begin_region(RegionKind::loop, "", types);
    const Id results[] = {m.add(Op::lt_, {p[0], x.id}), m.add(Op::add_, {p[0], m.number(0.125)}),
                          m.add(Op::sin_, {m.add(Op::add_, {p[1], p[0]})})};
    const RegionUse use = m.end_region(results, 30);
    const Id start[] = {m.number(-1), y.id};
    s.output(m.apply(use, start)[1]);
    s.output(m.add(Op::to_int_, {(x * 1000.0).id}));
    s.output(m.add(Op::gt_, {x.id, y.id}));
}

void expect_as_evaluated(const Program& program, const Results& wanted, const Columns& columns) {
    size_t plane = 0;
    for (size_t i = 0; i < program.outputs.size(); ++i) {
        const size_t lanes = program.outputs[i].regs.size();
        for (size_t lane = 0; lane < lanes; ++lane, ++plane)
            for (size_t k = 0; k < many; ++k)
                ASSERT_EQ(
                    std::bit_cast<uint32_t>(columns.outputs[plane][k]),
                    std::bit_cast<uint32_t>(static_cast<float>(wanted.values[i][k * lanes + lane])))
                    << "output " << i << " lane " << lane << " at " << k;
    }
    EXPECT_EQ(plane, columns.outputs.size());
}

TEST(Planes, HoldWhatEvaluateGives) {
    Scene s(many);
    write_outputs(s);
    std::string why;
    const Program program = compile_program(s.m, why);
    const std::vector<Texture> textures = {Texture(gradient_picture(), {})};
    Results wanted = make_results(program, many);
    evaluate<float>(program, s.points, textures, 0, many, wanted, InstructionSet::baseline);
    PlaneScratch scratch;
    for (const InstructionSet set : every_set())
        for (const size_t piece : {size_t{1}, size_t{37}, size_t{512}, many}) {
            Columns columns(program, s.points);
            for (size_t first = 0; first < many; first += piece)
                evaluate_planes(program, textures, columns.from(first),
                                std::min(piece, many - first), scratch, set);
            expect_as_evaluated(program, wanted, columns);
        }
}

// One PlaneScratch is used for a small program, a larger one, and the small one again.
TEST(Planes, OneScratchServesAnyProgram) {
    Scene small(many), large(many);
    small.output(small.numbers([](size_t k) { return static_cast<double>(k); }));
    write_outputs(large);
    const std::vector<Texture> textures = {Texture(gradient_picture(), {})};
    PlaneScratch scratch;
    for (const Scene* scene : {&small, &large, &small}) {
        std::string why;
        const Program program = compile_program(scene->m, why);
        Results wanted = make_results(program, many);
        evaluate<float>(program, scene->points, textures, 0, many, wanted);
        Columns columns(program, scene->points);
        evaluate_planes(program, textures, columns.from(0), many, scratch);
        expect_as_evaluated(program, wanted, columns);
    }
}

// A texture with one level, then one with several.
TEST(Planes, OneScratchServesAnyTextures) {
    Scene s(many);
    write_outputs(s);
    std::string why;
    const Program program = compile_program(s.m, why);
    MipChain flat = gradient_picture();
    flat.levels.resize(1);
    const std::vector<Texture> one = {Texture(flat, {})}, all = {Texture(gradient_picture(), {})};
    PlaneScratch scratch;
    for (const std::vector<Texture>* textures : {&one, &all, &one}) {
        Results wanted = make_results(program, many);
        evaluate<float>(program, s.points, *textures, 0, many, wanted, InstructionSet::baseline);
        Columns columns(program, s.points);
        evaluate_planes(program, *textures, columns.from(0), many, scratch);
        expect_as_evaluated(program, wanted, columns);
    }
}

// An input as an output, one value as two outputs, and a constant.
TEST(Planes, OutputsMayBeAnything) {
    Scene s(many);
    const Id x = s.numbers([](size_t k) { return 0.5 * static_cast<double>(k); });
    const Id twice = s.m.add(Op::add_, {x, x});
    for (const Id id : {x, twice, twice, x, s.m.number(3)})
        s.output(id);
    std::string why;
    const Program program = compile_program(s.m, why);
    Columns columns(program, s.points);
    PlaneScratch scratch;
    evaluate_planes(program, {}, columns.from(0), many, scratch);
    for (size_t k = 0; k < many; ++k) {
        const float at = 0.5F * static_cast<float>(k);
        const float wanted[] = {at, 2 * at, 2 * at, at, 3};
        for (size_t i = 0; i < std::size(wanted); ++i)
            ASSERT_EQ(columns.outputs[i][k], wanted[i]) << "output " << i << " at " << k;
    }
}

}  // namespace
}  // namespace wrinkle::test
