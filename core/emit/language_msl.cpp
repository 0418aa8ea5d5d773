// The Metal shading language 2.0. It has no globals: functions take the images and the block of
// numbers as parameters.
#include "emit/language.h"

namespace wrinkle {
namespace {

constexpr std::string_view msl_words = R"(
access alignas alignof and and_eq array as_type asm atan2 atomic auto bitand bitor bool2 bool3
bool4 catch char char16_t char32_t clz compl const_cast constant constexpr copysign ctz decltype
delete depth2d depthcube device dfdx dfdy discard_fragment dynamic_cast explicit export float2
float2x2 float2x3 float2x4 float3 float3x2 float3x3 float3x4 float4 float4x2 float4x3 float4x4
fmax fmin fmod fragment frexp friend fwidth_fine half2 half2x2 half3 half3x3 half4 half4x4 inline
int2 int3 int4 isfinite isnormal kernel ldexp level log10 mad24 metal mul24 mutable new noexcept
not_eq nullptr operator or or_eq packed_float2 packed_float3 packed_float4 pow10 powr private
protected ptrdiff_t register reinterpret_cast rint rsqrt saturate select short2 short3 short4
signbit signed sincos size_t static_assert static_cast texture1d texture2d texture3d texturecube
thread threadgroup throw try typeid typename uchar uint2 uint3 uint4 ulong ushort vec vertex
virtual wchar_t xor xor_eq gradient2d bias sample access coord address filter stage_in user
position color attribute buffer front_facing front)";

bool no_scalar(Op, size_t, bool) {
    return false;
}

void set_msl_ops(Language& language) {
    language.spell(Op::inversesqrt_, "rsqrt");
    language.spell(Op::atan2_, "atan2");
    language.spell(Op::sample_, "$n.sample($n_sampler, $0)");
    language.spell(Op::sample_lod_, "$n.sample($n_sampler, $0, level($1))");
    language.spell(Op::sample_grad_, "$n.sample($n_sampler, $0, gradient2d($1, $2))");
    language.spell(Op::image_size_, "float2($n.get_width(), $n.get_height())");
}

void set_msl_resources(Language& language) {
    language.image = "";
    language.block = "struct $n {";
    language.block_member = "$t $n;";
    language.end_block = "};";
    language.block_use = "$v.$n";
    language.image_parameter = "texture2d<float> $n, sampler $n_sampler";
    language.image_argument = "$n, $n_sampler";
    language.block_parameter = "constant $t& $n";
    language.block_argument = "$n";
    language.image_stage_parameter =
        "texture2d<float> $n [[texture($b)]], sampler $n_sampler [[sampler($b)]]";
    language.block_stage_parameter = "constant $t& $n [[buffer($b)]]";
    language.vec3_size = 16;
}

void set_msl_stages(StagePatterns& stage) {
    stage.structs = true;
    stage.attribute = "$t $n [[attribute($l)]];";
    stage.varying_out = stage.varying_in = "$t $n [[user(locn$l)]];";
    stage.clip_position = "float4 clip [[position]];";
    stage.target = "$t $n [[color($l)]];";
    stage.vertex_entry = "$n_vertex";
    stage.fragment_entry = "$n_fragment";
    stage.vertex = "vertex WrinkleVaryings_$n $n_vertex(WrinkleVertex_$n v [[stage_in]]$v) {";
    stage.fragment =
        "fragment WrinkleTargets_$n $n_fragment(WrinkleVaryings_$n v [[stage_in]], "
        "bool front [[front_facing]]$v) {";
    stage.transform = "o.clip = $0 * float4($1, 1.0);";
    stage.front_facing = "front";
}

Language msl_language() {
    Language language = glsl_language();
    reserve_words(language, msl_words);
    language.types = {"", "float", "float2", "float3", "float4", "float3x3", "int", "uint", "bool"};
    language.matrix4 = "float4x4";
    set_msl_ops(language);
    language.takes_scalar = no_scalar;
    language.has_mod = false;
    language.not_a_number = "as_type<float>(0x7fc00000u)";
    language.infinity = "as_type<float>(0x7f800000u)";
    language.minus_infinity = "as_type<float>(0xff800000u)";
    language.global_constant = "constant $t $n = $v;";
    language.out_parameter = "thread $t& $n";
    language.function = "inline $t $n($v) {";
    language.no_value = "inline void $n($v) {";
    set_msl_resources(language);
    set_msl_stages(language.stage);
    return language;
}

}  // namespace

const Language& msl() {
    static const Language language = msl_language();
    return language;
}

}  // namespace wrinkle
