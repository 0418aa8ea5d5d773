// Flattening of single instructions: splits vector ops into scalar steps.
#include "cpu/flatten.h"

#include <cmath>
#include <cstdlib>

namespace wrinkle {
namespace {

using Lanes = std::vector<uint32_t>;

size_t lane_count(Type type) {
    return info(type).lanes;
}

// Returns component k; a float operand next to a vector is broadcast to all components.
uint32_t lane_of(const Lanes& lanes, size_t k) {
    return lanes.size() == 1 ? lanes[0] : lanes[k];
}

}  // namespace

// Adds a vector op as a single step.
Flattener::Lanes Flattener::add_vector(Op op, size_t outputs, const Lanes& in) {
    CpuInst step;
    step.op = op;
    step.type = Type::float_;
    return emit(step, in, outputs, Type::float_);
}

uint32_t Flattener::dot(const Lanes& a, const Lanes& b) {
    if (a.size() <= 3) {
        Lanes both = a;
        both.insert(both.end(), b.begin(), b.end());
        return add_vector(Op::dot_, 1, both)[0];
    }
    uint32_t sum = add_float(Op::mul_, {a[0], b[0]});
    for (size_t k = 1; k < a.size(); ++k)
        sum = add_float(Op::add_, {sum, add_float(Op::mul_, {a[k], b[k]})});
    return sum;
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
        case Op::image_size_:
            return sampled(inst, args);
        case Op::sin_:
        case Op::cos_:
            return sine_or_cosine(inst.op, args[0]);
        case Op::dot_:
        case Op::cross_:
        case Op::length_:
        case Op::normalize_:
        case Op::reflect_:
            return vector_op(inst, args);
        case Op::transform_:
        case Op::matrix_product_:
            return transformed(args);
        case Op::div_:
            if (const auto product = divided_by_power_of_two(inst, args)) return *product;
            break;
        default:
            break;
    }
    return lanewise(inst, inst.op == Op::select_ ? inst.type : module_->type(inst.arg[0]), args);
}

Flattener::Lanes Flattener::leaf(const Inst& inst) {
    Lanes result;
    if (inst.op == Op::region_param_) return context_[inst.level].params[inst.extra];
    if (inst.op == Op::literal_) return {constant(inst.value, inst.type)};
    if (inst.op == Op::parameter_ && module_->parameters[inst.extra].graph_input)
        return graph_input(inst.extra);
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
        for (int k = 0; k < swizzle_count(inst.extra); ++k)
            result.push_back(args[0][static_cast<size_t>(swizzle_component(inst.extra, k))]);
    else if (inst.op == Op::column_)
        result.assign(args[0].begin() + inst.extra * 3, args[0].begin() + inst.extra * 3 + 3);
    else
        for (size_t k = 0; k < 9; ++k)
            result.push_back(args[0][k % 3 * 3 + k / 3]);
    return result;
}

Flattener::Lanes Flattener::lanewise(const Inst& inst, Type operands,
                                     const std::vector<Lanes>& args) {
    const bool same_bits = inst.op == Op::to_int_ || inst.op == Op::to_uint_;
    if (same_bits && is_whole_type(operands)) return args[0];
    Lanes lanes;
    for (size_t k = 0; k < lane_count(inst.type); ++k) {
        Lanes in;
        for (const Lanes& arg : args)
            in.push_back(lane_of(arg, k));
        lanes.push_back(add(inst.op, component_type(operands), component_type(inst.type), in));
    }
    return lanes;
}

// Returns the product with the reciprocal of a literal power of two, which is the same number and
// quicker to compute; std::nullopt for other divisors.
std::optional<Flattener::Lanes> Flattener::divided_by_power_of_two(const Inst& inst,
                                                                   const std::vector<Lanes>& args) {
    const Inst& divisor = (*module_)[inst.arg[1]];
    if (divisor.op != Op::literal_ || divisor.type != Type::float_) return {};
    constexpr int largest = 100;  // floats hold the divisor and its reciprocal, neither subnormal
    int exponent = 0;
    if (std::frexp(divisor.value, &exponent) != 0.5 || std::abs(exponent) > largest) return {};
    const uint32_t factor = constant(1 / divisor.value, Type::float_);
    Lanes lanes;
    for (size_t k = 0; k < lane_count(inst.type); ++k)
        lanes.push_back(add_float(Op::mul_, {lane_of(args[0], k), factor}));
    return lanes;
}

// One step of the op `sin` has both.
Flattener::Lanes Flattener::sine_or_cosine(Op op, const Lanes& angles) {
    Lanes lanes;
    for (const uint32_t angle : angles)
        lanes.push_back(add_vector(Op::sin_, 2, {angle})[op == Op::sin_ ? 0 : 1]);
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
            if (a.size() <= 3) return add_vector(Op::normalize_, a.size(), a);
            const uint32_t scale = add_float(Op::inversesqrt_, {dot(a, a)});
            for (const uint32_t lane : a)
                result.push_back(add_float(Op::mul_, {lane, scale}));
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
    Lanes both = a;
    both.insert(both.end(), args[1].begin(), args[1].end());
    return add_vector(Op::cross_, 3, both);
}

// Multiplies a mat3 with each vec3 column of the other operand.
Flattener::Lanes Flattener::transformed(const std::vector<Lanes>& args) {
    const Lanes& m = args[0];
    Lanes result;
    for (size_t column = 0; column < args[1].size(); column += 3)
        for (size_t row = 0; row < 3; ++row)
            result.push_back(dot({m[row], m[3 + row], m[6 + row]},
                                 {args[1][column], args[1][column + 1], args[1][column + 2]}));
    return result;
}

Flattener::Lanes Flattener::sampled(const Inst& inst, const std::vector<Lanes>& args) {
    CpuInst step;
    step.kind = inst.op == Op::image_size_ ? CpuInst::Kind::size : CpuInst::Kind::sample;
    step.extra = inst.extra;
    if (inst.op == Op::image_size_) return emit(step, {}, 2, Type::float_);
    return emit(step, materialised({args[0][0], args[0][1], args[1][0]}, Type::float_), 4,
                Type::float_);
}

}  // namespace wrinkle
