#include "ir/add.h"

#include <algorithm>

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

Type refuse(std::string* why, Op op, Types operands, const char* expected) {
    if (!why) return Type::poison_;
    *why = std::string(info(op).name) + " of (";
    for (size_t i = 0; i < operands.size(); ++i)
        *why += (i ? ", " : "") + std::string(info(operands[i]).name);
    *why += ") makes no sense: it takes ";
    *why += expected;
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

Type exactly(Op op, Types operands, std::initializer_list<Type> wanted, Type result,
             std::string* why) {
    if (std::equal(operands.begin(), operands.end(), wanted.begin(), wanted.end())) return result;
    if (!why) return Type::poison_;
    std::string list;
    for (const Type t : wanted)
        list += (list.empty() ? "" : ", ") + std::string(info(t).name);
    return refuse(why, op, operands, list.c_str());
}

Type gradient_type(Op op, Types operands, std::string* why) {
    using T = Type;
    switch (op) {
        case Op::base_:
            return exactly(op, operands, {T::vec3_}, T::base_, why);
        case Op::frame_:  // the host checks that the method `guess` has its direction
            return operands.size() == 2
                       ? exactly(op, operands, {T::vec2_, T::vec3_}, T::frame_, why)
                       : exactly(op, operands, {T::vec2_}, T::frame_, why);
        case Op::derivative_:
            return exactly(op, operands, {T::vec2_, T::frame_}, T::derivative_, why);
        case Op::normal_derivative_:
            return exactly(op, operands, {T::vec3_, T::float_, T::frame_}, T::derivative_, why);
        case Op::slope_:
            return exactly(op, operands, {T::derivative_}, T::vec2_, why);
        case Op::gradient_zero_:
            return T::gradient_;
        case Op::gradient_from_derivative_:
            return exactly(op, operands, {T::derivative_}, T::gradient_, why);
        case Op::gradient_from_height_:
            return exactly(op, operands, {T::float_}, T::gradient_, why);
        case Op::gradient_from_volume_:
        case Op::gradient_from_normal_:
        case Op::gradient_from_outward_normal_:
            return exactly(op, operands, {T::vec3_}, T::gradient_, why);
        case Op::gradient_add_:
            return exactly(op, operands, {T::gradient_, T::gradient_}, T::gradient_, why);
        case Op::gradient_scale_:
            return exactly(op, operands, {T::gradient_, T::float_}, T::gradient_, why);
        case Op::gradient_mix_:
            return exactly(op, operands, {T::gradient_, T::gradient_, T::float_}, T::gradient_,
                           why);
        case Op::gradient_vector_:
        case Op::resolve_:
            return exactly(op, operands, {T::gradient_}, T::vec3_, why);
        case Op::normal_variance_:
            return exactly(op, operands, {T::gradient_}, T::float_, why);
        default:
            return T::poison_;
    }
}

Type special(Op op, Types operands, Type wanted, std::string* why) {
    using T = Type;
    const Type first = operands.empty() ? T::poison_ : operands[0];
    switch (op) {
        case Op::construct_:
            return construct(operands, wanted, why);
        case Op::swizzle_:
            return wanted != T::poison_ ? wanted
                                        : refuse(why, op, operands, "components that a vector has");
        case Op::column_:
            return exactly(op, operands, {T::mat3_}, T::vec3_, why);
        case Op::sign_nonzero_:
            return exactly(op, operands, {T::float_}, T::float_, why);
        case Op::dot_:
            return vectors(op, operands, true, why);
        case Op::length_:
            return vectors(op, operands, true, why);
        case Op::normalize_:
        case Op::reflect_:
            return vectors(op, operands, false, why);
        case Op::cross_:
            return exactly(op, operands, {T::vec3_, T::vec3_}, T::vec3_, why);
        case Op::transform_:
            return exactly(op, operands, {T::mat3_, T::vec3_}, T::vec3_, why);
        case Op::matrix_product_:
            return exactly(op, operands, {T::mat3_, T::mat3_}, T::mat3_, why);
        case Op::transpose_:
            return exactly(op, operands, {T::mat3_}, T::mat3_, why);
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
        case Op::to_uint_:
            return exactly(op, operands, {T::int_}, T::uint_, why);
        case Op::detach_:
            return info(first).lanes > 0 ? first : refuse(why, op, operands, "a number");
        case Op::with_covariance_:
            return first == T::vec3_ ? exactly(op, operands, {first, T::float_}, first, why)
                                     : exactly(op, operands, {T::vec2_, T::vec3_}, T::vec2_, why);
        case Op::ddx_:
        case Op::ddy_:
            return is_float_type(first) ? first : refuse(why, op, operands, "a float or vector");
        case Op::sample_:
            return exactly(op, operands, {T::vec2_}, T::vec4_, why);
        case Op::sample_lod_:
            return exactly(op, operands, {T::vec2_, T::float_}, T::vec4_, why);
        case Op::sample_grad_:
            return exactly(op, operands, {T::vec2_, T::vec2_, T::vec2_}, T::vec4_, why);
        case Op::image_size_:
            return T::vec2_;
        case Op::loop_:
        case Op::call_:
            return T::tuple_;
        case Op::result_:
            return first == T::tuple_ ? wanted : refuse(why, op, operands, "a call or a loop");
        default:
            return gradient_type(op, operands, why);
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
