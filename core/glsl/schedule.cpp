// The order of a scope's statements: node by node, in dependency order.
//
// A node whose outside needs are all written is written whole; among several the one that a walk
// from the results meets first. Where nodes need each other's values in turn (equal expressions of
// two nodes are one value), the first statement that can stand is next.
#include <limits>
#include <queue>
#include <set>
#include <unordered_map>

#include "glsl/scope.h"

namespace wrinkle {
namespace {

constexpr uint32_t written = std::numeric_limits<uint32_t>::max();

using Ready = std::priority_queue<uint32_t, std::vector<uint32_t>, std::greater<>>;

struct Group {
    uint32_t first = 0;    // its first statement
    uint32_t outside = 0;  // needs of other groups not yet written
    uint32_t left = 0;     // statements
    Ready ready;
};

class Scheduler {
public:
    Scheduler(const Plan& plan, Values& values, const Scope& scope)
        : plan_(plan), values_(values), scope_(scope) {}
    std::vector<Id> run(std::span<const Id> part);

private:
    void find_groups();
    void find_needs();
    uint32_t next_group();
    void write(uint32_t statement);

    const Plan& plan_;
    Values& values_;
    const Scope& scope_;
    std::vector<Id> statements_;
    std::vector<uint32_t> group_, needs_;  // by statement
    std::vector<std::vector<uint32_t>> users_;
    std::vector<Group> groups_;
    std::set<std::pair<uint32_t, uint32_t>> whole_;  // first statement, group: nothing missing
    Ready ready_;
    std::vector<Id> result_;
};

void Scheduler::find_groups() {
    std::unordered_map<uint32_t, uint32_t> known;
    for (uint32_t i = 0; i < statements_.size(); ++i) {
        const auto [entry, added] = known.try_emplace(group_of(plan_, values_, statements_[i]),
                                                      static_cast<uint32_t>(groups_.size()));
        if (added) groups_.push_back({.first = i, .ready = {}});
        group_.push_back(entry->second);
        ++groups_[entry->second].left;
    }
}

// Through what is folded into a statement to the statements it reads.
void Scheduler::find_needs() {
    std::vector<Id> open;
    needs_.resize(statements_.size());
    users_.resize(statements_.size());
    for (uint32_t i = 0; i < statements_.size(); ++i) {
        open.assign(1, statements_[i]);
        while (!open.empty()) {
            const Id reader = open.back();
            open.pop_back();
            for (const Id operand : plan_.operands(reader)) {
                const ValueState& s = values_.state[operand];
                if (plan_.role(operand) == Role::leaf || s.epoch != scope_.epoch) continue;
                if (!s.statement) {
                    open.push_back(operand);
                } else if (s.place != written) {
                    users_[s.place].push_back(i);
                    ++needs_[i];
                    if (group_[s.place] != group_[i]) ++groups_[group_[i]].outside;
                }
            }
        }
    }
}

uint32_t Scheduler::next_group() {
    if (!whole_.empty()) {
        const uint32_t group = whole_.begin()->second;
        whole_.erase(whole_.begin());
        return group;
    }
    while (values_.state[statements_[ready_.top()]].place == written)
        ready_.pop();
    return group_[ready_.top()];
}

void Scheduler::write(uint32_t statement) {
    values_.state[statements_[statement]].place = written;
    result_.push_back(statements_[statement]);
    --groups_[group_[statement]].left;
    for (const uint32_t user : users_[statement]) {
        Group& group = groups_[group_[user]];
        if (group_[user] != group_[statement] && --group.outside == 0 && group.left > 0)
            whole_.insert({group.first, group_[user]});
        if (--needs_[user] > 0) continue;
        group.ready.push(user);
        ready_.push(user);
    }
}

std::vector<Id> Scheduler::run(std::span<const Id> part) {
    for (const Id id : part) {
        if (!values_.state[id].statement) continue;
        values_.state[id].place = static_cast<uint32_t>(statements_.size());
        statements_.push_back(id);
    }
    find_groups();
    find_needs();
    for (uint32_t i = 0; i < statements_.size(); ++i) {
        if (needs_[i] > 0) continue;
        groups_[group_[i]].ready.push(i);
        ready_.push(i);
    }
    for (uint32_t g = 0; g < groups_.size(); ++g)
        if (groups_[g].outside == 0) whole_.insert({groups_[g].first, g});
    while (result_.size() < statements_.size()) {
        Group& group = groups_[next_group()];
        while (!group.ready.empty()) {
            const uint32_t statement = group.ready.top();
            group.ready.pop();
            write(statement);
        }
    }
    return std::move(result_);
}

}  // namespace

std::vector<Id> schedule(const Plan& plan, Values& values, const Scope& scope,
                         std::span<const Id> part) {
    return Scheduler(plan, values, scope).run(part);
}

}  // namespace wrinkle
