#include "bake/texel_points.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

#include "bake/mesh_check.h"
#include "cpu/kernels.h"

namespace wrinkle {
namespace {

glm::dvec3 clamped_to_triangle(const glm::dvec3& weights) {
    const glm::dvec3 inside = glm::max(weights, glm::dvec3(0));
    return inside / (inside.x + inside.y + inside.z);
}

bool is_outside(const glm::dvec3& weights) {
    return weights.x < 0 || weights.y < 0 || weights.z < 0;
}

}  // namespace

TexelPoints::TexelPoints(const Mesh& mesh, const Program& program, const UvLayout& layout)
    : mesh_(mesh),
      layout_(layout),
      columns_(layout.width + interpolate_padding),
      interpolate_(kernels_of(default_instruction_set()).interpolate) {
    assert(missing_input(mesh, program).empty());
    for (size_t i = 0; i < program.inputs.size(); ++i)
        add(program.inputs[i], i);
    for (uint32_t x = 0; x < layout.width; ++x)
        columns_[x] = layout.uv(x + 0.5, 0).x;
}

void TexelPoints::add(const Program::Input& input, size_t plane) {
    const bool is_value = input.variant == Variant::value;
    Source source = {plane, input.variant, input.lane};
    if (input.input == SurfaceInput::facing_) {
        constants_.push_back({is_value ? 1.0F : 0.0F, plane});
    } else if (input.input == SurfaceInput::uv0_ && is_value) {
        uvs_.push_back(source);
    } else if (input.input == SurfaceInput::uv0_) {
        const uint32_t along = input.variant == Variant::dx ? 0 : 1;
        const double texel = 1.0 / (along == 0 ? layout_.width : layout_.height);
        constants_.push_back({input.lane == along ? static_cast<float>(texel) : 0.0F, plane});
    } else if (input.input == SurfaceInput::view_) {
        views_.push_back(source);
    } else {
        const MeshAttribute attribute = attribute_of(mesh_, input.input);
        source.values = attribute.values + input.lane;
        source.stride = attribute.stride;
        (is_value ? linear_ : changes_).push_back(source);
    }
}

size_t TexelPoints::count(const Coverage& coverage) {
    return coverage.owned + coverage.samples.size();
}

void TexelPoints::fill_constants(size_t stride, float* planes) const {
    for (const FlatInput& constant : constants_)
        std::fill_n(planes + constant.plane * stride, stride, constant.value);
}

void TexelPoints::fill(const Coverage& coverage, const TexelRect& rect, size_t stride,
                       float* planes, TriangleCache& cache) const {
    if (!planes) return;  // the program has no inputs
    float* out = planes;
    for (uint32_t y = 0; y < rect.height; ++y) {
        const uint32_t* owners = coverage.owners.data() + size_t{y} * rect.width;
        out = fill_row({owners, rect.width}, columns_.data() + rect.x,
                       layout_.uv(0, rect.y + y + 0.5).y, stride, out, cache);
    }
    for (const UvSample& sample : coverage.samples) {
        const glm::dvec2 uv = layout_.uv(sample.position.x, sample.position.y);
        const std::array<double, interpolate_padding> u = {uv.x};
        out = fill_row({&sample.triangle, 1}, u.data(), uv.y, stride, out, cache);
    }
}

// Fills one run of texels with the same owner after the other.
float* TexelPoints::fill_row(std::span<const uint32_t> owners, const double* u, double v,
                             size_t stride, float* out, TriangleCache& cache) const {
    for (size_t first = 0, end = 0; first < owners.size(); first = end) {
        const uint32_t owner = owners[first];
        for (end = first + 1; end < owners.size() && owners[end] == owner;)
            ++end;
        if (owner == Coverage::none) continue;
        CachedTriangle& triangle = cache[owner % cache.size()];
        if (triangle.triangle != owner) insert(owner, triangle);
        const PointRow run = {u + first, v, end - first};
        interpolate_(triangle.planes, run, out, stride);
        for (const Source& source : views_)
            fill_view(triangle, run, source, out + source.plane * stride);
        fill_uvs(run, stride, out);
        out += run.count;
    }
    return out;
}

glm::dvec3 TexelPoints::change(const UvTriangle& triangle, Variant variant) const {
    return variant == Variant::dy ? triangle.dv() / static_cast<double>(layout_.height)
                                  : triangle.du() / static_cast<double>(layout_.width);
}

void TexelPoints::insert(uint32_t triangle, CachedTriangle& one) const {
    const auto uv = uv_triangle(mesh_, triangle);
    assert(uv);
    one.triangle = triangle;
    one.uv = *uv;
    const uint32_t* corners = mesh_.indices.data() + 3 * size_t{triangle};
    const auto at = [&](const Source& source, size_t k) {
        return source.values[size_t{corners[k]} * source.stride];
    };
    one.linear.clear();
    one.constant.clear();
    for (const Source& source : linear_)
        one.linear.push_back({{at(source, 0), at(source, 1), at(source, 2)}, source.plane});
    for (const Source& source : changes_) {
        const double value = blend<double>(at(source, 0), at(source, 1), at(source, 2),
                                           change(one.uv, source.variant));
        one.constant.push_back({static_cast<float>(value), source.plane});
    }
    one.planes = {{uv->first.x, uv->first.y}, {uv->second.x, uv->second.y},
                  {uv->third.x, uv->third.y}, one.linear.data(),
                  one.linear.size(),          one.constant.data(),
                  one.constant.size()};
}

void TexelPoints::fill_uvs(const PointRow& row, size_t stride, float* out) const {
    for (const Source& source : uvs_) {
        float* to = out + source.plane * stride;
        for (size_t i = 0; i < row.count; ++i)
            to[i] = static_cast<float>(source.lane == 0 ? row.u[i] : row.v);
    }
}

void TexelPoints::fill_view(const CachedTriangle& one, const PointRow& row, const Source& source,
                            float* out) const {
    const uint32_t* corners = mesh_.indices.data() + 3 * size_t{one.triangle};
    const auto at = [&](const glm::dvec3& w) {
        return blend<glm::dvec3>(mesh_.normals[corners[0]], mesh_.normals[corners[1]],
                                 mesh_.normals[corners[2]], w);
    };
    for (size_t i = 0; i < row.count; ++i) {
        const glm::dvec3 weights = one.uv.weights({row.u[i], row.v});
        const glm::dvec3 normal = at(is_outside(weights) ? clamped_to_triangle(weights) : weights);
        const double length = glm::length(normal);
        const glm::dvec3 unit = normal / length;
        glm::dvec3 value = unit;
        if (source.variant != Variant::value) {
            const glm::dvec3 moved = at(change(one.uv, source.variant));
            value = (moved - unit * glm::dot(unit, moved)) / length;
        }
        out[i] = static_cast<float>(value[static_cast<int>(source.lane)]);
    }
}

}  // namespace wrinkle
