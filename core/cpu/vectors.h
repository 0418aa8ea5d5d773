// Vectors of one instruction set, as wide as its registers, on the compiler's own vector types:
// + - * / and comparisons are theirs. Included inside the unnamed namespace of a file that was
// compiled for the set, so every name is that file's own; nothing rounds but what IEEE 754 rounds.
#if defined(__AVX512F__)
constexpr size_t vector_bytes = 64;
#elif defined(__AVX2__)
constexpr size_t vector_bytes = 32;
#else
constexpr size_t vector_bytes = 16;
#endif
constexpr size_t vector_lanes = vector_bytes / sizeof(float);

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

// smaller_word: of unsigned numbers. above_zero: 0 for NaN too. whole_below: the greatest whole
// number that is not greater, of what an int holds. gather: of 32-bit values. gather_pairs: of
// neighbours, those at the places and those behind them.
struct Pairs {
    Ints first, second;
};
#if defined(__AVX512F__)
WRINKLE_INLINE Floats floor_of(Floats v) {
    return _mm512_maskz_roundscale_ps(0xFFFF, v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
}
WRINKLE_INLINE Ints whole_below(Floats v) {
    return reinterpret_cast<Ints>(
        _mm512_maskz_cvt_roundps_epi32(0xFFFF, v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC));
}
WRINKLE_INLINE Floats above_zero(Floats v) {
    return _mm512_maskz_max_ps(0xFFFF, v, _mm512_setzero_ps());
}
WRINKLE_INLINE Ints smaller_word(Ints a, Ints b) {
    return reinterpret_cast<Ints>(
        _mm512_maskz_min_epu32(0xFFFF, reinterpret_cast<__m512i>(a), reinterpret_cast<__m512i>(b)));
}
WRINKLE_INLINE Ints gather(const void* from, Ints places) {
    const auto at = reinterpret_cast<__m512i>(places);
    return reinterpret_cast<Ints>(
        _mm512_mask_i32gather_epi32(_mm512_setzero_si512(), 0xFFFF, at, from, 4));
}
WRINKLE_INLINE Pairs gather_pairs(const void* from, Ints places) {
    const auto at = reinterpret_cast<__m512i>(places);
    const __m512i zero = _mm512_setzero_si512();
    const __m512i low = _mm512_mask_i32gather_epi64(
        zero, 0xFF, _mm512_maskz_extracti64x4_epi64(0xFF, at, 0), from, 4);
    const __m512i high = _mm512_mask_i32gather_epi64(
        zero, 0xFF, _mm512_maskz_extracti64x4_epi64(0xFF, at, 1), from, 4);
    const __m512i even =
        _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
    const __m512i odd =
        _mm512_setr_epi32(1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31);
    return {reinterpret_cast<Ints>(_mm512_permutex2var_epi32(low, even, high)),
            reinterpret_cast<Ints>(_mm512_permutex2var_epi32(low, odd, high))};
}
#elif defined(__AVX2__)
WRINKLE_INLINE Floats floor_of(Floats v) {
    return _mm256_floor_ps(v);
}
WRINKLE_INLINE Ints whole_below(Floats v) {
    return reinterpret_cast<Ints>(_mm256_cvttps_epi32(_mm256_floor_ps(v)));
}
WRINKLE_INLINE Floats above_zero(Floats v) {
    return _mm256_max_ps(v, _mm256_setzero_ps());
}
WRINKLE_INLINE Ints smaller_word(Ints a, Ints b) {
    return reinterpret_cast<Ints>(
        _mm256_min_epu32(reinterpret_cast<__m256i>(a), reinterpret_cast<__m256i>(b)));
}
WRINKLE_INLINE Ints gather(const void* from, Ints places) {
    const auto at = reinterpret_cast<__m256i>(places);
    return reinterpret_cast<Ints>(_mm256_i32gather_epi32(static_cast<const int*>(from), at, 4));
}
WRINKLE_INLINE Pairs gather_pairs(const void* from, Ints places) {
    // Lanes 0 1 4 5 and 2 3 6 7, so that the shuffle within halves leaves them in order.
    const __m256i at = _mm256_permute4x64_epi64(reinterpret_cast<__m256i>(places), 0xD8);
    const auto* base = static_cast<const long long*>(from);
    const __m256 a =
        _mm256_castsi256_ps(_mm256_i32gather_epi64(base, _mm256_castsi256_si128(at), 4));
    const __m256 b =
        _mm256_castsi256_ps(_mm256_i32gather_epi64(base, _mm256_extracti128_si256(at, 1), 4));
    return {reinterpret_cast<Ints>(_mm256_shuffle_ps(a, b, 0x88)),
            reinterpret_cast<Ints>(_mm256_shuffle_ps(a, b, 0xDD))};
}
#else
WRINKLE_INLINE Floats floor_of(Floats v) {
    for (size_t k = 0; k < vector_lanes; ++k)
        v[k] = math::floor(v[k]);
    return v;
}
WRINKLE_INLINE Ints whole_below(Floats v) {
    return __builtin_convertvector(floor_of(v), Ints);
}
WRINKLE_INLINE Floats above_zero(Floats v) {
    for (size_t k = 0; k < vector_lanes; ++k)
        v[k] = v[k] > 0 ? v[k] : 0;
    return v;
}
WRINKLE_INLINE Ints smaller_word(Ints a, Ints b) {
    for (size_t k = 0; k < vector_lanes; ++k)
        a[k] = static_cast<uint32_t>(a[k]) < static_cast<uint32_t>(b[k]) ? a[k] : b[k];
    return a;
}
WRINKLE_INLINE Ints gather(const void* from, Ints places) {
    for (size_t k = 0; k < vector_lanes; ++k)
        places[k] = static_cast<const int32_t*>(from)[places[k]];
    return places;
}
WRINKLE_INLINE Pairs gather_pairs(const void* from, Ints places) {
    return {gather(from, places), gather(from, places + 1)};
}
#endif

#undef WRINKLE_INLINE
