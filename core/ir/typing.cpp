#include "ir/add.h"

#include <algorithm>

#include "base/text.h"

namespace wrinkle {
namespace {

using Types = std::span<const Type>;

bool is_integer(Type t) {
    return t == Type::int_ || t == Type::uint_;
}
bool is_shift(Op op) {
    return op == Op::shift_left_ || op == Op::shift_right_;
}
bool is_vector(Type t) {
    return t >= Type::vec2_ && t <= Type::vec4_;
}
bool is_scalar(Type t) {
    return t == Type::float_ || is_integer(t) || t == Type::bool_;
}

std::string names(Types types) {
    return joined(types, ", ", [](Type type) { return info(type).name; });
}

Type refuse(std::string* why, Op op, Types operands, std::string_view expected) {
    if (why)
        *why = std::string(info(op).name) + " of (" + names(operands) +
               ") makes no sense: it takes " + std::string(expected);
    return Type::poison_;
}

// All operands have one type, but a float may be combined with vectors.
Type widest(Types operands) {
    Type wide = operands[0];
    for (const Type t : operands)
        if (is_vector(t)) wide = t;
    for (const Type t : operands)
        if (t != wide && !(t == Type::float_ && is_vector(wide))) return Type::poison_;
    return wide;
}

Type broadcast(Op op, Types operands, bool integers, std::string* why) {
    const Type wide = widest(operands);
    if (is_float_type(wide) || (integers && is_integer(wide))) return wide;
    return refuse(why, op, operands, "floats or vectors of one size");
}

Type construct(Types operands, Type wanted, std::string* why) {
    if (wanted == Type::mat3_) {
        const bool columns =
            operands.size() == 3 &&
            std::all_of(operands.begin(), operands.end(), [](Type t) { return t == Type::vec3_; });
        return columns ? wanted
                       : refuse(why, Op::construct_, operands, "three vec3 columns for a mat3");
    }
    int lanes = 0;
    for (const Type t : operands) {
        if (!is_float_type(t)) return refuse(why, Op::construct_, operands, "floats and vectors");
        lanes += info(t).lanes;
    }
    if (is_vector(wanted) && lanes == info(wanted).lanes) return wanted;
    return refuse(why, Op::construct_, operands, "as many lanes as the vector has");
}

Type vectors(Op op, Types operands, bool to_float, std::string* why) {
    const bool fit = is_vector(operands[0]) && (operands.size() < 2 || operands[0] == operands[1]);
    if (!fit) return refuse(why, op, operands, "vectors of one size");
    return to_float ? Type::float_ : operands[0];
}

// Ops that take these types and no others.
struct Signature {
    Op op;
    std::array<Type, 3> operands;  // the rest is poison
    Type result;

    Types taken() const { return {operands.begin(), std::ranges::find(operands, Type::poison_)}; }
};
using T = Type;
constexpr Signature signatures[] = {
    {Op::column_, {T::mat3_}, T::vec3_},
    {Op::sign_nonzero_, {T::float_}, T::float_},
    {Op::cross_, {T::vec3_, T::vec3_}, T::vec3_},
    {Op::transform_, {T::mat3_, T::vec3_}, T::vec3_},
    {Op::matrix_product_, {T::mat3_, T::mat3_}, T::mat3_},
    {Op::transpose_, {T::mat3_}, T::mat3_},
    {Op::to_uint_, {T::int_}, T::uint_},
    {Op::sample_, {T::vec2_}, T::vec4_},
    {Op::sample_lod_, {T::vec2_, T::float_}, T::vec4_},
    {Op::sample_grad_, {T::vec2_, T::vec2_, T::vec2_}, T::vec4_},
    {Op::image_size_, {}, T::vec2_},
    {Op::base_, {T::vec3_}, T::base_},
    {Op::derivative_, {T::vec2_, T::frame_}, T::derivative_},
    {Op::normal_derivative_, {T::vec3_, T::float_, T::frame_}, T::derivative_},
    {Op::slope_, {T::derivative_}, T::vec2_},
    {Op::gradient_zero_, {}, T::gradient_},
    {Op::gradient_from_derivative_, {T::derivative_}, T::gradient_},
    {Op::gradient_from_height_, {T::float_}, T::gradient_},
    {Op::gradient_from_volume_, {T::vec3_}, T::gradient_},
    {Op::gradient_from_normal_, {T::vec3_}, T::gradient_},
    {Op::gradient_from_outward_normal_, {T::vec3_}, T::gradient_},
    {Op::gradient_add_, {T::gradient_, T::gradient_}, T::gradient_},
    {Op::gradient_scale_, {T::gradient_, T::float_}, T::gradient_},
    {Op::gradient_mix_, {T::gradient_, T::gradient_, T::float_}, T::gradient_},
    {Op::gradient_vector_, {T::gradient_}, T::vec3_},
    {Op::resolve_, {T::gradient_}, T::vec3_},
    {Op::normal_variance_, {T::gradient_}, T::float_},
    {Op::normal_covariance_, {T::gradient_, T::vec3_}, T::vec3_},
};

constexpr auto signature_of = [] {
    std::array<const Signature*, tables::op_count> rows{};
    for (const Signature& row : signatures)
        rows[static_cast<size_t>(row.op)] = &row;
    return rows;
}();

Type exactly(Op op, Types operands, Types wanted, Type result, std::string* why) {
    if (std::equal(operands.begin(), operands.end(), wanted.begin(), wanted.end())) return result;
    if (!why) return Type::poison_;
    return refuse(why, op, operands, names(wanted));
}

Type by_signature(Op op, Types operands, std::string* why) {
    const Signature* row = signature_of[static_cast<size_t>(op)];
    return row ? exactly(op, operands, row->taken(), row->result, why) : T::poison_;
}

Type special(Op op, Types operands, Type wanted, std::string* why) {
    const Type first = operands.empty() ? T::poison_ : operands[0];
    switch (op) {
        case Op::construct_:
            return construct(operands, wanted, why);
        case Op::swizzle_:
            return wanted != T::poison_ ? wanted
                                        : refuse(why, op, operands, "components that a vector has");
        case Op::dot_:
        case Op::length_:
            return vectors(op, operands, true, why);
        case Op::normalize_:
        case Op::reflect_:
            return vectors(op, operands, false, why);
        case Op::select_:
            if (first == T::bool_ && operands[1] == operands[2] && info(operands[1]).lanes > 0)
                return operands[1];
            return refuse(why, op, operands, "a bool and two values of one type");
        case Op::to_float_:
            return is_scalar(first) && first != T::float_
                       ? T::float_
                       : refuse(why, op, operands, "an int, a uint or a bool");
        case Op::to_int_:
            return first == T::float_ || first == T::uint_
                       ? T::int_
                       : refuse(why, op, operands, "a float or a uint");
        case Op::frame_:  // the host checks that the method `guess` has its direction
            return operands.size() == 2
                       ? exactly(op, operands, std::array{T::vec2_, T::vec3_}, T::frame_, why)
                       : exactly(op, operands, std::array{T::vec2_}, T::frame_, why);
        case Op::detach_:
            return info(first).lanes > 0 ? first : refuse(why, op, operands, "a number");
        case Op::with_covariance_:
            return first == T::vec3_
                       ? exactly(op, operands, std::array{first, T::float_}, first, why)
                       : exactly(op, operands, std::array{T::vec2_, T::vec3_}, T::vec2_, why);
        case Op::ddx_:
        case Op::ddy_:
            return is_float_type(first) ? first : refuse(why, op, operands, "a float or vector");
        case Op::loop_:
        case Op::call_:
            return T::tuple_;
        case Op::result_:
            return first == T::tuple_ ? wanted : refuse(why, op, operands, "a call or a loop");
        default:
            return by_signature(op, operands, why);
    }
}

}  // namespace

Type result_type(Op op, std::span<const Type> operands, Type wanted, std::string* why) {
    const OpInfo& row = info(op);
    if (row.arity >= 0 && operands.size() != static_cast<size_t>(row.arity)) {
        if (why)
            *why = std::string(row.name) + " takes " + std::to_string(row.arity) +
                   (row.arity == 1 ? " operand, not " : " operands, not ") +
                   std::to_string(operands.size());
        return Type::poison_;
    }
    switch (row.rule) {
        case Rule::same: {
            const Type t = operands[0];
            if (is_float_type(t) || is_integer(t)) return t;
            return refuse(why, op, operands, "a number");
        }
        case Rule::broadcast:
            return broadcast(op, operands, true, why);
        case Rule::floats:
            return broadcast(op, operands, false, why);
        case Rule::compare:
            if (operands[0] == operands[1] && is_scalar(operands[0])) return Type::bool_;
            return refuse(why, op, operands, "two scalars of one type");
        case Rule::logic:
            for (const Type t : operands)
                if (t != Type::bool_) return refuse(why, op, operands, "bools");
            return Type::bool_;
        case Rule::bits:
            if (is_integer(operands[0]) &&
                (operands[0] == operands[1] || (is_shift(op) && is_integer(operands[1]))))
                return operands[0];
            return refuse(why, op, operands, "integers of one type");
        case Rule::special:
            return special(op, operands, wanted, why);
        case Rule::leaf:
            break;
    }
    return Type::poison_;
}

}  // namespace wrinkle
