#include <immintrin.h>

#include "bench/texels/kernel.h"

namespace wrinkle::bench::avx2 {
namespace {

using Float = __m256;
using Int = __m256i;
constexpr uint32_t lanes = 8;

Float spread(float x) {
    return _mm256_set1_ps(x);
}
Int spread_int(int x) {
    return _mm256_set1_epi32(x);
}
Float counted(uint32_t first) {
    const Int steps = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    return _mm256_cvtepi32_ps(_mm256_add_epi32(spread_int(static_cast<int>(first)), steps));
}
Float mul(Float a, Float b) {
    return _mm256_mul_ps(a, b);
}
Float sub(Float a, Float b) {
    return _mm256_sub_ps(a, b);
}
Float fma(Float a, Float b, Float c) {
    return _mm256_fmadd_ps(a, b, c);
}
Float max(Float a, Float b) {
    return _mm256_max_ps(a, b);
}
Float abs(Float a) {
    return _mm256_andnot_ps(spread(-0.0F), a);
}
Float floor(Float a) {
    return _mm256_floor_ps(a);
}
Int to_int(Float a) {
    return _mm256_cvtps_epi32(a);
}
Float to_float(Int a) {
    return _mm256_cvtepi32_ps(a);
}
Int add_int(Int a, Int b) {
    return _mm256_add_epi32(a, b);
}
Int and_(Int a, Int b) {
    return _mm256_and_si256(a, b);
}
Int or_(Int a, Int b) {
    return _mm256_or_si256(a, b);
}
Int low_byte(Int a) {
    return and_(a, spread_int(255));
}
Int shift_left(Int a, int by) {
    return _mm256_slli_epi32(a, by);
}
Int shift_right(Int a, int by) {
    return _mm256_srli_epi32(a, by);
}
Int gather(const uint32_t* from, Int index) {
    return _mm256_i32gather_epi32(reinterpret_cast<const int*>(from), index, 4);
}
Float inverse_root(Float a) {
    return _mm256_div_ps(spread(1), _mm256_sqrt_ps(a));
}
Float load(const float* from) {
    return _mm256_loadu_ps(from);
}
void store(float* to, Float a) {
    _mm256_storeu_ps(to, a);
}
void store(uint32_t* to, Int a) {
    _mm256_storeu_si256(reinterpret_cast<Int*>(to), a);
}

}  // namespace
}  // namespace wrinkle::bench::avx2

#define WRINKLE_BENCH_ISA avx2
#include "bench/texels/kernel_body.h"
