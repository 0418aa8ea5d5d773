#include "ir/cost.h"

#include "ir/module_cloner.h"

namespace wrinkle {
namespace {

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
            if (id == poison || seen_[id] == walks_) continue;
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

Cost own_cost(const Module& module, Id id) {
    const Inst& inst = module[id];
    const uint32_t lanes = info(inst.type).lanes;
    const auto first = [&] { return uint32_t{info(module.type(inst.arg[0])).lanes}; };
    switch (inst.op) {
        case Op::poison_:
        case Op::literal_:
        case Op::input_:
        case Op::parameter_:
        case Op::region_param_:
        case Op::construct_:
        case Op::swizzle_:
        case Op::column_:
        case Op::transpose_:
        case Op::detach_:
        case Op::image_size_:
        case Op::loop_:
        case Op::call_:
        case Op::result_:
            return {};
        case Op::sample_:
        case Op::sample_lod_:
        case Op::sample_grad_:
            return {1, 0};
        case Op::sign_nonzero_:
        case Op::clamp_:
            return {0, 2 * lanes};
        case Op::mix_:
        case Op::pow_:
        case Op::normalize_:
            return {0, 3 * lanes};
        case Op::smoothstep_:
            return {0, 7 * lanes};
        case Op::dot_:
            return {0, 2 * first() - 1};
        case Op::length_:
            return {0, 2 * first()};
        case Op::cross_:
            return {0, 9};
        case Op::reflect_:
            return {0, 4 * lanes};  // v - 2 dot(n, v) n
        case Op::transform_:
            return {0, 15};
        case Op::matrix_product_:
            return {0, 45};
        default:
            return {0, lanes};
    }
}

std::vector<Cost> cost_by_node(const Module& module) {
    std::vector<Cost> nodes(module.nodes.size());
    std::vector<Id> roots;
    for (const ModuleOutput& output : module.outputs)
        roots.push_back(output.value);
    Counter counter(module);
    counter.walk(roots, [&](Id id, const Cost& cost) { nodes[module.origin[id]] += cost; });
    return nodes;
}

}  // namespace wrinkle
