// Runs one target of fuzz.h, WRINKLE_FUZZED, in libFuzzer.
#include <cstdio>
#include <cstdlib>

#include "fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    const std::string wrong =
        wrinkle::fuzz::WRINKLE_FUZZED({reinterpret_cast<const char*>(data), size});
    if (wrong.empty()) return 0;
    std::fprintf(stderr, "%s\n", wrong.c_str());
    std::abort();
}
