#include "glsl/names.h"

#include <algorithm>
#include <array>

#include "base/text.h"

namespace wrinkle {
namespace {

constexpr size_t longest_name = 120;
constexpr size_t longest_comment = 160;

// Sorted. GLSL 3.30 and 4.60 (sections 3.6 and 8), GLSL ES 3.00.
constexpr auto reserved = std::to_array<std::string_view>({
    "abs",
    "acos",
    "acosh",
    "active",
    "all",
    "any",
    "asin",
    "asinh",
    "asm",
    "atan",
    "atanh",
    "atomic_uint",
    "attribute",
    "bool",
    "break",
    "buffer",
    "bvec2",
    "bvec3",
    "bvec4",
    "case",
    "cast",
    "ceil",
    "centroid",
    "clamp",
    "class",
    "coherent",
    "common",
    "const",
    "continue",
    "cos",
    "cosh",
    "cross",
    "dFdx",
    "dFdxCoarse",
    "dFdxFine",
    "dFdy",
    "dFdyCoarse",
    "dFdyFine",
    "default",
    "degrees",
    "determinant",
    "discard",
    "distance",
    "dmat2",
    "dmat2x2",
    "dmat2x3",
    "dmat2x4",
    "dmat3",
    "dmat3x2",
    "dmat3x3",
    "dmat3x4",
    "dmat4",
    "dmat4x2",
    "dmat4x3",
    "dmat4x4",
    "do",
    "dot",
    "double",
    "dvec2",
    "dvec3",
    "dvec4",
    "else",
    "enum",
    "equal",
    "exp",
    "exp2",
    "extern",
    "external",
    "faceforward",
    "false",
    "filter",
    "fixed",
    "flat",
    "float",
    "floatBitsToInt",
    "floatBitsToUint",
    "floor",
    "fma",
    "for",
    "fract",
    "fvec2",
    "fvec3",
    "fvec4",
    "fwidth",
    "goto",
    "greaterThan",
    "greaterThanEqual",
    "half",
    "highp",
    "hvec2",
    "hvec3",
    "hvec4",
    "if",
    "iimage1D",
    "iimage1DArray",
    "iimage2D",
    "iimage2DArray",
    "iimage2DMS",
    "iimage2DMSArray",
    "iimage2DRect",
    "iimage3D",
    "iimageBuffer",
    "iimageCube",
    "iimageCubeArray",
    "image1D",
    "image1DArray",
    "image2D",
    "image2DArray",
    "image2DMS",
    "image2DMSArray",
    "image2DRect",
    "image3D",
    "imageBuffer",
    "imageCube",
    "imageCubeArray",
    "in",
    "inline",
    "inout",
    "input",
    "int",
    "intBitsToFloat",
    "interface",
    "invariant",
    "inverse",
    "inversesqrt",
    "isampler1D",
    "isampler1DArray",
    "isampler2D",
    "isampler2DArray",
    "isampler2DMS",
    "isampler2DMSArray",
    "isampler2DRect",
    "isampler3D",
    "isamplerBuffer",
    "isamplerCube",
    "isamplerCubeArray",
    "isinf",
    "isnan",
    "isubpass",
    "isubpassInput",
    "itexture2D",
    "ivec2",
    "ivec3",
    "ivec4",
    "layout",
    "length",
    "lessThan",
    "lessThanEqual",
    "log",
    "log2",
    "long",
    "lowp",
    "main",
    "mat2",
    "mat2x2",
    "mat2x3",
    "mat2x4",
    "mat3",
    "mat3x2",
    "mat3x3",
    "mat3x4",
    "mat4",
    "mat4x2",
    "mat4x3",
    "mat4x4",
    "matrixCompMult",
    "max",
    "mediump",
    "min",
    "mix",
    "mod",
    "modf",
    "namespace",
    "noinline",
    "noise1",
    "noise2",
    "noise3",
    "noise4",
    "noperspective",
    "normalize",
    "not",
    "notEqual",
    "outerProduct",
    "out",
    "output",
    "partition",
    "patch",
    "pow",
    "precise",
    "precision",
    "public",
    "radians",
    "readonly",
    "reflect",
    "refract",
    "resource",
    "restrict",
    "return",
    "round",
    "roundEven",
    "s",
    "sample",
    "sampler",
    "sampler1D",
    "sampler1DArray",
    "sampler1DArrayShadow",
    "sampler1DShadow",
    "sampler2D",
    "sampler2DArray",
    "sampler2DArrayShadow",
    "sampler2DMS",
    "sampler2DMSArray",
    "sampler2DRect",
    "sampler2DRectShadow",
    "sampler2DShadow",
    "sampler3D",
    "sampler3DRect",
    "samplerBuffer",
    "samplerCube",
    "samplerCubeArray",
    "samplerCubeArrayShadow",
    "samplerCubeShadow",
    "samplerShadow",
    "shared",
    "short",
    "sign",
    "sin",
    "sinh",
    "sizeof",
    "smooth",
    "smoothstep",
    "sqrt",
    "static",
    "step",
    "struct",
    "subpassInput",
    "subpassInputMS",
    "subroutine",
    "superp",
    "switch",
    "tan",
    "tanh",
    "template",
    "texelFetch",
    "texture",
    "texture1D",
    "texture2D",
    "texture2DArray",
    "texture3D",
    "textureCube",
    "textureGather",
    "textureGrad",
    "textureLod",
    "textureProj",
    "textureSize",
    "this",
    "transpose",
    "true",
    "trunc",
    "typedef",
    "uimage1D",
    "uimage1DArray",
    "uimage2D",
    "uimage2DArray",
    "uimage2DMS",
    "uimage2DMSArray",
    "uimage2DRect",
    "uimage3D",
    "uimageBuffer",
    "uimageCube",
    "uimageCubeArray",
    "uint",
    "uintBitsToFloat",
    "uniform",
    "union",
    "unsigned",
    "usampler1D",
    "usampler1DArray",
    "usampler2D",
    "usampler2DArray",
    "usampler2DMS",
    "usampler2DMSArray",
    "usampler2DRect",
    "usampler3D",
    "usamplerBuffer",
    "usamplerCube",
    "usamplerCubeArray",
    "using",
    "uvec2",
    "uvec3",
    "uvec4",
    "varying",
    "vec2",
    "vec3",
    "vec4",
    "void",
    "volatile",
    "while",
    "writeonly",
});

std::string legal(std::string_view wanted) {
    std::string name = identifier(wanted);
    while (name.size() > 1 && name.back() == '_')
        name.pop_back();
    if (name.starts_with("gl_") || name.starts_with("GL_") || name == "_") name.insert(0, "n");
    if (name.size() > longest_name) name.resize(longest_name);
    while (name.size() > 1 && name.back() == '_')
        name.pop_back();
    return name;
}

// max(|z| ..., floor) of a tangent-space normal, as expansion writes it.
bool is_depth(const Module& m, Id id) {
    const Inst& inst = m[id];
    return inst.op == Op::max_ && m.is_literal(inst.arg[1], 1e-6) && m[inst.arg[0]].op == Op::max_;
}

// -xy of a tangent-space normal, times factors.
bool is_slope(const Module& m, Id id) {
    for (int factors = 0; m[id].op == Op::mul_ && factors < 4; ++factors)
        id = m[id].arg[0];
    return m.type(id) == Type::vec2_ && m[id].op == Op::neg_ && m[m[id].arg[0]].op == Op::swizzle_;
}

// A sample, or what constants and swizzles make of it.
bool is_texel(const Module& m, Id id) {
    for (int steps = 0; steps < 6; ++steps) {
        const Inst& inst = m[id];
        if (inst.op == Op::sample_ || inst.op == Op::sample_lod_ || inst.op == Op::sample_grad_)
            return true;
        const bool scaled = (inst.op == Op::add_ || inst.op == Op::sub_ || inst.op == Op::mul_) &&
                            m.is_constant(inst.arg[1]);
        if (!scaled && inst.op != Op::swizzle_) return false;
        id = inst.arg[0];
    }
    return false;
}

}  // namespace

bool is_reserved(std::string_view word) {
    return std::find(reserved.begin(), reserved.end(), word) != reserved.end();
}

bool NameSet::taken(const std::string& name) const {
    return names_.count(name) || (outer_ && outer_->taken(name));
}

std::string NameSet::unique(std::string_view wanted) {
    const std::string base = legal(wanted);
    std::string name = base;
    uint32_t& next = next_.try_emplace(base, 2).first->second;
    while (taken(name) || is_reserved(name))
        name = base + "_" + std::to_string(next++);
    names_.insert(name);
    return name;
}

std::string comment_text(std::string_view text) {
    std::string result;
    for (const char c : text.substr(0, longest_comment))
        result += static_cast<unsigned char>(c) < 0x20 || c == '\x7F' ? ' ' : c == '\\' ? '/' : c;
    while (!result.empty() && (static_cast<unsigned char>(result.back()) & 0xC0) == 0x80 &&
           text.size() > longest_comment)
        result.pop_back();
    return result;
}

std::string_view word_for(const Module& module, Id id) {
    if (is_depth(module, id)) return "depth";
    if (is_slope(module, id)) return "slope";
    if (is_texel(module, id)) return "texel";
    switch (module[id].op) {
        case Op::image_size_:
            return "size";
        case Op::add_:
            return "sum";
        case Op::sub_:
            return "difference";
        case Op::mul_:
        case Op::matrix_product_:
            return "product";
        case Op::div_:
            return "quotient";
        case Op::neg_:
            return "negated";
        case Op::normalize_:
            return "unit";
        case Op::select_:
            return "choice";
        case Op::construct_:
            return "vector";
        case Op::transform_:
            return "transformed";
        case Op::lt_:
        case Op::le_:
        case Op::gt_:
        case Op::ge_:
        case Op::eq_:
        case Op::ne_:
        case Op::and_:
        case Op::or_:
        case Op::not_:
            return "test";
        case Op::bit_and_:
        case Op::bit_or_:
        case Op::bit_xor_:
        case Op::shift_left_:
        case Op::shift_right_:
            return "bits";
        case Op::sign_nonzero_:
            return "sign";
        case Op::to_float_:
        case Op::to_int_:
        case Op::to_uint_:
            return info(module.type(id)).name;
        case Op::result_:
            return module.region(module[module[id].arg[0]].extra).kind == RegionKind::loop
                       ? "state"
                       : std::string_view(module.region(module[module[id].arg[0]].extra).name);
        default:
            return info(module[id].op).name;
    }
}

}  // namespace wrinkle
