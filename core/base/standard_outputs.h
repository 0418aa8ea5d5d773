// The surface properties of a material: outputs of a graph that have a meaning in every host, and
// the channels of a value of type `material`. They are the inputs of OpenPBR Surface 1.1, some
// under a shorter name, with occlusion, height and displacement in addition.
//
// A further one is a row here, its line in docs/outputs.md and its test.
#pragma once

#include <array>
#include <limits>
#include <string_view>

namespace wrinkle {

struct StandardOutput {
    std::string_view name;
    std::string_view synonym;     // OpenPBR's name; "": the same, or it has none
    std::string_view type;        // port type
    std::array<double, 3> value;  // where a graph does not have it; a normal: the surface's
    double low, high;             // meaningful values
    double slider_high;           // end of a slider that begins at `low`
    std::string_view unit;
    std::string_view doc;  // comment in generated source: unit, space, range
};

namespace detail {

inline constexpr double no_limit = std::numeric_limits<double>::infinity();

constexpr StandardOutput factor(std::string_view name, double value, std::string_view doc,
                                std::string_view synonym = "") {
    return {name, synonym, "float", {value}, 0, 1, 1, "", doc};
}
constexpr StandardOutput color(std::string_view name, double r, double g, double b,
                               std::string_view doc, std::string_view synonym = "") {
    return {name, synonym, "color", {r, g, b}, 0, 1, 1, "", doc};
}
constexpr StandardOutput positive(std::string_view name, double value, double slider_high,
                                  std::string_view unit, std::string_view doc) {
    return {name, "", "float", {value}, 0, no_limit, slider_high, unit, doc};
}
constexpr StandardOutput vector(std::string_view name, std::string_view type, double x,
                                std::string_view doc, std::string_view synonym) {
    return {name, synonym, type, {x}, -1, 1, 1, "", doc};
}
constexpr StandardOutput length(std::string_view name, std::string_view doc) {
    return {name, "", "height", {}, -no_limit, no_limit, 0, "", doc};
}

}  // namespace detail

// In the order of cards and of the fragment outputs of a shader.
inline constexpr auto standard_output_table = [] {
    using namespace detail;
    return std::to_array<StandardOutput>({
        vector("normal", "normal", 0, "unit normal, object space", "geometry_normal"),
        color("color", 0.8, 0.8, 0.8, "base color, linear", "base_color"),
        factor("roughness", 0.3, "perceptual, 0 to 1", "specular_roughness"),
        factor("metalness", 0, "0 dielectric, 1 metal", "base_metalness"),
        factor("occlusion", 1, "1: no occlusion"),
        length("height", "outwards, in length units"),
        length("displacement", "along the normal, in length units"),
        {"emission",
         "emission_color",
         "color",
         {1, 1, 1},
         0,
         no_limit,
         1,
         "",
         "emitted color, linear"},
        positive("emission_luminance", 0, 1000, "nit", "luminance of a white emission, in nits"),
        factor("opacity", 1, "0 absent, 1 present", "geometry_opacity"),
        factor("base_weight", 1, "factor of the base color"),
        factor("base_diffuse_roughness", 0, "0 Lambert, 1 flattened"),
        positive("specular_weight", 1, 1, "", "factor of the reflectance at normal incidence"),
        color("specular_color", 1, 1, 1, "tint of the reflection, of a metal's edge"),
        factor("specular_roughness_anisotropy", 0, "0 isotropic, 1 along the tangent"),
        positive("specular_ior", 1.5, 3, "", "index of refraction"),
        vector("tangent", "vec3", 1, "highlights are stretched along it, object space",
               "geometry_tangent"),
        factor("coat_weight", 0, "coverage of the clear coat"),
        color("coat_color", 1, 1, 1, "transmittance of the coat, linear"),
        factor("coat_roughness", 0, "perceptual, 0 to 1"),
        factor("coat_roughness_anisotropy", 0, "0 isotropic, 1 along the coat's tangent"),
        positive("coat_ior", 1.6, 3, "", "index of refraction of the coat"),
        factor("coat_darkening", 1, "1: inner reflections darken the base"),
        vector("coat_normal", "normal", 0, "unit normal of the coat, object space",
               "geometry_coat_normal"),
        vector("coat_tangent", "vec3", 1,
               "the coat's highlights are stretched along it, object space",
               "geometry_coat_tangent"),
        factor("fuzz_weight", 0, "coverage of fibers or dust"),
        color("fuzz_color", 1, 1, 1, "albedo of the fuzz, linear"),
        factor("fuzz_roughness", 0.5, "0 at the rim, 1 dusty"),
        factor("subsurface_weight", 0, "0 diffuse, 1 subsurface"),
        color("subsurface_color", 0.8, 0.8, 0.8, "observed albedo, linear"),
        positive("subsurface_radius", 1, 1, "", "mean free path, in length units"),
        color("subsurface_radius_scale", 1, 0.5, 0.25, "factor of the radius by channel"),
        {"subsurface_scatter_anisotropy", "", "float", {}, -1, 1, 1, "", "-1 back, 1 forward"},
        factor("transmission_weight", 0, "0 opaque, 1 clear"),
        color("transmission_color", 1, 1, 1, "at transmission_depth, linear"),
        positive("transmission_depth", 0, 1, "", "in length units; 0: a tint"),
        color("transmission_scatter", 0, 0, 0, "albedo of the volume, linear"),
        {"transmission_scatter_anisotropy", "", "float", {}, -1, 1, 1, "", "-1 back, 1 forward"},
        factor("transmission_dispersion_scale", 0, "0: no dispersion"),
        positive("transmission_dispersion_abbe_number", 20, 91, "", "9 to 91"),
        factor("thin_film_weight", 0, "coverage of the film"),
        positive("thin_film_thickness", 0.5, 1, "um", "in micrometers"),
        positive("thin_film_ior", 1.4, 3, "", "index of refraction of the film"),
        factor("thin_walled", 0, "1: a sheet without an inside", "geometry_thin_walled"),
    });
}();

// Luminance of an `emission` where a graph has no `emission_luminance`: nits, one unit of the
// preview's radiance.
inline constexpr double nits_of_unit_emission = 100;

// Returns the port type of the output as a channel of a material, where a bump is a gradient.
constexpr std::string_view channel_type(const StandardOutput& output) {
    return output.type == "normal" ? "gradient" : output.type;
}

// Returns the row of a name or a synonym; nullptr for other names.
constexpr const StandardOutput* find_standard_output(std::string_view name) {
    for (const StandardOutput& output : standard_output_table)
        if (output.name == name || (!name.empty() && output.synonym == name)) return &output;
    return nullptr;
}

// Returns the name of the row of a synonym; any other name unchanged.
constexpr std::string_view output_name(std::string_view name) {
    const StandardOutput* output = find_standard_output(name);
    return output ? output->name : name;
}

}  // namespace wrinkle
