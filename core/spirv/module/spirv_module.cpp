#include "spirv/module/parts.h"

extern "C" __attribute__((visibility("default"))) const WrinkleSpirvModule* wrinkle_spirv_module() {
    static const WrinkleSpirvModule table = {
        sizeof(WrinkleSpirvModule), WRINKLE_SPIRV_MODULE_VERSION, wrinkle::spirv::compile,
        wrinkle::spirv::optimise,   wrinkle::spirv::validate,     wrinkle::spirv::disassemble,
        wrinkle::spirv::translate};
    return &table;
}
