// GLSL: the language of the op table, and the defaults of struct Language.
#include "emit/language.h"

namespace wrinkle {
namespace {

// GLSL 3.30 and 4.60 (sections 3.6 and 8), GLSL ES 3.00, GL_KHR_vulkan_glsl; and `s` and `m`, the
// argument and the result of the generated function.
constexpr std::string_view glsl_words =
    "abs acos acosh active all any asin asinh asm atan atanh atomic_uint attribute bool "
    "break buffer bvec2 bvec3 bvec4 case cast ceil centroid clamp class coherent common "
    "const continue cos cosh cross default degrees determinant dFdx dFdxCoarse dFdxFine dFdy "
    "dFdyCoarse dFdyFine discard distance dmat2 dmat2x2 dmat2x3 dmat2x4 dmat3 dmat3x2 "
    "dmat3x3 dmat3x4 dmat4 dmat4x2 dmat4x3 dmat4x4 do dot double dvec2 dvec3 dvec4 else enum "
    "equal exp exp2 extern external faceforward false filter fixed flat float floatBitsToInt "
    "floatBitsToUint floor fma for fract fvec2 fvec3 fvec4 fwidth goto greaterThan "
    "greaterThanEqual half highp hvec2 hvec3 hvec4 if iimage1D iimage1DArray iimage2D "
    "iimage2DArray iimage2DMS iimage2DMSArray iimage2DRect iimage3D iimageBuffer iimageCube "
    "iimageCubeArray image1D image1DArray image2D image2DArray image2DMS image2DMSArray "
    "image2DRect image3D imageBuffer imageCube imageCubeArray in inline inout input int "
    "intBitsToFloat interface invariant inverse inversesqrt isampler1D isampler1DArray "
    "isampler2D isampler2DArray isampler2DMS isampler2DMSArray isampler2DRect isampler3D "
    "isamplerBuffer isamplerCube isamplerCubeArray isinf isnan isubpass isubpassInput "
    "isubpassInputMS itexture1D itexture1DArray itexture2D itexture2DArray itexture2DMS "
    "itexture2DMSArray itexture2DRect itexture3D itextureBuffer itextureCube "
    "itextureCubeArray ivec2 ivec3 ivec4 layout length lessThan lessThanEqual log log2 long "
    "lowp m main mat2 mat2x2 mat2x3 mat2x4 mat3 mat3x2 mat3x3 mat3x4 mat4 mat4x2 mat4x3 mat4x4 "
    "matrixCompMult max mediump min mix mod modf namespace noinline noise1 noise2 noise3 "
    "noise4 noperspective normalize not notEqual out outerProduct output partition patch pow "
    "precise precision public radians readonly reflect refract resource restrict return "
    "round roundEven s sample sampler sampler1D sampler1DArray sampler1DArrayShadow "
    "sampler1DShadow sampler2D sampler2DArray sampler2DArrayShadow sampler2DMS "
    "sampler2DMSArray sampler2DRect sampler2DRectShadow sampler2DShadow sampler3D "
    "sampler3DRect samplerBuffer samplerCube samplerCubeArray samplerCubeArrayShadow "
    "samplerCubeShadow samplerShadow shared short sign sin sinh sizeof smooth smoothstep "
    "sqrt static step struct subpassInput subpassInputMS subroutine superp switch tan tanh "
    "template texelFetch texture texture1D texture1DArray texture2D texture2DArray "
    "texture2DMS texture2DMSArray texture2DRect texture3D textureBuffer textureCube "
    "textureCubeArray textureGather textureGrad textureLod textureProj textureSize this "
    "transpose true trunc typedef uimage1D uimage1DArray uimage2D uimage2DArray uimage2DMS "
    "uimage2DMSArray uimage2DRect uimage3D uimageBuffer uimageCube uimageCubeArray uint "
    "uintBitsToFloat uniform union unsigned usampler1D usampler1DArray usampler2D "
    "usampler2DArray usampler2DMS usampler2DMSArray usampler2DRect usampler3D usamplerBuffer "
    "usamplerCube usamplerCubeArray using usubpassInput usubpassInputMS utexture1D "
    "utexture1DArray utexture2D utexture2DArray utexture2DMS utexture2DMSArray "
    "utexture2DRect utexture3D utextureBuffer utextureCube utextureCubeArray uvec2 uvec3 "
    "uvec4 varying vec2 vec3 vec4 void volatile while writeonly";

// Global names of the shader form, taken in both forms so that a uniform has one name.
constexpr std::string_view own_words =
    "WrinkleFrame wrinkle_object_to_clip wrinkle_object_to_world wrinkle_normal_to_world "
    "wrinkle_eye wrinkle_position_relative wrinkle_frame wrinkle_parameters wrinkle_position "
    "wrinkle_normal wrinkle_tangent wrinkle_uv0 wrinkle_uv1 wrinkle_uv2 wrinkle_uv3 "
    "wrinkle_color0 wrinkle_view wrinkle_facing";

bool glsl_takes_scalar(Op op, size_t operand, bool others) {
    switch (op) {
        case Op::mod_:
        case Op::min_:
        case Op::max_:
            return operand == 1;
        case Op::clamp_:
            return operand > 0 && others;
        case Op::mix_:
            return operand == 2;
        case Op::step_:
            return operand == 0;
        case Op::smoothstep_:
            return operand < 2 && others;
        default:
            return false;
    }
}

}  // namespace

Language glsl_language() {
    Language language;
    for (size_t type = 0; type < language.types.size(); ++type)
        language.types[type] = info(static_cast<Type>(type)).name;
    for (size_t op = 0; op < language.ops.size(); ++op)
        language.ops[op] = info(static_cast<Op>(op)).glsl;
    language.spell(Op::sample_, "texture($n, $0)");
    language.spell(Op::sample_lod_, "textureLod($n, $0, $1)");
    language.spell(Op::sample_grad_, "textureGrad($n, $0, $1, $2)");
    language.spell(Op::image_size_, "vec2(textureSize($n, 0))");
    language.takes_scalar = glsl_takes_scalar;
    reserve_words(language, glsl_words);
    reserve_words(language, own_words);
    return language;
}

const Language& glsl() {
    static const Language language = glsl_language();
    return language;
}

const Language& vulkan_glsl() {
    static const Language language = [] {
        Language vulkan = glsl_language();
        vulkan.image = "layout(set = $s, binding = $b) uniform sampler2D $n;";
        vulkan.block = "layout(std140, set = $s, binding = $b) uniform $n {";
        vulkan.block_member = "$t $n;";
        vulkan.end_block = "};";
        vulkan.stage.varying_out = "layout(location = $l) out $t $n;";
        vulkan.stage.varying_in = "layout(location = $l) in $t $n;";
        return vulkan;
    }();
    return language;
}

}  // namespace wrinkle
