#include "cli/point_source.h"

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>

#include "bake/mesh_check.h"
#include "base/text.h"
#include "cli/arguments.h"
#include "cli/meshes.h"
#include "ir/op.h"
#include "mesh/sample.h"

namespace wrinkle::cli {
namespace {

constexpr InputNeed first_uv = {SurfaceInput::uv0_, Variant::value};

bool has_input(const Mesh& mesh, SurfaceInput input) {
    return input == SurfaceInput::facing_ ||
           (input != SurfaceInput::view_ && attribute_of(mesh, input).values);
}

// Returns a surface value, zero-padded.
glm::dvec4 value_of(const SurfacePoint& point, const InputNeed& need) {
    const SurfaceAttributes& from = need.variant == Variant::dx   ? point.dx
                                    : need.variant == Variant::dy ? point.dy
                                                                  : point.value;
    switch (need.input) {
        case SurfaceInput::position_:
            return {from.position, 0};
        case SurfaceInput::normal_:
            return {from.normal, 0};
        case SurfaceInput::tangent_:
            return from.tangent;
        case SurfaceInput::color0_:
            return from.color;
        case SurfaceInput::facing_:
            return {1, 0, 0, 0};
        default:
            break;
    }
    const auto set = static_cast<size_t>(need.input) - static_cast<size_t>(SurfaceInput::uv0_);
    return {from.uv.at(set), 0, 0};
}

}  // namespace

bool PointSource::check(const Needs& needs, Diagnostics& diagnostics) const {
    if (!surface) return points.check(needs, diagnostics);
    bool fine = points.check({first_uv}, diagnostics);
    for (const InputNeed& need : needs) {
        if (has_input(surface->mesh, need.input)) continue;
        diagnostics.error(RuleId::mesh_attribute, lacks(surface->name, need), "the graph needs it");
        fine = false;
    }
    return fine;
}

bool PointSource::fill(const Needs& needs, PointSet& set, Diagnostics& diagnostics) const {
    const size_t errors = diagnostics.error_count();
    const std::vector<double>& uvs = points.given.at(SurfaceInput::uv0_);
    set.count = points.count();
    for (const InputNeed& need : needs)
        if (!surface) set.at(need.input, need.variant) = points.given.at(need.input, need.variant);
    for (size_t i = 0; surface && i < set.count; ++i) {
        const glm::dvec2 uv(uvs[2 * i], uvs[2 * i + 1]);
        const auto point = sample_mesh(surface->mesh, surface->grid.near(uv), uv, surface->size);
        for (const InputNeed& need : needs)
            for (size_t lane = 0; point && lane < lanes_of(need); ++lane)
                set.at(need.input, need.variant)
                    .push_back(value_of(*point, need)[static_cast<int>(lane)]);
        if (!point)
            points.report(i, RuleId::point, Severity::error,
                          "no triangle of the mesh " + surface->name + " covers the uv (" +
                              shortest(uv.x) + ", " + shortest(uv.y) + ")",
                          "a place inside its uv layout", diagnostics);
    }
    return diagnostics.error_count() == errors;
}

std::optional<glm::dvec2> parse_uv(const std::string& text) {
    double uv[2];
    if (!parse_numbers<double>(text, ',', uv)) return {};
    if (!std::isfinite(uv[0]) || !std::isfinite(uv[1])) return {};
    return glm::dvec2(uv[0], uv[1]);
}

PointSource open_points(const PointOptions& options, const CommonOptions& common,
                        Diagnostics& diagnostics) {
    if (options.mesh.empty()) return {open_list(options.at, diagnostics)};
    std::optional<Mesh> mesh = open_mesh(options.mesh, common, diagnostics);
    if (mesh && !mesh->has_uv(0)) {
        diagnostics.error(RuleId::mesh_uvs, "the mesh " + options.mesh + " has no uvs (set 0)",
                          "a mesh with a uv layout");
        return {};
    }
    PointList places;
    if (!options.at.empty()) {
        places = open_list(options.at, diagnostics);
    } else {
        const glm::dvec2 uv = *parse_uv(options.uv);
        places.file = "--uv";
        places.numbered = false;
        places.given.count = 1;
        places.given.at(SurfaceInput::uv0_) = {uv.x, uv.y};
    }
    if (!mesh || diagnostics.has_errors()) return {};
    const UvGrid grid(*mesh);
    return {std::move(places), MeshSurface{std::move(*mesh), grid, options.mesh, options.size}};
}

}  // namespace wrinkle::cli
