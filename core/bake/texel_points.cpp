#include "bake/texel_points.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
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

// Returns null values for an attribute that the mesh lacks.
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

// Returns true if interpolation by any weights that sum to 1 yields exactly this float: the
// rounding error of that sum is below float precision. Excludes -0, as a sum of zeros may have
// either sign.
bool is_constant(float a, float b, float c) {
    const auto bits = std::bit_cast<uint32_t>(a);
    return bits == std::bit_cast<uint32_t>(b) && bits == std::bit_cast<uint32_t>(c) &&
           (a != 0 || bits == 0) && std::isfinite(a);
}

constexpr uint32_t max_in_row = 64;
static_assert(std::endian::native == std::endian::little, "bytes are gathered into bits");

// Returns a bit mask over up to max_in_row texels: set if the next texel has another owner, and
// for the last texel. Computed without a branch per texel, which would be unpredictable.
uint64_t ends_of_runs(std::span<const uint32_t> owners) {
    std::array<uint8_t, max_in_row> is_end{};
    const size_t last = owners.size() - 1;
    for (size_t x = 0; x < last; ++x)
        is_end[x] = owners[x] != owners[x + 1];
    is_end[last] = 1;
    uint64_t ends = 0;
    for (size_t k = 0; k < sizeof ends; ++k) {
        uint64_t bytes = 0;  // 8 bytes of 0 or 1; the product moves byte i to bit 56 + i
        std::memcpy(&bytes, is_end.data() + k * sizeof bytes, sizeof bytes);
        ends |= (bytes * 0x0102040810204080) >> 56 << (8 * k);
    }
    return ends;
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
        places_.push_back(source);
    } else if (input.input == SurfaceInput::uv0_) {
        const uint32_t along = input.variant == Variant::dx ? 0 : 1;
        const double texel = 1.0 / (along == 0 ? layout_.width : layout_.height);
        constants_.push_back({input.lane == along ? static_cast<float>(texel) : 0.0F, plane});
    } else if (input.input == SurfaceInput::view_) {
        views_.push_back(source);
    } else {
        const Attribute attribute = attribute_of(mesh_, input.input);
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
                       float* planes, TriangleCache& met) const {
    float* out = planes;
    for (uint32_t y = 0; y < rect.height; ++y)
        for (uint32_t x = 0; x < rect.width; x += max_in_row) {
            const uint32_t* owners = coverage.owners.data() + size_t{y} * rect.width + x;
            out = fill_row({owners, std::min(rect.width - x, max_in_row)},
                           columns_.data() + rect.x + x, layout_.uv(0, rect.y + y + 0.5).y, stride,
                           out, met);
        }
    for (const UvSample& sample : coverage.samples) {
        const glm::dvec2 uv = layout_.uv(sample.position.x, sample.position.y);
        const std::array<double, interpolate_padding> u = {uv.x};
        out = fill_row({&sample.triangle, 1}, u.data(), uv.y, stride, out, met);
    }
}

float* TexelPoints::fill_row(std::span<const uint32_t> owners, const double* u, double v,
                             size_t stride, float* out, TriangleCache& met) const {
    size_t first = 0, covered = 0;  // covered: start of the current covered texels
    const auto fill_covered = [&](size_t end) {
        const size_t count = end - covered;
        if (count > 0) fill_places({u + covered, v, count}, stride, out - count);
    };
    for (uint64_t ends = ends_of_runs(owners); ends != 0; ends &= ends - 1) {
        const auto end = static_cast<size_t>(std::countr_zero(ends)) + 1;
        if (owners[first] == Coverage::none) {
            fill_covered(first);
            covered = end;
        } else {
            // Most runs are short, and their triangles are cached.
            TriangleCache::Met& one = met.met[owners[first] % met.met.size()];
            if (one.triangle != owners[first]) learn(owners[first], one);
            const PlaceRow run = {u + first, v, end - first};
            interpolate_(one.planes, run, out, stride);
            for (const Source& source : views_)
                fill_view(one, run, source, out + source.plane * stride);
            out += run.count;
        }
        first = end;
    }
    fill_covered(owners.size());
    return out;
}

glm::dvec3 TexelPoints::change(const UvTriangle& triangle, Variant variant) const {
    return variant == Variant::dy ? triangle.dv() / static_cast<double>(layout_.height)
                                  : triangle.du() / static_cast<double>(layout_.width);
}

void TexelPoints::learn(uint32_t triangle, TriangleCache::Met& one) const {
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
    for (const Source& source : linear_) {
        const float a = at(source, 0), b = at(source, 1), c = at(source, 2);
        if (is_constant(a, b, c))
            one.constant.push_back({a, source.plane});
        else
            one.linear.push_back({{a, b, c}, source.plane});
    }
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

void TexelPoints::fill_places(const PlaceRow& row, size_t stride, float* out) const {
    for (const Source& source : places_) {
        float* to = out + source.plane * stride;
        for (size_t i = 0; i < row.count; ++i)
            to[i] = static_cast<float>(source.lane == 0 ? row.u[i] : row.v);
    }
}

void TexelPoints::fill_view(const TriangleCache::Met& one, const PlaceRow& row,
                            const Source& source, float* out) const {
    const uint32_t* corners = mesh_.indices.data() + 3 * size_t{one.triangle};
    const auto at = [&](const glm::dvec3& w) {
        return blend<glm::dvec3>(mesh_.normals[corners[0]], mesh_.normals[corners[1]],
                                 mesh_.normals[corners[2]], w);
    };
    for (size_t i = 0; i < row.count; ++i) {
        const glm::dvec3 weights = one.uv.weights({row.u[i], row.v});
        const glm::dvec3 normal = at(is_outside(weights) ? brought_back(weights) : weights);
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
