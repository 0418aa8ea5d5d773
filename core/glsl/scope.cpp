#include "glsl/scope.h"

#include <algorithm>

#include "glsl/expression.h"
#include "glsl/names.h"

namespace wrinkle {
namespace {

constexpr uint32_t widest_line = 98;
constexpr uint32_t widest_result = 84;
constexpr uint32_t widest_expression = 72;  // of what has no name yet
constexpr uint8_t deepest_expression = 6;
constexpr uint32_t parentheses = 2;
constexpr uint32_t loop_state_width = 12;
constexpr uint32_t view_suffix = 4;

// Folding decisions for one scope, operands first.
bool needs_parentheses(const Plan& plan, Id reader, Id operand) {
    const int outer = info(plan.module()[reader].op).precedence;
    const int inner = info(plan.module()[operand].op).precedence;
    return outer > 0 && inner > 0 && inner <= outer;
}

class Folder {
public:
    Folder(const Plan& plan, Values& values, const Scope& scope)
        : plan_(plan), values_(values), scope_(scope) {}

    void count_uses(std::span<const Id> roots);
    void visit(Id id, bool is_root);

private:
    // An operand of the value at hand.
    struct Part {
        Id target;              // what it is, or what it is a view of
        uint32_t width;         // of a leaf or a view; of a value what its view adds
        bool is_value, inside;  // of this scope
        bool plain;             // no view
        bool parentheses;       // where its text is folded in
    };

    ValueState& state(Id id) { return values_.state[id]; }
    bool inside(Id id) { return state(id).epoch == scope_.epoch && plan_.role(id) != Role::leaf; }
    Id base(Id id);
    Part part_of(Id reader, Id operand);
    bool foldable(const Part& part) { return part.inside && !state(part.target).statement; }
    uint32_t width_of(const Part& part);
    void make_statement(Id id);
    const std::string& name_of(Id id);
    void hoist_implicit(Id id);
    uint32_t room_for(Id id, bool is_root);
    void narrow(Id id, bool is_root);
    void flatten(Id id);
    bool must_name(Id id, bool is_root);

    const Plan& plan_;
    Values& values_;
    const Scope& scope_;
    std::vector<Part> parts_;  // of the value at hand
};

// What a view looks at.
Id Folder::base(Id id) {
    while (plan_.role(id) == Role::view && plan_.module()[id].op != Op::result_)
        id = plan_.operands(id)[0];
    return id;
}

Folder::Part Folder::part_of(Id reader, Id operand) {
    Part part{operand, 0, false, false, true, false};
    Role role = plan_.role(operand);
    if (role == Role::view) {
        part.target = base(operand);
        role = plan_.role(part.target);
        part.plain = part.target == operand;
    }
    part.width = part.plain ? 0 : view_suffix;
    if (role == Role::leaf) {
        part.width += leaf_width(plan_, part.target);
    } else if (role == Role::view) {
        part.width += loop_state_width;
    } else {
        part.is_value = true;
        part.inside = inside(part.target);
        part.parentheses = needs_parentheses(plan_, reader, operand);
    }
    return part;
}

uint32_t Folder::width_of(const Part& part) {
    if (!part.is_value) return part.width;
    const ValueState& s = state(part.target);
    const size_t own = s.statement ? name_of(part.target).size() : s.width;
    return part.width + static_cast<uint32_t>(own);
}

void Folder::count_uses(std::span<const Id> roots) {
    for (const Id root : roots) {
        if (!inside(root)) continue;
        ++state(root).uses;
        state(root).shared = false;
    }
    for (size_t i = scope_.order.size(); i-- > 0;) {
        const Id id = scope_.order[i];
        const bool view = plan_.role(id) == Role::view;
        const auto operands = plan_.operands(id);
        const bool shared = group_of(plan_, values_, id) == surface_group;
        const bool loop = plan_.module()[id].op == Op::loop_;
        const size_t own = loop ? plan_.module().operands(id).size() : operands.size();
        for (size_t k = 0; k < operands.size(); ++k) {
            if (!inside(operands[k])) continue;
            ValueState& read = state(operands[k]);
            read.uses += view ? std::max(1u, state(id).uses) : 1;
            if (k >= own) read.captured = true;
            read.shared = read.shared && shared;
        }
    }
}

void Folder::make_statement(Id id) {
    ValueState& s = state(id);
    if (s.statement) return;
    s.statement = true;
    name_of(id);
}

// Decided once: what it is shared by, and so its name, is known before.
const std::string& Folder::name_of(Id id) {
    std::string& name = values_.name(id);
    if (name.empty()) name = wanted_name(plan_, values_, id);
    return name;
}

// GLSL evaluates one branch of ?: only, and && and || may skip their right side; there an implicit
// derivative would be undefined.
void Folder::hoist_implicit(Id id) {
    const Op op = plan_.module()[id].op;
    if (op != Op::select_ && op != Op::and_ && op != Op::or_) return;
    for (size_t k = 1; k < parts_.size(); ++k)
        if (foldable(parts_[k]) && state(parts_[k].target).implicit)
            make_statement(parts_[k].target);
}

// What is known to become a temporary has its declaration on the line too.
uint32_t Folder::room_for(Id id, bool is_root) {
    if (is_root && state(id).uses == 1) return widest_result;
    if (!must_name(id, false)) return widest_expression;
    const uint32_t declaration = 12 + static_cast<uint32_t>(name_of(id).size());
    return widest_line - std::min(declaration, widest_line / 2);
}

void Folder::narrow(Id id, bool is_root) {
    const uint32_t room = room_for(id, is_root), own = own_width(plan_, id);
    for (;;) {
        uint32_t width = own, widest = 0;
        Id victim = poison;
        for (const Part& part : parts_) {
            const uint32_t w = width_of(part);
            width += w;
            if (!foldable(part)) continue;
            width += part.parentheses ? parentheses : 0;
            if (w <= widest) continue;
            widest = w;
            victim = part.target;
        }
        state(id).width = width;
        if (width <= room || victim == poison) return;
        make_statement(victim);
    }
}

// A chain of one precedence counts as one level, as it reads.
void Folder::flatten(Id id) {
    const Module& m = plan_.module();
    const auto precedence = info(m[id].op).precedence;
    uint8_t deepest = 1;
    for (size_t k = 0; k < parts_.size(); ++k) {
        const Part& part = parts_[k];
        if (!foldable(part)) continue;
        const bool chain = k == 0 && part.plain && precedence > 0 &&
                           precedence == info(m[part.target].op).precedence;
        const auto depth = static_cast<uint8_t>(state(part.target).depth + (chain ? 0 : 1));
        if (depth > deepest_expression)
            make_statement(part.target);
        else
            deepest = std::max(deepest, depth);
    }
    state(id).depth = deepest;
}

bool Folder::must_name(Id id, bool is_root) {
    if (plan_.role(id) != Role::value) return false;
    const ValueState& s = state(id);
    if (plan_.module().type(id) == Type::tuple_ || s.uses > 1 || s.captured) return true;
    const uint32_t name = plan_.first_name[id];
    return name && plan_.module().named[name - 1].output && !is_root;
}

void Folder::visit(Id id, bool is_root) {
    parts_.clear();
    for (const Id operand : plan_.operands(id))
        parts_.push_back(part_of(id, operand));
    hoist_implicit(id);
    const Op op = plan_.module()[id].op;
    if (plan_.role(id) == Role::value && op != Op::loop_) {
        flatten(id);
        narrow(id, is_root);
    }
    bool implicit = op == Op::sample_ || op == Op::input_;
    for (const Part& part : parts_)
        implicit = implicit || (foldable(part) && state(part.target).implicit);
    state(id).implicit = implicit;
    if (must_name(id, is_root)) make_statement(id);
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
            values.state[id] = ValueState{.epoch = scope.epoch, .shared = true};
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
        folder.visit(id, std::find(roots.begin(), roots.end(), id) != roots.end());
}

uint32_t group_of(const Plan& plan, const Values& values, Id id) {
    const Module& m = plan.module();
    if (values.anonymous) return 0;
    const uint32_t name = plan.first_name[id];
    if (name) return m.named[name - 1].node ? m.named[name - 1].node : surface_group;
    return values.state[id].shared || m[id].op == Op::input_ ? surface_group : m.origin[id];
}

std::string wanted_name(const Plan& plan, const Values& values, Id id) {
    const Module& m = plan.module();
    const uint32_t name = plan.first_name[id];
    if (values.anonymous) return name ? m.named[name - 1].name : std::string(word_for(m, id));
    if (name) {
        const Named& named = m.named[name - 1];
        return named.node ? m.nodes[named.node].path + "_" + named.name : named.name;
    }
    if (m[id].op == Op::input_) return change_name(m[id].extra);
    const std::string_view word = plan.is_gradient[id] ? "gradient" : word_for(m, id);
    if (values.state[id].shared) return "surface_" + std::string(word);
    const std::string& path = m.nodes[m.origin[id]].path;
    return (path.empty() ? "" : path + "_") + std::string(word);
}

}  // namespace wrinkle
