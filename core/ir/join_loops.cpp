#include <algorithm>
#include <optional>
#include <set>

#include "ir/compact.h"
#include "ir/scopes.h"

namespace wrinkle {
namespace {

// A loop of the scope and its members, by index in the state.
struct Loop {
    Id tuple = no_id;
    std::set<uint32_t> used;                // members that are read after the loop
    std::vector<std::set<uint32_t>> reads;  // that the condition and each next state read
};

// Loops that advance together. The derivative of a loop has the members of that loop and then its
// own (ir/derive.h): the first `shared` members are the same in all of them.
struct Group {
    std::vector<const Loop*> loops;
    uint32_t shared = 0;
};

struct Member {
    const Loop* loop;
    uint32_t index;
    auto operator<=>(const Member&) const = default;
};

// The state of the joined loop; several floats are the components of one vector.
using State = std::vector<std::vector<Member>>;

class LoopJoiner {
public:
    LoopJoiner(Module& m, std::span<const Id> roots) : m_(m), roots_(roots) { find_loops(); }

    // Returns the roots with joined loops; nothing if no loop changes.
    std::optional<std::vector<Id>> run() {
        ModuleCloner cloner(m_, m_, false);
        bool changes = false;
        std::set<const Loop*> done;
        for (const Loop& loop : loops_) {
            if (done.contains(&loop)) continue;
            const Group group = group_of(loop);
            done.insert(group.loops.begin(), group.loops.end());
            const State state = state_of(group);
            if (group.loops.size() == 1 && state.size() == region(loop).params.size()) continue;
            join(group, state, cloner);
            changes = true;
        }
        if (!changes) return std::nullopt;
        return ScopeRewriter(m_).rewritten(roots_, cloner);
    }

private:
    const Region& region(const Loop& loop) const { return m_.region(m_[loop.tuple].extra); }
    Type type_of(const Member& member) const { return region(*member.loop).params[member.index]; }

    void find_loops() {
        const std::vector<Id> values = values_in_scope(m_, roots_);
        for (const Id id : values) {
            if (m_[id].op != Op::loop_) continue;
            Loop& loop = loops_.emplace_back(Loop{id, {}, {}});
            for (const Id result : region(loop).results)
                loop.reads.push_back(members_read(result, region(loop).level));
        }
        for (const Id id : values) {
            if (m_[id].op != Op::result_) continue;
            const auto loop = std::ranges::find(loops_, m_[id].arg[0], &Loop::tuple);
            if (loop != loops_.end()) loop->used.insert(m_[id].extra);
        }
    }

    std::set<uint32_t> members_read(Id value, uint8_t level) const {
        std::set<uint32_t> members;
        for (const Id id : values_in_scope(m_, {&value, 1}, level))
            if (m_[id].op == Op::region_param_ && m_[id].level == level)
                members.insert(m_[id].extra);
        return members;
    }

    Group group_of(const Loop& first) const {
        Group group{{&first}, static_cast<uint32_t>(region(first).params.size())};
        for (const Loop& loop : std::span(&first + 1, loops_.data() + loops_.size())) {
            const uint32_t shared = std::min(group.shared, shared_members(first, loop));
            if (shared == 0 || depends_on_any(loop, group)) continue;
            group.loops.push_back(&loop);
            group.shared = shared;
        }
        return group;
    }

    // Returns how many first members have the same start and the same next state in both loops.
    uint32_t shared_members(const Loop& a, const Loop& b) const {
        const Region &of_a = region(a), &of_b = region(b);
        if (of_a.level != of_b.level || of_a.max_iterations != of_b.max_iterations ||
            of_a.results[0] != of_b.results[0])
            return 0;
        const auto start_a = m_.operands(a.tuple), start_b = m_.operands(b.tuple);
        uint32_t count = 0;
        while (count < std::min(start_a.size(), start_b.size()) &&
               start_a[count] == start_b[count] &&
               of_a.results[count + 1] == of_b.results[count + 1])
            ++count;
        const auto inside = [&](const std::set<uint32_t>& reads) {
            return reads.empty() || *reads.rbegin() < count;
        };
        return std::all_of(a.reads.begin(), a.reads.begin() + count + 1, inside) ? count : 0;
    }

    // Precondition: the loop is after those of the group, in id order.
    bool depends_on_any(const Loop& loop, const Group& group) const {
        bool found = false;
        walk({&loop.tuple, 1}, [&](Id id, std::vector<Id>& open) {
            for (const Loop* other : group.loops)
                found = found || id == other->tuple;
            if (id > group.loops[0]->tuple && !found) append_dependencies(m_, id, false, open);
        });
        return found;
    }

    static Member canonical(const Group& group, const Loop* loop, uint32_t index) {
        return {index < group.shared ? group.loops[0] : loop, index};
    }

    std::set<Member> needed_members(const Group& group) const {
        std::set<Member> needed;
        std::vector<Member> open;
        const auto need = [&](const Loop* loop, const std::set<uint32_t>& members) {
            for (const uint32_t k : members)
                open.push_back(canonical(group, loop, k));
        };
        need(group.loops[0], group.loops[0]->reads[0]);
        for (const Loop* loop : group.loops)
            need(loop, loop->used);
        while (!open.empty()) {
            const Member member = open.back();
            open.pop_back();
            if (needed.insert(member).second)
                need(member.loop, member.loop->reads[member.index + 1]);
        }
        return needed;
    }

    // Floats at the same index of different loops are the derivatives of one member along several
    // directions: they become a vector.
    State state_of(const Group& group) const {
        State state;
        std::set<Member> open = needed_members(group);
        const auto take = [&](const Loop* loop, uint32_t k) {
            return k < region(*loop).params.size() && open.erase({loop, k}) > 0;
        };
        for (const Loop* loop : group.loops) {
            for (uint32_t k = 0; k < region(*loop).params.size(); ++k) {
                if (!take(loop, k)) continue;
                std::vector<Member>& members = state.emplace_back(std::vector{Member{loop, k}});
                if (k < group.shared || type_of(members[0]) != Type::float_) continue;
                for (const Loop* other : group.loops)
                    if (members.size() < 4 && other->reads.size() == loop->reads.size() &&
                        region(*other).params.size() > k &&
                        region(*other).params[k] == Type::float_ && take(other, k))
                        members.push_back({other, k});
            }
        }
        return state;
    }

    // Returns the value, or the vector of the values, that `value_of` gives for the members.
    template <class ValueOf>
    Id combined(const std::vector<Member>& members, ValueOf value_of) {
        std::vector<Id> values;
        for (const Member& member : members)
            values.push_back(value_of(member));
        if (values.size() == 1) return values[0];
        return m_.add(Op::construct_, values, 0, vector_of(static_cast<int>(values.size())));
    }

    // Calls visit(loop, index of the member in it, value) for each member of the joined state, of
    // which value_at() returns the values.
    template <class ValueAt, class Visit>
    void for_each_member(const Group& group, const State& state, ValueAt value_at, Visit visit) {
        for (uint32_t at = 0; at < state.size(); ++at) {
            for (uint32_t lane = 0; lane < state[at].size(); ++lane) {
                const auto [of, index] = state[at][lane];
                const Id whole = value_at(at);
                const Id value = state[at].size() == 1 ? whole : m_.component(whole, lane);
                for (const Loop* loop : group.loops)
                    if (loop == of || index < group.shared) visit(loop, index, value);
            }
        }
    }

    // Writes the joined loop and maps the results of the old loops to its results.
    void join(const Group& group, const State& state, ModuleCloner& cloner) {
        Region joined = region(*group.loops[0]);
        const Id condition = joined.results[0];
        std::vector<Id> start;
        joined.params.clear();
        joined.param_names.clear();
        for (const auto& members : state) {
            start.push_back(combined(members, [&](const Member& member) {
                return m_.operands(member.loop->tuple)[member.index];
            }));
            joined.params.push_back(m_.type(start.back()));
            const std::vector<std::string>& names = region(*members[0].loop).param_names;
            if (!names.empty()) joined.param_names.push_back(names[members[0].index]);
        }
        std::map<const Loop*, ModuleCloner> bodies;
        for (const Loop* loop : group.loops) {
            ModuleCloner& body = bodies.try_emplace(loop, m_, m_, false).first->second;
            // A captured loop has parameters of the same level, which are other ones.
            for (const Id captured : region_body(m_, region(*loop)).captured)
                body.map(captured, captured);
        }
        const auto parameter = [&](uint32_t at) {
            return m_.region_parameter(joined.level, at, joined.params[at]);
        };
        for_each_member(group, state, parameter, [&](const Loop* loop, uint32_t k, Id value) {
            bodies.at(loop).map(m_.region_parameter(joined.level, k, type_of({loop, k})), value);
        });
        const auto next = [&](const Loop* loop, Id value) {
            bodies.at(loop).run({&value, 1});
            return bodies.at(loop)[value];
        };
        joined.results = {next(group.loops[0], condition)};
        for (const auto& members : state)
            joined.results.push_back(combined(members, [&](const Member& member) {
                return next(member.loop, region(*member.loop).results[member.index + 1]);
            }));
        const Id tuple = m_.apply_region(m_.intern_region(std::move(joined)), start);
        const auto result = [&](uint32_t at) { return m_.result(tuple, at); };
        for_each_member(group, state, result, [&](const Loop* loop, uint32_t k, Id value) {
            if (loop->used.contains(k)) cloner.map(m_.result(loop->tuple, k), value);
        });
    }

    Module& m_;
    const std::span<const Id> roots_;
    std::vector<Loop> loops_;
};

}  // namespace

std::vector<Id> join_loops(Module& module, std::vector<Id> roots) {
    while (auto joined = LoopJoiner(module, roots).run())
        roots = std::move(*joined);
    return roots;
}

}  // namespace wrinkle
