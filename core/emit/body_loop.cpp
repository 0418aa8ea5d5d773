// Emits loops: the state as variables, the body, the assignment of the next state.
#include <algorithm>
#include <deque>

#include "emit/body.h"
#include "emit/scope.h"

namespace wrinkle {
namespace {

bool is_parameter(const Module& m, Id id, uint8_t level, uint32_t index) {
    return m[id].op == Op::region_param_ && m[id].level == level && m[id].extra == index;
}

constexpr uint32_t no_member = ~0U;

// Returns the member that is the number of the iteration, which only the body reads; else
// no_member.
uint32_t counter_of(const EmitAnalysis& analysis, Id loop) {
    const Module& m = analysis.module();
    const Region& region = m.region(m[loop].extra);
    for (uint32_t k = 0; k < region.params.size(); ++k) {
        const Inst& next = m[region.results[k + 1]];
        if (region.params[k] == Type::int_ && m.is_literal(m.operands(loop)[k], 0) &&
            next.op == Op::add_ && is_parameter(m, next.arg[0], region.level, k) &&
            m.is_literal(next.arg[1], 1) && analysis.members(loop)[k] == no_id)
            return k;
    }
    return no_member;
}

}  // namespace

void Body::loop(Id id, int indent) {
    const Region& region = m_.region(m_[id].extra);
    const auto initial = m_.operands(id);
    const uint32_t counter = counter_of(analysis_, id);
    std::vector<std::string> texts;
    for (const Id value : initial)
        texts.push_back(text_of(context_, analysis_.strip_detach(value)));
    std::vector<std::string> state = name_members(id);
    const uint32_t node = node_of(group_);
    for (size_t k = 0; k < state.size(); ++k)
        if (k != counter)
            code(indent, declared(language_.variable, region.params[k], state[k], texts[k]), node);
    const std::string i = locals_.unique("i");
    if (counter != no_member) state[counter] = i;
    std::string most = std::to_string(std::min(region.max_iterations, 0x7FFFFFFFu));
    const Id limit = counter == no_member ? no_id : limit_of(region, counter);
    if (limit != no_id) most = "min(" + text_of(context_, limit) + ", " + most + ")";
    code(indent, filled(language_.loop, {{'n', i}, {'v', most}}), node);
    loop_body(id, state, limit != no_id, indent + 1);
    code(indent, "}", node);
}

// Returns n if the loop runs while its counter is less than n; otherwise no_id.
Id Body::limit_of(const Region& region, uint32_t counter) const {
    const Inst& condition = m_[analysis_.strip_detach(region.results[0])];
    const bool counts = condition.op == Op::lt_ &&
                        is_parameter(m_, condition.arg[0], region.level, counter) &&
                        m_[condition.arg[1]].level < region.level;
    return counts ? analysis_.strip_detach(condition.arg[1]) : no_id;
}

// The loop condition reads the current state. Statements that it does not need follow the break.
// `limited`: the condition is in the head of the loop.
void Body::loop_body(Id id, const std::vector<std::string>& state, bool limited, int indent) {
    const Region& region = m_.region(m_[id].extra);
    if (context_.parameters.size() <= region.level) context_.parameters.resize(region.level + 1u);
    context_.parameters[region.level] = state;
    const std::vector<Id> all = analysis_.strip_detach(region.results);
    const auto roots = std::span(all).subspan(limited ? 1 : 0);
    const Scope scope = collect(analysis_, values_, roots, region.level);
    decide(analysis_, values_, scope, roots);
    const std::span<const Id> order(scope.order);
    const size_t first = limited ? 0 : scope.first_part;
    const uint32_t node = node_of(group_of(analysis_, values_, id));
    statements(schedule(analysis_, values_, scope, order.first(first)), indent);
    if (!limited) write_loop_condition(all[0], indent, node);
    statements(schedule(analysis_, values_, scope, order.subspan(first)), indent);
    next_state(id, std::span(all).subspan(1), state, indent);
}

void Body::write_loop_condition(Id condition, int indent, uint32_t node) {
    if (m_.is_literal(condition, 1)) return;
    if (is_folded(condition) && m_[condition].op == Op::not_) {
        const Id inner = analysis_.strip_detach(m_[condition].arg[0]);
        code(indent, filled(language_.leave, {{'v', text_of(context_, inner)}}), node);
        return;
    }
    constexpr int postfix = 17;
    code(indent, filled(language_.leave, {{'v', "!" + text_of(context_, condition, postfix)}}),
         node);
}

// Returns the indices of the state members that a value's text reads.
std::vector<uint32_t> Body::state_read(Id value, uint8_t level) {
    std::vector<uint32_t> result;
    std::vector<Id> open{value};
    while (!open.empty()) {
        const Id id = open.back();
        open.pop_back();
        if (m_[id].op == Op::region_param_ && m_[id].level == level) result.push_back(m_[id].extra);
        if (analysis_.role(id) == Role::value && values_.state[id].statement) continue;
        if (m_[id].op == Op::result_ && analysis_.role(id) == Role::view) continue;
        const auto operands = analysis_.operands(id);
        open.insert(open.end(), operands.begin(), operands.end());
    }
    return result;
}

// Returns "sum += x" for a next state sum + x, otherwise "sum = ...".
std::string Body::assignment(const std::string& name, Id next, uint8_t level, uint32_t member) {
    const Inst& inst = m_[next];
    const bool combines = inst.op == Op::add_ || inst.op == Op::sub_ || inst.op == Op::mul_;
    if (combines && is_folded(next)) {
        const auto operands = analysis_.operands(next);
        const std::string sign = " " + std::string(language_.op(inst.op)) + "= ";
        if (is_parameter(m_, operands[0], level, member))
            return name + sign + text_of(context_, operands[1]);
        if (is_parameter(m_, operands[1], level, member) && inst.op != Op::sub_)
            return name + sign + text_of(context_, operands[0]);
    }
    return name + " = " + text_of(context_, next);
}

// Assigns all members simultaneously: each after those that read it. If they read each other, the
// next value of one is stored in a temporary first.
void Body::next_state(Id loop, std::span<const Id> next, const std::vector<std::string>& state,
                      int indent) {
    struct Pending {
        uint32_t member;
        std::vector<uint32_t> reads;
        std::string text;
    };
    const uint8_t level = m_.region(m_[loop].extra).level;
    const uint32_t node = node_of(group_of(analysis_, values_, loop));
    const uint32_t counter = counter_of(analysis_, loop);
    std::deque<Pending> pending;
    for (uint32_t k = 0; k < state.size(); ++k)
        if (k != counter && !is_parameter(m_, next[k], level, k))
            pending.push_back(
                {k, state_read(next[k], level), assignment(state[k], next[k], level, k)});
    while (!pending.empty()) {
        const auto is_free = [&](const Pending& one) {
            return std::ranges::none_of(pending, [&](const Pending& other) {
                return other.member != one.member &&
                       std::ranges::find(other.reads, one.member) != other.reads.end();
            });
        };
        const auto free = std::ranges::find_if(pending, is_free);
        if (free != pending.end()) {
            code(indent, free->text + ";", node);
            pending.erase(free);
            continue;
        }
        Pending first = std::move(pending.front());
        pending.pop_front();
        const std::string name = locals_.unique(state[first.member] + "_next");
        code(indent,
             declared(language_.constant, m_.type(next[first.member]), name,
                      text_of(context_, next[first.member])),
             node);
        pending.push_back({first.member, {}, state[first.member] + " = " + name});
    }
}

}  // namespace wrinkle
