#include <immintrin.h>

#include "bench/texels/kernel.h"

// Masked intrinsics with a zero source: those without one read an uninitialised register in the
// headers of gcc 12, which causes a warning.
namespace wrinkle::bench::avx512 {
namespace {

using Float = __m512;
using Int = __m512i;
constexpr uint32_t lanes = 16;

Float spread(float x) {
    return _mm512_set1_ps(x);
}
Int spread_int(int x) {
    return _mm512_set1_epi32(x);
}
Float counted(uint32_t first) {
    const Int steps = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    return _mm512_cvtepi32_ps(_mm512_add_epi32(spread_int(static_cast<int>(first)), steps));
}
Float mul(Float a, Float b) {
    return _mm512_mul_ps(a, b);
}
Float sub(Float a, Float b) {
    return _mm512_sub_ps(a, b);
}
Float fma(Float a, Float b, Float c) {
    return _mm512_fmadd_ps(a, b, c);
}
Float max(Float a, Float b) {
    return _mm512_max_ps(a, b);
}
Float abs(Float a) {
    return _mm512_abs_ps(a);
}
Float floor(Float a) {
    return _mm512_roundscale_ps(a, 1);
}
Int to_int(Float a) {
    return _mm512_cvtps_epi32(a);
}
Float to_float(Int a) {
    return _mm512_cvtepi32_ps(a);
}
Int add_int(Int a, Int b) {
    return _mm512_add_epi32(a, b);
}
Int and_(Int a, Int b) {
    return _mm512_and_si512(a, b);
}
Int or_(Int a, Int b) {
    return _mm512_or_si512(a, b);
}
Int low_byte(Int a) {
    return and_(a, spread_int(255));
}
Int shift_left(Int a, int by) {
    return _mm512_sllv_epi32(a, spread_int(by));
}
Int shift_right(Int a, int by) {
    return _mm512_srlv_epi32(a, spread_int(by));
}
Int gather(const uint32_t* from, Int index) {
    return _mm512_i32gather_epi32(index, from, 4);
}
Float inverse_root(Float a) {
    return _mm512_div_ps(spread(1), _mm512_sqrt_ps(a));
}
Float load(const float* from) {
    return _mm512_loadu_ps(from);
}
void store(float* to, Float a) {
    _mm512_storeu_ps(to, a);
}
void store(uint32_t* to, Int a) {
    _mm512_storeu_si512(to, a);
}

}  // namespace
}  // namespace wrinkle::bench::avx512

#define WRINKLE_BENCH_ISA avx512
#include "bench/texels/kernel_body.h"
