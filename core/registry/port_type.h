// The types on wires, read from the one table in wrinkle/plugin.h. Which converts to which stands
// in lower/conversion.h.
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

// How many numbers a literal of this type has: 1 to 4; 0 for derivative, gradient and image.
int lanes_of(PortType type);

// A property of the surface: "uv0", its type on wires (normal is a normal), and its doc line.
struct SurfaceProperty {
    std::string_view name;
    PortType type;
    std::string_view doc;
};
std::span<const SurfaceProperty> surface_properties();  // in the order of WR_SURFACE_*

}  // namespace wrinkle
