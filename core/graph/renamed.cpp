#include "graph/renamed.h"

#include <algorithm>
#include <set>

namespace wrinkle {
namespace {

// Replaces former names; `name` is the member of an entry that holds it. Returns true if there was
// a change.
template <class Entry>
bool replace_names(std::vector<Entry>& entries, std::string Entry::*name,
                   const FormerNames& names) {
    const auto is_former = [&](const Entry& entry) { return !names.current(entry.*name).empty(); };
    if (std::ranges::none_of(entries, is_former)) return false;
    std::set<std::string> taken;
    for (const Entry& entry : entries)
        taken.insert(entry.*name);
    bool changed = false;
    for (Entry& entry : entries) {
        const std::string current(names.current(entry.*name));
        if (current.empty() || !taken.insert(current).second) continue;
        entry.*name = current;
        changed = true;
    }
    return changed;
}

}  // namespace

FormerNames::FormerNames(Table<GraphInput> inputs) : inputs_(std::move(inputs)) {
    for (const GraphInput& input : inputs_)
        for (const json::Member& former : input.renamed.children())
            if (!inputs_.find(former.value.as_string()))
                current_.emplace(former.value.as_string(), input.name);
}

std::string_view FormerNames::current(std::string_view name) const {
    const auto found = current_.find(name);
    return found == current_.end() ? std::string_view() : found->second;
}

Preset with_current_names(Preset preset, const FormerNames& names) {
    replace_names(preset.values, &Extra::key, names);
    return preset;
}

NodePtr with_current_names(const NodePtr& node, const FormerNames& names) {
    if (names.empty()) return node;
    std::vector<Input> inputs = node->inputs;
    if (!replace_names(inputs, &Input::port, names)) return node;
    Node copy = *node;
    copy.inputs = std::move(inputs);
    return std::make_shared<const Node>(std::move(copy));
}

}  // namespace wrinkle
