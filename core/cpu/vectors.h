// SIMD vectors of the register width of one instruction set, based on the compiler's vector types,
// which define + - * / and comparisons. Included inside the unnamed namespace of a file compiled
// for the set, so all names are local to that file. Operations round only as IEEE 754 does.
#if defined(__AVX512F__)
constexpr size_t vector_bytes = 64;
#elif defined(__AVX2__)
constexpr size_t vector_bytes = 32;
#else
constexpr size_t vector_bytes = 16;
#endif
constexpr size_t vector_lanes = vector_bytes / sizeof(float);

using Doubles = double __attribute__((vector_size(vector_bytes)));
using Floats = float __attribute__((vector_size(vector_bytes)));
using Ints = int32_t __attribute__((vector_size(vector_bytes)));
using Words = uint32_t __attribute__((vector_size(vector_bytes)));

#define WRINKLE_INLINE [[gnu::always_inline]] inline

template <class Vector, class Lane>
WRINKLE_INLINE Vector load(const Lane* from) {
    Vector v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}
template <class Vector, class Lane>
WRINKLE_INLINE void store(Lane* to, Vector v) {
    __builtin_memcpy(to, &v, sizeof v);
}

WRINKLE_INLINE Floats to_floats(Ints v) {
    return __builtin_convertvector(v, Floats);
}

// above_zero: max(v, 0), and 0 for NaN. floor_to_int: floor(v) in int range, as int and as float.
// gather: 32-bit values by index. scaled: an integer of 23 bits times a constant, rounded once.
// are_lanes: returns true if all numbers are lane indices. permute: reorders by lane indices.
// lanes_below_zero: a bit mask, lane 0 in the lowest bit.
struct Whole {
    Ints number;
    Floats same;
};
#if defined(__AVX512F__)
WRINKLE_INLINE bool are_lanes(Ints v) {
    return _mm512_test_epi32_mask(reinterpret_cast<__m512i>(v), _mm512_set1_epi32(~15)) == 0;
}
WRINKLE_INLINE Ints permute(Ints from, Ints lanes) {
    return reinterpret_cast<Ints>(_mm512_maskz_permutexvar_epi32(
        0xFFFF, reinterpret_cast<__m512i>(lanes), reinterpret_cast<__m512i>(from)));
}
WRINKLE_INLINE Floats floor_of(Floats v) {
    return _mm512_maskz_roundscale_ps(0xFFFF, v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
}
WRINKLE_INLINE Whole floor_to_int(Floats v) {
    const auto number = reinterpret_cast<Ints>(
        _mm512_maskz_cvt_roundps_epi32(0xFFFF, v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC));
    return {number, to_floats(number)};
}
WRINKLE_INLINE Floats above_zero(Floats v) {
    return _mm512_maskz_max_ps(0xFFFF, v, _mm512_setzero_ps());
}
WRINKLE_INLINE Ints gather(const void* from, Ints indices) {
    const auto at = reinterpret_cast<__m512i>(indices);
    return reinterpret_cast<Ints>(
        _mm512_mask_i32gather_epi32(_mm512_setzero_si512(), 0xFFFF, at, from, 4));
}
WRINKLE_INLINE uint32_t lanes_below_zero(Doubles v) {
    return _mm512_cmp_pd_mask(v, _mm512_setzero_pd(), _CMP_LT_OQ);
}
WRINKLE_INLINE Floats scaled(Ints whole, float factor) {
    // Uses the integer as the mantissa of a float from 2^23 on; 2^23 * factor is subtracted
    // exactly.
    const auto number = reinterpret_cast<__m512>(whole | 0x4B000000);
    return _mm512_maskz_fmadd_ps(0xFFFF, number, _mm512_set1_ps(factor),
                                 _mm512_set1_ps(-0x1p23F * factor));
}
#elif defined(__AVX2__)
WRINKLE_INLINE bool are_lanes(Ints v) {
    return _mm256_testz_si256(reinterpret_cast<__m256i>(v), _mm256_set1_epi32(~7));
}
WRINKLE_INLINE Ints permute(Ints from, Ints lanes) {
    return reinterpret_cast<Ints>(_mm256_permutevar8x32_epi32(reinterpret_cast<__m256i>(from),
                                                              reinterpret_cast<__m256i>(lanes)));
}
WRINKLE_INLINE Floats floor_of(Floats v) {
    return _mm256_floor_ps(v);
}
WRINKLE_INLINE Whole floor_to_int(Floats v) {
    const Floats same = floor_of(v);
    return {reinterpret_cast<Ints>(_mm256_cvttps_epi32(same)), same};
}
WRINKLE_INLINE Floats above_zero(Floats v) {
    return _mm256_max_ps(v, _mm256_setzero_ps());
}
WRINKLE_INLINE Ints gather(const void* from, Ints indices) {
    const auto at = reinterpret_cast<__m256i>(indices);
    return reinterpret_cast<Ints>(_mm256_i32gather_epi32(static_cast<const int*>(from), at, 4));
}
WRINKLE_INLINE uint32_t lanes_below_zero(Doubles v) {
    return static_cast<uint32_t>(
        _mm256_movemask_pd(_mm256_cmp_pd(v, _mm256_setzero_pd(), _CMP_LT_OQ)));
}
#else
WRINKLE_INLINE bool are_lanes(Ints) {
    return false;  // a gather is not slower
}
WRINKLE_INLINE Ints permute(Ints from, Ints) {
    return from;
}
WRINKLE_INLINE Floats floor_of(Floats v) {
    for (size_t k = 0; k < vector_lanes; ++k)
        v[k] = math::floor(v[k]);
    return v;
}
WRINKLE_INLINE Whole floor_to_int(Floats v) {
    const Floats same = floor_of(v);
    return {__builtin_convertvector(same, Ints), same};
}
WRINKLE_INLINE Floats above_zero(Floats v) {
    for (size_t k = 0; k < vector_lanes; ++k)
        v[k] = v[k] > 0 ? v[k] : 0;
    return v;
}
WRINKLE_INLINE Ints gather(const void* from, Ints indices) {
    for (size_t k = 0; k < vector_lanes; ++k)
        indices[k] = static_cast<const int32_t*>(from)[indices[k]];
    return indices;
}
WRINKLE_INLINE uint32_t lanes_below_zero(Doubles v) {
    return static_cast<uint32_t>(v[0] < 0) | static_cast<uint32_t>(v[1] < 0) << 1;
}
#endif
#if !defined(__AVX512F__)
WRINKLE_INLINE Floats scaled(Ints whole, float factor) {
    return to_floats(whole) * factor;
}
#endif

#undef WRINKLE_INLINE
