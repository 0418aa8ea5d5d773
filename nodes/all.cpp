#include "nodes/all.h"

#include <iterator>

#include "wrinkle/node.h"

// All built-in nodes, in the order of the menus and of the reference. The variable of node `x` is
// x_node, because other nodes call the function x.
// clang-format off
#define WRINKLE_BUILT_IN_NODES(X) \
    /* uv.cpp, coordinates.cpp */ \
    X(uv_transform) X(planar_uv) X(plane_uv) X(box_uv) X(cylinder_uv) X(sphere_uv) \
    /* image.cpp, height_map.cpp */ \
    X(image) X(height_map) X(derivative_map) X(tangent_normal_map) X(object_normal_map) \
    /* cube_map.cpp */ \
    X(cube_normal_map) \
    /* triplanar.cpp */ \
    X(triplanar_weights) X(triplanar_color) X(triplanar_height_map) X(triplanar_derivative_map) \
    X(triplanar_normal_map) X(triplanar_height) X(triplanar_derivative) \
    /* hex.cpp */ \
    X(hex_tile_color) X(hex_tile_height_map) X(hex_tile_normal_map) \
    /* decal.cpp */ \
    X(decal_box) X(decal_cone) X(decal_sphere) X(decal_capsule) X(decal_add) X(decal_mask) \
    /* gradient.cpp */ \
    X(gradient_add) X(gradient_subtract) X(gradient_scale) X(gradient_invert) X(gradient_mix) \
    X(gradient_over) X(gradient_clamp_slope) X(gradient_tilt) X(normal_angle) X(gradient_from_height) \
    X(gradient_from_volume) X(gradient_from_normal) X(gradient_from_tangent_normal) X(resolve) \
    /* roughness.cpp */ \
    X(bump_roughness) X(slope_moments_map) \
    /* frame.cpp */ \
    X(tangent_frame) X(tangent_map) X(tangent_space_normal) X(face_viewer) \
    /* compositor.cpp */ \
    X(gradient_compositor) \
    /* height.cpp */ \
    X(height_add) X(height_subtract) X(height_scale) X(height_invert) X(height_mix) X(height_max) \
    X(height_min) X(height_remap) \
    /* noise.cpp */ \
    X(gradient_noise) X(simplex_noise) X(value_noise) \
    /* fractal.cpp */ \
    X(fbm) X(turbulence) X(ridged) X(dents) \
    /* cellular.cpp */ \
    X(worley_noise) X(scratches) \
    /* waves.cpp */ \
    X(waves) \
    /* pattern.cpp */ \
    X(checker) X(brick) X(hexagons) X(pyramids) X(domes) \
    /* weave.cpp */ \
    X(weave) \
    /* parallax.cpp */ \
    X(parallax_occlusion) X(parallax_offset) \
    /* math.cpp */ \
    X(add) X(subtract) X(multiply) X(divide) X(negate) X(absolute) X(minimum) X(maximum) X(clamp) X(mix) \
    X(step) X(smoothstep) X(remap) X(floor) X(fraction) X(modulo) X(power) X(square_root) X(sine) \
    X(cosine) X(tangent) X(arctangent2) \
    /* vector.cpp */ \
    X(combine_vec2) X(combine_vec3) X(combine_vec4) X(separate_vec2) X(separate_vec3) X(separate_vec4) \
    X(vec2_add) X(vec2_scale) X(vec3_add) X(vec3_subtract) X(vec3_multiply) X(vec3_scale) X(vec3_mix) \
    X(dot) X(cross) X(length) X(normalize) \
    /* comparison.cpp */ \
    X(compare_linear) X(compare_overlay) X(compare_whiteout) X(compare_udn) \
    X(compare_partial_derivative) X(compare_rnm) X(compare_unity) X(compare_nested_frame) \
    X(compare_bump_over_normal) X(compare_normal_strength) \
    /* comparison_surface.cpp */ \
    X(compare_perlin) X(compare_weighted_normals) X(compare_blender_strength) \
    X(compare_engine_basis) X(compare_bump_blend) X(compare_screen_height)
// clang-format on

namespace wrinkle {

namespace nodes {
#define X(id) extern sdk::Node id##_node;
WRINKLE_BUILT_IN_NODES(X)
#undef X
}  // namespace nodes

const wr_plugin* built_in_nodes() {
#define X(id) nodes::id##_node.descriptor(),
    static const wr_node* const list[] = {WRINKLE_BUILT_IN_NODES(X)};
#undef X
    static const wr_plugin plugin{sizeof(wr_plugin),
                                  WR_ABI,
                                  "wrinkle",
                                  "1.0",
                                  list,
                                  static_cast<uint32_t>(std::size(list)),
                                  [](const char*) -> const void* { return nullptr; }};
    return &plugin;
}

}  // namespace wrinkle
