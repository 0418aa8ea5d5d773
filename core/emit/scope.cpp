#include "emit/scope.h"

#include <algorithm>
#include <array>
#include <utility>

#include "emit/expression.h"

namespace wrinkle {
namespace {

constexpr uint32_t max_line = 98;
constexpr uint32_t min_room = max_line / 2;    // for an expression on any line
constexpr uint32_t max_result = 74;            // after "m.displacement = "
constexpr uint32_t max_return = 87;            // after "return "
constexpr uint32_t max_expression_width = 72;  // for a value that needs no name so far
constexpr uint8_t max_expression_depth = 6;
constexpr uint32_t second_line = 80;  // the arguments of a call may take two lines
constexpr uint32_t parentheses = 2;
constexpr uint32_t loop_state_width = 12;
constexpr uint32_t view_suffix = 4;
constexpr size_t usual_room = 64;  // initial capacity of a walk

// Precedence from the op table, in a compact array because it is read for every operand.
uint8_t precedence_of(Op op) {
    static constexpr auto table = [] {
        std::array<uint8_t, tables::op_count> precedences{};
        for (size_t i = 0; i < precedences.size(); ++i)
            precedences[i] = tables::ops[i].precedence;
        return precedences;
    }();
    return table[static_cast<size_t>(op)];
}

bool needs_parentheses(const EmitAnalysis& analysis, Id reader, Id operand) {
    const int outer = precedence_of(analysis.module()[reader].op);
    const int inner = precedence_of(analysis.module()[operand].op);
    return outer > 0 && inner > 0 && inner <= outer;
}

// Folding decisions for one scope, operands first.
class TemporarySelector {
public:
    TemporarySelector(const EmitAnalysis& analysis, Values& values, const Scope& scope)
        : analysis_(analysis), m_(analysis.module()), values_(values), scope_(scope) {}

    void count_uses(std::span<const Id> roots);
    void visit(Id id);

private:
    // A value's text with the operands that are currently folded into it.
    struct Folded {
        uint32_t width = 0;
        uint8_t depth = 1;
        bool implicit = false;
        uint32_t max_width = 0;
        bool has_name = false;
        Id widest = no_id;  // the widest folded operand, of those that have a name if there are any
    };

    ValueState& state(Id id) { return values_.state[id]; }
    bool inside(Id id) { return state(id).epoch == scope_.epoch; }  // false for a leaf
    Id base(Id id);
    Folded measure(Id id);
    void read_value(Id reader, Id operand, Id value, Folded& text);
    uint8_t depth_in(Id reader, Id operand, Id value);
    bool must_precede(Id reader, Id operand, const ValueState& read, uint8_t depth);
    void make_statement(Id id);
    uint32_t name_width(Id id) const;
    uint32_t room_for(Id id);
    bool may_wrap(Id id, const Folded& text);
    bool is_too_wide(Id id, const Folded& text);
    bool must_name(Id id, bool is_root);

    const EmitAnalysis& analysis_;
    const Module& m_;
    Values& values_;
    const Scope& scope_;
};

// Returns the value that a swizzle or column reads; other values are returned unchanged.
Id TemporarySelector::base(Id id) {
    while (analysis_.role(id) == Role::view && m_[id].op != Op::result_)
        id = analysis_.operands(id)[0];
    return id;
}

void TemporarySelector::count_uses(std::span<const Id> roots) {
    for (const Id root : roots) {
        if (!inside(root)) continue;
        ++state(root).uses;
        state(root).shared = false;
        state(root).root = true;
    }
    for (size_t i = scope_.order.size(); i-- > 0;) {
        const Id id = scope_.order[i];
        const auto operands = analysis_.operands(id);
        const uint32_t uses = analysis_.role(id) == Role::view ? std::max(1u, state(id).uses) : 1;
        const bool shared = group_of(analysis_, values_, id) == surface_group;
        const bool loop = m_[id].op == Op::loop_;
        const size_t own = loop ? m_.operands(id).size() : operands.size();
        for (size_t k = 0; k < operands.size(); ++k) {
            ValueState& read = state(operands[k]);
            if (read.epoch != scope_.epoch) continue;
            read.uses += uses;
            if (k >= own) read.captured = true;
            read.shared = read.shared && shared;
        }
    }
}

void TemporarySelector::make_statement(Id id) {
    ValueState& s = state(id);
    if (s.statement) return;
    s.statement = true;
    s.width = name_width(id);
}

// Precondition: count_uses() has run, because the name depends on ValueState::shared.
uint32_t TemporarySelector::name_width(Id id) const {
    return static_cast<uint32_t>(name_hint(analysis_, values_, id).size());
}

// A value that is known to become a temporary shares the line with its declaration.
uint32_t TemporarySelector::room_for(Id id) {
    if (state(id).root && state(id).uses == 1) return values_.anonymous ? max_return : max_result;
    if (!must_name(id, false) && !analysis_.name(id)) return max_expression_width;
    const uint32_t declaration = 12 + name_width(id);
    return std::max(max_line - std::min(declaration, max_line), min_room);
}

// Returns true if the text exceeds its line and folding fewer operands makes it narrower.
bool TemporarySelector::is_too_wide(Id id, const Folded& text) {
    if (text.width <= min_room || text.widest == no_id || m_[id].op == Op::loop_) return false;
    return text.width > room_for(id) + (may_wrap(id, text) ? second_line : 0);
}

// The arguments of a call, and the terms of a derivative that has a name, may continue on a second
// line, unless one of them has a name.
bool TemporarySelector::may_wrap(Id id, const Folded& text) {
    if (analysis_.name(text.widest)) return false;
    const Op op = m_[id].op;
    const bool terms = op == Op::add_ || op == Op::sub_ || op == Op::construct_;
    const Named* name = analysis_.name(id);
    return analysis_.single_call(id) || (terms && name && name->derived);
}

// A left-associative chain of one precedence, as a + b + c, counts as one level.
uint8_t TemporarySelector::depth_in(Id reader, Id operand, Id value) {
    const uint8_t precedence = precedence_of(m_[reader].op);
    const bool chain = operand == value && precedence > 0 &&
                       precedence == precedence_of(m_[value].op) &&
                       operand == analysis_.operands(reader)[0];
    return static_cast<uint8_t>(state(value).depth + (chain ? 0 : 1));
}

// Returns true if the operand is too deep to fold, or takes implicit derivatives where the reader
// may skip it and they are undefined: GLSL evaluates only one branch of ?:, and && and || may skip
// their right side.
bool TemporarySelector::must_precede(Id reader, Id operand, const ValueState& read, uint8_t depth) {
    const Op op = m_[reader].op;
    if (op == Op::loop_) return false;
    const bool skips = op == Op::select_ || op == Op::and_ || op == Op::or_;
    if (skips && read.implicit && operand != analysis_.operands(reader)[0]) return true;
    return depth > max_expression_depth;
}

void TemporarySelector::read_value(Id reader, Id operand, Id value, Folded& text) {
    const ValueState& read = state(value);
    const uint32_t suffix = operand == value ? 0 : view_suffix;
    const bool folded = read.epoch == scope_.epoch && !read.statement;
    const uint8_t depth = folded ? depth_in(reader, operand, value) : 0;
    if (folded && must_precede(reader, operand, read, depth)) make_statement(value);
    const uint32_t width = suffix + read.width;
    text.width += width;
    if (!folded || read.statement) return;
    if (needs_parentheses(analysis_, reader, operand)) text.width += parentheses;
    text.depth = std::max(text.depth, depth);
    text.implicit = text.implicit || read.implicit;
    // In a function, a value that has a name is the first to become a temporary.
    const bool named = values_.anonymous && analysis_.name(value) != nullptr;
    if (std::pair(named, width) <= std::pair(text.has_name, text.max_width)) return;
    text.has_name = named;
    text.max_width = width;
    text.widest = value;
}

TemporarySelector::Folded TemporarySelector::measure(Id id) {
    const Op op = m_[id].op;
    Folded text;
    text.width = own_width(analysis_, values_.symbols, id);
    text.implicit = op == Op::sample_ || op == Op::input_;
    Id last = no_id;  // the vector of which the last operand is one component
    for (const Id operand : analysis_.operands(id)) {
        const bool component = op == Op::construct_ && m_[operand].op == Op::swizzle_ &&
                               swizzle_count(m_[operand].extra) == 1;
        const Id vector = component ? m_[operand].arg[0] : no_id;
        if (std::exchange(last, vector) == vector && component) {
            ++text.width;  // (a, v.yz)
            continue;
        }
        const Id value = base(operand);
        const Role role = analysis_.role(value);
        if (role == Role::value) {
            read_value(id, operand, value, text);
            continue;
        }
        text.width += operand == value ? 0 : view_suffix;
        text.width +=
            role == Role::leaf ? leaf_width(analysis_, values_.symbols, value) : loop_state_width;
    }
    return text;
}

bool TemporarySelector::must_name(Id id, bool is_root) {
    const ValueState& s = state(id);
    if (m_.type(id) == Type::tuple_ || s.uses > 1 || s.captured) return true;
    const Named* name = analysis_.name(id);
    return name && !is_root && (name->output || (values_.anonymous && !name->derived));
}

void TemporarySelector::visit(Id id) {
    if (analysis_.role(id) == Role::view) return;
    ValueState& own = state(id);
    Folded text;
    do {
        if (text.widest != no_id) make_statement(text.widest);
        text = measure(id);
        own.depth = std::max(own.depth, text.depth);
    } while (is_too_wide(id, text));
    own.width = text.width;
    own.implicit = text.implicit;
    if (must_name(id, own.root)) make_statement(id);
}

}  // namespace

Scope collect(const EmitAnalysis& analysis, Values& values, std::span<const Id> roots, int level) {
    Scope scope;
    scope.epoch = ++values.epoch;
    scope.order.reserve(usual_room);
    std::vector<Id> stack;
    stack.reserve(usual_room);
    const auto push = [&](Id id) {
        if (values.state[id].epoch == scope.epoch || analysis.role(id) == Role::leaf) return;
        if (level == 0 || analysis.module()[id].level >= level) stack.push_back(id);
    };
    for (size_t r = 0; r < roots.size(); ++r) {
        push(roots[r]);
        while (!stack.empty()) {
            const Id id = stack.back();
            ValueState& state = values.state[id];
            if (state.epoch != scope.epoch) {
                state = {};
                state.epoch = scope.epoch;
                state.shared = true;
                const auto operands = analysis.operands(id);
                for (size_t k = operands.size(); k-- > 0;)
                    push(operands[k]);
                if (stack.back() != id) continue;
            }
            stack.pop_back();
            if (!state.ordered) scope.order.push_back(id);
            state.ordered = true;
        }
        if (r == 0) scope.first_part = scope.order.size();
    }
    return scope;
}

void decide(const EmitAnalysis& analysis, Values& values, const Scope& scope,
            std::span<const Id> roots) {
    TemporarySelector selector(analysis, values, scope);
    selector.count_uses(roots);
    for (const Id id : scope.order)
        selector.visit(id);
}

uint32_t group_of(const EmitAnalysis& analysis, const Values& values, Id id) {
    const Module& m = analysis.module();
    if (values.anonymous) return 0;
    if (const Named* name = analysis.name(id)) return name->node ? name->node : surface_group;
    const bool shared = values.state[id].shared && !analysis.reads_texture(id);
    return shared || m[id].op == Op::input_ ? surface_group : m.origin[id];
}

NameHint name_hint(const EmitAnalysis& analysis, const Values& values, Id id) {
    const Module& m = analysis.module();
    const Named* name = analysis.name(id);
    if (values.anonymous) return {{}, name ? std::string_view(name->name) : word_for(m, id)};
    if (name) return {name->node ? std::string_view(m.nodes[name->node].path) : "", name->name};
    if (m[id].op == Op::input_) return {{}, change_name(m[id].extra)};
    // The result of a function that is named by one word has the name of the node.
    const bool call = analysis.single_call(id);
    if (call && m.region(m[m[id].arg[0]].extra).name.find('_') == std::string::npos)
        return {{}, m.nodes[m.origin[id]].path};
    const std::string_view word = analysis.is_gradient(id) ? "gradient" : word_for(m, id);
    if (group_of(analysis, values, id) == surface_group) return {"surface", word};
    return {m.nodes[m.origin[id]].path, word};
}

}  // namespace wrinkle
