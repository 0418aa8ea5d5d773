// Access to the compiler module, and conversion of its C types.
#pragma once

#include <string>

#include "spirv/module/spirv_module.h"
#include "spirv/spirv.h"

namespace wrinkle {

// Returns the module's function table, or null and sets `why`. The first result is cached.
const WrinkleSpirvModule* spirv_module(std::string& why);

inline WrinkleSpirvSink sink_of(std::string& text) {
    return {&text, [](void* user, const void* bytes, uint64_t size) {
                static_cast<std::string*>(user)->append(static_cast<const char*>(bytes), size);
            }};
}

inline WrinkleSpirvWords view_of(const SpirvWords& words) {
    return {words.data(), words.size()};
}

}  // namespace wrinkle
