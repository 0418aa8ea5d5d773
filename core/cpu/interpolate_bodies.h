// Kernels of interpolate.h; see kernels.h.
#ifndef WRINKLE_ISA
#error "say for which instruction set: define WRINKLE_ISA"
#endif

#include "cpu/interpolate.h"

namespace wrinkle::WRINKLE_ISA {
namespace {

constexpr size_t double_lanes = vector_bytes / sizeof(double);
static_assert(double_lanes <= interpolate_padding);
using NarrowFloats = float __attribute__((vector_size(vector_bytes / 2)));

struct CornerWeights {
    Doubles a, b, c;

    // Clamps and normalises the lanes in which `least`, the smallest weight, is below 0.
    void bring_back(Doubles least) {
        const Doubles zero{};
        const Doubles x = a < zero ? zero : a, y = b < zero ? zero : b, z = c < zero ? zero : c;
        const Doubles sum = x + y + z;
        a = least < zero ? x / sum : a;
        b = least < zero ? y / sum : b;
        c = least < zero ? z / sum : c;
    }
};

CornerWeights weights_at(const TrianglePlanes& triangle, Doubles u, double v, size_t left) {
    const Doubles x = u - triangle.first[0];
    const double y = v - triangle.first[1];
    const Doubles s = triangle.second[0] * x + triangle.second[1] * y;
    const Doubles t = triangle.third[0] * x + triangle.third[1] * y;
    CornerWeights weights = {1 - s - t, s, t};
    const Doubles low = s < t ? s : t;
    const Doubles least = weights.a < low ? weights.a : low;
    // Lanes past the last point are usually outside the triangle; they are ignored here.
    const uint32_t mine = left < double_lanes ? (1U << left) - 1 : ~0U;
    if (lanes_below_zero(least) & mine) weights.bring_back(least);
    return weights;
}

void interpolate(const TrianglePlanes& triangle, const PointRow& row, float* out, size_t stride) {
    // Local copies, which the stores below cannot alias.
    const TrianglePlanes planes = triangle;
    const PointRow points = row;
    const VaryingInput* const end = planes.linear + planes.linear_count;
    const FlatInput* const constant_end = planes.constant + planes.constant_count;
    for (size_t k = 0; k < points.count; k += double_lanes) {
        for (const FlatInput* each = planes.constant; each != constant_end; ++each)
            store(out + each->plane * stride + k, NarrowFloats{} + each->value);
        if (planes.linear == end) continue;
        const auto u = load<Doubles>(points.u + k);
        const CornerWeights weights = weights_at(planes, u, points.v, points.count - k);
        for (const VaryingInput* each = planes.linear; each != end; ++each) {
            const Doubles at = each->corner[0] * weights.a + each->corner[1] * weights.b +
                               each->corner[2] * weights.c;
            store(out + each->plane * stride + k, __builtin_convertvector(at, NarrowFloats));
        }
    }
}

}  // namespace
}  // namespace wrinkle::WRINKLE_ISA
