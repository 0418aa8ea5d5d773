// Port types, generated from the table in wrinkle/plugin.h. lower/conversion.h defines the
// conversions between them.
#pragma once

#include <wrinkle/plugin.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace wrinkle {

#define X(name, number, value) name##_ = number,
enum class PortType : uint8_t { WR_PORT_TYPES(X) };
#undef X
inline constexpr uint32_t port_type_count = 10;  // numbered from 1

std::string_view name_of(PortType type);
std::optional<PortType> port_type_named(std::string_view name);
std::span<const std::string_view> port_type_names();  // in the order of the table

// Returns the number of components of a literal: 1 to 4; 0 for derivative, gradient and image.
int lanes_of(PortType type);

// A surface property: its name ("uv0"), port type and one line of documentation.
struct SurfaceProperty {
    std::string_view name;
    PortType type;
    std::string_view doc;
};
std::span<const SurfaceProperty> surface_properties();  // in the order of WR_SURFACE_*

}  // namespace wrinkle
