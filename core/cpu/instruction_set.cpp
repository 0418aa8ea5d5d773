#include <cstdlib>
#include <string_view>

#include "cpu/evaluate.h"

namespace wrinkle {

bool is_available(InstructionSet set) {
#if defined(WRINKLE_HAS_AVX2)
    if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2");
#endif
    return set == InstructionSet::baseline;
}

InstructionSet default_instruction_set() {
    const char* wanted = std::getenv("WRINKLE_ISA");
    const bool baseline = wanted && std::string_view(wanted) == "baseline";
    return !baseline && is_available(InstructionSet::avx2) ? InstructionSet::avx2
                                                           : InstructionSet::baseline;
}

}  // namespace wrinkle
