// WGSL. It has no infinities and no NaN: the largest finite number is written for an infinity,
// 0 for NaN.
#include "emit/language.h"

namespace wrinkle {
namespace {

// WGSL's keywords, reserved words, built-in functions and predeclared types.
constexpr std::string_view wgsl_words = R"(
NULL Self abstract alias array arrayLength as async atan2 atomic auto await become bitcast catch
co_await co_return co_yield coherent column_major compile compile_fragment concept const_assert
const_cast consteval constexpr constinit continuing countOneBits crate debugger decltype delete
demote demote_to_helper diagnostic do dpdx dpdxCoarse dpdxFine dpdy dpdyCoarse dpdyFine
dynamic_cast elseif enable explicit export extractBits f16 f32 fallthrough final finally
firstLeadingBit firstTrailingBit fn friend from frexp fwidthCoarse fwidthFine get groupshared i32
impl implements import insertBits instanceof interface inverseSqrt ldexp let loop macro
macro_rules mat2x2f mat2x3f mat2x4f mat3x2f mat3x3f mat3x4f mat4x2f mat4x3f mat4x4f match mod
module move mut mutable nil noexcept nointerpolation null nullptr of operator override package
packoffset pass pixelfragment priv private protected ptr pub quantizeToF16 ref regardless register
reinterpret_cast require requires resource reverseBits saturate self select set shared signed
snorm static_assert static_cast std storageBarrier super target textureDimensions textureLoad
textureNumLayers textureSample textureSampleBias textureSampleCompare textureSampleGrad
textureSampleLevel textureStore texture_1d texture_2d texture_2d_array texture_3d texture_cube
thread_local throw trait try type typeid typename typeof u32 unless unorm unsafe unsized use var
vec2 vec2f vec2h vec2i vec2u vec3f vec3h vec3i vec3u vec4f vec4h vec4i vec4u vertex fragment
virtual wgsl where with workgroupBarrier writeonly yield front pack4x8snorm unpack4x8snorm)";

bool only_of_mix(Op op, size_t operand, bool) {
    return op == Op::mix_ && operand == 2;
}

void set_wgsl_ops(Language& language) {
    language.spell(Op::inversesqrt_, "inverseSqrt");
    language.spell(Op::atan2_, "atan2");
    language.spell(Op::to_float_, "f32");
    language.spell(Op::to_int_, "i32");
    language.spell(Op::to_uint_, "u32");
    language.spell(Op::sample_, "textureSample($n, $n_sampler, $0)");
    language.spell(Op::sample_lod_, "textureSampleLevel($n, $n_sampler, $0, $1)");
    language.spell(Op::sample_grad_, "textureSampleGrad($n, $n_sampler, $0, $1, $2)");
    language.spell(Op::image_size_, "vec2f(textureDimensions($n))");
}

void set_wgsl_declarations(Language& language) {
    language.global_constant = "const $n: $t = $v;";
    language.constant = "let $n = $v;";
    language.variable = "var $n = $v;";
    language.unset = "var $n: $t;";
    language.parameter = "$n: $t";
    language.out_parameter = "$n: ptr<function, $t>";
    language.out_argument = "&$n";
    language.out_use = "*$n";
    language.function = "fn $n($v) -> $t {";
    language.no_value = "fn $n($v) {";
    language.member = "$n: $t,";
    language.end_structure = "}";
    language.loop = "for (var $n = 0; $n < $v; $n++) {";
    language.leave = "if ($v) { break; }";
    language.image =
        "@group($s) @binding($b) var $n: texture_2d<f32>;\n"
        "@group($s) @binding($l) var $n_sampler: sampler;";
    language.block = "struct $n {";
    language.block_member = "$n: $t,";
    language.end_block = "}\n@group($s) @binding($b) var<uniform> $v: $n;";
    language.block_use = "$v.$n";
}

void set_wgsl_stages(StagePatterns& stage) {
    stage.structs = true;
    stage.attribute = stage.varying_out = stage.varying_in = stage.target = "@location($l) $n: $t,";
    stage.clip_position = "@builtin(position) clip: vec4f,";
    stage.vertex_entry = "$n_vertex";
    stage.fragment_entry = "$n_fragment";
    stage.vertex = "@vertex fn $n_vertex(v: WrinkleVertex_$n) -> WrinkleVaryings_$n {";
    stage.fragment =
        "@fragment fn $n_fragment(v: WrinkleVaryings_$n, @builtin(front_facing) front: bool) -> "
        "WrinkleTargets_$n {";
    stage.transform = "o.clip = $0 * vec4f($1, 1.0);";
    stage.front_facing = "front";
}

Language wgsl_language() {
    Language language = glsl_language();
    reserve_words(language, wgsl_words);
    language.types = {"", "f32", "vec2f", "vec3f", "vec4f", "mat3x3f", "i32", "u32", "bool"};
    language.matrix4 = "mat4x4f";
    set_wgsl_ops(language);
    language.takes_scalar = only_of_mix;
    language.select = "select($2, $1, $0)";
    language.select_is_call = true;
    language.has_mod = false;
    language.not_a_number = "0.0";
    language.infinity = "3.4028235e38";
    language.minus_infinity = "(-3.4028235e38)";
    set_wgsl_declarations(language);
    set_wgsl_stages(language.stage);
    return language;
}

}  // namespace

const Language& wgsl() {
    static const Language language = wgsl_language();
    return language;
}

}  // namespace wrinkle
