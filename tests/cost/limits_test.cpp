// Tests of the resources named when a shader exceeds the guaranteed minimum of a target.
#include "cost/limits.h"
#include "ir/op.h"

#include <gtest/gtest.h>

namespace wrinkle::test {
namespace {

TEST(Limits, NamesImagesBeyondTheUnits) {
    Reflection reflection;
    for (int i = 0; i < 16; ++i)
        reflection.samplers.emplace_back().written = std::to_string(i) + ".png";
    EXPECT_EQ(texture_unit_excess(reflection).problem, "");
    SamplerInfo& last = reflection.samplers.emplace_back();
    last.written = "last.png";
    last.readers = {{"weave", "image"}};
    const std::string problem = texture_unit_excess(reflection).problem;
    EXPECT_NE(problem.find("17 images"), std::string::npos);
    EXPECT_NE(problem.find("15.png, last.png (weave)"), std::string::npos) << problem;
}

// Writes `count` fragment outputs o0, o1, ...
std::string excess_of(const char* target, int count) {
    Reflection reflection;
    reflection.target = target;
    for (int i = 0; i < count; ++i) {
        OutputInfo& output = reflection.outputs.emplace_back();
        output.output = "o" + std::to_string(i);
        output.type = Type::vec3_;
        output.location = i;
    }
    return draw_buffer_excess(reflection).problem;
}

// Minimum limits of the specifications: OpenGL 3.3 table 6.56, ES 3.0 table 6.35, Vulkan 1.0 table
// 36.
TEST(Limits, NamesOutputsBeyondTheDrawBuffers) {
    for (const auto& [target, most] : {std::pair{"glsl330", 8},
                                       {"glsl450", 4},
                                       {"essl300", 4},
                                       {"spirv", 4},
                                       {"hlsl", 8},
                                       {"msl", 8},
                                       {"wgsl", 8}}) {
        EXPECT_EQ(excess_of(target, most), "") << target;
        EXPECT_NE(excess_of(target, most + 1), "") << target;
    }
    EXPECT_EQ(excess_of("essl300", 5),
              "it has 5 outputs, and a shader of GLSL ES 3.00 draws to 4 buffers for certain: "
              "o0, o1, o2, o3, o4");
}

TEST(Limits, FunctionsDrawNothing) {
    Reflection reflection;
    reflection.target = "essl300";
    reflection.outputs.resize(9);
    EXPECT_EQ(draw_buffer_excess(reflection).problem, "");
}

}  // namespace
}  // namespace wrinkle::test
