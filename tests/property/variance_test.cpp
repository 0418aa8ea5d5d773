// Tests of the variance of a normal caused by the variance of its slopes, against normals resolved
// for many such slopes: unit normals of mean m have covariances of trace 1 - |m|^2.
#include <gtest/gtest.h>

#include <cmath>

#include "property/material.h"

namespace wrinkle::test {
namespace {

// Deviation of the slopes; small, because the result is accurate to first order.
constexpr double spread = 0.02;

// Lower triangles of the two covariances: deviations are these times independent normal numbers.
struct Factor {
    double xx, yx, yy;
};
constexpr Factor first{1.0, 0.4, 0.7}, second{0.6, -0.5, 0.9};

Value covariance_of(Material& m, const Factor& f) {
    const double s = spread * spread;
    return m.vector(dvec3(f.xx * f.xx, f.yx * f.yx + f.yy * f.yy, f.xx * f.yx) * s);
}

// Two slopes with variance; the deviations are the free input: either added as numbers, to be
// resolved for each deviation, or declared as variance.
struct Slopes {
    Value a, b;
};

using Layering = Value (*)(Material&, const Slopes&);

Value free_of(Material& m) {
    return m.input(free_vector);
}

Slopes slopes(Material& m, bool said) {
    const Value c = free_of(m);
    Slopes s{m.vector(dvec2(0.35, -0.2)) + vec2(c.x(), c.y()),
             m.vector(dvec2(-0.1, 0.25)) + vec2(c.z(), c.w())};
    if (!said) return s;
    return {op(Op::with_covariance_, s.a, covariance_of(m, first)),
            op(Op::with_covariance_, s.b, covariance_of(m, second))};
}

// Five points of the normal distribution that are exact up to the ninth moment (Gauss-Hermite).
struct Node {
    double at, weight;
};
const std::array<Node, 5> nodes{{{0, 8.0 / 15},
                                 {std::sqrt(5 - std::sqrt(10)), (7 + 2 * std::sqrt(10)) / 60},
                                 {-std::sqrt(5 - std::sqrt(10)), (7 + 2 * std::sqrt(10)) / 60},
                                 {std::sqrt(5 + std::sqrt(10)), (7 - 2 * std::sqrt(10)) / 60},
                                 {-std::sqrt(5 + std::sqrt(10)), (7 - 2 * std::sqrt(10)) / 60}}};

void set_deviations(Surroundings& around, const std::array<double, 4>& z) {
    set(around, free_vector,
        {spread * first.xx * z[0], spread * (first.yx * z[0] + first.yy * z[1]),
         spread * second.xx * z[2], spread * (second.yx * z[2] + second.yy * z[3])});
}

// The mean of the resolved unit normals n, and that of n n^T.
struct Moments {
    dvec3 first;
    glm::dmat3 second;

    double covariance(dvec3 a, dvec3 b) const {
        return glm::dot(a, second * b) - glm::dot(a, first) * glm::dot(b, first);
    }
};

Moments moments_of_resolved(const Expanded& material, Surroundings around) {
    Moments moments{dvec3(0), glm::dmat3(0)};
    for (size_t i = 0; i < 625; ++i) {
        const std::array<size_t, 4> k{i % 5, i / 5 % 5, i / 25 % 5, i / 125};
        double weight = 1;
        std::array<double, 4> z{};
        for (size_t j = 0; j < 4; ++j) {
            weight *= nodes[k[j]].weight;
            z[j] = nodes[k[j]].at;
        }
        set_deviations(around, z);
        const dvec3 normal = material.vector(0, around);
        moments.first += normal * weight;
        moments.second += glm::outerProduct(normal, normal) * weight;
    }
    return moments;
}

void expect_said_is_seen(Layering bump) {
    Material seen, said;
    seen.output("normal", seen.resolve(bump(seen, slopes(seen, false))));
    const Value gradient = bump(said, slopes(said, true)), normal = said.resolve(gradient);
    const Value x = op(Op::normalize_, cross(normal, said.vector(dvec3(0.3, 0.9, -0.4))));
    said.output("variance", op(Op::normal_variance_, gradient));
    said.output("normal", normal);
    said.output("x", x);
    said.output("covariance", op(Op::normal_covariance_, gradient, x));
    const Expanded resolved(seen), stated(said);
    for (const Surface& surface : {sphere(), torus(), tilted_plane()})
        for (const Sample& sample : samples(3, 5)) {
            Surroundings around = point_at(surface, sample.st, sample.pixel);
            set_deviations(around, {});
            const Moments wanted = moments_of_resolved(resolved, around);
            const double variance = 1 - glm::dot(wanted.first, wanted.first);
            ASSERT_GT(variance, 1e-6) << surface.name;
            EXPECT_NEAR(stated.number(0, around) / variance, 1, 0.01) << surface.name;
            const dvec3 along = stated.vector(2, around), covariance = stated.vector(3, around);
            const dvec3 across = glm::cross(stated.vector(1, around), along);
            EXPECT_NEAR(covariance.x, wanted.covariance(along, along), 0.01 * variance);
            EXPECT_NEAR(covariance.y, wanted.covariance(across, across), 0.01 * variance);
            EXPECT_NEAR(covariance.z, wanted.covariance(along, across), 0.01 * variance);
        }
}

Value derived(Material& m, Value slope) {
    return m.from_slope(slope, m.frame(m.uv1(), WR_FRAME_derived, WR_SCALE_unit));
}
Value vertex(Material& m, Value slope) {
    return m.from_slope(slope, m.frame(m.uv0(), WR_FRAME_vertex, WR_SCALE_unit));
}

TEST(Variance, OfOneBump) {
    expect_said_is_seen([](Material& m, const Slopes& s) { return derived(m, s.a); });
}

TEST(Variance, GoesWithTheSquareOfTheAmount) {
    expect_said_is_seen(
        [](Material& m, const Slopes& s) { return m.scale(derived(m, s.a), -1.7); });
}

TEST(Variance, PassesFramesThatStretchAndSkew) {
    expect_said_is_seen([](Material& m, const Slopes& s) {
        return m.from_slope(s.a * 0.3, m.frame(m.uv1(), WR_FRAME_exact, WR_SCALE_surface));
    });
}

TEST(Variance, PassesTilings) {
    expect_said_is_seen([](Material& m, const Slopes& s) {
        const Value skewed = vec2(m.uv0().x() * 3 + m.uv0().y(), m.uv0().y() * 0.5);
        return m.from_slope(s.a, m.frame(skewed, WR_FRAME_vertex, WR_SCALE_unit));
    });
}

TEST(Variance, OfIndependentBumpsAdds) {
    expect_said_is_seen([](Material& m, const Slopes& s) {
        return m.add(vertex(m, s.a), m.scale(derived(m, s.b), 0.6));
    });
}

TEST(Variance, OfOneSourceMetTwiceIsThatOfItsSum) {
    expect_said_is_seen([](Material& m, const Slopes& s) {
        return m.add(vertex(m, s.a), m.scale(derived(m, s.a), 0.8));
    });
}

TEST(Variance, OfAMixtureTakesBothSquares) {
    expect_said_is_seen([](Material& m, const Slopes& s) {
        return m.mix_gradients(vertex(m, s.a), derived(m, s.b), 0.3);
    });
}

TEST(Variance, OfTangentNormals) {
    expect_said_is_seen([](Material& m, const Slopes& s) {
        const auto normal = [&](Value xy) { return vec3(xy, m.number(0.8)); };
        const Value frame = m.frame(m.uv0(), WR_FRAME_vertex, WR_SCALE_unit);
        return m.add(m.from_tangent_normal(normal(s.a), frame, 1.2),
                     m.from_tangent_normal(normal(s.b), frame));
    });
}

// The base rotates as well, together with the bump on it.
TEST(Variance, OfABumpOnABump) {
    expect_said_is_seen([](Material& m, const Slopes& s) {
        const Value base = op(Op::base_, m.resolve(vertex(m, s.a)));
        const Value frame = m.frame(m.uv1(), WR_FRAME_derived, WR_SCALE_unit);
        const Value d = op(Op::derivative_, s.b, frame);
        return Value{&m.module, m.module.add(Op::gradient_from_derivative_, {d.id}, base.id)};
    });
}

TEST(Variance, OfObjectNormals) {
    const auto normal = [](Material& m) {
        const Value c = free_of(m);
        return m.input(SurfaceInput::normal_) + m.vector(dvec3(0.3, -0.2, 0.25)) +
               vec3(c.x(), c.y(), c.z());
    };
    Material seen, said;
    seen.output("normal", seen.resolve(seen.from_normal(normal(seen))));
    const Value varies = op(Op::with_covariance_, normal(said), said.number(spread * spread));
    said.output("variance", op(Op::normal_variance_, said.from_normal(varies)));
    const Expanded resolved(seen), stated(said);
    for (const Sample& sample : samples(5, 6)) {
        Surroundings around = point_at(sphere(), sample.st, sample.pixel);
        dvec3 mean(0);
        for (size_t i = 0; i < 125; ++i) {
            const Node &x = nodes[i % 5], &y = nodes[i / 5 % 5], &z = nodes[i / 25];
            set_free(around, dvec3(x.at, y.at, z.at) * spread);
            mean += resolved.vector(0, around) * (x.weight * y.weight * z.weight);
        }
        set_free(around, dvec3(0));
        EXPECT_NEAR(stated.number(0, around) / (1 - glm::dot(mean, mean)), 1, 0.01);
    }
}

TEST(Variance, OfWhatDoesNotVaryIsZero) {
    Material m;
    const Value flat = m.flat(), bump = m.from_height(m.uv0().x() * 0.2);
    m.output("flat", op(Op::normal_variance_, flat));
    m.output("bump", op(Op::normal_variance_, bump));
    const Expanded material(m);
    const Surroundings around = values_at(sphere(), {0.4, 0.3});
    EXPECT_EQ(material.number(0, around), 0);
    EXPECT_EQ(material.number(1, around), 0);
}

// A declared variance does not change the value itself.
TEST(Variance, LeavesTheNormalAsItIs) {
    Material plain, said;
    plain.output("normal", plain.resolve(vertex(plain, slopes(plain, false).a)));
    const Value bump = vertex(said, slopes(said, true).a);
    said.output("normal", said.resolve(bump));
    said.output("variance", op(Op::normal_variance_, bump));
    const Expanded without(plain), with(said);
    for (const Sample& sample : samples(5, 7)) {
        const Surroundings around = point_at(torus(), sample.st, sample.pixel);
        EXPECT_EQ(without.vector(0, around), with.vector(0, around));
    }
}

}  // namespace
}  // namespace wrinkle::test
