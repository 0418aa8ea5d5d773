#include "nodes/solid.h"

#include <cmath>

namespace wrinkle::test {

Vector operator+(Vector a, Vector b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vector operator-(Vector a, Vector b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vector operator*(Vector a, double k) {
    return {a.x * k, a.y * k, a.z * k};
}
double dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vector cross(Vector a, Vector b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vector unit(Vector a) {
    return a * (1 / std::sqrt(dot(a, a)));
}
Vector vector_of(const std::vector<double>& lanes) {
    return {lanes.at(0), lanes.at(1), lanes.at(2)};
}

std::vector<Place> on_sphere(int count) {
    std::vector<Place> places;
    for (int i = 0; i < count; ++i) {
        const double y = 1 - 2 * (i + 0.5) / count, turn = i * 2.399963229728653;
        const double r = std::sqrt(1 - y * y);
        const Vector p{r * std::cos(turn), y, r * std::sin(turn)};
        places.push_back({p, p});
    }
    return places;
}

Vector side(int index) {
    const double sign = index % 2 ? -1 : 1;
    return {index / 2 == 0 ? sign : 0, index / 2 == 1 ? sign : 0, index / 2 == 2 ? sign : 0};
}

Seen seen_from_outside(int index) {
    const Vector out = side(index);
    const Vector up = index / 2 == 1 ? Vector{0, 0, -out.y} : Vector{0, 1, 0};
    return {cross(up, out), up};
}

namespace {

struct Tangents {
    Vector a, b;
};
Tangents tangents_of(Vector n) {
    const Vector a = unit(cross(std::fabs(n.x) < 0.8 ? Vector{1, 0, 0} : Vector{0, 1, 0}, n));
    return {a, cross(n, a)};
}

void append(PointSet& set, SurfaceInput input, Variant variant, Vector v) {
    for (const double lane : {v.x, v.y, v.z})
        set.at(input, variant).push_back(lane);
}

Vector displaced(Vector normal, const std::function<Vector(double, double)>& moved) {
    constexpr double step = 1e-5;
    const Vector along_a = moved(step, 0) - moved(-step, 0);
    const Vector along_b = moved(0, step) - moved(0, -step);
    const Vector n = unit(cross(along_a, along_b));
    return n * (dot(n, normal) < 0 ? -1 : 1);
}

}  // namespace

std::vector<std::vector<double>> values_on(const Scene& scene, const std::vector<Place>& places,
                                           double size) {
    PointSet set;
    set.count = places.size();
    for (const Place& place : places) {
        const Tangents t = tangents_of(place.normal);
        append(set, SurfaceInput::position_, Variant::value, place.position);
        append(set, SurfaceInput::position_, Variant::dx, t.a * size);
        append(set, SurfaceInput::position_, Variant::dy, t.b * size);
        append(set, SurfaceInput::normal_, Variant::value, place.normal);
        append(set, SurfaceInput::normal_, Variant::dx, t.a * size);
        append(set, SurfaceInput::normal_, Variant::dy, t.b * size);
        for (const Variant variant : {Variant::value, Variant::dx, Variant::dy})
            for (const double lane : {0.0, 0.0})
                set.at(SurfaceInput::uv0_, variant).push_back(lane);
        set.at(SurfaceInput::facing_).push_back(1);
        append(set, SurfaceInput::view_, Variant::value, place.normal);
    }
    return values(scene, set);
}

std::vector<double> value_on(const Scene& scene, Place place, double size) {
    const auto all = values_on(scene, {place}, size);
    return all.empty() ? std::vector<double>(4) : all[0];
}

Vector displaced_on_sphere(Vector place, const std::function<double(Vector)>& height) {
    const Tangents t = tangents_of(place);
    return displaced(place, [&](double a, double b) {
        const Vector p = unit(place + t.a * a + t.b * b);
        return p * (1 + height(p));
    });
}

Vector displaced_on_plane(Place place, const std::function<double(Vector)>& height) {
    const Tangents t = tangents_of(place.normal);
    return displaced(place.normal, [&](double a, double b) {
        const Vector p = place.position + t.a * a + t.b * b;
        return p + place.normal * height(p);
    });
}

}  // namespace wrinkle::test
