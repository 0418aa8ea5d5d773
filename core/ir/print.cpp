#include "ir/inspect.h"

#include <unordered_set>

#include "base/text.h"
#include "ir/rewrite.h"

namespace wrinkle {
namespace {

std::string swizzle_text(uint32_t extra) {
    std::string text = ".";
    for (int i = 0; i < swizzle_count(extra); ++i)
        text += "xyzw"[swizzle_component(extra, i)];
    return text;
}

std::string extra_text(const Module& m, const Inst& inst) {
    switch (inst.op) {
        case Op::literal_:
            return " " + shortest(inst.value);
        case Op::input_: {
            static constexpr const char* suffix[] = {"", "_dx", "_dy"};
            return " " + std::string(info(input_of(inst.extra)).name) +
                   suffix[static_cast<size_t>(variant_of(inst.extra))];
        }
        case Op::parameter_: {
            const Parameter& parameter = m.parameters[inst.extra];
            return " " + m.nodes[parameter.node].path + "." + parameter.port;
        }
        case Op::swizzle_:
            return swizzle_text(inst.extra);
        case Op::region_param_:
            return " " + std::to_string(inst.level) + "." + std::to_string(inst.extra);
        case Op::loop_:
        case Op::call_:
            return " @" + std::to_string(inst.extra);
        default:
            return inst.extra ? " #" + std::to_string(inst.extra) : "";
    }
}

std::string region_text(const Module& m, uint32_t index) {
    const Region& region = m.region(index);
    const bool loop = region.kind == RegionKind::loop;
    std::string text = "@" + std::to_string(index) + (loop ? " loop" : " function");
    if (loop) text += " of at most " + std::to_string(region.max_iterations);
    if (!region.name.empty()) text += " " + region.name;
    text += " (" + joined(region.params, ", ", [](Type type) { return info(type).name; }) + ") ->";
    for (const Id result : region.results)
        text += " %" + std::to_string(result);
    return text + "\n";
}

}  // namespace

std::string print(const Module& module) {
    const std::vector<bool> needed = reachable(module);
    std::string text;
    std::unordered_set<uint32_t> shown;  // regions
    for (Id id = 1; id < module.size(); ++id) {
        if (!needed[id]) continue;
        const Inst& inst = module[id];
        if ((inst.op == Op::loop_ || inst.op == Op::call_) && shown.insert(inst.extra).second)
            text += region_text(module, inst.extra);
        text += "%" + std::to_string(id) + " " + std::string(info(inst.type).name) + " = " +
                std::string(info(inst.op).name) + extra_text(module, inst);
        for (const Id operand : module.operands(id))
            text += " %" + std::to_string(operand);
        if (const uint32_t node = module.origin[id]) text += "  ; " + module.nodes[node].path;
        text += "\n";
    }
    for (const ModuleOutput& output : module.outputs)
        text += "output " + output.name + " = %" + std::to_string(output.value) + "\n";
    return text;
}

}  // namespace wrinkle
