// The hand-written job over the vectors of one instruction set: the file that includes this defines
// WRINKLE_BENCH_ISA and, in that namespace, Float, Int, lanes and the operations on them.
#include "bench/texels/kernel.h"

namespace wrinkle::bench::WRINKLE_BENCH_ISA {
namespace {

struct Vector {
    Float x, y, z;
};

Float at(const Affine& value, Float x, Float row) {
    return fma(spread(value.across), x, row);
}
Float row_of(const Affine& value, uint32_t y) {
    return spread(value.at + value.up * static_cast<float>(y));
}

Float dot(const Vector& a, const Vector& b) {
    return fma(a.x, b.x, fma(a.y, b.y, mul(a.z, b.z)));
}

Float channel(Int texel, int shift) {
    return to_float(low_byte(shift_right(texel, shift)));
}

struct Corners {
    Int a, b, c, d;
    Float fx, fy;
};

Corners corners(const std::vector<uint32_t>& texels, Float u, Float v) {
    const Float x = sub(mul(u, spread(side)), spread(0.5F));
    const Float y = sub(mul(v, spread(side)), spread(0.5F));
    const Float left = floor(x), low = floor(y);
    const Int mask = spread_int(side - 1), one = spread_int(1);
    const Int i = to_int(left), j = to_int(low);
    const Int i0 = and_(i, mask), i1 = and_(add_int(i, one), mask);
    const Int j0 = shift_left(and_(j, mask), 11), j1 = shift_left(and_(add_int(j, one), mask), 11);
    return {gather(texels.data(), add_int(j0, i0)),
            gather(texels.data(), add_int(j0, i1)),
            gather(texels.data(), add_int(j1, i0)),
            gather(texels.data(), add_int(j1, i1)),
            sub(x, left),
            sub(y, low)};
}

// Returns 2t - 1 of one channel.
Float decoded(const Corners& at, int shift) {
    const Float a = channel(at.a, shift), b = channel(at.b, shift), c = channel(at.c, shift),
                d = channel(at.d, shift);
    const Float low = fma(sub(b, a), at.fx, a), high = fma(sub(d, c), at.fx, c);
    return fma(fma(sub(high, low), at.fy, low), spread(2.0F / 255), spread(-1));
}

Vector decoded(const Corners& at) {
    return {decoded(at, 0), decoded(at, 8), decoded(at, 16)};
}

Float depth(const Vector& normal) {
    const Float least = mul(max(abs(normal.x), abs(normal.y)), spread(0.0078125F));
    return max(max(abs(normal.z), least), spread(1e-6F));
}

Int packed(Float x, Float scale, int shift) {
    const Float value = fma(mul(x, scale), spread(127.5F), spread(127.5F));
    return shift_left(to_int(value), shift);  // rounds to nearest
}

Int texels(const Frame& frame, Float x, uint32_t y) {
    const auto value = [&](const Affine& affine) { return at(affine, x, row_of(affine, y)); };
    const Float u = value(frame.uv[0]), v = value(frame.uv[1]);
    const Float tiled_u = fma(u, spread(tiling), spread(offset_u));
    const Float tiled_v = fma(v, spread(tiling), spread(offset_v));
    const Textures& images = textures();
    const Vector a = decoded(corners(images.rgba_base, u, v));
    const Vector b = decoded(corners(images.rgba_detail, tiled_u, tiled_v));
    const Float depth_a = depth(a), depth_b = depth(b), half = mul(depth_a, spread(amount));
    const Float slope_x = fma(a.x, depth_b, mul(b.x, half));
    const Float slope_y = mul(fma(a.y, depth_b, mul(b.y, half)), spread(tangent_w));
    const Float both = mul(depth_a, depth_b);
    const Vector n{value(frame.normal[0]), value(frame.normal[1]), value(frame.normal[2])};
    const Vector t{value(frame.tangent[0]), value(frame.tangent[1]), value(frame.tangent[2])};
    const Vector bitangent{sub(mul(n.y, t.z), mul(n.z, t.y)), sub(mul(n.z, t.x), mul(n.x, t.z)),
                           sub(mul(n.x, t.y), mul(n.y, t.x))};
    const Vector m{fma(n.x, both, fma(t.x, slope_x, mul(bitangent.x, slope_y))),
                   fma(n.y, both, fma(t.y, slope_x, mul(bitangent.y, slope_y))),
                   fma(n.z, both, fma(t.z, slope_x, mul(bitangent.z, slope_y)))};
    const Float scale = inverse_root(dot(m, m));
    return or_(or_(packed(m.x, scale, 0), packed(m.y, scale, 8)),
               or_(packed(m.z, scale, 16), spread_int(static_cast<int>(255U << 24))));
}

void rows(uint32_t first, uint32_t last, uint32_t* out) {
    const Frame frame = bench::frame();
    for (uint32_t y = first; y < last; ++y)
        for (uint32_t x = 0; x < side; x += lanes)
            store(out + size_t{y} * side + x, texels(frame, counted(x), y));
}

void fill(const Plane* planes, size_t plane_count, uint32_t x, uint32_t y, uint32_t count) {
    Float rows[max_planes];
    for (size_t i = 0; i < plane_count; ++i)
        rows[i] = row_of(planes[i].value, y);
    for (uint32_t k = 0; k < count; k += lanes) {
        const Float column = counted(x + k);
        for (size_t i = 0; i < plane_count; ++i)
            store(planes[i].out + k, at(planes[i].value, column, rows[i]));
    }
}

void pack(const float* const* normal, uint32_t count, uint32_t* out) {
    const Float one = spread(1);
    for (uint32_t k = 0; k < count; k += lanes)
        store(out + k,
              or_(or_(packed(load(normal[0] + k), one, 0), packed(load(normal[1] + k), one, 8)),
                  or_(packed(load(normal[2] + k), one, 16),
                      spread_int(static_cast<int>(255U << 24)))));
}

}  // namespace

const Kernel kernel = {rows, fill, pack};

}  // namespace wrinkle::bench::WRINKLE_BENCH_ISA
