// HLSL, shader model 5.0. The rows of a float3x3 are the columns of a mat3, and mul() takes its
// operands in reverse order; matrices of blocks are row_major, so their bytes are GLSL's too.
#include "emit/language.h"

namespace wrinkle {
namespace {

// HLSL's keywords and reserved words, its intrinsic functions and its types without digits.
constexpr std::string_view hlsl_words = R"(
AppendStructuredBuffer BlendState Buffer ByteAddressBuffer CompileShader ComputeShader
ConsumeStructuredBuffer DepthStencilState DepthStencilView DomainShader GeometryShader Hullshader
InputPatch LineStream NULL OutputPatch PixelShader PointStream RWBuffer RWByteAddressBuffer
RWStructuredBuffer RWTexture1D RWTexture2D RWTexture3D RasterizerState RenderTargetView
SamplerComparisonState SamplerState StructuredBuffer Texture1D Texture1DArray Texture2D
Texture2DArray Texture2DMS Texture2DMSArray Texture3D TextureCube TextureCubeArray TriangleStream
VertexShader abort asdouble asfloat asint asm asm_fragment asuint atan2 auto catch cbuffer char
clip column_major compile compile_fragment const_cast countbits ddx ddx_coarse ddx_fine ddy
ddy_coarse ddy_fine delete dst dword dynamic_cast errorf explicit export f16tof32 f32tof16
firstbithigh firstbitlow fmod frac frexp friend fxgroup groupshared isfinite ldexp lerp line
lineadj linear lit log10 mad matrix min10float min12int min16float min16int min16uint msad4 mul
mutable new nointerpolation noise operator packoffset pass pixelfragment point printf private
protected rcp register reinterpret_cast reversebits row_major rsqrt saturate signed sincos snorm
stateblock stateblock_state static_cast string tbuffer technique technique10 technique11 tex1D
tex2D tex2Dbias tex2Dgrad tex2Dlod tex2Dproj tex3D texCUBE throw triangle triangleadj try typename
unorm vector vertexfragment virtual front)";

bool every_scalar(Op, size_t, bool) {
    return true;
}

constexpr std::string_view size_helper = R"(float2 $f_image_size(Texture2D<float4> image) {
    uint width, height;
    image.GetDimensions(width, height);
    return float2(width, height);
})";

void set_hlsl_ops(Language& language) {
    language.spell(Op::fract_, "frac");
    language.spell(Op::mix_, "lerp");
    language.spell(Op::inversesqrt_, "rsqrt");
    language.spell(Op::atan2_, "atan2");
    language.spell(Op::transform_, "mul($1, $0)");
    language.spell(Op::matrix_product_, "mul($1, $0)");
    language.spell(Op::sample_, "$n.Sample($n_sampler, $0)");
    language.spell(Op::sample_lod_, "$n.SampleLevel($n_sampler, $0, $1)");
    language.spell(Op::sample_grad_, "$n.SampleGrad($n_sampler, $0, $1, $2)");
    language.spell(Op::image_size_, "$f_image_size($n)");
}

Language hlsl_language() {
    Language language = glsl_language();
    reserve_words(language, hlsl_words);
    for (const char* base : {"float", "int", "uint", "bool", "half", "double"})
        for (int rows = 1; rows <= 4; ++rows) {
            const std::string vector = base + std::to_string(rows);
            reserve_words(language, vector);
            for (int columns = 1; columns <= 4; ++columns)
                reserve_words(language, vector + "x" + std::to_string(columns));
        }
    language.types = {"", "float", "float2", "float3", "float4", "float3x3", "int", "uint", "bool"};
    language.matrix4 = "row_major float4x4";
    set_hlsl_ops(language);
    language.takes_scalar = every_scalar;
    language.splat = "($t)$0";
    language.splat_is_cast = true;
    language.has_mod = false;
    language.not_a_number = "asfloat(0x7fc00000u)";
    language.infinity = "asfloat(0x7f800000u)";
    language.minus_infinity = "asfloat(0xff800000u)";
    language.global_constant = "static const $t $n = $v;";
    language.image =
        "Texture2D<float4> $n : register(t$b);\nSamplerState $n_sampler : register(s$b);";
    language.block = "cbuffer $n : register(b$b) {";
    language.block_member = "$t $n : packoffset($o);";
    language.end_block = "};";
    language.image_size_helper = size_helper;
    StagePatterns& stage = language.stage;
    stage.structs = true;
    stage.attribute = "$t $n : $s;";
    stage.varying_out = stage.varying_in = "$t $n : TEXCOORD$l;";
    stage.clip_position = "float4 clip : SV_Position;";
    stage.target = "$t $n : SV_Target$l;";
    stage.vertex = "WrinkleVaryings_$n main(WrinkleVertex_$n v) {";
    stage.fragment = "WrinkleTargets_$n main(WrinkleVaryings_$n v, bool front : SV_IsFrontFace) {";
    stage.transform = "o.clip = mul(float4($1, 1.0), $0);";
    stage.front_facing = "front";
    return language;
}

}  // namespace

const Language& hlsl() {
    static const Language language = hlsl_language();
    return language;
}

}  // namespace wrinkle
