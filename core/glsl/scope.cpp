#include "glsl/scope.h"

#include <algorithm>
#include <array>

#include "glsl/expression.h"

namespace wrinkle {
namespace {

constexpr uint32_t widest_line = 98;
constexpr uint32_t widest_result = 84;
constexpr uint32_t widest_expression = 72;  // of what has no name yet
constexpr uint8_t deepest_expression = 6;
constexpr uint32_t parentheses = 2;
constexpr uint32_t loop_state_width = 12;
constexpr uint32_t view_suffix = 4;

// What the op table says, close together: it is asked for every operand.
uint8_t precedence_of(Op op) {
    static constexpr auto table = [] {
        std::array<uint8_t, tables::op_count> precedences{};
        for (size_t i = 0; i < precedences.size(); ++i)
            precedences[i] = tables::ops[i].precedence;
        return precedences;
    }();
    return table[static_cast<size_t>(op)];
}

bool needs_parentheses(const Plan& plan, Id reader, Id operand) {
    const int outer = precedence_of(plan.module()[reader].op);
    const int inner = precedence_of(plan.module()[operand].op);
    return outer > 0 && inner > 0 && inner <= outer;
}

// Folding decisions for one scope, operands first.
class Folder {
public:
    Folder(const Plan& plan, Values& values, const Scope& scope)
        : plan_(plan), m_(plan.module()), values_(values), scope_(scope) {}

    void count_uses(std::span<const Id> roots);
    void visit(Id id);

private:
    // A value that is read by the value at hand, or that is read through a view.
    struct Part {
        Id id;
        uint32_t extra;    // width that its view adds
        bool inside;       // of this scope
        bool first;        // of the operands
        bool plain;        // no view
        bool parentheses;  // where its text is folded in
    };

    ValueState& state(Id id) { return values_.state[id]; }
    bool inside(Id id) { return state(id).epoch == scope_.epoch; }  // a leaf never is
    Id base(Id id);
    void take_operands(Id id);
    bool foldable(const Part& part) { return part.inside && !state(part.id).statement; }
    void make_statement(Id id);
    uint32_t name_width(Id id) const;
    void hoist_implicit();
    uint32_t room_for(Id id);
    void narrow(Id id);
    void flatten(Id id);
    bool must_name(Id id, bool is_root);

    const Plan& plan_;
    const Module& m_;
    Values& values_;
    const Scope& scope_;
    std::vector<Part> parts_;  // of the value at hand
    uint32_t leaves_ = 0;      // width of its other operands
};

// What a view looks at.
Id Folder::base(Id id) {
    while (plan_.role(id) == Role::view && m_[id].op != Op::result_)
        id = plan_.operands(id)[0];
    return id;
}

void Folder::take_operands(Id id) {
    parts_.clear();
    leaves_ = 0;
    bool first = true;
    for (const Id operand : plan_.operands(id)) {
        const Id target = base(operand);
        const bool plain = target == operand;
        const uint32_t extra = plain ? 0 : view_suffix;
        const Role role = plan_.role(target);
        if (role == Role::leaf)
            leaves_ += extra + leaf_width(plan_, target);
        else if (role == Role::view)
            leaves_ += extra + loop_state_width;
        else
            parts_.push_back({target, extra, inside(target), first, plain,
                              needs_parentheses(plan_, id, operand)});
        first = false;
    }
}

void Folder::count_uses(std::span<const Id> roots) {
    for (const Id root : roots) {
        if (!inside(root)) continue;
        ++state(root).uses;
        state(root).shared = false;
        state(root).root = true;
    }
    for (size_t i = scope_.order.size(); i-- > 0;) {
        const Id id = scope_.order[i];
        const auto operands = plan_.operands(id);
        const uint32_t uses = plan_.role(id) == Role::view ? std::max(1u, state(id).uses) : 1;
        const bool shared = group_of(plan_, values_, id) == surface_group;
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

void Folder::make_statement(Id id) {
    ValueState& s = state(id);
    if (s.statement) return;
    s.statement = true;
    s.width = name_width(id);
}

// What it is shared by, and so its name, is known before.
uint32_t Folder::name_width(Id id) const {
    return static_cast<uint32_t>(wanted_name(plan_, values_, id).size());
}

// GLSL evaluates one branch of ?: only, and && and || may skip their right side; there an implicit
// derivative would be undefined.
void Folder::hoist_implicit() {
    for (const Part& part : parts_)
        if (!part.first && foldable(part) && state(part.id).implicit) make_statement(part.id);
}

// What is known to become a temporary has its declaration on the line too.
uint32_t Folder::room_for(Id id) {
    if (state(id).root && state(id).uses == 1) return widest_result;
    if (!must_name(id, false)) return widest_expression;
    const uint32_t declaration = 12 + name_width(id);
    return widest_line - std::min(declaration, widest_line / 2);
}

void Folder::narrow(Id id) {
    const uint32_t own = own_width(plan_, id) + leaves_;
    state(id).width = own;
    if (parts_.empty()) return;
    const uint32_t room = room_for(id);
    for (;;) {
        uint32_t width = own, widest = 0;
        Id victim = poison;
        for (const Part& part : parts_) {
            const uint32_t w = part.extra + state(part.id).width;
            width += w;
            if (!foldable(part)) continue;
            width += part.parentheses ? parentheses : 0;
            if (w <= widest) continue;
            widest = w;
            victim = part.id;
        }
        state(id).width = width;
        if (width <= room || victim == poison) return;
        make_statement(victim);
    }
}

// A chain of one precedence counts as one level, as it reads.
void Folder::flatten(Id id) {
    const uint8_t precedence = precedence_of(m_[id].op);
    uint8_t deepest = 1;
    for (const Part& part : parts_) {
        if (!foldable(part)) continue;
        const bool chain = part.first && part.plain && precedence > 0 &&
                           precedence == precedence_of(m_[part.id].op);
        const auto depth = static_cast<uint8_t>(state(part.id).depth + (chain ? 0 : 1));
        if (depth > deepest_expression)
            make_statement(part.id);
        else
            deepest = std::max(deepest, depth);
    }
    state(id).depth = deepest;
}

bool Folder::must_name(Id id, bool is_root) {
    const ValueState& s = state(id);
    if (m_.type(id) == Type::tuple_ || s.uses > 1 || s.captured) return true;
    const uint32_t name = plan_.first_name[id];
    return name && m_.named[name - 1].output && !is_root;
}

void Folder::visit(Id id) {
    if (plan_.role(id) == Role::view) return;
    take_operands(id);
    const Op op = m_[id].op;
    if (op == Op::select_ || op == Op::and_ || op == Op::or_) hoist_implicit();
    if (op != Op::loop_) {
        if (!parts_.empty()) flatten(id);
        narrow(id);
    }
    bool implicit = op == Op::sample_ || op == Op::input_;
    for (const Part& part : parts_)
        implicit = implicit || (foldable(part) && state(part.id).implicit);
    state(id).implicit = implicit;
    if (must_name(id, state(id).root)) make_statement(id);
}

}  // namespace

Scope collect(const Plan& plan, Values& values, std::span<const Id> roots, int level) {
    Scope scope;
    scope.epoch = ++values.epoch;
    std::vector<std::pair<Id, bool>> stack;
    const auto push = [&](Id id) {
        if (plan.role(id) == Role::leaf || plan.module()[id].level < level) return;
        if (values.state[id].epoch != scope.epoch) stack.push_back({id, false});
    };
    for (size_t r = 0; r < roots.size(); ++r) {
        push(roots[r]);
        while (!stack.empty()) {
            const auto [id, finished] = stack.back();
            stack.pop_back();
            if (finished) {
                scope.order.push_back(id);
                continue;
            }
            if (values.state[id].epoch == scope.epoch) continue;
            values.state[id] = {};
            values.state[id].epoch = scope.epoch;
            values.state[id].shared = true;
            stack.push_back({id, true});
            const auto operands = plan.operands(id);
            for (size_t k = operands.size(); k-- > 0;)
                push(operands[k]);
        }
        if (r == 0) scope.first_part = scope.order.size();
    }
    return scope;
}

void decide(const Plan& plan, Values& values, const Scope& scope, std::span<const Id> roots) {
    Folder folder(plan, values, scope);
    folder.count_uses(roots);
    for (const Id id : scope.order)
        folder.visit(id);
}

uint32_t group_of(const Plan& plan, const Values& values, Id id) {
    const Module& m = plan.module();
    if (values.anonymous) return 0;
    const uint32_t name = plan.first_name[id];
    if (name) return m.named[name - 1].node ? m.named[name - 1].node : surface_group;
    return values.state[id].shared || m[id].op == Op::input_ ? surface_group : m.origin[id];
}

WantedName wanted_name(const Plan& plan, const Values& values, Id id) {
    const Module& m = plan.module();
    const uint32_t name = plan.first_name[id];
    if (values.anonymous)
        return {{}, name ? std::string_view(m.named[name - 1].name) : word_for(m, id)};
    if (name) {
        const Named& named = m.named[name - 1];
        return {named.node ? std::string_view(m.nodes[named.node].path) : "", named.name};
    }
    if (m[id].op == Op::input_) return {{}, change_name(m[id].extra)};
    const std::string_view word = plan.is_gradient[id] ? "gradient" : word_for(m, id);
    if (values.state[id].shared) return {"surface", word};
    return {m.nodes[m.origin[id]].path, word};
}

}  // namespace wrinkle
