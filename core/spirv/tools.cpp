#include "spirv/tools.h"

#include <cstring>

#include "base/dynamic_library.h"

namespace wrinkle {
namespace {

struct Found {
    const WrinkleSpirvModule* module = nullptr;
    std::string why;
};

Found find_module() {
    const std::string what = "the module for SPIR-V, HLSL and Metal";
    const DynamicLibrary companion =
        open_library(WRINKLE_SPIRV_MODULE, WRINKLE_SPIRV_MODULE_SYMBOL, what);
    if (!companion.symbol) return {nullptr, companion.why};
    const auto entry = reinterpret_cast<WrinkleSpirvModuleEntry>(companion.symbol);
    const WrinkleSpirvModule* module = entry();
    if (module && module->size >= sizeof(WrinkleSpirvModule) &&
        module->version == WRINKLE_SPIRV_MODULE_VERSION)
        return {module, ""};
    return {nullptr, wrong_version(companion, what)};
}

std::optional<SpirvWords> made(bool good, const std::string& bytes) {
    if (!good) return {};
    return words_of(bytes);
}

uint32_t number_of(ShaderStage stage) {
    return stage == ShaderStage::vertex ? WRINKLE_SPIRV_VERTEX : WRINKLE_SPIRV_FRAGMENT;
}

}  // namespace

const WrinkleSpirvModule* spirv_module(std::string& why) {
    static const Found found = find_module();
    why = found.why;
    return found.module;
}

bool have_spirv_tools(std::string& why) {
    return spirv_module(why) != nullptr;
}

std::optional<SpirvWords> compile_to_spirv(std::string_view glsl450, ShaderStage stage, Lines lines,
                                           std::string& log) {
    const WrinkleSpirvModule* module = spirv_module(log);
    if (!module) return {};
    std::string bytes;
    const bool good = module->compile({glsl450.data(), glsl450.size()}, number_of(stage),
                                      lines == Lines::keep, sink_of(bytes), sink_of(log));
    return made(good, bytes);
}

std::optional<SpirvWords> optimised(const SpirvWords& words, Inlining inlining, std::string& log) {
    const WrinkleSpirvModule* module = spirv_module(log);
    if (!module) return {};
    std::string bytes;
    const bool good =
        module->optimise(view_of(words), inlining == Inlining::all, sink_of(bytes), sink_of(log));
    return made(good, bytes);
}

bool is_valid(const SpirvWords& words, std::string& log) {
    const WrinkleSpirvModule* module = spirv_module(log);
    return module && module->validate(view_of(words), sink_of(log));
}

std::string disassembly(std::string_view bytes) {
    std::string text, log;
    const WrinkleSpirvModule* module = spirv_module(log);
    const SpirvWords words = words_of(bytes);
    if (!module || !module->disassemble(view_of(words), sink_of(text), sink_of(log))) return {};
    return text;
}

std::string bytes_of(const SpirvWords& words) {
    std::string bytes(words.size() * sizeof(uint32_t), '\0');
    if (!words.empty()) std::memcpy(bytes.data(), words.data(), bytes.size());
    return bytes;
}

SpirvWords words_of(std::string_view bytes) {
    SpirvWords words(bytes.size() / sizeof(uint32_t));
    if (!words.empty()) std::memcpy(words.data(), bytes.data(), words.size() * sizeof(uint32_t));
    return words;
}

}  // namespace wrinkle
