// Flattens instructions to steps on registers that are each written once; allocate_registers() then
// lets registers with disjoint live ranges share storage. Internal to compile_program().
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "cpu/evaluate.h"
#include "ir/module.h"

namespace wrinkle {

class Flattener {
public:
    Flattener(const Module& module, size_t max_steps)
        : module_(&module), max_steps_(max_steps), context_(1) {}

    Program run(std::string& why);

private:
    using Lanes = std::vector<uint32_t>;
    // Values computed at one region depth: components of values, and members of loops and calls.
    struct Scope {
        std::unordered_map<Id, Lanes> values;
        std::unordered_map<Id, std::vector<Lanes>> tuples;
        std::vector<Lanes> params;  // parameters of the region at this depth
    };

    void compute(std::span<const Id> roots, int low, int high);
    Lanes lanes(Id id);
    void instruction(Id id);
    Lanes made(const Inst& inst, const std::vector<Lanes>& args);
    Lanes leaf(const Inst& inst);
    Lanes rearranged(const Inst& inst, const std::vector<Lanes>& args) const;
    Lanes lanewise(const Inst& inst, Type operands, const std::vector<Lanes>& args);
    std::optional<Lanes> divided_by_power_of_two(const Inst& inst, const std::vector<Lanes>& args);
    Lanes sine_or_cosine(Op op, const Lanes& angles);
    Lanes vector_op(const Inst& inst, const std::vector<Lanes>& args);
    Lanes transformed(const std::vector<Lanes>& args);
    Lanes sampled(const Inst& inst, const std::vector<Lanes>& args);
    std::vector<Lanes> called(const Inst& inst, const std::vector<Lanes>& args);
    std::vector<Lanes> looped(const Inst& inst, const std::vector<Lanes>& args);
    void advance_state(const Region& region, const std::vector<Lanes>& state);

    uint32_t fresh(Type type);
    Lanes emit(CpuInst step, const Lanes& in, size_t outputs, Type result);
    uint32_t add(Op op, Type operands, Type result, const Lanes& in);
    uint32_t add_float(Op op, const Lanes& in) { return add(op, Type::float_, Type::float_, in); }
    void move(Type type, uint32_t from, uint32_t to, bool masked);
    uint32_t constant(double value, Type type);
    uint32_t add_constant(double value, Type type);
    Lanes graph_input(uint32_t index);
    Lanes materialised(Lanes lanes, Type type);
    uint32_t dot(const Lanes& a, const Lanes& b);
    Lanes add_vector(Op op, size_t outputs, const Lanes& in);
    void push(const CpuInst& step);
    void refuse(std::string why);
    bool refused() const { return !why_.empty(); }

    const Module* module_;
    size_t max_steps_;
    size_t depth_ = 0;  // call nesting depth
    Program program_;
    std::map<std::pair<uint64_t, bool>, uint32_t> constants_;
    // Steps that later equal ones can share, and the order in which they were added: those of a
    // loop's body are erased at its end, as the state has other values after it.
    using StepIdentity = std::tuple<CpuInst::Kind, Op, Type, uint32_t, Lanes>;
    std::map<StepIdentity, Lanes> known_;
    std::vector<std::map<StepIdentity, Lanes>::iterator> known_order_;
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> inputs_;
    std::map<uint32_t, Lanes> parameters_;  // those of the graph's inputs, by index in the module
    std::vector<Scope> context_;            // by region depth
    std::vector<bool> integer_;             // by register
    std::vector<bool> constant_;            // by register
    std::string why_;                       // reason if the program is refused
};

// Returns the type of a component of a value.
inline Type component_type(Type type) {
    return is_whole_type(type) ? type : Type::float_;
}

// Removes steps; loops keep their extent.
template <class F>
void remove_steps(std::vector<CpuInst>& steps, F is_removed) {
    std::vector<uint32_t> new_index;
    std::vector<CpuInst> kept;
    for (const CpuInst& step : steps) {
        new_index.push_back(static_cast<uint32_t>(kept.size()));
        if (is_removed(step)) continue;
        kept.push_back(step);
        if (step.kind == CpuInst::Kind::loop_end) kept.back().extra = new_index[step.extra];
    }
    steps = std::move(kept);
}

// Replaces each integer hash, eight ops, by one step; the others become unused.
void recognise_hashes(Program& program, size_t registers);

// Removes steps without a used output, and sets CpuInst::channels. Precondition: each register is
// written once, except loop state.
void remove_unused(Program& program, size_t registers);

// Fuses steps, so that several ops share a pass over memory.
void fuse_steps(Program& program, size_t registers);

// Returns, by register, if it has the same value at all points and only kernels read it.
std::vector<bool> uniform_registers(const Program& program, size_t registers);

// Reuses registers after their live range ends. `integer` selects the register file of each.
void allocate_registers(Program& program, const std::vector<bool>& integer,
                        const std::vector<bool>& uniform);

}  // namespace wrinkle
