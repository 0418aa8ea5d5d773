#include "emit/expression.h"

#include <algorithm>
#include <array>

#include "emit/literal.h"

namespace wrinkle {
namespace {

constexpr int name_precedence = 20, call_precedence = 18, postfix = 17, prefix = 16;
constexpr int additive = 14, relational = 12, equality = 11, conditional = 3;

bool is_associative(Op op) {
    return op == Op::bit_and_ || op == Op::bit_or_ || op == Op::bit_xor_ || op == Op::and_ ||
           op == Op::or_;
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
          language_(context.language),
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
    void list(std::span<const Id> ids, std::string_view more);
    void parts(std::span<const Id> ids);
    void components(std::span<const Id> ids);
    size_t run_length(std::span<const Id> ids) const;
    void builtin(Id id);
    void operand(Id id, size_t k, int least);
    void operation(Id id);
    void sample(Id id);
    void pattern(std::string_view pattern, std::span<const Id> operands, int least,
                 std::string_view image = {});
    void call(Id id);
    void construct(Id id);
    void select(Id id);
    int least_in(Id id, Id operand, int least) const;
    int construct_binding(Id id) const {
        const bool cast = language_.splat_is_cast && analysis_.is_splat(id);
        return cast ? prefix : call_precedence;
    }

    const ExpressionContext& context_;
    const EmitAnalysis& analysis_;
    const Module& m_;
    const Language& language_;
    std::string& text_;
};

int Writer::leaf_binding(Id id) const {
    const Inst& inst = m_[id];
    if (analysis_.is_named_constant(id)) return name_precedence;
    switch (inst.op) {
        case Op::literal_:
            return is_negative_literal(inst.type, inst.value) ? prefix : name_precedence;
        case Op::input_:
        case Op::swizzle_:
            return postfix;
        case Op::construct_:
            return construct_binding(id);
        default:
            return name_precedence;
    }
}

int Writer::definition_binding(Id id) const {
    const Inst& inst = m_[id];
    switch (inst.op) {
        case Op::sign_nonzero_:
        case Op::select_:
            return language_.select_is_call ? call_precedence : conditional;
        case Op::construct_:
            return construct_binding(id);
        default:
            break;
    }
    if (info(inst.op).precedence == 0 || language_.is_pattern(inst.op)) return call_precedence;
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

// `more`: further arguments.
void Writer::list(std::span<const Id> ids, std::string_view more) {
    text_.append("(");
    for (size_t i = 0; i < ids.size(); ++i) {
        if (i > 0) text_.append(", ");
        read(ids[i], 0);
    }
    if (!ids.empty() && !more.empty()) text_.append(", ");
    text_.append(more).append(")");
}

void Writer::input(Id id) {
    const SurfaceInput which = input_of(m_[id].extra);
    const Variant variant = variant_of(m_[id].extra);
    const bool change = analysis_.role(id) != Role::leaf;
    if (change)
        text_.append(variant == Variant::dx ? context_.target.change_x : context_.target.change_y)
            .append("(");
    if (language_.arguments == Arguments::structs) text_.append("s.");
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
    const Symbols& symbols = context_.values.symbols;
    if (analysis_.is_named_constant(id)) {
        text_.append(symbols.constants.at(id));
        return;
    }
    switch (inst.op) {
        case Op::literal_:
            text_.append(analysis_.literal(id));
            break;
        case Op::input_:
            input(id);
            break;
        case Op::parameter_:
            text_.append(symbols.parameters[inst.extra]);
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

// Fills a pattern with operands; `least` is the precedence below which they have parentheses.
void Writer::pattern(std::string_view pattern, std::span<const Id> operands, int least,
                     std::string_view image) {
    std::array<std::string, 3> texts;
    for (size_t k = 0; k < operands.size(); ++k)
        texts[k] = text_of(context_, analysis_.strip_detach(operands[k]), least);
    append_filled(text_, pattern,
                  {{'0', texts[0]},
                   {'1', texts[1]},
                   {'2', texts[2]},
                   {'n', image},
                   {'f', context_.values.symbols.prefix}});
}

void Writer::sample(Id id) {
    pattern(language_.op(m_[id].op), analysis_.operands(id), 0,
            context_.values.symbols.resources[m_[id].extra]);
}

void Writer::builtin(Id id) {
    const Inst& inst = m_[id];
    const auto operands = analysis_.operands(id);
    const auto is_float = [&](Id operand) { return m_.type(operand) == Type::float_; };
    const bool broadcasts =
        info(inst.op).rule == Rule::floats || info(inst.op).rule == Rule::broadcast;
    const auto floats =
        static_cast<size_t>(std::count_if(operands.begin(), operands.end(), is_float));
    text_.append(language_.op(inst.op)).append("(");
    for (size_t k = 0; k < operands.size(); ++k) {
        const bool widened = broadcasts && is_float(operands[k]) && floats < operands.size() &&
                             !language_.takes_scalar(inst.op, k, floats == 2);
        if (k > 0) text_.append(", ");
        if (widened) text_.append(language_.type(inst.type)).append("(");
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
                       !analysis_.is_named_constant(own) && m_[own].op == Op::construct_ &&
                       analysis_.is_splat(own) && m_.type(other) == m_.type(own) &&
                       !m_.is_constant(other);
    read(splat ? m_[own].arg[0] : own, least_in(id, own, least));
}

// Operators below arithmetic have parentheses around every operand of another operator: WGSL
// requires them, and readers need not know the order.
int Writer::least_in(Id id, Id operand, int least) const {
    const Op op = m_[id].op;
    const Rule rule = info(op).rule;
    const bool chain = m_[operand].op == op && is_associative(op);
    if (info(op).precedence >= additive || chain) return least;
    return rule == Rule::bits ? prefix : rule == Rule::logic ? equality : additive;
}

void Writer::operation(Id id) {
    const Inst& inst = m_[id];
    const auto operands = analysis_.operands(id);
    if (operands.size() == 1) {
        text_.append(language_.op(inst.op));
        read(operands[0], prefix + 1);
        return;
    }
    const int own = info(inst.op).precedence;
    operand(id, 0, own);
    text_.append(" ").append(language_.op(inst.op)).append(" ");
    operand(id, 1, own + 1);
}

void Writer::construct(Id id) {
    const auto operands = analysis_.operands(id);
    const std::string_view type = language_.type(m_[id].type);
    if (operands.size() == 1) {
        const std::string value =
            text_of(context_, operands[0], language_.splat_is_cast ? prefix + 1 : 0);
        append_filled(text_, language_.splat, {{'t', type}, {'0', value}});
        return;
    }
    text_.append(type);
    parts(operands);
}

// A condition has parentheses within another.
void Writer::select(Id id) {
    const Inst& inst = m_[id];
    const bool sign = inst.op == Op::sign_nonzero_;
    const int least = language_.select_is_call ? 0 : conditional + 1;
    const auto part = [&](size_t k) {
        return text_of(context_, analysis_.strip_detach(inst.arg[k]), least);
    };
    const std::string condition =
        sign ? text_of(context_, analysis_.strip_detach(inst.arg[0]), relational + 1) + " < 0.0"
             : part(0);
    append_filled(
        text_, language_.select,
        {{'0', condition}, {'1', sign ? "-1.0" : part(1)}, {'2', sign ? "1.0" : part(2)}});
}

void Writer::call(Id id) {
    const Symbols& symbols = context_.values.symbols;
    const uint32_t function = m_[m_[id].arg[0]].extra;
    text_.append(symbols.functions[function]);
    list(analysis_.operands(id), symbols.resource_arguments[function]);
}

void Writer::define(Id id) {
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
        case Op::select_:
            return select(id);
        case Op::result_:
            return call(id);
        default:
            if (language_.is_pattern(inst.op))
                return pattern(language_.op(inst.op), analysis_.operands(id), 0);
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
