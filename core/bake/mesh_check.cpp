#include "bake/mesh_check.h"

#include "base/diagnostics.h"
#include "cpu/columns.h"
#include "ir/op.h"

namespace wrinkle {
namespace {

template <class Vector>
MeshAttribute attribute(const std::vector<Vector>& values) {
    if (values.empty()) return {};
    return {&values[0][0], static_cast<uint32_t>(Vector::length())};
}

// "3 of 12 triangles"
std::string share(size_t count, size_t all) {
    return std::to_string(count) + " of " + std::to_string(all) + " triangles";
}

constexpr const char* beyond_first = "UDIM tiles (--udim) have the other squares";
const std::string numbered_range = "with u from 0 to 10 and v on one side of 0";

std::string nothing_to_bake(const UvSurvey& uvs, bool udim, std::string& expected) {
    expected = "a mesh with a uv layout";
    if (uvs.triangles == uvs.without_area) return "no triangle has an area in uv";
    if (udim ? !uvs.udim_tiles.empty() : uvs.in_square > 0) return "";
    expected = uvs.udim_tiles.empty() ? "uvs " + numbered_range : beyond_first;
    return udim ? "no triangle lies in a square of uv that UDIM has a number for"
                : "no triangle lies in the uv square from (0, 0) to (1, 1), and the layout lies in "
                  "several others";
}

}  // namespace

MeshAttribute attribute_of(const Mesh& mesh, SurfaceInput input) {
    switch (input) {
        case SurfaceInput::position_:
            return attribute(mesh.positions);
        case SurfaceInput::normal_:
        case SurfaceInput::view_:
            return attribute(mesh.normals);
        case SurfaceInput::tangent_:
            return attribute(mesh.tangents);
        case SurfaceInput::color0_:
            return attribute(mesh.colors);
        default:
            break;
    }
    const size_t set = static_cast<size_t>(input) - static_cast<size_t>(SurfaceInput::uv0_);
    return set < max_uv_sets ? attribute(mesh.uvs[set]) : MeshAttribute{};
}

std::string missing_input(const Mesh& mesh, const Program& program) {
    for (const InputNeed& need : needed_inputs(program))
        if (need.input != SurfaceInput::facing_ && !attribute_of(mesh, need.input).values)
            return std::string(info(need.input).name);
    return "";
}

bool has_uv_layout(const Mesh& mesh, const std::string& name, Diagnostics& diagnostics) {
    if (mesh.has_uv(0)) return true;
    diagnostics.add(file_problem(Severity::error, RuleId::mesh_uvs, name,
                                 "the mesh has no uvs (set 0)", "a mesh with a uv layout"));
    return false;
}

bool check_uvs(const UvSurvey& uvs, bool udim, const std::string& name, Diagnostics& diagnostics) {
    std::string expected;
    const std::string nothing = nothing_to_bake(uvs, udim, expected);
    if (!nothing.empty()) {
        diagnostics.add(file_problem(Severity::error, RuleId::mesh_uvs, name, nothing, expected));
        return false;
    }
    const auto warn = [&](std::string message, std::string expected) {
        diagnostics.add(file_problem(Severity::warning, RuleId::mesh_uvs, name, std::move(message),
                                     std::move(expected)));
    };
    const size_t area = uvs.triangles - uvs.without_area;
    if (uvs.without_area > 0)
        warn(share(uvs.without_area, uvs.triangles) + " have no area in uv and no texel", "");
    if (!udim && uvs.in_square < area)
        warn(share(area - uvs.in_square, uvs.triangles) + " lie outside of the uv square",
             uvs.udim_tiles.size() > 1 ? beyond_first : "uvs " + numbered_range);
    if (udim && uvs.beyond_udim > 0)
        warn(share(uvs.beyond_udim, uvs.triangles) +
                 " reach into squares of uv that UDIM has no number for and are cut off there",
             "uvs " + numbered_range);
    if (uvs.mirrored > 0)
        warn(share(uvs.mirrored, uvs.triangles) + " are mirrored in uv",
             "their tangents' w is -1; engines must read it");
    return true;
}

bool check_inputs(const Mesh& mesh, std::span<const BakePlan> plans, const std::string& name,
                  Diagnostics& diagnostics) {
    for (const BakePlan& plan : plans) {
        const std::string missing = missing_input(mesh, plan.program);
        if (missing.empty()) continue;
        diagnostics.add(file_problem(Severity::error, RuleId::mesh_attribute, name,
                                     "the mesh lacks '" + missing + "'", "the graph reads it"));
        return false;
    }
    return true;
}

}  // namespace wrinkle
