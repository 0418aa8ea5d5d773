#include "glsl/expression.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"

namespace wrinkle {
namespace {

constexpr int name_precedence = 20, call_precedence = 18, postfix = 17, prefix = 16;
constexpr int relational = 12, conditional = 3;

std::string float_text(double value) {
    const auto narrow = static_cast<float>(value);
    if (std::isnan(narrow)) return "uintBitsToFloat(0x7fc00000u)";
    if (std::isinf(narrow))
        return narrow > 0 ? "uintBitsToFloat(0x7f800000u)" : "uintBitsToFloat(0xff800000u)";
    std::string text = shortest(narrow);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string call(std::string_view name, const std::vector<std::string>& arguments) {
    std::string text(name);
    text += '(';
    for (size_t i = 0; i < arguments.size(); ++i)
        text += (i ? ", " : "") + arguments[i];
    return text + ")";
}

// Operands of built-in functions where GLSL takes a float beside vectors.
bool takes_float(Op op, size_t operand, bool others_float) {
    switch (op) {
        case Op::mod_:
        case Op::min_:
        case Op::max_:
            return operand == 1;
        case Op::clamp_:
            return operand > 0 && others_float;
        case Op::mix_:
            return operand == 2;
        case Op::step_:
            return operand == 0;
        case Op::smoothstep_:
            return operand < 2 && others_float;
        default:
            return false;
    }
}

class Writer {
public:
    explicit Writer(const ExpressionContext& context)
        : context_(context), plan_(context.plan), m_(context.plan.module()) {}

    Piece read(Id id) const;
    Piece define(Id id) const;

private:
    std::string at_least(Id id, int precedence) const;
    std::vector<std::string> texts(Id id) const;
    std::string operand(Id id, const std::vector<Id>& operands, size_t k, int precedence) const;
    Piece leaf(Id id) const;
    Piece input(Id id) const;
    Piece view(Id id) const;
    Piece construct(Id id) const;
    Piece builtin(Id id) const;
    Piece operation(Id id) const;
    Piece sample(Id id) const;

    const ExpressionContext& context_;
    const Plan& plan_;
    const Module& m_;
};

std::string Writer::at_least(Id id, int precedence) const {
    Piece piece = read(id);
    return piece.precedence >= precedence ? piece.text : "(" + piece.text + ")";
}

std::vector<std::string> Writer::texts(Id id) const {
    std::vector<Id> operands;
    plan_.operands(id, operands);
    std::vector<std::string> result;
    for (const Id operand : operands)
        result.push_back(read(operand).text);
    return result;
}

Piece Writer::input(Id id) const {
    const SurfaceInput which = input_of(m_[id].extra);
    const Variant variant = variant_of(m_[id].extra);
    if (plan_.role(id) == Role::leaf) return {"s." + member_name(which, variant), postfix};
    const std::string_view change =
        variant == Variant::dx ? context_.target.change_x : context_.target.change_y;
    const std::string member =
        which == SurfaceInput::position_ ? "position_relative" : std::string(info(which).name);
    return {call(change, {"s." + member}), call_precedence};
}

Piece Writer::leaf(Id id) const {
    const Inst& inst = m_[id];
    switch (inst.op) {
        case Op::literal_: {
            std::string text = literal_text(inst.type, inst.value);
            const int precedence = text[0] == '-' ? prefix : name_precedence;
            return {std::move(text), precedence};
        }
        case Op::input_:
            return input(id);
        case Op::parameter_:
            return {context_.symbols.parameters[inst.extra]};
        case Op::region_param_:
            return {context_.parameters[inst.level][inst.extra]};
        case Op::construct_:
            return construct(id);
        case Op::swizzle_:
            return view(id);
        default:
            return {"0.0"};
    }
}

Piece Writer::view(Id id) const {
    const Inst& inst = m_[id];
    if (inst.op == Op::result_) return {context_.values.state[id].name};
    const std::string whole = at_least(plan_.plain(inst.arg[0]), postfix);
    if (inst.op == Op::column_) return {whole + "[" + std::to_string(inst.extra) + "]", postfix};
    std::string text = whole + ".";
    for (uint32_t i = 0; i < (inst.extra & 0xF); ++i)
        text += "xyzw"[inst.extra >> (4 + 4 * i) & 0xF];
    return {std::move(text), postfix};
}

Piece Writer::construct(Id id) const {
    return {call(info(m_.type(id)).name, texts(id)), call_precedence};
}

Piece Writer::sample(Id id) const {
    std::vector<std::string> arguments = texts(id);
    arguments.insert(arguments.begin(), context_.symbols.resources[m_[id].extra]);
    if (m_[id].op == Op::image_size_)
        return {"vec2(textureSize(" + arguments[0] + ", 0))", call_precedence};
    return {call(info(m_[id].op).glsl, arguments), call_precedence};
}

Piece Writer::builtin(Id id) const {
    std::vector<std::string> arguments = texts(id);
    const Inst& inst = m_[id];
    const auto operands = m_.operands(id);
    if (info(inst.op).rule == Rule::floats || info(inst.op).rule == Rule::broadcast) {
        const auto is_float = [&](Id operand) { return m_.type(operand) == Type::float_; };
        const size_t floats =
            static_cast<size_t>(std::count_if(operands.begin(), operands.end(), is_float));
        for (size_t k = 0; k < operands.size(); ++k)
            if (is_float(operands[k]) && floats < operands.size() &&
                !takes_float(inst.op, k, floats == 2))
                arguments[k] = call(info(inst.type).name, {arguments[k]});
    }
    return {call(info(inst.op).glsl, arguments), call_precedence};
}

// A constant of equal lanes is a plain number beside a vector.
std::string Writer::operand(Id id, const std::vector<Id>& operands, size_t k,
                            int precedence) const {
    const Id own = operands[k], other = operands[1 - k];
    const bool broadcast = info(m_[id].op).rule == Rule::broadcast || m_[id].op == Op::div_;
    const bool splat = plan_.role(own) == Role::leaf && m_[own].op == Op::construct_ &&
                       plan_.is_splat(own) && m_.type(other) == m_.type(own) &&
                       !m_.is_constant(other);
    return at_least(broadcast && splat ? m_[own].arg[0] : own, precedence);
}

Piece Writer::operation(Id id) const {
    std::vector<Id> operands;
    plan_.operands(id, operands);
    const int precedence = info(m_[id].op).precedence;
    const std::string spelling(info(m_[id].op).glsl);
    if (operands.size() == 1) return {spelling + at_least(operands[0], prefix + 1), prefix};
    return {operand(id, operands, 0, precedence) + " " + spelling + " " +
                operand(id, operands, 1, precedence + 1),
            precedence};
}

Piece Writer::define(Id id) const {
    const Inst& inst = m_[id];
    switch (inst.op) {
        case Op::input_:
            return input(id);
        case Op::construct_:
            return construct(id);
        case Op::sample_:
        case Op::sample_lod_:
        case Op::sample_grad_:
        case Op::image_size_:
            return sample(id);
        case Op::sign_nonzero_:
            return {at_least(plan_.plain(inst.arg[0]), relational + 1) + " < 0.0 ? -1.0 : 1.0",
                    conditional};
        case Op::select_:
            return {at_least(plan_.plain(inst.arg[0]), conditional + 1) + " ? " +
                        at_least(plan_.plain(inst.arg[1]), conditional + 1) + " : " +
                        at_least(plan_.plain(inst.arg[2]), conditional),
                    conditional};
        case Op::result_:
            return {call(context_.symbols.functions[m_[inst.arg[0]].extra], texts(id)),
                    call_precedence};
        default:
            return info(inst.op).precedence ? operation(id) : builtin(id);
    }
}

Piece Writer::read(Id id) const {
    if (plan_.role(id) == Role::leaf) return leaf(id);
    if (plan_.role(id) == Role::view) return view(id);
    const ValueState& state = context_.values.state[id];
    return state.statement ? Piece{state.name} : define(id);
}

}  // namespace

std::string literal_text(Type type, double value) {
    switch (type) {
        case Type::int_:
            if (value <= -2147483648.0) return "int(0x80000000u)";
            return std::to_string(static_cast<int64_t>(value));
        case Type::uint_:
            return std::to_string(static_cast<int64_t>(value)) + "u";
        case Type::bool_:
            return value != 0 ? "true" : "false";
        default:
            return float_text(value);
    }
}

std::string member_name(SurfaceInput input, Variant variant) {
    std::string name(info(input).name);
    if (variant == Variant::dx) name += "_dx";
    if (variant == Variant::dy) name += "_dy";
    return name;
}

Piece read(const ExpressionContext& context, Id id) {
    return Writer(context).read(id);
}

Piece define(const ExpressionContext& context, Id id) {
    return Writer(context).define(id);
}

uint32_t leaf_width(const Plan& plan, Id leaf) {
    const Module& m = plan.module();
    const Inst& inst = m[leaf];
    switch (inst.op) {
        case Op::literal_:
            return static_cast<uint32_t>(literal_text(inst.type, inst.value).size());
        case Op::parameter_: {
            const Parameter& parameter = m.parameters[inst.extra];
            return static_cast<uint32_t>(m.nodes[parameter.node].path.size() + 1 +
                                         parameter.port.size());
        }
        case Op::input_:
            return static_cast<uint32_t>(info(input_of(inst.extra)).name.size() + 2);
        case Op::construct_: {
            std::vector<Id> parts;
            plan.operands(leaf, parts);
            uint32_t width = own_width(plan, leaf);
            for (const Id part : parts)
                width += leaf_width(plan, part);
            return width;
        }
        case Op::swizzle_:
            return leaf_width(plan, plan.plain(inst.arg[0])) + 1 + (inst.extra & 0xF);
        default:
            return 2;
    }
}

uint32_t own_width(const Plan& plan, Id id) {
    const Module& m = plan.module();
    const Inst& inst = m[id];
    const OpInfo& op = info(inst.op);
    const auto commas = static_cast<uint32_t>(2 * m.operands(id).size());
    const auto spelling = static_cast<uint32_t>(op.glsl.size());
    if (inst.op == Op::construct_) return 4 + commas;
    if (inst.op == Op::select_) return 6;
    if (inst.op == Op::sign_nonzero_) return 19;
    if (inst.op == Op::input_) return 4 + 2 + 2 + 17;
    if (inst.op == Op::result_)
        return 16 + static_cast<uint32_t>(m.region(m[inst.arg[0]].extra).name.size()) + commas;
    if (inst.op >= Op::sample_ && inst.op <= Op::image_size_) return spelling + 16 + commas;
    return op.precedence ? spelling + 2 : spelling + commas;
}

}  // namespace wrinkle
