// The loops of interpolate.h; see kernels.h.
#ifndef WRINKLE_ISA
#error "say for which instruction set: define WRINKLE_ISA"
#endif

#include "cpu/interpolate.h"

namespace wrinkle::WRINKLE_ISA {
namespace {

constexpr size_t double_lanes = vector_bytes / sizeof(double);
static_assert(double_lanes <= interpolated_behind);
using Doubles = double __attribute__((vector_size(vector_bytes)));
using NarrowFloats = float __attribute__((vector_size(vector_bytes / 2)));

struct CornerWeights {
    Doubles a, b, c;

    void bring_back() {
        const Doubles zero{};
        a = a < zero ? zero : a;
        b = b < zero ? zero : b;
        c = c < zero ? zero : c;
        const Doubles sum = a + b + c;
        a /= sum;
        b /= sum;
        c /= sum;
    }
};

CornerWeights weights_at(const TriangleRow& row, size_t k) {
    const Doubles x = load<Doubles>(row.u + k) - row.first[0];
    const double y = row.v - row.first[1];
    const Doubles s = row.second[0] * x + row.second[1] * y;
    const Doubles t = row.third[0] * x + row.third[1] * y;
    CornerWeights weights = {1 - s - t, s, t};
    if (row.outside) weights.bring_back();
    return weights;
}

void interpolate(const TriangleRow& row, const CornerValues* values, size_t planes, float* out,
                 size_t stride) {
    // Copies, which what is stored cannot change.
    const TriangleRow places = row;
    for (size_t k = 0; k < places.count; k += double_lanes) {
        const CornerWeights weights = weights_at(places, k);
        float* to = out + k;
        for (size_t plane = 0; plane < planes; ++plane, to += stride) {
            const CornerValues& value = values[plane];
            Doubles at{};
            if (value.kind == CornerValues::Kind::linear)
                at = value.at[0] * weights.a + value.at[1] * weights.b + value.at[2] * weights.c;
            else if (value.kind == CornerValues::Kind::constant)
                at = at + value.at[0];
            else
                continue;
            store(to, __builtin_convertvector(at, NarrowFloats));
        }
    }
}

}  // namespace
}  // namespace wrinkle::WRINKLE_ISA
