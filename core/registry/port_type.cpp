#include "registry/port_type.h"

#include <wrinkle/plugin.h>

#include <algorithm>
#include <array>

#include "base/standard_outputs.h"
#include "base/text.h"

namespace wrinkle {
namespace {

#define X(name, number, value) static_assert(static_cast<int>(PortType::name##_) == number);
WR_PORT_TYPES(X)
#undef X

#define X(name, number, value) #name,
constexpr std::array<std::string_view, port_type_count> names = {WR_PORT_TYPES(X)};
#undef X

constexpr int lanes_poison = 0, lanes_float = 1, lanes_vec2 = 2, lanes_vec3 = 3, lanes_vec4 = 4;
constexpr int lanes_derivative = 0, lanes_gradient = 0, lanes_material = 0;
#define X(name, number, value) lanes_##value,
constexpr std::array<int, port_type_count> lanes = {WR_PORT_TYPES(X)};
#undef X

#define X(name, number, type, doc) SurfaceProperty{#name, PortType::type##_, doc},
constexpr auto surface_table = [] {
    std::array table = {WR_SURFACE_INPUTS(X)};
    table[WR_SURFACE_normal].type = PortType::normal_;
    return table;
}();
#undef X

}  // namespace

std::string_view name_of(PortType type) {
    return names[static_cast<size_t>(type) - 1];
}

std::optional<PortType> port_type_named(std::string_view name) {
    return enumerator_named<PortType>(names, name, 1);
}

std::span<const std::string_view> port_type_names() {
    return names;
}

int lanes_of(PortType type) {
    return lanes[static_cast<size_t>(type) - 1];
}

std::span<const SurfaceProperty> surface_properties() {
    return surface_table;
}

std::optional<PortType> standard_output(std::string_view name) {
    const StandardOutput* found = find_standard_output(name);
    return found ? port_type_named(found->type) : std::nullopt;
}

std::span<const std::string_view> standard_outputs() {
    static constexpr auto list = [] {
        std::array<std::string_view, standard_output_table.size()> result;
        std::ranges::transform(standard_output_table, result.begin(), &StandardOutput::name);
        return result;
    }();
    return list;
}

bool is_name(std::string_view text) {
    const auto lower = [](char c) { return c >= 'a' && c <= 'z'; };
    const auto inside = [&](char c) { return lower(c) || (c >= '0' && c <= '9') || c == '_'; };
    return !text.empty() && text.size() <= max_name && lower(text[0]) &&
           std::ranges::all_of(text, inside);
}

}  // namespace wrinkle
