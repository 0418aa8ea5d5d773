#include "certify/points.h"

#include <cmath>
#include <random>

#include "cpu/columns.h"
#include "ir/op.h"

namespace wrinkle::certify {
namespace {

constexpr Variant variants[] = {Variant::value, Variant::dx, Variant::dy};

// In the order of degenerate_points().
constexpr std::string_view degenerate_names[] = {
    "no uv changes between pixels",      "the position does not change between pixels",
    "no value changes between pixels",   "the tangent is zero",
    "the tangent's w is zero",           "the view vector is zero",
    "everything but the normal is zero", "position and uvs are a thousand times as large",
    "pixels are a millionth in size",
};

using Numbers = std::array<double, 4>;

class Draw {
public:
    explicit Draw(unsigned seed) : random_(seed) {}
    double number(double low, double high) {
        return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
    }
    // Returns a random unit vector, by rejection.
    Numbers direction() {
        for (;;) {
            const Numbers v{number(-1, 1), number(-1, 1), number(-1, 1)};
            const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
            if (square < 0.05 || square > 1) continue;
            const double scale = 1 / std::sqrt(square);
            return {v[0] * scale, v[1] * scale, v[2] * scale};
        }
    }

private:
    std::mt19937 random_;
};

void append(PointSet& set, SurfaceInput input, Variant variant, const Numbers& numbers) {
    std::vector<double>& values = set.at(input, variant);
    for (size_t i = 0; i < lanes_of(InputNeed{input, variant}); ++i)
        values.push_back(static_cast<double>(static_cast<float>(numbers[i])));
}

// Returns the component of `along` orthogonal to the unit vector n.
Numbers in_plane(const Numbers& along, const Numbers& n) {
    const double k = along[0] * n[0] + along[1] * n[1] + along[2] * n[2];
    return {along[0] - k * n[0], along[1] - k * n[1], along[2] - k * n[2]};
}
Numbers times(const Numbers& v, double k) {
    return {v[0] * k, v[1] * k, v[2] * k, v[3] * k};
}

// Appends the normal, the tangent and all differentials of one point; the position changes by 2^-12
// to 2^-4 per pixel.
void append_frame(PointSet& set, Draw& draw) {
    const Numbers n = draw.direction();
    append(set, SurfaceInput::normal_, Variant::value, times(n, draw.number(0.85, 1)));
    Numbers tangent = in_plane(draw.direction(), n);
    tangent[3] = draw.number(-1, 1) < 0 ? -1 : 1;
    append(set, SurfaceInput::tangent_, Variant::value, tangent);
    const double pixel = std::exp2(draw.number(-12, -4));
    Numbers dx = in_plane(draw.direction(), n), dy = in_plane(draw.direction(), n);
    // dy is n x dx or its negative plus 0.3 times a random vector, so that pixel footprints are not
    // degenerate.
    const Numbers across{n[1] * dx[2] - n[2] * dx[1], n[2] * dx[0] - n[0] * dx[2],
                         n[0] * dx[1] - n[1] * dx[0]};
    const double side = draw.number(-1, 1) < 0 ? -1 : 1;
    for (size_t i = 0; i < 3; ++i)
        dy[i] = 0.3 * dy[i] + side * across[i];
    append(set, SurfaceInput::position_, Variant::dx, times(dx, pixel));
    append(set, SurfaceInput::position_, Variant::dy, times(dy, pixel));
    for (const Variant variant : {Variant::dx, Variant::dy}) {
        append(set, SurfaceInput::normal_, variant, times(in_plane(draw.direction(), n), pixel));
        append(set, SurfaceInput::tangent_, variant, {});
        append(set, SurfaceInput::view_, variant, {});
        append(set, SurfaceInput::facing_, variant, {});
        append(set, SurfaceInput::color0_, variant,
               times({draw.number(-1, 1), draw.number(-1, 1), draw.number(-1, 1), 0.1}, pixel));
    }
    for (int uv = 0; uv < 4; ++uv) {
        const auto input = static_cast<SurfaceInput>(static_cast<int>(SurfaceInput::uv0_) + uv);
        const double turn = draw.number(0, 6.28), mirror = draw.number(-1, 1) < 0 ? -1 : 1;
        const double size = pixel * draw.number(0.3, 1), skew = draw.number(-0.4, 0.4);
        append(set, input, Variant::dx, {std::cos(turn) * size, std::sin(turn) * size});
        append(set, input, Variant::dy,
               {(skew - std::sin(turn)) * size * mirror, std::cos(turn) * size * mirror});
    }
}

void clear(PointSet& set, size_t point, SurfaceInput input, Variant variant) {
    const size_t lanes = lanes_of(InputNeed{input, variant});
    for (size_t i = 0; i < lanes; ++i)
        set.at(input, variant)[point * lanes + i] = 0;
}

// Sets both differentials to zero.
void clear_changes(PointSet& set, size_t point, SurfaceInput input) {
    clear(set, point, input, Variant::dx);
    clear(set, point, input, Variant::dy);
}

void clear_all_uv_changes(PointSet& set, size_t point) {
    for (const SurfaceInput uv :
         {SurfaceInput::uv0_, SurfaceInput::uv1_, SurfaceInput::uv2_, SurfaceInput::uv3_})
        clear_changes(set, point, uv);
}

void scale(PointSet& set, size_t point, Variant variant, double factor) {
    for (const SurfaceInput input : {SurfaceInput::position_, SurfaceInput::uv0_,
                                     SurfaceInput::uv1_, SurfaceInput::uv2_, SurfaceInput::uv3_}) {
        const size_t lanes = lanes_of(InputNeed{input, variant});
        for (size_t i = 0; i < lanes; ++i) {
            double& x = set.at(input, variant)[point * lanes + i];
            x = static_cast<double>(static_cast<float>(x * factor));
        }
    }
}

}  // namespace

PointSet random_points(size_t count, unsigned seed, UvRange uvs) {
    Draw draw(seed);
    PointSet set;
    set.count = count;
    const auto four = [&](double low, double high) {
        return Numbers{draw.number(low, high), draw.number(low, high), draw.number(low, high),
                       draw.number(low, high)};
    };
    for (size_t point = 0; point < count; ++point) {
        append_frame(set, draw);
        append(set, SurfaceInput::position_, Variant::value, four(-2, 2));
        for (int uv = 0; uv < 4; ++uv)
            append(set, static_cast<SurfaceInput>(static_cast<int>(SurfaceInput::uv0_) + uv),
                   Variant::value, four(uvs.low, uvs.high));
        append(set, SurfaceInput::color0_, Variant::value, four(0, 1));
        append(set, SurfaceInput::view_, Variant::value, draw.direction());
        append(set, SurfaceInput::facing_, Variant::value, {draw.number(-1, 1) < 0 ? -1.0 : 1.0});
    }
    return set;
}

PointSet degenerate_points() {
    PointSet set = random_points(std::size(degenerate_names), 99);
    clear_all_uv_changes(set, 0);
    clear_changes(set, 1, SurfaceInput::position_);
    for (const SurfaceInput input : {SurfaceInput::position_, SurfaceInput::normal_})
        clear_changes(set, 2, input);
    clear_all_uv_changes(set, 2);
    clear(set, 3, SurfaceInput::tangent_, Variant::value);
    set.at(SurfaceInput::tangent_)[4 * 4 + 3] = 0;
    clear(set, 5, SurfaceInput::view_, Variant::value);
    for (int i = 0; i < surface_input_count; ++i)
        for (const Variant variant : variants)
            if (static_cast<SurfaceInput>(i) != SurfaceInput::normal_)
                clear(set, 6, static_cast<SurfaceInput>(i), variant);
    set.at(SurfaceInput::facing_)[6] = 1;
    scale(set, 7, Variant::value, 1e3);
    for (const Variant variant : {Variant::dx, Variant::dy})
        scale(set, 8, variant, 1e-6);
    return set;
}

std::string_view degenerate_words(size_t point) {
    return degenerate_names[point];
}

PointSet nudged(const PointSet& points, unsigned seed) {
    std::mt19937 random(seed);
    PointSet result = points;
    for (int i = 0; i < surface_input_count; ++i) {
        const auto input = static_cast<SurfaceInput>(i);
        if (input == SurfaceInput::facing_) continue;
        for (const Variant variant : variants) {
            std::vector<double>& values = result.at(input, variant);
            for (size_t k = 0; k < values.size(); ++k) {
                if (input == SurfaceInput::tangent_ && k % 4 == 3) continue;
                const double ulp = std::ldexp(std::fabs(values[k]), -23);
                values[k] += (random() & 1 ? 4 : -4) * ulp;
            }
        }
    }
    return result;
}

PointSet moved_in_x(const PointSet& points, double step) {
    PointSet result = points;
    for (int i = 0; i < surface_input_count; ++i) {
        const auto input = static_cast<SurfaceInput>(i);
        const std::vector<double>& change = points.at(input, Variant::dx);
        for (size_t k = 0; k < change.size(); ++k)
            result.at(input)[k] += step * change[k];
    }
    return result;
}

}  // namespace wrinkle::certify
