#include "patterns.h"

#include <cstdint>

namespace wrinkle::textures {

namespace {

// Any two integers and a seed to [0, 1); the mixing steps are those of a 64-bit xorshift-multiply.
double random(int64_t x, int64_t y, uint64_t seed) {
    uint64_t bits = static_cast<uint64_t>(x) * 0x9E3779B97F4A7C15u +
                    static_cast<uint64_t>(y) * 0xC2B2AE3D27D4EB4Fu +
                    (seed + 1) * 0x165667B19E3779F9u;
    for (int round = 0; round < 3; ++round) {
        bits ^= bits >> 29;
        bits *= 0xBF58476D1CE4E5B9u;
    }
    return static_cast<double>((bits ^ (bits >> 32)) >> 11) * 0x1p-53;
}

int64_t wrapped(int64_t index, int64_t period) {
    return (index % period + period) % period;
}

Dual mix(Dual a, Dual b, Dual t) {
    return a + (b - a) * t;
}

// Smoothed random values in [0, 1] on a grid of `period` cells per tile.
Dual noise(Dual u, Dual v, int64_t period, uint64_t seed) {
    const Dual x = u * static_cast<double>(period), y = v * static_cast<double>(period);
    const auto column = static_cast<int64_t>(std::floor(x.value));
    const auto row = static_cast<int64_t>(std::floor(y.value));
    const auto corner = [&](int64_t i, int64_t j) -> Dual {
        return random(wrapped(column + i, period), wrapped(row + j, period), seed);
    };
    const Dual s = smooth(fraction(x)), t = smooth(fraction(y));
    return mix(mix(corner(0, 0), corner(1, 0), s), mix(corner(0, 1), corner(1, 1), s), t);
}

// Octaves, each of half the size and height; in [0, 1].
Dual rough(Dual u, Dual v, int64_t period, int octaves, uint64_t seed) {
    Dual sum = 0;
    double height = 1, total = 0;
    for (int octave = 0; octave < octaves; ++octave) {
        sum = sum + noise(u, v, period << octave, seed + static_cast<uint64_t>(octave)) * height;
        total += height;
        height /= 2;
    }
    return sum / total;
}

// 1 on the plateau of a brick, 0 in the joint; `place` runs from 0 to 1 across the brick.
Dual bevel(Dual place, double size, Dual ragged) {
    constexpr double joint = 0.006, slope = 0.014;
    const Dual from_edge = smaller(place, 1 - place) * size;
    return smooth((from_edge + ragged - joint) / slope);
}

struct Thread {
    Dual across;  // -1 to 1
    Dual along;   // in threads
    Dual lift;    // -1 below the other thread, 1 above it
};

Dual thread_height(const Thread& thread) {
    const Dual round = root(1 - thread.across * thread.across * 0.9);
    const Dual twist = wave(thread.along * 6 + thread.across * 1.5);
    return 0.2 + 0.52 * round + 0.22 * thread.lift + 0.03 * twist * round;
}

Dual dome(Dual x, Dual y, double radius) {
    return smooth(1 - root(x * x + y * y) / radius);
}

// Distance from the middle of the tile's nearest copy of `at`.
Dual from_center(Dual place, double at) {
    return fraction(place - at + 0.5) - 0.5;
}

Dual dents(Dual u, Dual v) {
    Dual depth = 0;
    for (int i = 0; i < 14; ++i) {
        const Dual x = from_center(u, random(i, 0, 31)), y = from_center(v, random(i, 1, 31));
        const double radius = 0.04 + 0.06 * random(i, 2, 31);
        depth = depth + dome(x, y, radius) * (radius * 1.6);
    }
    return depth;
}

// A stone with its middle somewhere in the cell; a paraboloid, so stones meet in sharp creases.
Dual pebble(Dual x, Dual y, int64_t column, int64_t row, int64_t period) {
    const int64_t i = wrapped(column, period), j = wrapped(row, period);
    const Dual dx = x - (static_cast<double>(column) + 0.15 + 0.7 * random(i, j, 41));
    const Dual dy = y - (static_cast<double>(row) + 0.15 + 0.7 * random(i, j, 42));
    const double size = 0.55 + 0.45 * random(i, j, 43);
    return size * (1 - (dx * dx + dy * dy) / (size * size));
}

}  // namespace

Dual bricks(Dual u, Dual v) {
    constexpr int64_t columns = 4, rows = 8;
    const Dual y = v * static_cast<double>(rows);
    const auto row = static_cast<int64_t>(std::floor(y.value));
    const Dual x = u * static_cast<double>(columns) + 0.5 * static_cast<double>(row & 1);
    const int64_t column = wrapped(static_cast<int64_t>(std::floor(x.value)), columns);
    const Dual across = fraction(x), up = fraction(y);
    const Dual ragged = (noise(u, v, 32, 11) - 0.5) * 0.008;
    const Dual body = bevel(across, 1.0 / columns, ragged) * bevel(up, 1.0 / rows, ragged);
    const Dual tilt = (across - 0.5) * (0.16 * (random(column, row, 12) - 0.5)) +
                      (up - 0.5) * (0.16 * (random(column, row, 13) - 0.5));
    const Dual top =
        0.72 + 0.18 * (random(column, row, 14) - 0.5) + tilt - 0.12 * rough(u, v, 16, 3, 15);
    const Dual mortar = 0.12 + 0.08 * rough(u, v, 32, 2, 16);
    return mix(mortar, top, body) + 0.03 * noise(u, v, 128, 17);
}

Dual weave(Dual u, Dual v) {
    constexpr double threads = 8;
    const Dual x = u * threads, y = v * threads;
    const double column = std::floor(x.value), row = std::floor(y.value);
    const Thread warp{fraction(x) * 2 - 1, y, wave(y - 0.5 + column)};
    const Thread weft{fraction(y) * 2 - 1, x, -wave(x - 0.5 + row)};
    return larger(thread_height(warp), thread_height(weft));
}

Dual rivets(Dual u, Dual v) {
    const Dual x = fraction(u * 4) - 0.5, y = fraction(v * 4) - 0.5;
    const Dual distance = root(x * x + y * y);
    const Dual head = root(1 - distance * distance / (0.22 * 0.22)) * 0.4;
    const Dual washer = smooth((0.30 - distance) / 0.03) * 0.05;
    const Dual seam = smooth((magnitude(from_center(u, 0.5)) - 0.004) / 0.012) *
                      smooth((magnitude(from_center(v, 0.5)) - 0.004) / 0.012);
    return 0.35 + 0.12 * (seam - 1) + larger(head, washer) - dents(u, v);
}

Dual pebbles(Dual u, Dual v) {
    constexpr int64_t period = 10;
    const Dual x = u * static_cast<double>(period), y = v * static_cast<double>(period);
    const auto column = static_cast<int64_t>(std::floor(x.value));
    const auto row = static_cast<int64_t>(std::floor(y.value));
    Dual height = 0;
    for (int64_t j = -2; j <= 2; ++j)
        for (int64_t i = -2; i <= 2; ++i)
            height = larger(height, pebble(x, y, column + i, row + j, period));
    return 0.05 + 0.85 * height + 0.05 * rough(u, v, 32, 2, 44);
}

Dual patches(Dual u, Dual v) {
    return smooth((rough(u, v, 4, 4, 51) - 0.34) / 0.24);
}

}  // namespace wrinkle::textures
