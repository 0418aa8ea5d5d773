#include "cpu/flatten.h"

#include <algorithm>
#include <atomic>
#include <bit>

#include "cpu/kernel_table.h"
#include "ir/module_cloner.h"
#include "ir/rewrite.h"

namespace wrinkle {
namespace {

using Lanes = std::vector<uint32_t>;

bool is_number(Op op) {
    return op == Op::literal_ || op == Op::parameter_;
}

uint64_t new_serial() {
    static std::atomic<uint64_t> last = 0;
    return ++last;
}

}  // namespace

void Flattener::refuse(std::string why) {
    if (why_.empty()) why_ = std::move(why);
}

void Flattener::push(const CpuInst& step) {
    if (program_.steps.size() < max_steps_)
        program_.steps.push_back(step);
    else
        refuse("the graph makes more than " + std::to_string(max_steps_) +
               " steps once its functions are inlined");
}

uint32_t Flattener::fresh(Type type) {
    integer_.push_back(is_whole_type(type));
    constant_.push_back(false);
    return static_cast<uint32_t>(integer_.size() - 1);
}

// Adds a step with new output registers, or returns those of an equal step.
Flattener::Lanes Flattener::emit(CpuInst step, const Lanes& in, size_t outputs, Type result) {
    const auto [entry, added] =
        known_.try_emplace({step.kind, step.op, step.type, step.extra, in}, Lanes{});
    if (!added) return entry->second;
    known_order_.push_back(entry);
    std::copy(in.begin(), in.end(), step.in.begin());
    step.count = static_cast<uint8_t>(in.size());
    step.outputs = static_cast<uint8_t>(outputs);
    for (size_t k = 0; k < outputs; ++k)
        entry->second.push_back(step.out[k] = fresh(result));
    push(step);
    return entry->second;
}

uint32_t Flattener::add(Op op, Type operands, Type result, const Lanes& in) {
    CpuInst step;
    step.op = op;
    step.type = operands;
    return emit(step, in, 1, result)[0];
}

void Flattener::move(Type type, uint32_t from, uint32_t to, bool masked) {
    CpuInst step;
    step.kind = masked ? CpuInst::Kind::masked_move : CpuInst::Kind::move;
    step.type = type;
    step.in[0] = from;
    step.count = 1;
    step.outputs = 1;
    step.out[0] = to;
    push(step);
}

uint32_t Flattener::constant(double value, Type type) {
    const auto [entry, added] =
        constants_.try_emplace({std::bit_cast<uint64_t>(value), is_whole_type(type)});
    if (!added) return entry->second;
    return entry->second = add_constant(value, type);
}

uint32_t Flattener::add_constant(double value, Type type) {
    const uint32_t reg = fresh(type);
    constant_[reg] = true;
    program_.constants.push_back({value, component_type(type), reg});
    return reg;
}

// Constants of graph inputs are not shared with equal ones, because set_parameter() changes them.
Flattener::Lanes Flattener::graph_input(uint32_t index) {
    const auto [entry, added] = parameters_.try_emplace(index);
    if (!added) return entry->second;
    const Parameter& parameter = module_->parameters[index];
    Program::Parameter& made = program_.parameters.emplace_back();
    made.name = parameter.port;
    for (uint32_t k = 0; k < info(parameter.type).lanes; ++k) {
        made.constants.push_back(static_cast<uint32_t>(program_.constants.size()));
        entry->second.push_back(add_constant(parameter.value[k], parameter.type));
    }
    return entry->second;
}

// Copies constants to written registers, for users other than kernels.
Flattener::Lanes Flattener::materialised(Lanes lanes, Type type) {
    for (uint32_t& lane : lanes) {
        if (!constant_[lane]) continue;
        const uint32_t copy = fresh(type);
        move(component_type(type), lane, copy, false);
        lane = copy;
    }
    return lanes;
}

// Computes the values at levels `low` to `high` that the roots need, including those that bodies of
// deeper loops capture.
void Flattener::compute(std::span<const Id> roots, int low, int high) {
    std::vector<Id> list;
    walk(roots, [&](Id id, std::vector<Id>& open) {
        const Inst& inst = (*module_)[id];
        if (inst.level < low) return;
        if (inst.level <= high && !is_number(inst.op)) list.push_back(id);
        append_dependencies(*module_, id, false, open);
    });
    std::sort(list.begin(), list.end());
    for (const Id id : list)
        if (!refused()) instruction(id);
}

Flattener::Lanes Flattener::lanes(Id id) {
    const Inst& inst = (*module_)[id];
    return is_number(inst.op) ? leaf(inst) : context_[inst.level].values.at(id);
}

void Flattener::instruction(Id id) {
    const Inst& inst = (*module_)[id];
    Scope& scope = context_[inst.level];
    if (inst.op == Op::result_) {
        const Scope& from = context_[(*module_)[inst.arg[0]].level];
        scope.values[id] = from.tuples.at(inst.arg[0])[inst.extra];
        return;
    }
    std::vector<Lanes> args;
    for (const Id operand : module_->operands(id))
        args.push_back(module_->type(operand) == Type::tuple_ ? Lanes{} : lanes(operand));
    if (inst.op == Op::call_ || inst.op == Op::loop_) {
        auto members = inst.op == Op::call_ ? called(inst, args) : looped(inst, args);
        context_[inst.level].tuples[id] = std::move(members);
        return;
    }
    Lanes value = made(inst, args);
    context_[inst.level].values[id] = std::move(value);
}

std::vector<Flattener::Lanes> Flattener::called(const Inst& inst, const std::vector<Lanes>& args) {
    const Region& region = module_->region(inst.extra);
    if (depth_ >= max_call_depth) {
        refuse("functions call each other more than " + std::to_string(max_call_depth) + " deep");
        return {};
    }
    std::vector<Scope> inside(2);
    inside[1].params = args;
    std::swap(inside, context_);
    ++depth_;
    compute(region.results, 0, 1);
    --depth_;
    std::vector<Lanes> results;
    if (!refused())
        for (const Id id : region.results)
            results.push_back(lanes(id));
    std::swap(inside, context_);
    return results;
}

std::vector<Flattener::Lanes> Flattener::looped(const Inst& inst, const std::vector<Lanes>& args) {
    const Region& region = module_->region(inst.extra);
    std::vector<Lanes> state;
    for (size_t k = 0; k < args.size(); ++k) {
        const Type type = component_type(region.params[k]);
        Lanes lanes;
        for (const uint32_t lane : args[k]) {
            lanes.push_back(fresh(type));
            move(type, lane, lanes.back(), false);
        }
        state.push_back(std::move(lanes));
    }
    const auto begin = static_cast<uint32_t>(program_.steps.size());
    CpuInst step;
    step.kind = CpuInst::Kind::loop_begin;
    step.extra = region.max_iterations;
    push(step);
    if (context_.size() <= region.level) context_.resize(region.level + 1u);
    context_[region.level] = {};
    context_[region.level].params = state;
    const size_t known_before = known_order_.size();
    compute(region.results, region.level, region.level);
    if (!refused()) advance_state(region, state);
    for (; known_order_.size() > known_before; known_order_.pop_back())
        known_.erase(known_order_.back());
    step.kind = CpuInst::Kind::loop_end;
    step.extra = begin;
    push(step);
    context_[region.level] = {};
    return state;
}

// Assigns the next state in the lanes in which the loop continues. A next value that is the current
// value of another member is copied before any is written.
void Flattener::advance_state(const Region& region, const std::vector<Lanes>& state) {
    struct Move {
        Type type;
        uint32_t from, to;
    };
    std::vector<Move> moves;
    std::vector<bool> is_state(integer_.size(), false);
    for (const Lanes& lanes : state)
        for (const uint32_t lane : lanes)
            is_state[lane] = true;
    for (size_t k = 0; k < state.size(); ++k) {
        const Type type = component_type(region.params[k]);
        const Lanes next = lanes(region.results[k + 1]);
        for (size_t i = 0; i < next.size(); ++i) {
            if (next[i] == state[k][i]) continue;
            uint32_t from = next[i];
            if (is_state[from]) {
                from = fresh(type);
                move(type, next[i], from, false);
            }
            moves.push_back({type, from, state[k][i]});
        }
    }
    CpuInst test;
    test.kind = CpuInst::Kind::loop_test;
    test.type = Type::bool_;
    test.in[0] = lanes(region.results[0])[0];
    test.count = 1;
    push(test);
    for (const Move& each : moves)
        move(each.type, each.from, each.to, true);
}

Program Flattener::run(std::string& why) {
    compute(output_values(*module_), 0, 0);
    for (const ModuleOutput& output : module_->outputs)
        if (!refused())
            program_.outputs.push_back(
                {output.name, module_->type(output.value), output.port_type,
                 materialised(lanes(output.value), module_->type(output.value))});
    why = why_;
    if (refused()) return {};
    recognise_hashes(program_, integer_.size());
    remove_unused(program_, integer_.size());
    fuse_steps(program_, integer_.size());
    allocate_registers(program_, integer_, uniform_registers(program_, integer_.size()));
    for (CpuInst& step : program_.steps)
        if (has_kernel(step)) step.kernel = static_cast<uint16_t>(kernel_index(step));
    program_.serial = new_serial();
    return std::move(program_);
}

Program compile_program(const Module& module, std::string& why, size_t max_steps) {
    return Flattener(module, max_steps).run(why);
}

void set_parameter(Program& program, const Program::Parameter& parameter,
                   std::span<const double> value) {
    for (size_t k = 0; k < parameter.constants.size(); ++k)
        program.constants[parameter.constants[k]].value = value[k];
    program.serial = new_serial();
}

}  // namespace wrinkle
