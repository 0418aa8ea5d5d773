// Names with the same meaning in every graph: port types, surface properties, standard outputs.
//
// Port types are the rows of WR_PORT_TYPES in wrinkle/plugin.h, which port_type.cpp compares.
// lower/conversion.h defines the conversions between them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace wrinkle {

enum class PortType : uint8_t {
    float_ = 1,
    vec2_,
    vec3_,
    vec4_,
    color_,
    height_,
    derivative_,
    gradient_,
    normal_,
    image_,
    material_
};
inline constexpr uint32_t port_type_count = 11;  // numbered from 1

std::string_view name_of(PortType type);
std::optional<PortType> port_type_named(std::string_view name);
std::span<const std::string_view> port_type_names();  // in the order of the table

// Types of graph inputs that are constants while compiling; they go to options of nodes.
inline constexpr std::array<std::string_view, 3> option_type_names = {"choice", "count", "flag"};

// Returns the number of components of a literal: 1 to 4; 0 for derivative, gradient, image and
// material.
int lanes_of(PortType type);

// A surface property: its name ("uv0"), port type and one line of documentation.
struct SurfaceProperty {
    std::string_view name;
    PortType type;
    std::string_view doc;
};
std::span<const SurfaceProperty> surface_properties();  // in the order of WR_SURFACE_*

inline constexpr std::string_view reroute_type = "reroute";

// Ids of nodes, names of ports and choices: lower_snake_case that begins with a letter.
inline constexpr size_t max_name = 64;  // bytes
bool is_name(std::string_view text);

// Returns the type of a standard output of a graph (base/standard_outputs.h): "normal" is a normal,
// "roughness" a float, ...; std::nullopt for other names.
std::optional<PortType> standard_output(std::string_view name);
std::span<const std::string_view> standard_outputs();  // without synonyms

}  // namespace wrinkle
