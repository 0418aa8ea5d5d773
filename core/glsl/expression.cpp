#include "glsl/expression.h"

#include <algorithm>
#include <array>

#include "glsl/literal.h"

namespace wrinkle {
namespace {

constexpr int name_precedence = 20, call_precedence = 18, postfix = 17, prefix = 16;
constexpr int relational = 12, conditional = 3;

// Returns true if the GLSL built-in accepts a float for this operand together with vectors.
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

std::string_view suffix_of(Variant variant) {
    return variant == Variant::dx ? "_dx" : variant == Variant::dy ? "_dy" : "";
}

class Writer {
public:
    Writer(const ExpressionContext& context, std::string& text)
        : context_(context),
          analysis_(context.analysis),
          m_(context.analysis.module()),
          text_(text) {}

    void read(Id id, int least);
    void define(Id id);

private:
    int binding(Id id) const;  // precedence; the value is not a temporary
    int leaf_binding(Id id) const;
    int definition_binding(Id id) const;
    void write_inline(Id id);
    void leaf(Id id);
    void input(Id id);
    void view(Id id);
    void list(std::span<const Id> ids);
    void parts(std::span<const Id> ids);
    void components(std::span<const Id> ids);
    size_t run_length(std::span<const Id> ids) const;
    void builtin(Id id);
    void operand(Id id, size_t k, int least);
    void operation(Id id);
    void sample(Id id);

    const ExpressionContext& context_;
    const EmitAnalysis& analysis_;
    const Module& m_;
    std::string& text_;
};

int Writer::leaf_binding(Id id) const {
    const Inst& inst = m_[id];
    switch (inst.op) {
        case Op::literal_:
            return is_negative_literal(inst.type, inst.value) ? prefix : name_precedence;
        case Op::input_:
        case Op::swizzle_:
            return postfix;
        case Op::construct_:
            return call_precedence;
        default:
            return name_precedence;
    }
}

int Writer::definition_binding(Id id) const {
    const Inst& inst = m_[id];
    switch (inst.op) {
        case Op::sign_nonzero_:
        case Op::select_:
            return conditional;
        case Op::construct_:
            return call_precedence;
        default:
            break;
    }
    if (info(inst.op).precedence == 0) return call_precedence;
    return analysis_.operands(id).size() == 1 ? prefix : info(inst.op).precedence;
}

int Writer::binding(Id id) const {
    if (analysis_.role(id) == Role::leaf) return leaf_binding(id);
    if (analysis_.role(id) == Role::view)
        return m_[id].op == Op::result_ ? name_precedence : postfix;
    return definition_binding(id);
}

void Writer::read(Id id, int least) {
    if (analysis_.role(id) == Role::value && context_.values.state[id].statement) {
        text_.append(context_.values.state[id].name);
        return;
    }
    const bool enclosed = least > 0 && binding(id) < least;
    if (enclosed) text_.append("(");
    write_inline(id);
    if (enclosed) text_.append(")");
}

// Writes a value that is not a temporary.
void Writer::write_inline(Id id) {
    switch (analysis_.role(id)) {
        case Role::leaf:
            return leaf(id);
        case Role::view:
            return view(id);
        case Role::value:
            return define(id);
    }
}

void Writer::list(std::span<const Id> ids) {
    text_.append("(");
    for (size_t i = 0; i < ids.size(); ++i) {
        if (i > 0) text_.append(", ");
        read(ids[i], 0);
    }
    text_.append(")");
}

void Writer::input(Id id) {
    const SurfaceInput which = input_of(m_[id].extra);
    const Variant variant = variant_of(m_[id].extra);
    const bool change = analysis_.role(id) != Role::leaf;
    if (change)
        text_.append(variant == Variant::dx ? context_.target.change_x : context_.target.change_y)
            .append("(");
    text_.append("s.");
    if (!change)
        text_.append(info(which).name).append(suffix_of(variant));
    else if (which == SurfaceInput::position_)
        text_.append("position_relative");
    else
        text_.append(info(which).name);
    if (change) text_.append(")");
}

void Writer::leaf(Id id) {
    const Inst& inst = m_[id];
    switch (inst.op) {
        case Op::literal_:
            text_.append(analysis_.literal(id));
            break;
        case Op::input_:
            input(id);
            break;
        case Op::parameter_:
            text_.append(context_.values.symbols.parameters[inst.extra]);
            break;
        case Op::region_param_:
            text_.append(context_.parameters[inst.level][inst.extra]);
            break;
        case Op::construct_:
            define(id);
            break;
        case Op::swizzle_:
            view(id);
            break;
        default:
            text_.append("0.0");
    }
}

void Writer::view(Id id) {
    const Inst& inst = m_[id];
    if (inst.op == Op::result_) {
        text_.append(context_.values.state[id].name);
        return;
    }
    read(analysis_.strip_detach(inst.arg[0]), postfix);
    if (inst.op == Op::column_) {
        text_.append("[").append(std::to_string(inst.extra)).append("]");
        return;
    }
    text_.append(".");
    for (int i = 0; i < swizzle_count(inst.extra); ++i)
        text_ += "xyzw"[swizzle_component(inst.extra, i)];
}

// Returns how many of the first values are single components of one vector.
size_t Writer::run_length(std::span<const Id> ids) const {
    const auto is_component = [&](Id id) {
        return m_[id].op == Op::swizzle_ && swizzle_count(m_[id].extra) == 1 &&
               m_[id].arg[0] == m_[ids[0]].arg[0];
    };
    return static_cast<size_t>(std::ranges::find_if_not(ids, is_component) - ids.begin());
}

// Writes (a, v.yz) for the components a, v.y, v.z.
void Writer::parts(std::span<const Id> ids) {
    text_.append("(");
    for (size_t k = 0; k < ids.size();) {
        if (k > 0) text_.append(", ");
        const size_t run = run_length(ids.subspan(k));
        if (run > 1)
            components(ids.subspan(k, run));
        else
            read(ids[k], 0);
        k += std::max<size_t>(run, 1);
    }
    text_.append(")");
}

void Writer::components(std::span<const Id> ids) {
    const Id vector = analysis_.strip_detach(m_[ids[0]].arg[0]);
    std::string letters;
    for (const Id id : ids)
        letters += "xyzw"[swizzle_component(m_[id].extra, 0)];
    read(vector, postfix);
    if (letters != std::string_view("xyzw").substr(0, info(m_.type(vector)).lanes))
        text_.append(".").append(letters);
}

void Writer::sample(Id id) {
    const std::string& image = context_.values.symbols.resources[m_[id].extra];
    if (m_[id].op == Op::image_size_) {
        text_.append("vec2(textureSize(").append(image).append(", 0))");
        return;
    }
    text_.append(info(m_[id].op).glsl).append("(").append(image);
    for (const Id operand : analysis_.operands(id)) {
        text_.append(", ");
        read(operand, 0);
    }
    text_.append(")");
}

void Writer::builtin(Id id) {
    const Inst& inst = m_[id];
    const auto operands = analysis_.operands(id);
    const auto is_float = [&](Id operand) { return m_.type(operand) == Type::float_; };
    const bool broadcasts =
        info(inst.op).rule == Rule::floats || info(inst.op).rule == Rule::broadcast;
    const auto floats =
        static_cast<size_t>(std::count_if(operands.begin(), operands.end(), is_float));
    text_.append(info(inst.op).glsl).append("(");
    for (size_t k = 0; k < operands.size(); ++k) {
        const bool widened = broadcasts && is_float(operands[k]) && floats < operands.size() &&
                             !takes_float(inst.op, k, floats == 2);
        if (k > 0) text_.append(", ");
        if (widened) text_.append(info(inst.type).name).append("(");
        read(operands[k], 0);
        if (widened) text_.append(")");
    }
    text_.append(")");
}

// If the other operand is a vector, a constant with equal components is written as a scalar.
void Writer::operand(Id id, size_t k, int least) {
    const auto operands = analysis_.operands(id);
    const Id own = operands[k], other = operands[1 - k];
    const bool broadcast = info(m_[id].op).rule == Rule::broadcast || m_[id].op == Op::div_;
    const bool splat = broadcast && analysis_.role(own) == Role::leaf &&
                       m_[own].op == Op::construct_ && analysis_.is_splat(own) &&
                       m_.type(other) == m_.type(own) && !m_.is_constant(other);
    read(splat ? m_[own].arg[0] : own, least);
}

void Writer::operation(Id id) {
    const OpInfo& op = info(m_[id].op);
    const auto operands = analysis_.operands(id);
    if (operands.size() == 1) {
        text_.append(op.glsl);
        read(operands[0], prefix + 1);
        return;
    }
    operand(id, 0, op.precedence);
    text_.append(" ").append(op.glsl).append(" ");
    operand(id, 1, op.precedence + 1);
}

void Writer::define(Id id) {
    const Inst& inst = m_[id];
    switch (inst.op) {
        case Op::input_:
            return input(id);
        case Op::construct_:
            text_.append(info(inst.type).name);
            return parts(analysis_.operands(id));
        case Op::sample_:
        case Op::sample_lod_:
        case Op::sample_grad_:
        case Op::image_size_:
            return sample(id);
        case Op::sign_nonzero_:
            read(analysis_.strip_detach(inst.arg[0]), relational + 1);
            text_.append(" < 0.0 ? -1.0 : 1.0");
            return;
        case Op::select_:
            read(analysis_.strip_detach(inst.arg[0]), conditional + 1);
            text_.append(" ? ");
            read(analysis_.strip_detach(inst.arg[1]), conditional + 1);
            text_.append(" : ");
            return read(analysis_.strip_detach(inst.arg[2]), conditional);
        case Op::result_:
            text_.append(context_.values.symbols.functions[m_[inst.arg[0]].extra]);
            return list(analysis_.operands(id));
        default:
            return info(inst.op).precedence ? operation(id) : builtin(id);
    }
}

}  // namespace

std::string member_name(SurfaceInput input, Variant variant) {
    return std::string(info(input).name).append(suffix_of(variant));
}

void write(const ExpressionContext& context, Id id, std::string& text, int least) {
    Writer(context, text).read(id, least);
}

std::string text_of(const ExpressionContext& context, Id id, int least) {
    std::string text;
    write(context, id, text, least);
    return text;
}

void write_definition(const ExpressionContext& context, Id id, std::string& text) {
    Writer(context, text).define(id);
}

}  // namespace wrinkle
