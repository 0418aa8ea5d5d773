// The module's functions, implemented in one file per library.
#pragma once

#include <string_view>

#include "spirv/module/spirv_module.h"

namespace wrinkle::spirv {

inline void write(WrinkleSpirvSink sink, std::string_view text) {
    sink.write(sink.user, text.data(), text.size());
}

int32_t compile(WrinkleSpirvText source, uint32_t stage, int32_t lines, WrinkleSpirvSink words,
                WrinkleSpirvSink log);
int32_t optimise(WrinkleSpirvWords in, int32_t inlining, WrinkleSpirvSink words,
                 WrinkleSpirvSink log);
int32_t validate(WrinkleSpirvWords in, WrinkleSpirvSink log);
int32_t disassemble(WrinkleSpirvWords in, WrinkleSpirvSink text, WrinkleSpirvSink log);

}  // namespace wrinkle::spirv
