// The shading languages of Godot 3 and 4. Godot 3 has no structs and no suffix of unsigned numbers.
#include "emit/language.h"

namespace wrinkle {
namespace {

// Functions and words that GLSL lacks, and the built-in variables of spatial shaders.
constexpr std::string_view godot_words = R"(
ALBEDO ALPHA ANISOTROPY AO AT_LIGHT_PASS ATTENUATION BACKLIGHT BINORMAL CAMERA_MATRIX CLEARCOAT
COLOR DEPTH DIFFUSE_LIGHT E EMISSION FRAGCOORD FRONT_FACING INSTANCE_ID INV_CAMERA_MATRIX LIGHT
METALLIC MODELVIEW_MATRIX MODEL_MATRIX NORMAL NORMALMAP NORMAL_MAP PI POINT_SIZE PROJECTION_MATRIX
RIM ROUGHNESS SCREEN_TEXTURE SCREEN_UV SPECULAR TANGENT TAU TIME TRANSMISSION UV UV2 VERTEX
VERTEX_ID VIEW VIEWPORT_SIZE VIEW_MATRIX WORLD_MATRIX global group_uniforms instance instance_index
include render_mode shader_type)";

Language godot_language(std::string_view srgb_hint) {
    Language language = glsl_language();
    language.image = "uniform sampler2D $n$h;";
    language.srgb_hint = srgb_hint;
    reserve_words(language, godot_words);
    return language;
}

}  // namespace

const Language& godot3() {
    static const Language language = [] {
        Language godot = godot_language(" : hint_albedo");
        godot.arguments = Arguments::flat;
        godot.uint_literal = "uint($v)";
        godot.uint_literal_is_int = true;  // it reads 2147483648 and above as 2147483647
        godot.not_a_number = "uintBitsToFloat(uint(2143289344))";
        godot.infinity = "uintBitsToFloat(uint(2139095040))";
        godot.minus_infinity = "uintBitsToFloat(uint(-8388608))";
        return godot;
    }();
    return language;
}

const Language& godot4() {
    static const Language language = godot_language(" : source_color");
    return language;
}

}  // namespace wrinkle
