// Names of node types in Blender, Unreal Engine, Unity, Substance Designer and MaterialX, and of
// techniques, that a search of titles, ids and doc lines would not find.
#include "editor/view/panels/search.h"

namespace wrinkle::editor {
namespace {

constexpr OtherName names[] = {
    {"blackbody", "Color Temperature"},
    {"bump_roughness", "LEAN mapping"},
    {"bump_roughness", "Toksvig"},
    {"clamp", "Saturate"},
    {"combine_vec2", "Append Vector"},
    {"combine_vec3", "Combine XYZ"},
    {"combine_vec3", "Combine RGB"},
    {"compare", "Greater Than"},
    {"compare", "Less Than"},
    {"curvature", "Cavity"},
    {"curvature", "Dirt"},
    {"curve", "RGB Curves"},
    {"curve", "Float Curve"},
    {"facing", "Layer Weight"},
    {"fbm", "Clouds"},
    {"fbm", "Noise Texture"},
    {"fbm", "Fractal3D"},
    {"gradient_add", "Blend Angle Corrected Normals"},
    {"gradient_add", "Detail Normal"},
    {"gradient_add", "Normal Blend"},
    {"gradient_add", "Normal Combine"},
    {"gradient_from_height", "Height to Normal"},
    {"gradient_from_height", "Normal from Height"},
    {"gradient_noise", "Perlin Noise"},
    {"gradient_scale", "Normal Strength"},
    {"hsv_adjust", "HSL"},
    {"hsv_adjust", "Hue Saturation Value"},
    {"image", "Bitmap"},
    {"image", "Image Texture"},
    {"image", "Sample Texture 2D"},
    {"image", "Texture Sample"},
    {"invert", "One Minus"},
    {"luminance", "Grayscale Conversion"},
    {"mix", "Lerp"},
    {"mix", "Linear Interpolate"},
    {"parallax_occlusion", "POM"},
    {"parallax_offset", "Bump Offset"},
    {"quantize", "Posterize"},
    {"ramp", "Gradient Map"},
    {"random", "White Noise"},
    {"remap", "Map Range"},
    {"ridged", "Musgrave Texture"},
    {"rotate", "Vector Rotate"},
    {"saturation", "Desaturation"},
    {"separate_vec3", "Component Mask"},
    {"separate_vec3", "Separate RGB"},
    {"separate_vec3", "Separate XYZ"},
    {"separate_vec3", "Swizzle"},
    {"separate_vec4", "Split"},
    {"tangent_normal_map", "Normal Map Texture"},
    {"triplanar_color", "World Aligned Texture"},
    {"uv_swirl", "Twirl"},
    {"uv_transform", "Mapping"},
    {"uv_transform", "Place2D"},
    {"uv_transform", "Tiling and Offset"},
    {"uv_transform", "Transform 2D"},
    {"uv_rotate", "Rotator"},
    {"uv_warp_directional", "Directional Warp"},
    {"uv_warp_slope", "Slope Blur"},
    {"vec3_add", "Vector Math"},
    {"worley_noise", "Cells"},
    {"worley_noise", "Crystal"},
    {"worley_noise", "Voronoi Texture"},
};

}  // namespace

std::span<const OtherName> other_names() {
    return names;
}

std::string_view other_name(std::string_view type, std::string_view query) {
    if (query.size() < 3) return "";
    for (const OtherName& other : names) {
        const auto matched = other.type == type ? match(other.name, "", "", query) : std::nullopt;
        if (matched && matched->rank <= rank_of_other_name) return other.name;
    }
    return "";
}

}  // namespace wrinkle::editor
