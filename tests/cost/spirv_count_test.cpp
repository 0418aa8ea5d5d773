// Tests of instruction counts in SPIR-V modules of a few instructions, counted by hand.
#include "cost/spirv_count.h"

#include <gtest/gtest.h>
#include <spirv-tools/libspirv.hpp>

namespace wrinkle::test {
namespace {

constexpr const char* head = R"(
OpCapability Shader
%std = OpExtInstImport "GLSL.std.450"
OpMemoryModel Logical GLSL450
OpEntryPoint Fragment %main "main"
OpExecutionMode %main OriginUpperLeft
%file = OpString "a.frag"
%void = OpTypeVoid
%bool = OpTypeBool
%float = OpTypeFloat 32
%int = OpTypeInt 32 1
%zero = OpConstant %int 0
%three = OpConstant %int 3
%eight = OpConstant %int 8
%vec2 = OpTypeVector %float 2
%vec3 = OpTypeVector %float 3
%vec4 = OpTypeVector %float 4
%mat3 = OpTypeMatrix %vec3 3
%proc = OpTypeFunction %void
%image = OpTypeImage %float 2D 0 0 0 1 Unknown
%sampled = OpTypeSampledImage %image
%place = OpTypePointer UniformConstant %sampled
%texture = OpVariable %place UniformConstant
%f = OpConstant %float 2
%v = OpConstantComposite %vec3 %f %f %f
%v2 = OpConstantComposite %vec2 %f %f
%m = OpConstantComposite %mat3 %v %v %v
%main = OpFunction %void None %proc
%first = OpLabel
)";

std::vector<uint32_t> words_of(const std::string& body) {
    const spvtools::SpirvTools tools(SPV_ENV_UNIVERSAL_1_3);
    std::vector<uint32_t> words;
    EXPECT_TRUE(tools.Assemble(head + body + "OpReturn\nOpFunctionEnd\n", &words)) << body;
    return words;
}

SpirvCount counted(const std::string& body) {
    std::string why;
    const auto count = count_spirv(words_of(body), why);
    EXPECT_TRUE(count) << why;
    return count.value_or(SpirvCount{});
}

struct Case {
    const char* instruction;
    ShaderCost cost;
};

TEST(SpirvCount, EveryInstructionCostsWhatTheRuleSays) {
    const Case cases[] = {
        {"%r = OpFAdd %float %f %f", {.alu = 1}},
        {"%r = OpFDiv %vec3 %v %v", {.alu = 3, .divisions = 3}},
        {"%r = OpVectorTimesScalar %vec3 %v %f", {.alu = 3}},
        {"%r = OpDot %float %v %v", {.alu = 5}},
        {"%r = OpMatrixTimesVector %vec3 %m %v", {.alu = 15}},
        {"%r = OpVectorTimesMatrix %vec3 %v %m", {.alu = 15}},
        {"%r = OpMatrixTimesMatrix %mat3 %m %m", {.alu = 45}},
        {"%r = OpFOrdLessThan %bool %f %f", {.alu = 1}},
        {"%r = OpExtInst %vec3 %std Cross %v %v", {.alu = 9}},
        {"%r = OpExtInst %vec3 %std Normalize %v", {.alu = 9, .transcendental = 1}},
        {"%r = OpExtInst %float %std Length %v", {.alu = 6, .transcendental = 1}},
        {"%r = OpExtInst %float %std Distance %v %v", {.alu = 9, .transcendental = 1}},
        {"%r = OpExtInst %vec3 %std Pow %v %v", {.alu = 9, .transcendental = 6}},
        {"%r = OpExtInst %vec3 %std FMix %v %v %v", {.alu = 9}},
        {"%r = OpExtInst %vec3 %std FClamp %v %v %v", {.alu = 6}},
        {"%r = OpExtInst %float %std SmoothStep %f %f %f", {.alu = 7}},
        {"%r = OpExtInst %vec3 %std FAbs %v", {.alu = 3}},
        {"%r = OpExtInst %vec3 %std Sin %v", {.alu = 3, .transcendental = 3}},
        {"%r = OpExtInst %float %std InverseSqrt %f", {.alu = 1, .transcendental = 1}},
        {"%r = OpDPdx %vec3 %v", {.derivatives = 1, .derivative_lanes = 3}},
        {"%t = OpLoad %sampled %texture\n%r = OpImageSampleImplicitLod %vec4 %t %v2", {.reads = 1}},
        {"%r = OpVectorShuffle %vec2 %v %v 0 1", {}},
        {"%r = OpCompositeExtract %float %v 1", {}},
    };
    for (const Case& each : cases) {
        const SpirvCount count = counted(std::string(each.instruction) + "\n");
        EXPECT_EQ(count.total, each.cost) << each.instruction << ": " << count.total.alu;
    }
}

TEST(SpirvCount, LinesGetWhatStandsBehindThem) {
    const SpirvCount count = counted(R"(
%a = OpFAdd %vec3 %v %v
OpLine %file 7 0
%b = OpFMul %vec3 %v %v
%c = OpFMul %float %f %f
OpLine %file 3 0
%d = OpDot %float %a %b
OpNoLine
%e = OpFSub %float %d %c
OpLine %file 7 0
OpBranch %second
%second = OpLabel
%g = OpFAdd %float %e %c
)");
    ASSERT_EQ(count.lines.size(), 8U);
    EXPECT_EQ(count.lines[0].alu, 3U + 1U + 1U);  // a line ends at the end of its block
    EXPECT_EQ(count.lines[7].alu, 4U);
    EXPECT_EQ(count.lines[3].alu, 5U);
    ShaderCost sum;
    for (const ShaderCost& line : count.lines)
        sum += line;
    EXPECT_EQ(sum, count.total);
}

// for (i < 8) { v + v; for (i < 3) { f * f; } }
TEST(SpirvCount, ALoopCountsItsIterations) {
    const SpirvCount count = counted(R"(
OpBranch %outer
%outer = OpLabel
OpLoopMerge %outer_end %outer_next None
OpBranch %outer_test
%outer_test = OpLabel
%c = OpSLessThan %bool %zero %eight
OpBranchConditional %c %inner %outer_end
%inner = OpLabel
%a = OpFAdd %vec3 %v %v
%d = OpSLessThan %bool %zero %three
OpLoopMerge %inner_end %inner_next None
OpBranchConditional %d %inner_next %inner_end
%inner_next = OpLabel
%b = OpFMul %float %f %f
OpBranch %inner
%inner_end = OpLabel
OpBranch %outer_next
%outer_next = OpLabel
OpBranch %outer
%outer_end = OpLabel
%e = OpFMul %float %f %f
)");
    EXPECT_EQ(count.once.alu, 1U + 3U + 1U + 1U + 1U);
    EXPECT_EQ(count.total.alu, 8U * (1U + 3U + 1U + 3U) + 1U);
    EXPECT_EQ(count.total.loops, 2U);
}

TEST(SpirvCount, RefusesACall) {
    std::string why;
    const auto words = words_of("%r = OpFunctionCall %void %main\n");
    EXPECT_FALSE(count_spirv(words, why));
    EXPECT_NE(why.find("call"), std::string::npos);
}

// Any input gives an error or a count, without reads out of bounds.
TEST(SpirvCount, TakesAnyWords) {
    std::vector<uint32_t> words = words_of("%r = OpDot %float %v %v\n");
    std::string why;
    for (size_t length = 0; length < words.size(); ++length)
        count_spirv(std::span(words.data(), length), why);
    for (size_t i = 0; i < words.size(); ++i)
        for (const uint32_t other : {0U, ~0U, words[i] ^ 0x10000U, words[i] + 7}) {
            std::vector<uint32_t> changed = words;
            changed[i] = other;
            count_spirv(changed, why);
        }
    EXPECT_FALSE(count_spirv({}, why));
    EXPECT_FALSE(why.empty());
}

}  // namespace
}  // namespace wrinkle::test
