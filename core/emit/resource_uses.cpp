// Images and numbers as parameters of functions, in languages without global resources.
#include <span>

#include "emit/interface.h"

namespace wrinkle {
namespace {

// The images and numbers that a function uses, itself or by its calls.
struct FunctionResources {
    std::vector<bool> images;  // by index in Module::resources
    bool numbers = false;
};

void add(const FunctionResources& callee, FunctionResources& used) {
    used.numbers = used.numbers || callee.numbers;
    for (size_t i = 0; i < callee.images.size(); ++i)
        used.images[i] = used.images[i] || callee.images[i];
}

FunctionResources resources_of(const Module& m, std::span<const Id> results,
                               const std::vector<FunctionResources>& of_functions) {
    FunctionResources used{std::vector<bool>(m.resources.size()), false};
    std::vector<bool> seen(m.size());
    std::vector<Id> open(results.begin(), results.end());
    while (!open.empty()) {
        const Id id = open.back();
        open.pop_back();
        if (seen[id]) continue;
        seen[id] = true;
        const Inst& inst = m[id];
        open.insert(open.end(), m.operands(id).begin(), m.operands(id).end());
        if (reads_image(inst.op)) used.images[inst.extra] = true;
        if (inst.op == Op::parameter_) used.numbers = true;
        if (inst.op == Op::call_) add(of_functions[inst.extra], used);
        if (inst.op != Op::loop_) continue;
        const auto& results_of_loop = m.region(inst.extra).results;
        open.insert(open.end(), results_of_loop.begin(), results_of_loop.end());
    }
    return used;
}

std::string listed(const FunctionResources& used, const Reflection& r, std::string_view image,
                   std::string_view block) {
    std::string list;
    for (const SamplerInfo& sampler : r.samplers)
        if (used.images[sampler.resource]) append_item(list, filled(image, {{'n', sampler.name}}));
    if (used.numbers && r.parameter_block)
        append_item(list, filled(block, {{'t', r.parameter_block->name},
                                         {'n', r.parameter_block->variable}}));
    return list;
}

}  // namespace

void set_resource_uses(const EmitAnalysis& analysis, const Language& language, Interface& face) {
    const Reflection& r = face.reflection;
    Symbols& symbols = face.symbols;
    if (r.parameter_block)
        for (const UniformInfo& uniform : r.uniforms)
            symbols.parameters[uniform.parameter] = filled(
                language.block_use, {{'v', r.parameter_block->variable}, {'n', uniform.name}});
    if (language.image_parameter.empty()) return;
    const Module& m = analysis.module();
    std::vector<FunctionResources> used(m.region_count());
    for (const uint32_t region : analysis.functions) {
        used[region] = resources_of(m, m.region(region).results, used);
        symbols.resource_parameters[region] =
            listed(used[region], r, language.image_parameter, language.block_parameter);
        symbols.resource_arguments[region] =
            listed(used[region], r, language.image_argument, language.block_argument);
    }
    const FunctionResources all{std::vector<bool>(m.resources.size(), true), true};
    symbols.material_parameters =
        listed(all, r, language.image_parameter, language.block_parameter);
    symbols.material_arguments = listed(all, r, language.image_argument, language.block_argument);
}

}  // namespace wrinkle
