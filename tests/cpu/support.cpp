#include "cpu/support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wrinkle::test {
namespace {

// The n-th scalar of a surface point, variants included.
struct Place {
    SurfaceInput input;
    Variant variant;
    uint32_t lane;
};

Place place(uint32_t n) {
    for (const Variant variant : {Variant::value, Variant::dx, Variant::dy})
        for (int i = 0; i < surface_input_count; ++i) {
            const auto input = static_cast<SurfaceInput>(i);
            const uint32_t lanes = info(info(input).type).lanes;
            if (n < lanes) return {input, variant, n};
            n -= lanes;
        }
    ADD_FAILURE() << "more scalars than a surface point has";
    return {};
}

}  // namespace

std::vector<InstructionSet> every_set() {
    std::vector<InstructionSet> sets;
    for (const InstructionSet set :
         {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
        if (is_available(set)) sets.push_back(set);
    return sets;
}

Scene::Scene(size_t count) {
    points.count = count;
}

Id Scene::scalar(std::span<const double> values) {
    const Place p = place(used_++);
    const uint32_t lanes = info(info(p.input).type).lanes;
    std::vector<double>& column = points.at(p.input, p.variant);
    column.resize(points.count * lanes);
    for (size_t k = 0; k < values.size(); ++k)
        column[k * lanes + p.lane] = values[k];
    const Id input = m.input(p.input, p.variant);
    return lanes == 1 ? input : m.add(Op::swizzle_, {input}, WR_SWIZZLE(1, p.lane, 0, 0, 0));
}

Id Scene::operand(Type type, std::span<const Lanes> values) {
    std::vector<Id> parts;
    for (size_t lane = 0; lane < info(type).lanes; ++lane)
        parts.push_back(numbers([&](size_t k) {
            const double value = values[k][lane];
            // to_uint is done through int, which has the same bits.
            return type == Type::uint_ && value > 2147483647 ? value - 4294967296.0 : value;
        }));
    if (type == Type::mat3_) {
        std::vector<Id> columns;
        for (size_t c = 0; c < 9; c += 3)
            columns.push_back(m.construct(Type::vec3_, {parts[c], parts[c + 1], parts[c + 2]}));
        return m.add(Op::construct_, columns, 0, type);
    }
    if (parts.size() > 1) return m.add(Op::construct_, parts, 0, type);
    if (type == Type::bool_) return m.add(Op::gt_, {parts[0], m.number(0.5)});
    if (type == Type::float_) return parts[0];
    const Id integer = m.add(Op::to_int_, {parts[0]});
    return type == Type::int_ ? integer : m.add(Op::to_uint_, {integer});
}

void Scene::output(Id value) {
    m.outputs.push_back({"out" + std::to_string(m.outputs.size()), WR_PORT_float, value});
}

Surroundings Scene::at(size_t point) const {
    Surroundings around;
    for (uint32_t n = 0; n < used_; ++n) {
        const Place p = place(n);
        const uint32_t lanes = info(info(p.input).type).lanes;
        around.inputs[input_extra(p.input, p.variant)][p.lane] =
            points.at(p.input, p.variant)[point * lanes + p.lane];
    }
    return around;
}

void expect_as_interpreted(const Scene& scene, double tolerance) {
    const Results results = evaluate_all<double>(scene);
    ASSERT_EQ(results.values.size(), scene.m.outputs.size());
    for (size_t point = 0; point < scene.points.count; ++point) {
        const Surroundings around = scene.at(point);
        for (size_t i = 0; i < scene.m.outputs.size(); ++i) {
            const Id value = scene.m.outputs[i].value;
            const size_t count = info(scene.m.type(value)).lanes;
            const Lanes wanted = interpret(scene.m, value, around);
            for (size_t lane = 0; lane < count; ++lane)
                ASSERT_NEAR(results.values[i][point * count + lane], wanted[lane],
                            tolerance * (1 + std::fabs(wanted[lane])))
                    << "output " << i << " lane " << lane << " of point " << point;
        }
    }
}

}  // namespace wrinkle::test
