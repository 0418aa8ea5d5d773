// Orders a scope's statements by list scheduling, grouped by node.
//
// A group is ready when all operands from other groups are written; it is then written completely.
// Among ready groups, the first in post-order from the results is next. If groups depend on each
// other (equal expressions of two nodes are one value), the first ready statement selects the next
// group, and all its ready statements are written.
//
// Statements are numbered in that post-order, operands first. Within a group they are written in
// the order of their numbers. The number of the first ready statement never decreases: a statement
// that is not ready waits for one with a smaller number.
#include <limits>
#include <queue>

#include "emit/scope.h"

namespace wrinkle {
namespace {

constexpr uint32_t is_written = std::numeric_limits<uint32_t>::max();
constexpr uint32_t none = std::numeric_limits<uint32_t>::max();

// Statements of a group and users of a statement form linked lists by index.
struct Statement {
    Id id;
    uint32_t group = 0;
    uint32_t next = none;   // next statement of the group
    uint32_t needs = 0;     // operands not yet written
    uint32_t users = none;  // head of its list in `users_`
};

struct User {
    uint32_t statement;
    uint32_t next;
};

struct Group {
    uint32_t first;  // all statements of the group before it are written
    uint32_t last;
    uint32_t outside = 0;  // operands in other groups not yet written
};

class Scheduler {
public:
    Scheduler(const EmitAnalysis& analysis, Values& values, const Scope& scope)
        : analysis_(analysis), values_(values), scope_(scope) {}
    std::vector<Id> run(std::span<const Id> part);

private:
    void find_statements(std::span<const Id> part);
    void find_groups();
    void find_needs(uint32_t statement);
    bool written(const Statement& s) const { return values_.state[s.id].place == is_written; }
    bool is_ready(const Statement& s) const { return s.needs == 0 && !written(s); }
    uint32_t next_group();
    void write_group(Group& group);
    void write_statement(Statement& statement);

    const EmitAnalysis& analysis_;
    Values& values_;
    const Scope& scope_;
    std::vector<Statement> statements_;
    std::vector<User> users_;
    std::vector<Group> groups_;  // in the order of their first statements
    std::vector<Id> open_;
    // Ready groups, the first on top.
    std::priority_queue<uint32_t, std::vector<uint32_t>, std::greater<>> whole_;
    uint32_t first_ = 0;  // no statement before it is ready
    std::vector<Id> result_;
};

void Scheduler::find_statements(std::span<const Id> part) {
    statements_.reserve(part.size() / 2);
    for (const Id id : part) {
        ValueState& state = values_.state[id];
        if (!state.statement) continue;
        state.place = static_cast<uint32_t>(statements_.size());
        statements_.push_back({id});
    }
}

void Scheduler::find_groups() {
    std::vector<uint32_t>& known = values_.group_numbers;
    groups_.reserve(statements_.size() / 2);
    users_.reserve(2 * statements_.size());
    const auto slot_of = [&](const Statement& statement) {
        const uint32_t owner = group_of(analysis_, values_, statement.id);
        return owner == surface_group ? known.size() - 1 : owner;
    };
    for (uint32_t i = 0; i < statements_.size(); ++i) {
        uint32_t& number = known[slot_of(statements_[i])];
        if (number == 0) {
            groups_.push_back({i, i});
            number = static_cast<uint32_t>(groups_.size());
        }
        statements_[i].group = number - 1;
        uint32_t& last = groups_[number - 1].last;
        if (last != i) statements_[last].next = i;
        last = i;
    }
    for (const Group& group : groups_)
        known[slot_of(statements_[group.first])] = 0;
}

// Walks the values folded into a statement and records the statements that it reads.
void Scheduler::find_needs(uint32_t statement) {
    Statement& own = statements_[statement];
    open_.push_back(own.id);
    while (!open_.empty()) {
        const Id reader = open_.back();
        open_.pop_back();
        for (const Id operand : analysis_.operands(reader)) {
            const ValueState& s = values_.state[operand];
            if (s.epoch != scope_.epoch) continue;
            if (!s.statement) {
                open_.push_back(operand);
            } else if (s.place != is_written) {
                Statement& read = statements_[s.place];
                users_.push_back({statement, read.users});
                read.users = static_cast<uint32_t>(users_.size() - 1);
                ++own.needs;
                if (read.group != own.group) ++groups_[own.group].outside;
            }
        }
    }
}

uint32_t Scheduler::next_group() {
    if (!whole_.empty()) {
        const uint32_t group = whole_.top();
        whole_.pop();
        return group;
    }
    while (!is_ready(statements_[first_]))
        ++first_;
    return statements_[first_].group;
}

void Scheduler::write_statement(Statement& statement) {
    values_.state[statement.id].place = is_written;
    result_.push_back(statement.id);
    for (uint32_t u = statement.users; u != none; u = users_[u].next) {
        Statement& user = statements_[users_[u].statement];
        --user.needs;
        if (user.group != statement.group && --groups_[user.group].outside == 0)
            whole_.push(user.group);
    }
}

void Scheduler::write_group(Group& group) {
    bool all = true;
    for (uint32_t at = group.first; at != none; at = statements_[at].next) {
        Statement& statement = statements_[at];
        if (is_ready(statement)) write_statement(statement);
        all = all && written(statement);
        if (all) group.first = statement.next;
    }
}

std::vector<Id> Scheduler::run(std::span<const Id> part) {
    find_statements(part);
    find_groups();
    for (uint32_t i = 0; i < statements_.size(); ++i)
        find_needs(i);
    result_.reserve(statements_.size());
    for (uint32_t g = 0; g < groups_.size(); ++g)
        if (groups_[g].outside == 0) whole_.push(g);
    while (result_.size() < statements_.size())
        write_group(groups_[next_group()]);
    return std::move(result_);
}

}  // namespace

std::vector<Id> schedule(const EmitAnalysis& analysis, Values& values, const Scope& scope,
                         std::span<const Id> part) {
    return Scheduler(analysis, values, scope).run(part);
}

}  // namespace wrinkle
