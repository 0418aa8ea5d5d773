#include "property/in_float.h"

#include <gtest/gtest.h>

namespace wrinkle::test {

InFloat::InFloat(const Expanded& material) {
    std::string why;
    program_ = compile_program(material.module(), why);
    EXPECT_EQ(why, "");
    needs_ = needed_inputs(program_);
}

dvec3 InFloat::vector(size_t output, const Surroundings& around) const {
    PointSet points;
    points.count = 1;
    for (const InputNeed& need : needs_) {
        const auto found = around.inputs.find(input_extra(need.input, need.variant));
        const Lanes lanes = found == around.inputs.end() ? Lanes{} : found->second;
        const size_t count = info(info(need.input).type).lanes;
        points.at(need.input, need.variant)
            .assign(lanes.begin(), lanes.begin() + static_cast<ptrdiff_t>(count));
    }
    Results results = make_results(program_, 1);
    evaluate<float>(program_, points, {}, 0, 1, results);
    const auto& v = results.values.at(output);
    return {v[0], v[1], v[2]};
}

}  // namespace wrinkle::test
