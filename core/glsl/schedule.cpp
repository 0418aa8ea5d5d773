// The order of a scope's statements: node by node, in dependency order.
//
// A node whose outside needs are all written is written whole; among several the one that a walk
// from the results meets first. Where nodes need each other's values in turn (equal expressions of
// two nodes are one value), the first statement that can stand is next.
//
// Statements are numbered in the order of that walk, in which each stands after what it needs. So
// within a group the order is that of the numbers, and the first statement that can stand never
// moves back: one that cannot yet waits for a smaller number.
#include <limits>
#include <queue>

#include "glsl/scope.h"

namespace wrinkle {
namespace {

constexpr uint32_t is_written = std::numeric_limits<uint32_t>::max();

struct Group {
    uint32_t outside = 0;  // needs of other groups not yet written
    uint32_t next = 0;     // in `members_`: all before are written
    uint32_t end = 0;
};

// What belongs to each of a row of numbers, one behind the other.
struct Rows {
    std::vector<uint32_t> first, items;

    // `pairs`: row and item.
    void fill(size_t rows, const std::vector<std::pair<uint32_t, uint32_t>>& pairs) {
        first.assign(rows + 1, 0);
        for (const auto& pair : pairs)
            ++first[pair.first + size_t{1}];
        for (size_t row = 0; row < rows; ++row)
            first[row + 1] += first[row];
        std::vector<uint32_t> at(first.begin(), first.end() - 1);
        items.resize(pairs.size());
        for (const auto& [row, item] : pairs)
            items[at[row]++] = item;
    }
    std::span<const uint32_t> of(uint32_t row) const {
        return std::span(items).subspan(first[row], first[row + size_t{1}] - first[row]);
    }
};

class Scheduler {
public:
    Scheduler(const Plan& plan, Values& values, const Scope& scope)
        : plan_(plan), values_(values), scope_(scope) {}
    std::vector<Id> run(std::span<const Id> part);

private:
    void find_groups();
    void find_needs();
    bool can_stand(uint32_t statement) const {
        return needs_[statement] == 0 && values_.state[statements_[statement]].place != is_written;
    }
    uint32_t next_group();
    void write_group(uint32_t group);
    void write_statement(uint32_t statement);

    const Plan& plan_;
    Values& values_;
    const Scope& scope_;
    std::vector<Id> statements_;
    std::vector<uint32_t> group_, needs_;  // by statement
    Rows members_, users_;                 // by group, by statement
    std::vector<Group> groups_;            // by their first statement
    // Groups with nothing missing, the first of them on top.
    std::priority_queue<uint32_t, std::vector<uint32_t>, std::greater<>> whole_;
    uint32_t first_ = 0;  // no statement before it can stand
    std::vector<Id> result_;
};

void Scheduler::find_groups() {
    std::vector<uint32_t>& known = values_.group_numbers;
    std::vector<std::pair<uint32_t, uint32_t>> pairs;
    std::vector<size_t> met;
    for (uint32_t i = 0; i < statements_.size(); ++i) {
        const uint32_t owner = group_of(plan_, values_, statements_[i]);
        const size_t slot = owner == surface_group ? known.size() - 1 : owner;
        if (known[slot] == 0) {
            groups_.push_back({});
            met.push_back(slot);
            known[slot] = static_cast<uint32_t>(groups_.size());
        }
        group_.push_back(known[slot] - 1);
        pairs.push_back({group_.back(), i});
    }
    for (const size_t slot : met)
        known[slot] = 0;
    members_.fill(groups_.size(), pairs);
    for (uint32_t g = 0; g < groups_.size(); ++g) {
        groups_[g].next = members_.first[g];
        groups_[g].end = members_.first[g + size_t{1}];
    }
}

// Through what is folded into a statement to the statements it reads.
void Scheduler::find_needs() {
    std::vector<Id> open;
    std::vector<std::pair<uint32_t, uint32_t>> pairs;
    needs_.resize(statements_.size());
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
                } else if (s.place != is_written) {
                    pairs.push_back({s.place, i});
                    ++needs_[i];
                    if (group_[s.place] != group_[i]) ++groups_[group_[i]].outside;
                }
            }
        }
    }
    users_.fill(statements_.size(), pairs);
}

uint32_t Scheduler::next_group() {
    if (!whole_.empty()) {
        const uint32_t group = whole_.top();
        whole_.pop();
        return group;
    }
    while (!can_stand(first_))
        ++first_;
    return group_[first_];
}

void Scheduler::write_statement(uint32_t statement) {
    values_.state[statements_[statement]].place = is_written;
    result_.push_back(statements_[statement]);
    for (const uint32_t user : users_.of(statement)) {
        Group& group = groups_[group_[user]];
        if (group_[user] != group_[statement] && --group.outside == 0) whole_.push(group_[user]);
        --needs_[user];
    }
}

void Scheduler::write_group(uint32_t index) {
    Group& group = groups_[index];
    bool all = true;
    for (uint32_t at = group.next; at < group.end; ++at) {
        const uint32_t statement = members_.items[at];
        if (can_stand(statement)) write_statement(statement);
        all = all && values_.state[statements_[statement]].place == is_written;
        if (all) group.next = at + 1;
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
    result_.reserve(statements_.size());
    for (uint32_t g = 0; g < groups_.size(); ++g)
        if (groups_[g].outside == 0) whole_.push(g);
    while (result_.size() < statements_.size())
        write_group(next_group());
    return std::move(result_);
}

}  // namespace

std::vector<Id> schedule(const Plan& plan, Values& values, const Scope& scope,
                         std::span<const Id> part) {
    return Scheduler(plan, values, scope).run(part);
}

}  // namespace wrinkle
