// Compiles a Shader in GLSL 4.50 to SPIR-V.
#include "base/dynamic_library.h"
#include "emit/log.h"
#include "spirv/tools.h"

namespace wrinkle {
namespace {

// Replaces the text by its SPIR-V. Returns false and sets the shader's problem if it is rejected.
bool compile_stage(ShaderStage stage, std::string& text, Shader& shader) {
    std::string log;
    const auto words = compile_to_spirv(text, stage, Lines::forget, log);
    const auto smaller = words ? optimised(*words, Inlining::none, log) : std::nullopt;
    if (smaller) {
        text = bytes_of(*smaller);
        return true;
    }
    shader.problems.push_back(
        problem_of_log("SPIR-V cannot be made from the GLSL", log, shader.reflection));
    return false;
}

}  // namespace

Shader write_shader(const Module& module, const EmitOptions& options) {
    Shader shader = emit(module, options);
    if (!is_binary(*options.target) || !shader.problems.empty()) return shader;
    if (std::string why; !have_spirv_tools(why))
        shader.problems.push_back({RuleId::environment, 0, why, library_remedy});
    else if (compile_stage(ShaderStage::vertex, shader.vertex, shader) &&
             compile_stage(ShaderStage::fragment, shader.fragment, shader))
        shader.reflection.lines.clear();
    if (!shader.problems.empty()) shader.vertex = shader.fragment = "";
    return shader;
}

}  // namespace wrinkle
