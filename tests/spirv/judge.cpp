#include "spirv/judge.h"

#include "glslang/validate.h"
#include "spirv/metal.h"
#include "spirv/spirv.h"

namespace wrinkle::test {
namespace {

std::string spirv_errors(const std::string& bytes) {
    std::string log;
    if (bytes.size() % 4 != 0 || !bytes.starts_with("\x03\x02\x23\x07")) return "no SPIR-V";
    return is_valid(words_of(bytes), log) ? "" : log + disassembly(bytes);
}

}  // namespace

std::string errors_of(const Shader& shader) {
    const std::string& target = shader.reflection.target;
    if (!shader.problems.empty()) return shader.problems[0].message;
    if (target == "spirv") return spirv_errors(shader.vertex) + spirv_errors(shader.fragment);
    if (target == "msl") return metal_errors(shader);
    if (has_validator(*find_target(target))) return compile_errors(shader);
    return bracket_errors(shader.source) + bracket_errors(shader.vertex) +
           bracket_errors(shader.fragment);
}

}  // namespace wrinkle::test
