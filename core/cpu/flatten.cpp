#include "cpu/flatten.h"

#include <algorithm>
#include <bit>
#include <unordered_set>

#include "ir/copy.h"

namespace wrinkle {
namespace {

using Lanes = std::vector<uint32_t>;

size_t lane_count(Type type) {
    return info(type).lanes;
}

// A float stands for every lane beside a vector.
uint32_t lane_of(const Lanes& lanes, size_t k) {
    return lanes.size() == 1 ? lanes[0] : lanes[k];
}

bool is_number(Op op) {
    return op == Op::literal_ || op == Op::parameter_;
}

}  // namespace

void Flattener::refuse(std::string why) {
    if (why_.empty()) why_ = std::move(why);
}

void Flattener::push(const Step& step) {
    if (program_.steps.size() < max_steps_)
        program_.steps.push_back(step);
    else
        refuse("the graph makes more than " + std::to_string(max_steps_) +
               " steps once its functions are written out");
}

uint32_t Flattener::fresh(Type type) {
    integer_.push_back(is_integer_type(type));
    return static_cast<uint32_t>(integer_.size() - 1);
}

uint32_t Flattener::add(Op op, Type operands, Type result, const Lanes& in) {
    Step step;
    step.op = op;
    step.type = operands;
    std::copy(in.begin(), in.end(), step.in.begin());
    step.count = static_cast<uint8_t>(in.size());
    step.out[0] = fresh(result);
    push(step);
    return step.out[0];
}

void Flattener::move(Type type, uint32_t from, uint32_t to, bool masked) {
    Step step;
    step.kind = masked ? Step::Kind::masked_move : Step::Kind::move;
    step.type = type;
    step.in[0] = from;
    step.count = 1;
    step.out[0] = to;
    push(step);
}

// Written where it is first needed, so that few numbers live at once.
uint32_t Flattener::constant(double value, Type type) {
    const bool integer = is_integer_type(type);
    const auto [entry, added] = constants_.try_emplace({std::bit_cast<uint64_t>(value), integer});
    if (!added) return entry->second;
    Step step;
    step.kind = Step::Kind::constant;
    step.type = integer ? type : Type::float_;
    step.extra = static_cast<uint32_t>(program_.constants.size());
    step.out[0] = entry->second = fresh(type);
    program_.constants.push_back(value);
    push(step);
    return step.out[0];
}

uint32_t Flattener::dot(const Lanes& a, const Lanes& b) {
    uint32_t sum = add_float(Op::mul_, {a[0], b[0]});
    for (size_t k = 1; k < a.size(); ++k)
        sum = add_float(Op::add_, {sum, add_float(Op::mul_, {a[k], b[k]})});
    return sum;
}

// What must be there before an instruction: its operands and, of a loop, what its body captures.
std::vector<Id> Flattener::dependencies(Id id) const {
    const auto operands = module_->operands(id);
    std::vector<Id> found(operands.begin(), operands.end());
    if ((*module_)[id].op != Op::loop_) return found;
    const Region& region = module_->region((*module_)[id].extra);
    std::unordered_set<Id> seen;
    std::vector<Id> open(region.results.begin(), region.results.end());
    while (!open.empty()) {
        const Id next = open.back();
        open.pop_back();
        if (!seen.insert(next).second) continue;
        if ((*module_)[next].level < region.level)
            found.push_back(next);
        else
            append_dependencies(*module_, next, false, open);
    }
    return found;
}

std::vector<Id> Flattener::needed(std::vector<Id> open, int level) const {
    std::unordered_set<Id> seen;
    std::vector<Id> list;
    while (!open.empty()) {
        const Id id = open.back();
        open.pop_back();
        if ((*module_)[id].level < level || !seen.insert(id).second) continue;
        list.push_back(id);
        for (const Id dependency : dependencies(id))
            open.push_back(dependency);
    }
    std::sort(list.begin(), list.end());
    return list;
}

void Flattener::compute(std::vector<Id> roots, int level) {
    for (const Id id : needed(std::move(roots), level)) {
        if (refused()) return;
        if (!is_number((*module_)[id].op)) instruction(id);
    }
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

Flattener::Lanes Flattener::made(const Inst& inst, const std::vector<Lanes>& args) {
    switch (inst.op) {
        case Op::literal_:
        case Op::input_:
        case Op::parameter_:
        case Op::region_param_:
            return leaf(inst);
        case Op::construct_:
        case Op::swizzle_:
        case Op::column_:
        case Op::transpose_:
            return rearranged(inst, args);
        case Op::detach_:
            return args[0];
        case Op::sample_lod_:
        case Op::sample_grad_:
        case Op::image_size_:
            return sampled(inst, args);
        case Op::dot_:
        case Op::cross_:
        case Op::length_:
        case Op::normalize_:
        case Op::reflect_:
            return vector_op(inst, args);
        case Op::transform_:
        case Op::matrix_product_:
            return transformed(args);
        default:
            break;
    }
    return lanewise(inst, inst.op == Op::select_ ? inst.type : module_->type(inst.arg[0]), args);
}

Flattener::Lanes Flattener::leaf(const Inst& inst) {
    Lanes result;
    if (inst.op == Op::region_param_) return context_[inst.level].params[inst.extra];
    if (inst.op == Op::literal_) return {constant(inst.value, inst.type)};
    for (uint32_t k = 0; k < lane_count(inst.type); ++k) {
        if (inst.op == Op::parameter_) {
            result.push_back(constant(module_->parameters[inst.extra].value[k], inst.type));
            continue;
        }
        const auto [entry, added] = inputs_.try_emplace({inst.extra, k});
        if (added) {
            entry->second = fresh(Type::float_);
            program_.inputs.push_back(
                {input_of(inst.extra), variant_of(inst.extra), k, entry->second});
        }
        result.push_back(entry->second);
    }
    return result;
}

Flattener::Lanes Flattener::rearranged(const Inst& inst, const std::vector<Lanes>& args) const {
    Lanes result;
    if (inst.op == Op::construct_)
        for (const Lanes& part : args)
            result.insert(result.end(), part.begin(), part.end());
    else if (inst.op == Op::swizzle_)
        for (uint32_t k = 0; k < (inst.extra & 0xF); ++k)
            result.push_back(args[0][inst.extra >> (4 + 4 * k) & 0xF]);
    else if (inst.op == Op::column_)
        result.assign(args[0].begin() + inst.extra * 3, args[0].begin() + inst.extra * 3 + 3);
    else
        for (size_t k = 0; k < 9; ++k)
            result.push_back(args[0][k % 3 * 3 + k / 3]);
    return result;
}

Flattener::Lanes Flattener::lanewise(const Inst& inst, Type operands,
                                     const std::vector<Lanes>& args) {
    const Type operand =
        is_float_type(operands) || operands == Type::mat3_ ? Type::float_ : operands;
    const Type result = is_integer_type(inst.type) ? inst.type : Type::float_;
    Lanes lanes;
    for (size_t k = 0; k < lane_count(inst.type); ++k) {
        Lanes in;
        for (const Lanes& arg : args)
            in.push_back(lane_of(arg, k));
        lanes.push_back(add(inst.op, operand, result, in));
    }
    return lanes;
}

Flattener::Lanes Flattener::vector_op(const Inst& inst, const std::vector<Lanes>& args) {
    const Lanes& a = args[0];
    Lanes result;
    switch (inst.op) {
        case Op::dot_:
            return {dot(a, args[1])};
        case Op::length_:
            return {add_float(Op::sqrt_, {dot(a, a)})};
        case Op::normalize_: {
            const uint32_t length = add_float(Op::sqrt_, {dot(a, a)});
            for (const uint32_t lane : a)
                result.push_back(add_float(Op::div_, {lane, length}));
            return result;
        }
        case Op::reflect_: {
            const uint32_t twice =
                add_float(Op::mul_, {constant(2, Type::float_), dot(args[1], a)});
            for (size_t k = 0; k < a.size(); ++k)
                result.push_back(
                    add_float(Op::sub_, {a[k], add_float(Op::mul_, {twice, args[1][k]})}));
            return result;
        }
        default:
            break;
    }
    const Lanes& b = args[1];
    for (size_t k = 0; k < 3; ++k) {
        const size_t i = (k + 1) % 3, j = (k + 2) % 3;
        result.push_back(add_float(
            Op::sub_, {add_float(Op::mul_, {a[i], b[j]}), add_float(Op::mul_, {a[j], b[i]})}));
    }
    return result;
}

// A mat3 times each vec3 column of the other operand.
Flattener::Lanes Flattener::transformed(const std::vector<Lanes>& args) {
    const Lanes& m = args[0];
    Lanes result;
    for (size_t column = 0; column < args[1].size(); column += 3)
        for (size_t row = 0; row < 3; ++row)
            result.push_back(dot({m[row], m[3 + row], m[6 + row]},
                                 {args[1][column], args[1][column + 1], args[1][column + 2]}));
    return result;
}

// As sample_lod_of() in ir/rewrite.h.
uint32_t Flattener::lod_of(uint32_t resource, const Lanes& dx, const Lanes& dy) {
    Inst size;
    size.op = Op::image_size_;
    size.extra = resource;
    const Lanes texels = sampled(size, {});
    const auto square = [&](const Lanes& change) {
        const Lanes scaled{add_float(Op::mul_, {texels[0], change[0]}),
                           add_float(Op::mul_, {texels[1], change[1]})};
        return dot(scaled, scaled);
    };
    constexpr double smallest = 9.094947017729282e-13;
    const uint32_t widest = add_float(Op::max_, {add_float(Op::max_, {square(dx), square(dy)}),
                                                 constant(smallest, Type::float_)});
    return add_float(Op::mul_, {add_float(Op::log2_, {widest}), constant(0.5, Type::float_)});
}

Flattener::Lanes Flattener::sampled(const Inst& inst, const std::vector<Lanes>& args) {
    Step step;
    step.kind = inst.op == Op::image_size_ ? Step::Kind::size : Step::Kind::sample;
    step.extra = inst.extra;
    if (inst.op != Op::image_size_) {
        const uint32_t lod =
            inst.op == Op::sample_lod_ ? args[1][0] : lod_of(inst.extra, args[1], args[2]);
        step.in = {args[0][0], args[0][1], lod};
        step.count = 3;
    }
    Lanes result;
    for (size_t k = 0; k < step.outputs(); ++k)
        result.push_back(step.out[k] = fresh(Type::float_));
    push(step);
    return result;
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
    compute(region.results, 0);
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
        const Type type = is_integer_type(region.params[k]) ? region.params[k] : Type::float_;
        Lanes lanes;
        for (const uint32_t lane : args[k]) {
            lanes.push_back(fresh(type));
            move(type, lane, lanes.back(), false);
        }
        state.push_back(std::move(lanes));
    }
    const auto begin = static_cast<uint32_t>(program_.steps.size());
    Step step;
    step.kind = Step::Kind::loop_begin;
    step.extra = region.max_iterations;
    push(step);
    if (context_.size() <= region.level) context_.resize(region.level + 1u);
    context_[region.level] = {};
    context_[region.level].params = state;
    compute(region.results, region.level);
    if (!refused()) advance_state(region, state);
    step.kind = Step::Kind::loop_end;
    step.extra = begin;
    push(step);
    context_[region.level] = {};
    return state;
}

// The next state, taken where the loop goes on. A member may be next to another's present value, so
// all are read before any is written.
void Flattener::advance_state(const Region& region, const std::vector<Lanes>& state) {
    struct Move {
        Type type;
        uint32_t from, to;
    };
    std::vector<Move> moves;
    for (size_t k = 0; k < state.size(); ++k) {
        const Type type = is_integer_type(region.params[k]) ? region.params[k] : Type::float_;
        const Lanes next = lanes(region.results[k + 1]);
        for (size_t i = 0; i < next.size(); ++i) {
            if (next[i] == state[k][i]) continue;
            const uint32_t copy = fresh(type);
            move(type, next[i], copy, false);
            moves.push_back({type, copy, state[k][i]});
        }
    }
    Step test;
    test.kind = Step::Kind::loop_test;
    test.type = Type::bool_;
    test.in[0] = lanes(region.results[0])[0];
    test.count = 1;
    push(test);
    for (const Move& each : moves)
        move(each.type, each.from, each.to, true);
}

Program Flattener::run(std::string& why) {
    std::vector<Id> roots;
    for (const ModuleOutput& output : module_->outputs)
        roots.push_back(output.value);
    compute(roots, 0);
    for (const ModuleOutput& output : module_->outputs)
        if (!refused())
            program_.outputs.push_back(
                {output.name, module_->type(output.value), output.port_type, lanes(output.value)});
    why = why_;
    if (refused()) return {};
    allocate_registers(program_, integer_);
    return std::move(program_);
}

Program compile_program(const Module& module, std::string& why, size_t max_steps) {
    return Flattener(module, max_steps).run(why);
}

}  // namespace wrinkle
