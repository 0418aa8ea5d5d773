#include "ir/cost.h"

#include "ir/module_cloner.h"
#include "ir/op_traits.h"
#include "ir/rewrite.h"

namespace wrinkle {
namespace {

// Returns the cost of one instruction, without the body of the function or loop that it runs.
Cost own_cost(const Module& module, Id id) {
    const Inst& inst = module[id];
    const OpTraits& op = traits(inst.op);
    int operations = op.per_component * info(inst.type).lanes + op.fixed;
    if (op.per_operand) operations += op.per_operand * info(module.type(inst.arg[0])).lanes;
    return {is_sample(inst.op) ? 1U : 0U, static_cast<uint32_t>(operations)};
}

class Counter {
public:
    explicit Counter(const Module& module)
        : module_(module), seen_(module.size(), 0), functions_(module.region_count()) {
        // A function has a greater index than those that it calls.
        for (uint32_t i = 1; i < functions_.size(); ++i)
            if (module.region(i).kind == RegionKind::function)
                walk(module.region(i).results,
                     [&](Id, const Cost& cost) { functions_[i] += cost; });
    }

    // Visits each instruction that the roots need once, with its cost; that of a call is its
    // function's.
    template <class Each>
    void walk(const std::vector<Id>& roots, Each each) {
        ++walks_;
        std::vector<Id> open = roots;
        while (!open.empty()) {
            const Id id = open.back();
            open.pop_back();
            if (id == no_id || seen_[id] == walks_) continue;
            seen_[id] = walks_;
            const bool calls = module_[id].op == Op::call_;
            each(id, calls ? functions_[module_[id].extra] : own_cost(module_, id));
            append_dependencies(module_, id, false, open);
        }
    }

private:
    const Module& module_;
    std::vector<uint32_t> seen_;  // by Id: the last walk that visited it
    uint32_t walks_ = 0;
    std::vector<Cost> functions_;  // by region
};

}  // namespace

std::vector<Cost> cost_by_node(const Module& module) {
    std::vector<Cost> nodes(module.nodes.size());
    Counter counter(module);
    counter.walk(output_values(module),
                 [&](Id id, const Cost& cost) { nodes[module.origin[id]] += cost; });
    return nodes;
}

}  // namespace wrinkle
