#include <array>
#include <cstdlib>
#include <string_view>

#include "cpu/kernels.h"

namespace wrinkle {
namespace {

constexpr std::array<std::string_view, 3> set_names = {"baseline", "avx2", "avx512"};

}  // namespace

// __builtin_cpu_supports() also checks that the operating system saves the vector registers.
bool is_available(InstructionSet set) {
#if defined(WRINKLE_HAS_AVX)
    if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2");
    if (set == InstructionSet::avx512)
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
               __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
#endif
    return set == InstructionSet::baseline;
}

const Kernels& kernels_of(InstructionSet set) {
#if defined(WRINKLE_HAS_AVX)
    if (set == InstructionSet::avx2) return avx2::kernels;
    if (set == InstructionSet::avx512) return avx512::kernels;
#endif
    static_cast<void>(set);
    return baseline::kernels;
}

InstructionSet default_instruction_set() {
    const char* wanted = std::getenv("WRINKLE_ISA");
    InstructionSet best = InstructionSet::baseline;
    for (size_t k = 0; k < set_names.size(); ++k) {
        const auto set = static_cast<InstructionSet>(k);
        if (!is_available(set)) continue;
        best = set;
        if (wanted && wanted == set_names[k]) return set;
    }
    return best;
}

}  // namespace wrinkle
