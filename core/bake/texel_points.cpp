#include "bake/texel_points.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <glm/geometric.hpp>

#include "cpu/columns.h"
#include "mesh/uv_triangle.h"

namespace wrinkle {
namespace {

// How many points of a run are made at a time.
constexpr size_t run_part = 64;

struct Attribute {
    const float* values = nullptr;
    uint32_t stride = 0;
};

template <class Vector>
Attribute attribute(const std::vector<Vector>& values) {
    if (values.empty()) return {};
    return {&values[0][0], static_cast<uint32_t>(Vector::length())};
}

// Null for what the mesh lacks.
Attribute attribute_of(const Mesh& mesh, SurfaceInput input) {
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
    return set < max_uv_sets ? attribute(mesh.uvs[set]) : Attribute{};
}

glm::dvec3 brought_back(const glm::dvec3& weights) {
    const glm::dvec3 inside = glm::max(weights, glm::dvec3(0));
    return inside / (inside.x + inside.y + inside.z);
}

// The weights of `count` places in a row; they are linear along it, so its ends tell of all.
void weigh(const UvTriangle& triangle, const UvLayout& layout, glm::dvec2 place, size_t count,
           glm::dvec3* weights) {
    bool outside = false;
    for (size_t i = 0; i < count; ++i) {
        weights[i] = triangle.weights(layout.uv(place.x + static_cast<double>(i), place.y));
        if (i == 0 || i + 1 == count)
            outside = outside || glm::any(glm::lessThan(weights[i], glm::dvec3(0)));
    }
    for (size_t i = 0; outside && i < count; ++i)
        weights[i] = brought_back(weights[i]);
}

}  // namespace

std::string missing_input(const Mesh& mesh, const Program& program) {
    for (const InputNeed& need : needed_inputs(program))
        if (need.input != SurfaceInput::facing_ && !attribute_of(mesh, need.input).values)
            return std::string(info(need.input).name);
    return "";
}

TexelPoints::TexelPoints(const Mesh& mesh, const Program& program, const UvLayout& layout)
    : mesh_(mesh), layout_(layout) {
    assert(missing_input(mesh, program).empty());
    for (const Program::Input& input : program.inputs)
        sources_.push_back(source_of(input));
}

TexelPoints::Source TexelPoints::source_of(const Program::Input& input) const {
    const Attribute attribute = attribute_of(mesh_, input.input);
    const uint32_t lane = input.input == SurfaceInput::view_ ? 0 : input.lane;
    const float* values = attribute.values ? attribute.values + lane : nullptr;
    return {input.input, input.variant, values, attribute.stride, input.lane};
}

size_t TexelPoints::count(const Coverage& coverage) {
    const auto empty = std::count(coverage.owners.begin(), coverage.owners.end(), Coverage::none);
    return coverage.owners.size() - static_cast<size_t>(empty) + coverage.samples.size();
}

void TexelPoints::fill(const Coverage& coverage, const TexelRect& rect, size_t count,
                       float* planes) const {
    size_t first = 0;
    for (uint32_t y = 0; y < rect.height; ++y)
        for (uint32_t x = 0; x < rect.width;) {
            const uint32_t* owner = coverage.owners.data() + size_t{y} * rect.width + x;
            const auto left = static_cast<size_t>(rect.width - x);
            const uint32_t* end = std::find_if(owner, owner + std::min(left, run_part),
                                               [&](uint32_t other) { return other != *owner; });
            const auto length = static_cast<size_t>(end - owner);
            if (*owner != Coverage::none) {
                fill_run({*owner, {rect.x + x + 0.5, rect.y + y + 0.5}, first, length}, count,
                         planes);
                first += length;
            }
            x += static_cast<uint32_t>(length);
        }
    for (const UvSample& sample : coverage.samples)
        fill_run({sample.triangle, sample.place, first++, 1}, count, planes);
}

void TexelPoints::fill_run(const Run& run, size_t count, float* planes) const {
    std::array<glm::dvec3, run_part> weights;
    const auto triangle = uv_triangle(mesh_, run.triangle);
    assert(triangle);
    weigh(*triangle, layout_, run.place, run.count, weights.data());
    const std::array<glm::dvec3, 2> changes = {
        triangle->du() / static_cast<double>(layout_.width),
        triangle->dv() / static_cast<double>(layout_.height)};
    const uint32_t* corners = mesh_.indices.data() + 3 * size_t{run.triangle};
    float* out = planes + run.first;
    for (const Source& source : sources_) {
        const bool is_value = source.variant == Variant::value;
        const glm::dvec3& change = changes[source.variant == Variant::dy ? 1 : 0];
        const auto corner = [&](size_t k) {
            return static_cast<double>(source.values[size_t{corners[k]} * source.stride]);
        };
        if (source.input == SurfaceInput::facing_) {
            std::fill_n(out, run.count, is_value ? 1.0F : 0.0F);
        } else if (source.input == SurfaceInput::view_) {
            fill_view(run, source, weights.data(), change, out);
        } else if (is_value) {
            const double a = corner(0), b = corner(1), c = corner(2);
            for (size_t i = 0; i < run.count; ++i)
                out[i] = static_cast<float>(blend<double>(a, b, c, weights[i]));
        } else {
            std::fill_n(out, run.count,
                        static_cast<float>(blend<double>(corner(0), corner(1), corner(2), change)));
        }
        out += count;
    }
}

void TexelPoints::fill_view(const Run& run, const Source& source, const glm::dvec3* weights,
                            const glm::dvec3& change, float* out) const {
    const uint32_t* corners = mesh_.indices.data() + 3 * size_t{run.triangle};
    const auto at = [&](const glm::dvec3& w) {
        return blend<glm::dvec3>(mesh_.normals[corners[0]], mesh_.normals[corners[1]],
                                 mesh_.normals[corners[2]], w);
    };
    for (size_t i = 0; i < run.count; ++i) {
        const glm::dvec3 normal = at(weights[i]);
        const double length = glm::length(normal);
        const glm::dvec3 unit = normal / length;
        glm::dvec3 value = unit;
        if (source.variant != Variant::value) {
            const glm::dvec3 moved = at(change);
            value = (moved - unit * glm::dot(unit, moved)) / length;
        }
        out[i] = static_cast<float>(value[static_cast<int>(source.lane)]);
    }
}

}  // namespace wrinkle
