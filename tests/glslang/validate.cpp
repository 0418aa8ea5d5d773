#include "glslang/validate.h"

#include <glslang/Include/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include <sstream>

namespace wrinkle::test {
namespace {

// Default limits of a desktop; only what a fragment shader of ours can meet matters.
TBuiltInResource limits() {
    TBuiltInResource r{};
    r.maxDrawBuffers = 32;
    r.maxVertexAttribs = 64;
    r.maxVertexUniformComponents = r.maxFragmentUniformComponents = 4096;
    r.maxTextureImageUnits = r.maxCombinedTextureImageUnits = 80;
    r.maxVaryingFloats = r.maxVaryingComponents = 64;
    r.maxClipDistances = 8;
    r.limits.nonInductiveForLoops = r.limits.whileLoops = r.limits.doWhileLoops = true;
    r.limits.generalUniformIndexing = r.limits.generalSamplerIndexing = true;
    r.limits.generalVariableIndexing = r.limits.generalConstantMatrixVectorIndexing = true;
    r.limits.generalAttributeMatrixVectorIndexing = r.limits.generalVaryingIndexing = true;
    return r;
}

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

}  // namespace

std::string compile_errors(const std::string& text, Stage stage) {
    static const Process process;
    const TBuiltInResource resources = limits();
    const EShLanguage language = stage == Stage::vertex ? EShLangVertex : EShLangFragment;
    glslang::TShader shader(language);
    const char* source = text.c_str();
    shader.setStrings(&source, 1);
    const bool parsed = shader.parse(&resources, 330, ECoreProfile, false, false, EShMsgDefault);
    glslang::TProgram program;
    program.addShader(&shader);
    if (parsed && program.link(EShMsgDefault)) return {};
    return std::string(shader.getInfoLog()) + program.getInfoLog() + "\n" + numbered(text);
}

std::string wrapped(const Shader& shader) {
    std::string text = "#version 330 core\n#line 1\n" + shader.source;
    const Reflection& r = shader.reflection;
    std::string sum = "    result = vec4(0.0);\n";
    for (const MemberInfo& member : r.members)
        text += "in " + std::string(info(member.type).name) + " WrTest_" + member.name + ";\n";
    for (const FunctionInfo& function : r.functions)
        sum += "    result += vec4(" + function.function + (r.struct_name.empty() ? "()" : "(s)") +
               (function.type == Type::float_  ? ")"
                : function.type == Type::vec2_ ? ", 0.0, 0.0)"
                : function.type == Type::vec3_ ? ", 0.0)"
                                               : ")") +
               ";\n";
    text += "out vec4 result;\nvoid main() {\n";
    if (!r.struct_name.empty()) text += "    " + r.struct_name + " s;\n";
    for (const MemberInfo& member : r.members)
        text += "    s." + member.name + " = WrTest_" + member.name + ";\n";
    return text + sum + "}\n";
}

std::string compile_errors(const Shader& shader) {
    if (!shader.problems.empty()) return shader.problems[0].message;
    if (!shader.source.empty()) return compile_errors(wrapped(shader), Stage::fragment);
    return compile_errors(shader.vertex, Stage::vertex) +
           compile_errors(shader.fragment, Stage::fragment);
}

}  // namespace wrinkle::test
