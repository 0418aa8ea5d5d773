#include "maps/poisson.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <complex>
#include <kissfft.hh>
#include <numbers>
#include <utility>

namespace wrinkle::maps {

namespace {

using Complex = std::complex<float>;

constexpr float penalty = 1e-4f;

struct Plane {
    uint32_t width = 0, height = 0;
    std::vector<Complex> values;

    Complex* row(uint32_t y) { return values.data() + size_t{y} * width; }
};

enum class Along { rows, columns };

// Transforms a group of lines at a time, as values of adjacent columns are adjacent in memory.
void transform(Plane& plane, Along along, bool inverse) {
    constexpr uint32_t at_once = 16;
    const bool rows = along == Along::rows;
    const uint32_t lines = rows ? plane.height : plane.width;
    const uint32_t length = rows ? plane.width : plane.height;
    const size_t next_line = rows ? plane.width : 1, next_value = rows ? 1 : plane.width;
    const tbb::blocked_range<uint32_t> groups(0, (lines + at_once - 1) / at_once);
    tbb::parallel_for(groups, [&](const auto& range) {
        kissfft<float> transform(length, inverse);
        std::vector<Complex> values(size_t{length} * at_once), result(length);
        for (uint32_t group = range.begin(); group < range.end(); ++group) {
            const uint32_t count = std::min(at_once, lines - group * at_once);
            Complex* first = plane.values.data() + group * at_once * next_line;
            for (uint32_t k = 0; k < length; ++k)
                for (uint32_t i = 0; i < count; ++i)
                    values[size_t{i} * length + k] = first[i * next_line + k * next_value];
            for (uint32_t i = 0; i < count; ++i) {
                transform.transform(&values[size_t{i} * length], result.data());
                for (uint32_t k = 0; k < length; ++k)
                    first[i * next_line + k * next_value] = result[k];
            }
        }
    });
}

float finite(float value) {
    return std::isfinite(value) ? value : 0;
}

// Packs du as the real and dv as the imaginary part: one transform serves both. The slopes of an
// even height change sign across its mirror axis.
Plane extended(const std::vector<float>& du, const std::vector<float>& dv, uint32_t width,
               uint32_t height, Wrap wrap) {
    const uint32_t times = wrap == Wrap::repeat ? 1 : 2;
    Plane plane{width * times, height * times, {}};
    plane.values.resize(size_t{plane.width} * plane.height);
    for (uint32_t y = 0; y < plane.height; ++y) {
        const uint32_t from_y = y < height ? y : plane.height - 1 - y;
        const float up = y < height ? 1.0f : -1.0f;
        for (uint32_t x = 0; x < plane.width; ++x) {
            const uint32_t from_x = x < width ? x : plane.width - 1 - x;
            const size_t from = size_t{from_y} * width + from_x;
            const float across = x < width ? 1.0f : -1.0f;
            plane.row(y)[x] = {across * finite(du[from]), up * finite(dv[from])};
        }
    }
    return plane;
}

struct Wave {
    float sine, cosine;
};

std::vector<Wave> waves(uint32_t count) {
    std::vector<Wave> table(count);
    for (uint32_t k = 0; k < count; ++k) {
        const double angle = 2 * std::numbers::pi * k / count;
        table[k] = {static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle))};
    }
    return table;
}

// The filter multiplies a wave by i f, with f = sin of its angle along the slope times
// (1 + cos) / 2 of the angle across. Solves the damped least-squares equation for one wave.
Complex height_of_wave(Complex du, Complex dv, const Wave& x, const Wave& y) {
    const float fu = x.sine * (1 + y.cosine) / 2, fv = y.sine * (1 + x.cosine) / 2;
    const float laplacian = 4 - 2 * x.cosine - 2 * y.cosine;
    const float weight = fu * fu + fv * fv + penalty * laplacian * laplacian;
    if (weight == 0) return {};
    return Complex(0, -1) * (fu * du + fv * dv) / weight;
}

// Separates Z = U + iV, of real u and v: U = (Z(k) + conj Z(-k)) / 2, V = (Z(k) - conj Z(-k)) / 2i.
// A wave and its opposite are processed together, as each needs the other.
void solve(Plane& plane) {
    const std::vector<Wave> across = waves(plane.width), up = waves(plane.height);
    const auto one = [&](Complex here, Complex there, uint32_t x, uint32_t y) {
        const Complex du = (here + std::conj(there)) * 0.5f;
        const Complex dv = (here - std::conj(there)) * Complex(0, -0.5f);
        return height_of_wave(du, dv, across[x], up[y]);
    };
    tbb::parallel_for(0u, plane.height / 2 + 1, [&](uint32_t y) {
        const uint32_t other_y = (plane.height - y) % plane.height;
        const uint32_t end = y == other_y ? plane.width / 2 + 1 : plane.width;
        for (uint32_t x = 0; x < end; ++x) {
            const uint32_t other_x = (plane.width - x) % plane.width;
            Complex &here = plane.row(y)[x], &there = plane.row(other_y)[other_x];
            const Complex first = here, second = there;
            here = one(first, second, x, y);
            there = one(second, first, other_x, other_y);
        }
    });
}

}  // namespace

std::vector<float> height_of_slopes(std::vector<float> du, std::vector<float> dv, uint32_t width,
                                    uint32_t height, Wrap wrap) {
    Plane plane = extended(du, dv, width, height, wrap);
    du = {};
    dv = {};
    transform(plane, Along::rows, false);
    transform(plane, Along::columns, false);
    solve(plane);
    transform(plane, Along::columns, true);
    transform(plane, Along::rows, true);
    const float divisor = static_cast<float>(plane.values.size());
    std::vector<float> heights(size_t{width} * height);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            heights[size_t{y} * width + x] = plane.row(y)[x].real() / divisor;
    return heights;
}

}  // namespace wrinkle::maps
