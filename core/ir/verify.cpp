#include "ir/inspect.h"

#include <algorithm>
#include <unordered_set>

#include "ir/add.h"
#include "ir/module_cloner.h"
#include "ir/rewrite.h"

namespace wrinkle {
namespace {

std::string at(Id id, const std::string& what) {
    return "%" + std::to_string(id) + ": " + what;
}

std::string check_types(const Module& m, Id id) {
    const Inst& inst = m[id];
    if (info(inst.op).rule == Rule::leaf || inst.type == Type::tuple_ || inst.op == Op::result_ ||
        inst.op == Op::swizzle_)
        return {};
    std::vector<Type> types;
    for (const Id operand : m.operands(id))
        types.push_back(m.type(operand));
    std::string why;
    return result_type(inst.op, types, inst.type, &why) == inst.type ? "" : at(id, "type: " + why);
}

std::string check_region(const Module& m, Id id) {
    const Inst& inst = m[id];
    const Region& region = m.region(inst.extra);
    const auto args = m.operands(id);
    if (args.size() != region.params.size()) return at(id, "arguments and parameters differ");
    for (size_t k = 0; k < args.size(); ++k)
        if (m.type(args[k]) != region.params[k]) return at(id, "an argument has another type");
    if (inst.op == Op::loop_ && region.results.size() != region.params.size() + 1)
        return at(id, "a loop's state and next state differ");
    for (const Id result : region.results)
        if (result >= id || result == poison)
            return at(id, "a region's result does not precede its use");
    return {};
}

std::string check_level(const Module& m, Id id) {
    const Inst& inst = m[id];
    if (inst.op == Op::region_param_)
        return inst.level > 0 || inst.extra < m.open_inputs.size()
                   ? ""
                   : at(id, "parameter of no region");
    int level = 0;
    for (const Id operand : m.operands(id))
        level = std::max<int>(level, m[operand].level);
    if (inst.op == Op::loop_) return inst.level >= level ? "" : at(id, "level");
    if (inst.level != level) return at(id, "its level is not that of its operands");
    if (level > 0 && info(inst.op).flags & WR_FLAG_IMPLICIT)
        return at(id, "an implicit derivative inside a region");
    return {};
}

// A region reads its own parameters; a function captures only global values and values computed
// from them.
std::string check_body(const Module& m, uint32_t index) {
    const Region& region = m.region(index);
    if (region.is_open()) return {};
    const RegionBody body = region_body(m, region);
    if (region.kind == RegionKind::function)
        for (const Id id : body.captured)
            if (!is_of_globals(m, id)) return at(id, "a function reads a value of outside");
    return body.parameters_fit ? "" : "a region reads a parameter that it does not have";
}

}  // namespace

std::string verify(const Module& module) {
    const std::vector<bool> needed = reachable(module);
    std::unordered_set<uint32_t> checked;  // regions
    for (Id id = 1; id < module.size(); ++id) {
        if (!needed[id]) continue;
        for (const Id operand : module.operands(id))
            if (operand >= id || operand == poison) return at(id, "an operand does not precede it");
        const Op op = module[id].op;
        std::string problem = check_types(module, id);
        if (problem.empty()) problem = check_level(module, id);
        if (problem.empty() && (op == Op::loop_ || op == Op::call_)) {
            problem = check_region(module, id);
            if (problem.empty() && checked.insert(module[id].extra).second)
                problem = check_body(module, module[id].extra);
        }
        if (!problem.empty()) return problem;
    }
    for (const ModuleOutput& output : module.outputs)
        if (output.value != poison && module[output.value].level > 0)
            return "output " + output.name + " is inside a region";
    return {};
}

}  // namespace wrinkle
