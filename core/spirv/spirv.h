// Targets that are no GLSL: SPIR-V for Vulkan, and HLSL and Metal made from it. glslang,
// SPIRV-Tools and SPIRV-Cross do the work, in a module that is opened on first need
// (base/companion.h says where), so that nothing else pays for them. Equal inputs give equal bytes.
// Safe on any number of threads.
//
// spirv   SPIR-V 1.0 words, little-endian as files hold them. Optimised inside functions; what is
//         called stays a function. Names are kept.
// hlsl    shader model 5.0, entry points `main`. Vertex attributes have the semantics POSITION,
//         NORMAL, TANGENT, TEXCOORD0 ... and COLOR0. An image is a texture and, called
//         _NAME_sampler, a sampler state of the same number. Matrices are stored by columns, as
//         those of GLSL. Uniforms are called VARIABLE_NAME, the block's variable first.
// msl     Metal 2.0, entry points NAME_vertex and NAME_fragment. An image has a sampler
//         NAMESmplr.
//
// HLSL and Metal have a comment where the code of another node begins, as GLSL has.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/emit.h"

namespace wrinkle {

// Whether the module is there; else false, with the reason in `why` (companion_remedy helps).
bool have_spirv_tools(std::string& why);

// emit(), and for a target that is no GLSL what its texts become: `vertex` and `fragment` hold the
// target's bytes, and the reflection its names, numbers and lines. A text that is refused is a
// problem on the node that its line came from.
Shader write_shader(const Module& module, const EmitOptions& options);

using SpirvWords = std::vector<uint32_t>;
enum class ShaderStage : uint8_t { vertex, fragment };
enum class Lines : uint8_t { forget, keep };  // keep: which line each instruction came from
enum class Inlining : uint8_t { none, all };  // all: as `spirv-opt -O`

// The steps by themselves. Empty, with the compiler's log, when they fail.
std::optional<SpirvWords> compile_to_spirv(std::string_view glsl450, ShaderStage stage, Lines lines,
                                           std::string& log);
std::optional<SpirvWords> optimised(const SpirvWords& words, Inlining inlining, std::string& log);
bool is_valid(const SpirvWords& words, std::string& log);  // by the rules of Vulkan 1.0

// The bytes of a file as text; empty when they are no SPIR-V.
std::string disassembly(std::string_view bytes);
std::string bytes_of(const SpirvWords& words);
SpirvWords words_of(std::string_view bytes);

}  // namespace wrinkle
