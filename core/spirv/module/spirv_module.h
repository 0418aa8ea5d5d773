/* C interface between core/spirv and the module with glslang and SPIRV-Tools.
 *
 * The module exports one symbol, wrinkle_spirv_module, which returns a table of functions. Only
 * plain data is passed: strings are UTF-8 with their length, SPIR-V is words in native byte order,
 * results are written to the caller's sinks, and exceptions do not leave the module. Thread-safe. A
 * function returns 1 on success, or 0 with the reason in `log`. The caller must check size and
 * version of the table.
 */
#ifndef WRINKLE_SPIRV_MODULE_H
#define WRINKLE_SPIRV_MODULE_H

#include <stdint.h>

#define WRINKLE_SPIRV_MODULE_VERSION 2u
#define WRINKLE_SPIRV_MODULE_SYMBOL "wrinkle_spirv_module"

#ifdef __cplusplus
extern "C" {
#endif

/* Appends bytes to a buffer of the caller. */
typedef struct WrinkleSpirvSink {
    void* user;
    void (*write)(void* user, const void* bytes, uint64_t size);
} WrinkleSpirvSink;

typedef struct WrinkleSpirvText {
    const char* data;
    uint64_t size;
} WrinkleSpirvText;

typedef struct WrinkleSpirvWords {
    const uint32_t* data;
    uint64_t count;
} WrinkleSpirvWords;

enum { WRINKLE_SPIRV_VERTEX = 0, WRINKLE_SPIRV_FRAGMENT = 1 };

typedef struct WrinkleSpirvModule {
    uint32_t size; /* sizeof this struct when the module was built */
    uint32_t version;
    /* GLSL 4.50 by the rules of Vulkan 1.0 to SPIR-V 1.0. `lines`: with debug info for lines. */
    int32_t (*compile)(WrinkleSpirvText source, uint32_t stage, int32_t lines,
                       WrinkleSpirvSink words, WrinkleSpirvSink log);
    /* `inlining`: the passes of spirv-opt -O; else passes that do not inline functions. */
    int32_t (*optimise)(WrinkleSpirvWords in, int32_t inlining, WrinkleSpirvSink words,
                        WrinkleSpirvSink log);
    int32_t (*validate)(WrinkleSpirvWords in, WrinkleSpirvSink log);
    int32_t (*disassemble)(WrinkleSpirvWords in, WrinkleSpirvSink text, WrinkleSpirvSink log);
} WrinkleSpirvModule;

typedef const WrinkleSpirvModule* (*WrinkleSpirvModuleEntry)(void);

#ifdef __cplusplus
}
#endif

#endif
