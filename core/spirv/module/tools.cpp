#include <exception>
#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>
#include <string>
#include <vector>

#include "spirv/module/parts.h"

namespace wrinkle::spirv {
namespace {

constexpr spv_target_env environment = SPV_ENV_VULKAN_1_0;

spvtools::MessageConsumer to_log(WrinkleSpirvSink log) {
    return [log](spv_message_level_t, const char*, const spv_position_t& at, const char* message) {
        write(log, "instruction " + std::to_string(at.index) + ": " + message + "\n");
    };
}

// Passes without inlining: a call graph with shared callees grows exponentially when inlined, and
// drivers inline themselves.
void register_light_passes(spvtools::Optimizer& optimizer) {
    optimizer.RegisterPass(spvtools::CreateScalarReplacementPass(0))
        .RegisterPass(spvtools::CreateLocalAccessChainConvertPass())
        .RegisterPass(spvtools::CreateLocalSingleBlockLoadStoreElimPass())
        .RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
        .RegisterPass(spvtools::CreateSSARewritePass())
        .RegisterPass(spvtools::CreateAggressiveDCEPass())
        .RegisterPass(spvtools::CreateSimplificationPass())
        .RegisterPass(spvtools::CreateRedundancyEliminationPass())
        .RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateBlockMergePass())
        .RegisterPass(spvtools::CreateAggressiveDCEPass())
        .RegisterPass(spvtools::CreateCompactIdsPass());
}

}  // namespace

int32_t optimise(WrinkleSpirvWords in, int32_t inlining, WrinkleSpirvSink words,
                 WrinkleSpirvSink log) try {
    spvtools::Optimizer optimizer(environment);
    optimizer.SetMessageConsumer(to_log(log));
    if (inlining)
        optimizer.RegisterPerformancePasses();
    else
        register_light_passes(optimizer);
    std::vector<uint32_t> made;
    if (!optimizer.Run(in.data, in.count, &made)) return 0;
    words.write(words.user, made.data(), made.size() * sizeof made[0]);
    return 1;
} catch (const std::exception& problem) {
    write(log, problem.what());
    return 0;
}

int32_t validate(WrinkleSpirvWords in, WrinkleSpirvSink log) try {
    spvtools::SpirvTools tools(environment);
    tools.SetMessageConsumer(to_log(log));
    return tools.Validate(in.data, in.count) ? 1 : 0;
} catch (const std::exception& problem) {
    write(log, problem.what());
    return 0;
}

int32_t disassemble(WrinkleSpirvWords in, WrinkleSpirvSink text, WrinkleSpirvSink log) try {
    spvtools::SpirvTools tools(environment);
    tools.SetMessageConsumer(to_log(log));
    std::string made;
    if (!tools.Disassemble(std::vector<uint32_t>(in.data, in.data + in.count), &made,
                           SPV_BINARY_TO_TEXT_OPTION_INDENT |
                               SPV_BINARY_TO_TEXT_OPTION_FRIENDLY_NAMES |
                               SPV_BINARY_TO_TEXT_OPTION_NO_HEADER))
        return 0;
    write(text, made);
    return 1;
} catch (const std::exception& problem) {
    write(log, problem.what());
    return 0;
}

}  // namespace wrinkle::spirv

extern "C" __attribute__((visibility("default"))) const WrinkleSpirvModule* wrinkle_spirv_module() {
    using namespace wrinkle::spirv;
    static const WrinkleSpirvModule table = {sizeof(WrinkleSpirvModule),
                                             WRINKLE_SPIRV_MODULE_VERSION,
                                             compile,
                                             optimise,
                                             validate,
                                             disassemble};
    return &table;
}
