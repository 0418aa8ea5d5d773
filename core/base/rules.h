// Rules: the kinds of problems that a diagnostic reports, each with an id by which users, CI
// systems and code scanning filter and count them. An id never changes and is never reused; one
// rule may be reported by several functions. docs/diagnostics.md is generated from this table.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace wrinkle {

enum class RuleId : uint8_t {
    // Files and JSON
    file_unreadable,
    file_unwritable,
    outside_root,
    json_syntax,
    duplicate_key,
    unknown_key,
    missing_key,
    wrong_kind,
    invalid_value,
    invalid_name,
    format_version,
    wrong_file,
    merge_conflict,
    // Nodes and wires
    unknown_node_type,
    node_version,
    unknown_port,
    port_not_set,
    option_wire,
    invalid_link,
    unknown_source,
    type_mismatch,
    value_range,
    cycle,
    base_cycle,
    subgraph_unreadable,
    subgraph_cycle,
    node_build,
    projection_scale,
    // Interface of a graph
    input_type,
    input_key,
    former_name,
    unknown_input,
    unknown_preset,
    no_output,
    unknown_output,
    // Size and targets
    over_limit,
    target,
    shader_rejected,
    texture_precision,
    gpu_limit,
    // Images and meshes
    image_missing,
    image_unreadable,
    image_values,
    image_meaning,
    texture_set,
    materialx_syntax,
    materialx_value,
    materialx_unsupported,
    materialx_approximate,
    mesh_unreadable,
    mesh_repaired,
    double_sided,
    mesh_uvs,
    mesh_attribute,
    // Results
    not_finite,
    precision_loss,
    point,
    unknown_map,
    map_view,
    host_lacks,
    bake_part,
    test_case,
    test_failed,
    // Program and machine
    option,
    output_path,
    environment,
    plugin,
    certification,
    opengl,
    cache,
};

struct RuleInfo {
    std::string_view id;
    std::string_view title;        // a few words
    std::string_view description;  // its meaning, one sentence
    std::string_view help;         // how to solve it, one sentence
};

inline constexpr size_t rule_count = static_cast<size_t>(RuleId::cache) + 1;

// In the order of the enumerators.
extern const std::array<RuleInfo, rule_count> rule_infos;

inline const RuleInfo& info(RuleId rule) {
    return rule_infos[static_cast<size_t>(rule)];
}

}  // namespace wrinkle
