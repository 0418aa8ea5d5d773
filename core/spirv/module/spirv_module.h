/* The border between core/spirv and the module that holds glslang, SPIRV-Tools and SPIRV-Cross.
 *
 * The module exports one symbol, wrinkle_spirv_module, which returns a table of functions. Only
 * plain data crosses: texts are UTF-8 with their length, SPIR-V is words of the machine's own
 * order, results go to the caller's sinks, and no exception leaves. Everything may be called from
 * several threads at once. A function returns 1, or 0 with the reason in `log`.
 */
#ifndef WRINKLE_SPIRV_MODULE_H
#define WRINKLE_SPIRV_MODULE_H

#include <stdint.h>

#define WRINKLE_SPIRV_MODULE_VERSION 1u
#define WRINKLE_SPIRV_MODULE_SYMBOL "wrinkle_spirv_module"

#ifdef __cplusplus
extern "C" {
#endif

/* Appends bytes to something of the caller's. */
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
enum { WRINKLE_SPIRV_HLSL = 0, WRINKLE_SPIRV_MSL = 1 };

/* What a vertex attribute is called in HLSL. */
typedef struct WrinkleSpirvSemantic {
    uint32_t location;
    const char* semantic;
} WrinkleSpirvSemantic;

/* What a block of uniforms is called as a variable. */
typedef struct WrinkleSpirvName {
    const char* block;
    const char* variable;
} WrinkleSpirvName;

/* A text to make. Metal's buffers, textures and samplers have the numbers of their bindings. */
typedef struct WrinkleSpirvJob {
    uint32_t language; /* WRINKLE_SPIRV_HLSL or _MSL */
    uint32_t stage;
    const char* entry; /* the entry point's name */
    const WrinkleSpirvName* names;
    uint32_t name_count;
    const WrinkleSpirvSemantic* semantics;
    uint32_t semantic_count;
} WrinkleSpirvJob;

typedef struct WrinkleSpirvModule {
    uint32_t size; /* of this struct as the module knows it */
    uint32_t version;
    /* GLSL 4.50 by the rules of Vulkan 1.0 to SPIR-V 1.0. `lines`: with the line of everything. */
    int32_t (*compile)(WrinkleSpirvText source, uint32_t stage, int32_t lines,
                       WrinkleSpirvSink words, WrinkleSpirvSink log);
    /* `inlining`: as spirv-opt -O; else what leaves functions as they are. */
    int32_t (*optimise)(WrinkleSpirvWords in, int32_t inlining, WrinkleSpirvSink words,
                        WrinkleSpirvSink log);
    int32_t (*validate)(WrinkleSpirvWords in, WrinkleSpirvSink log);
    int32_t (*disassemble)(WrinkleSpirvWords in, WrinkleSpirvSink text, WrinkleSpirvSink log);
    /* To another language; with "#line N" before what came from it, where the words know that. */
    int32_t (*translate)(WrinkleSpirvWords in, const WrinkleSpirvJob* job, WrinkleSpirvSink text,
                         WrinkleSpirvSink log);
} WrinkleSpirvModule;

typedef const WrinkleSpirvModule* (*WrinkleSpirvModuleEntry)(void);

#ifdef __cplusplus
}
#endif

#endif
