#include "glslang/validate.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include <sstream>

#include "emit/language.h"

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

namespace {

// The inputs of several materials: one member of a name for all of them.
std::map<std::string, Type> inputs_of(std::span<const Shader> shaders) {
    std::map<std::string, Type> inputs;
    for (const Shader& shader : shaders)
        for (const MemberInfo& member : shader.reflection.members)
            inputs.emplace(member.name, member.type);
    return inputs;
}

// Returns code that calls the material with inputs named `prefix` + member and adds its outputs to
// WrTest_sum.
std::string call(const Reflection& r, const Language& language, const std::string& prefix) {
    std::string body = "    {\n";
    if (!r.struct_name.empty()) body += "    " + r.struct_name + " s;\n";
    for (const MemberInfo& member : r.members)
        body += "    s." + member.name + " = " + prefix + member.name + ";\n";
    body += "    " + result_type(r, language) + " m = " + call_text(r, "s") + ";\n";
    constexpr const char* rest[] = {"", "", ", 0.0, 0.0", ", 0.0", ""};  // by lanes
    for (const OutputInfo& output : r.outputs) {
        const std::string value = output_text(r, output, "m");
        const bool scalar = output.type == Type::float_;
        body += "    WrTest_sum += " +
                (scalar ? value
                        : std::string(language.type(Type::vec4_)) + "(" + value +
                              rest[info(output.type).lanes] + ")") +
                ";\n";
    }
    return body + "    }\n";
}

std::string wrapped_glsl(std::span<const Shader> shaders, const Target& target) {
    std::string text = std::string(target.version) + "\n#line 1\n", body;
    for (const Shader& shader : shaders) {
        text += shader.source;
        body += call(shader.reflection, target.language(), "WrTest_");
    }
    size_t location = 0;
    for (const auto& [name, type] : inputs_of(shaders)) {
        if (target.bindings != Bindings::by_name)
            text +=
                "layout(location = " +
                std::to_string(std::exchange(location, location + (type == Type::mat3_ ? 3 : 1))) +
                ") ";
        text += "in " + std::string(info(type).name) + " WrTest_" + name + ";\n";
    }
    return text + "layout(location = 0) out vec4 WrTest_sum;\nvoid main() {\n" +
           "    WrTest_sum = vec4(0.0);\n" + body + "}\n";
}

std::string wrapped_hlsl(std::span<const Shader> shaders) {
    std::string text, body;
    for (const Shader& shader : shaders) {
        text += shader.source;
        body += call(shader.reflection, hlsl(), "v.");
    }
    text += "struct WrTest_inputs {\n";
    size_t location = 0;
    for (const auto& [name, type] : inputs_of(shaders))
        text += "    " + std::string(hlsl().type(type)) + " " + name + " : TEXCOORD" +
                std::to_string(location++) + ";\n";
    return text +
           "    float4 place : SV_Position;\n};\n"
           "float4 main(WrTest_inputs v) : SV_Target0 {\n"
           "    float4 WrTest_sum = 0.0;\n" +
           body + "    return WrTest_sum;\n}\n";
}

}  // namespace

std::string wrapped(std::span<const Shader> shaders) {
    const Target& target = *find_target(shaders[0].reflection.target);
    return target.name == "hlsl" ? wrapped_hlsl(shaders) : wrapped_glsl(shaders, target);
}

bool has_validator(const Target& target) {
    return target.name == "hlsl" || (target.version.starts_with("#version") && !is_binary(target));
}

std::string compile_errors(const Shader& shader) {
    if (!shader.problems.empty()) return shader.problems[0].message;
    const auto errors = [&](const std::string& text, Stage stage) {
        return shader.reflection.target == "hlsl" ? hlsl_errors(text, stage)
                                                  : compile_errors(text, stage);
    };
    if (!shader.source.empty()) return errors(wrapped({&shader, 1}), Stage::fragment);
    return errors(shader.vertex, Stage::vertex) + errors(shader.fragment, Stage::fragment);
}

}  // namespace wrinkle::test
