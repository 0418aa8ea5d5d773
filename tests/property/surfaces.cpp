#include "property/surfaces.h"

#include <algorithm>
#include <cmath>

namespace wrinkle::test {
namespace {

constexpr double shape_step = 1e-3;
// Small relative to the waves of all heights in these tests, large relative to rounding errors.
constexpr double height_step = 1e-5;

std::function<dvec2(dvec2)> scaled(double a, double b) {
    return [=](dvec2 st) { return dvec2(a * st.x + 0.3, b * st.y - 0.2); };
}

// Skewed, mirrored and bent, as uvs made by artists are.
std::function<dvec2(dvec2)> bent(double a, double b) {
    return [=](dvec2 st) {
        return dvec2(a * st.x * 0.8 + b * st.y * 0.5 + 0.1 * a * std::sin(st.y),
                     a * st.x * 0.4 - b * st.y * 0.9 + 0.1 * b * std::sin(2 * st.x));
    };
}

const dvec3 plane_u(0.8, 0.36, 0.48), plane_v(-0.6, 0.48, 0.64);

void set2(Surroundings& around, SurfaceInput input, dvec2 v, Variant variant) {
    set(around, input, {v.x, v.y}, variant);
}

void set_tangent(Surroundings& around, const Surface& surface, dvec2 st) {
    const auto d = [&](const auto& f, dvec2 axis) { return along(f, st, axis, shape_step); };
    const dvec2 s(1, 0), t(0, 1);
    const dmat2 uv_of_st(d(surface.uv0, s), d(surface.uv0, t));
    const dmat2 st_of_uv = glm::inverse(uv_of_st);
    const auto towards = [&](int axis) {
        return d(surface.position, s) * st_of_uv[axis].x +
               d(surface.position, t) * st_of_uv[axis].y;
    };
    const dvec3 u = glm::normalize(towards(0));
    const bool right_handed = glm::dot(glm::cross(surface.normal(st), u), towards(1)) > 0;
    set(around, SurfaceInput::tangent_, {u.x, u.y, u.z, right_handed ? 1.0 : -1.0});
}

}  // namespace

Surface sphere() {
    const double r = 2;
    const auto normal = [](dvec2 p) {
        return dvec3(std::cos(p.x) * std::cos(p.y), std::sin(p.x) * std::cos(p.y), std::sin(p.y));
    };
    return {"sphere", r, [=](dvec2 p) { return normal(p) * r; }, normal, scaled(r, r), bent(r, r)};
}

Surface torus() {
    const double ring = 1, r = 0.4;
    const auto position = [=](dvec2 p) {
        const double reach = ring + r * std::cos(p.y);
        return dvec3(reach * std::cos(p.x), reach * std::sin(p.x), r * std::sin(p.y));
    };
    const auto normal = [](dvec2 p) {
        return dvec3(std::cos(p.y) * std::cos(p.x), std::cos(p.y) * std::sin(p.x), std::sin(p.y));
    };
    return {"torus", r, position, normal, scaled(ring, r), bent(ring, r)};
}

Surface tilted_plane() {
    Surface plane = plane_with(dmat2(1));
    plane.uv0 = scaled(1, 1);
    return plane;
}

Surface plane_with(dmat2 uv0_of_length) {
    return {"tilted plane",
            1,
            [](dvec2 p) { return plane_u * p.x + plane_v * p.y + dvec3(1, 2, 3); },
            [](dvec2) { return glm::cross(plane_u, plane_v); },
            [=](dvec2 p) { return uv0_of_length * p + dvec2(0.25, 0.5); },
            bent(1, 1)};
}

Surface cylinder_with(dmat2 uv0_of_length) {
    const double r = 1.5;
    const auto normal = [](dvec2 p) { return dvec3(std::cos(p.x), std::sin(p.x), 0); };
    return {"cylinder",
            r,
            [=](dvec2 p) { return normal(p) * r + dvec3(0, 0, p.y); },
            normal,
            [=](dvec2 p) { return uv0_of_length * dvec2(r * p.x, p.y); },
            bent(r, 1)};
}

void set(Surroundings& around, SurfaceInput input, std::initializer_list<double> lanes,
         Variant variant) {
    Lanes& place = around.inputs[input_extra(input, variant)];
    place = {};
    std::copy(lanes.begin(), lanes.end(), place.begin());
}

Surroundings values_at(const Surface& surface, dvec2 st) {
    Surroundings around;
    set3(around, SurfaceInput::position_, surface.position(st), Variant::value);
    set3(around, SurfaceInput::normal_, surface.normal(st), Variant::value);
    set2(around, SurfaceInput::uv0_, surface.uv0(st), Variant::value);
    set2(around, SurfaceInput::uv1_, surface.uv1(st), Variant::value);
    set_tangent(around, surface, st);
    set(around, SurfaceInput::facing_, {1});
    return around;
}

Surroundings point_at(const Surface& surface, dvec2 st, const dmat2& pixel) {
    Surroundings around = values_at(surface, st);
    for (const Variant variant : {Variant::dx, Variant::dy}) {
        const dvec2 direction = pixel[variant == Variant::dx ? 0 : 1];
        // Scaled afterwards, because pixels may be tiny.
        const double size = glm::length(direction);
        const auto d = [&](const auto& f) {
            return along(f, st, direction / size, shape_step) * size;
        };
        set3(around, SurfaceInput::position_, d(surface.position), variant);
        set3(around, SurfaceInput::normal_, d(surface.normal), variant);
        set2(around, SurfaceInput::uv0_, d(surface.uv0), variant);
        set2(around, SurfaceInput::uv1_, d(surface.uv1), variant);
    }
    return around;
}

dvec3 displaced_normal(const Surface& surface, const std::function<double(dvec2)>& height,
                       dvec2 st) {
    const auto displaced = [&](dvec2 p) {
        return surface.position(p) + surface.normal(p) * height(p);
    };
    const dvec3 n = glm::normalize(glm::cross(along(displaced, st, dvec2(1, 0), height_step),
                                              along(displaced, st, dvec2(0, 1), height_step)));
    return glm::dot(n, surface.normal(st)) < 0 ? -n : n;
}

std::vector<Sample> samples(int count, unsigned seed) {
    std::mt19937 random(seed);
    const auto number = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    std::vector<Sample> result;
    for (int i = 0; i < count; ++i) {
        const dvec2 st{number(-3, 3), number(-1.1, 1.1)};  // braces fix the evaluation order
        const double turn = number(0, 6.28), skew = number(-0.5, 0.5), size = number(1e-4, 1e-2);
        const dvec2 x(std::cos(turn), std::sin(turn));
        const dvec2 y(-x.y, x.x);
        result.push_back({st, dmat2(x * size, (y * (i % 2 ? 1.0 : -1.0) + x * skew) * size)});
    }
    return result;
}

dvec3 to_vec3(const Lanes& lanes) {
    return {lanes[0], lanes[1], lanes[2]};
}

void set3(Surroundings& around, SurfaceInput input, dvec3 v, Variant variant) {
    set(around, input, {v.x, v.y, v.z}, variant);
}

dvec3 normal_of(const Surroundings& around) {
    return to_vec3(around.inputs.at(input_extra(SurfaceInput::normal_, Variant::value)));
}

void set_free(Surroundings& around, dvec3 v) {
    set(around, free_vector, {v.x, v.y, v.z, 1});
}

}  // namespace wrinkle::test
