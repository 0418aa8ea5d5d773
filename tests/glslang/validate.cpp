#include "glslang/validate.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include <sstream>

#include "ir/op.h"

namespace wrinkle::test {
namespace {

struct Process {
    Process() { glslang::InitializeProcess(); }
    ~Process() { glslang::FinalizeProcess(); }
};

std::string numbered(const std::string& text) {
    std::istringstream lines(text);
    std::string result, line;
    for (int i = 1; std::getline(lines, line); ++i)
        result += std::to_string(i) + ": " + line + "\n";
    return result;
}

// Parses and links the source, by the rules of Vulkan if its version is 450.
struct Compilation {
    Compilation(const std::string& text, Stage stage);

    EShLanguage language;
    glslang::TShader shader;
    glslang::TProgram program;
    bool fine = false;
};

Compilation::Compilation(const std::string& text, Stage stage)
    : language(stage == Stage::vertex ? EShLangVertex : EShLangFragment), shader(language) {
    static const Process process;
    const char* source = text.c_str();
    shader.setStrings(&source, 1);
    const bool vulkan = text.starts_with("#version 450");
    const auto rules =
        static_cast<EShMessages>(vulkan ? EShMsgSpvRules | EShMsgVulkanRules : EShMsgDefault);
    if (vulkan) {
        shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
        shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
        shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
    }
    const bool parsed = shader.parse(GetDefaultResources(), 330, ECoreProfile, false, false, rules);
    program.addShader(&shader);
    fine = parsed && program.link(rules);
}

}  // namespace

std::string compile_errors(const std::string& text, Stage stage) {
    Compilation compiled(text, stage);
    if (compiled.fine) return {};
    return std::string(compiled.shader.getInfoLog()) + compiled.program.getInfoLog() + "\n" +
           numbered(text);
}

std::string hlsl_errors(const std::string& text, Stage stage) {
    static const Process process;
    const EShLanguage language = stage == Stage::vertex ? EShLangVertex : EShLangFragment;
    constexpr auto rules =
        static_cast<EShMessages>(EShMsgReadHlsl | EShMsgSpvRules | EShMsgVulkanRules);
    glslang::TShader shader(language);
    const char* source = text.c_str();
    shader.setStrings(&source, 1);
    shader.setEntryPoint("main");
    shader.setEnvInput(glslang::EShSourceHlsl, language, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
    const bool parsed = shader.parse(GetDefaultResources(), 500, false, rules);
    glslang::TProgram program;
    program.addShader(&shader);
    if (parsed && program.link(rules)) return {};
    return std::string(shader.getInfoLog()) + program.getInfoLog() + "\n" + numbered(text);
}

std::map<std::string, Place> places(const std::string& text, Stage stage) {
    std::map<std::string, Place> found;
    Compilation compiled(text, stage);
    if (!compiled.fine || !compiled.program.buildReflection(EShReflectionAllBlockVariables))
        return found;
    for (int i = 0; i < compiled.program.getNumUniformBlocks(); ++i) {
        const glslang::TObjectReflection& block = compiled.program.getUniformBlock(i);
        found[block.name] = {block.getBinding(), -1, block.size};
    }
    for (int i = 0; i < compiled.program.getNumUniformVariables(); ++i) {
        const glslang::TObjectReflection& uniform = compiled.program.getUniform(i);
        found[uniform.name] = {uniform.getBinding(), uniform.offset, -1};
    }
    return found;
}

std::string wrapped(std::span<const Shader> shaders) {
    const Target& target = *find_target(shaders[0].reflection.target);
    std::string text = std::string(target.version) + "\n#line 1\n", body;
    std::map<std::string, Type> inputs;
    for (const Shader& shader : shaders) {
        const Reflection& r = shader.reflection;
        text += shader.source;
        body += "    {\n";
        if (!r.struct_name.empty()) body += "    " + r.struct_name + " s;\n";
        for (const MemberInfo& member : r.members) {
            inputs.emplace(member.name, member.type);
            body += "    s." + member.name + " = WrTest_" + member.name + ";\n";
        }
        body += "    " + result_type(r) + " m = " + call_text(r, "s") + ";\n";
        for (const OutputInfo& output : r.outputs)
            body += "    WrTest_sum += vec4(" + output_text(r, output, "m") +
                    (output.type == Type::float_  ? ")"
                     : output.type == Type::vec2_ ? ", 0.0, 0.0)"
                     : output.type == Type::vec3_ ? ", 0.0)"
                                                  : ")") +
                    ";\n";
        body += "    }\n";
    }
    size_t location = 0;
    for (const auto& [name, type] : inputs) {
        if (target.bindings != Bindings::by_name)
            text += "layout(location = " + std::to_string(location++) + ") ";
        text += "in " + std::string(info(type).name) + " WrTest_" + name + ";\n";
    }
    return text + "layout(location = 0) out vec4 WrTest_sum;\nvoid main() {\n" +
           "    WrTest_sum = vec4(0.0);\n" + body + "}\n";
}

std::string compile_errors(const Shader& shader) {
    if (!shader.problems.empty()) return shader.problems[0].message;
    if (!shader.source.empty()) return compile_errors(wrapped({&shader, 1}), Stage::fragment);
    return compile_errors(shader.vertex, Stage::vertex) +
           compile_errors(shader.fragment, Stage::fragment);
}

}  // namespace wrinkle::test
