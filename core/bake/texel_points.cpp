#include "bake/texel_points.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>

#include "cpu/columns.h"
#include "cpu/kernels.h"

namespace wrinkle {
namespace {

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

bool is_outside(const glm::dvec3& weights) {
    return weights.x < 0 || weights.y < 0 || weights.z < 0;
}

}  // namespace

std::string missing_input(const Mesh& mesh, const Program& program) {
    for (const InputNeed& need : needed_inputs(program))
        if (need.input != SurfaceInput::facing_ && !attribute_of(mesh, need.input).values)
            return std::string(info(need.input).name);
    return "";
}

TexelPoints::TexelPoints(const Mesh& mesh, const Program& program, const UvLayout& layout)
    : mesh_(mesh),
      layout_(layout),
      columns_(layout.width + interpolated_behind),
      interpolate_(kernels_of(default_instruction_set()).interpolate) {
    assert(missing_input(mesh, program).empty());
    for (const Program::Input& input : program.inputs) {
        sources_.push_back(source_of(input));
        has_view_ = has_view_ || input.input == SurfaceInput::view_;
    }
    for (uint32_t x = 0; x < layout.width; ++x)
        columns_[x] = layout.uv(x + 0.5, 0).x;
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

void TexelPoints::fill(const Coverage& coverage, const TexelRect& rect, size_t stride,
                       float* planes, MetTriangles& met) const {
    for (uint32_t y = 0; y < rect.height; ++y) {
        const double v = layout_.uv(0, rect.y + y + 0.5).y;
        const uint32_t* row = coverage.owners.data() + size_t{y} * rect.width;
        for (uint32_t x = 0, end = 0; x < rect.width; x = end) {
            for (end = x + 1; end < rect.width && row[end] == row[x];)
                ++end;
            if (row[x] == Coverage::none) continue;
            fill_run({row[x], columns_.data() + rect.x + x, v, end - x}, stride, planes, met);
            planes += end - x;
        }
    }
    for (const UvSample& sample : coverage.samples) {
        const glm::dvec2 uv = layout_.uv(sample.place.x, sample.place.y);
        const std::array<double, interpolated_behind> u = {uv.x};
        fill_run({sample.triangle, u.data(), uv.y, 1}, stride, planes++, met);
    }
}

CornerValues TexelPoints::values_of(const Source& source, uint32_t triangle,
                                    const UvTriangle& uv) const {
    using Kind = CornerValues::Kind;
    const bool is_value = source.variant == Variant::value;
    if (source.input == SurfaceInput::facing_) return {Kind::constant, {is_value ? 1.0 : 0.0}};
    if (source.input == SurfaceInput::view_) return {};
    CornerValues values = {Kind::linear};
    for (size_t k = 0; k < 3; ++k) {
        const size_t vertex = mesh_.indices[3 * size_t{triangle} + k];
        values.at[k] = static_cast<double>(source.values[vertex * source.stride]);
    }
    if (is_value) return values;
    const glm::dvec3 change = source.variant == Variant::dy
                                  ? uv.dv() / static_cast<double>(layout_.height)
                                  : uv.du() / static_cast<double>(layout_.width);
    return {Kind::constant, {blend<double>(values.at[0], values.at[1], values.at[2], change)}};
}

const MetTriangles::Met& TexelPoints::meet(uint32_t triangle, MetTriangles& met) const {
    MetTriangles::Met& one = met.met[triangle % met.met.size()];
    if (one.triangle == triangle) return one;
    const auto uv = uv_triangle(mesh_, triangle);
    assert(uv);
    one.triangle = triangle;
    one.uv = *uv;
    one.values.clear();
    for (const Source& source : sources_)
        one.values.push_back(values_of(source, triangle, one.uv));
    return one;
}

void TexelPoints::fill_run(const Run& run, size_t stride, float* out, MetTriangles& met) const {
    const auto& [number, uv, values] = meet(run.triangle, met);
    TriangleRow row = {{uv.first.x, uv.first.y},
                       {uv.second.x, uv.second.y},
                       {uv.third.x, uv.third.y},
                       run.u,
                       run.v,
                       run.count};
    // Weights are linear along it, so its ends tell of all.
    row.outside = is_outside(uv.weights({run.u[0], run.v})) ||
                  is_outside(uv.weights({run.u[run.count - 1], run.v}));
    interpolate_(row, values.data(), values.size(), out, stride);
    for (size_t i = 0; has_view_ && i < sources_.size(); ++i)
        if (sources_[i].input == SurfaceInput::view_)
            fill_view(run, sources_[i], uv, row.outside, out + i * stride);
}

void TexelPoints::fill_view(const Run& run, const Source& source, const UvTriangle& triangle,
                            bool outside, float* out) const {
    const uint32_t* corners = mesh_.indices.data() + 3 * size_t{run.triangle};
    const auto at = [&](const glm::dvec3& w) {
        return blend<glm::dvec3>(mesh_.normals[corners[0]], mesh_.normals[corners[1]],
                                 mesh_.normals[corners[2]], w);
    };
    const glm::dvec3 change = source.variant == Variant::dy
                                  ? triangle.dv() / static_cast<double>(layout_.height)
                                  : triangle.du() / static_cast<double>(layout_.width);
    for (size_t i = 0; i < run.count; ++i) {
        const glm::dvec3 weights = triangle.weights({run.u[i], run.v});
        const glm::dvec3 normal = at(outside ? brought_back(weights) : weights);
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
