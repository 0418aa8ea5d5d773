// SPIR-V for Vulkan: SPIR-V 1.0 words, little-endian as in files, optimised inside functions; calls
// are not inlined and names are preserved. Uses glslang and SPIRV-Tools, in a dynamic library that
// is loaded on first use (searched as in base/dynamic_library.h), so that other programs do not
// load it. Equal inputs give equal bytes. Thread-safe.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "emit/emit.h"

namespace wrinkle {

// Returns true if the module can be loaded; otherwise sets `why` (hint: library_remedy).
bool have_spirv_tools(std::string& why);

// Calls emit(); for the target SPIR-V also compiles the result: `vertex` and `fragment` hold its
// bytes. Rejected source is reported as a problem on the node of the offending line; `vertex` and
// `fragment` are then empty.
Shader write_shader(const Module& module, const EmitOptions& options);

using SpirvWords = std::vector<uint32_t>;
enum class ShaderStage : uint8_t { vertex, fragment };
enum class Lines : uint8_t { forget, keep };  // keep: source line of each instruction
enum class Inlining : uint8_t { none, all };  // all: passes of `spirv-opt -O`

// The individual steps. Return std::nullopt (is_valid: false) and set `log` on failure.
std::optional<SpirvWords> compile_to_spirv(std::string_view glsl450, ShaderStage stage, Lines lines,
                                           std::string& log);
std::optional<SpirvWords> optimised(const SpirvWords& words, Inlining inlining, std::string& log);
bool is_valid(const SpirvWords& words, std::string& log);  // rules of Vulkan 1.0

// Returns the disassembly of a SPIR-V file; "" if the bytes are not SPIR-V or without the module.
std::string disassembly(std::string_view bytes);
std::string bytes_of(const SpirvWords& words);
SpirvWords words_of(std::string_view bytes);

}  // namespace wrinkle
