#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <exception>
#include <vector>

#include "spirv/module/parts.h"

namespace wrinkle::spirv {
namespace {

struct Process {
    Process() { glslang::InitializeProcess(); }
    ~Process() { glslang::FinalizeProcess(); }
};

void set_environment(glslang::TShader& shader, EShLanguage stage) {
    shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
}

// Disables the optimiser of glslang: optimise() is a separate step.
std::vector<uint32_t> words_of(const glslang::TProgram& program, EShLanguage stage, bool lines) {
    glslang::SpvOptions options;
    options.generateDebugInfo = lines;
    options.disableOptimizer = true;
    std::vector<uint32_t> words;
    glslang::GlslangToSpv(*program.getIntermediate(stage), words, &options);
    return words;
}

}  // namespace

int32_t compile(WrinkleSpirvText source, uint32_t stage, int32_t lines, WrinkleSpirvSink words,
                WrinkleSpirvSink log) try {
    static const Process process;
    const EShLanguage language = stage == WRINKLE_SPIRV_VERTEX ? EShLangVertex : EShLangFragment;
    constexpr auto rules = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    glslang::TShader shader(language);
    const char* const text = source.data;
    const int length = static_cast<int>(source.size);
    const char* const name = "0";
    shader.setStringsWithLengthsAndNames(&text, &length, &name, 1);
    set_environment(shader, language);
    glslang::TProgram program;
    const bool parsed = shader.parse(GetDefaultResources(), 450, false, rules);
    program.addShader(&shader);
    if (!parsed || !program.link(rules)) {
        write(log, shader.getInfoLog());
        write(log, program.getInfoLog());
        return 0;
    }
    const std::vector<uint32_t> made = words_of(program, language, lines != 0);
    words.write(words.user, made.data(), made.size() * sizeof made[0]);
    return 1;
} catch (const std::exception& problem) {
    write(log, problem.what());
    return 0;
}

}  // namespace wrinkle::spirv
