// Order of the entries of a merge; private to core/difference.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace wrinkle::difference {

// Returns the identities of `list` that both sets contain, in its order.
template <class T, class Identity>
std::vector<std::string> common_order(const std::vector<T>& list, const std::set<std::string>& one,
                                      const std::set<std::string>& two, Identity identity) {
    std::vector<std::string> ids;
    for (const T& each : list)
        if (one.contains(identity(each)) && two.contains(identity(each)))
            ids.push_back(identity(each));
    return ids;
}

// Returns the elements of `ours` and `theirs`, each once, in the order of `ours`; of `theirs` if
// only that has another order than `base`. An element that only the other list has follows the last
// common one before it. O(n log n).
template <class T, class Identity>
std::vector<T> merged_order(const std::vector<T>& base, const std::vector<T>& ours,
                            const std::vector<T>& theirs, Identity identity) {
    const auto ids_of = [&](const std::vector<T>& list) {
        std::set<std::string> ids;
        for (const T& each : list)
            ids.insert(identity(each));
        return ids;
    };
    const auto in_base = ids_of(base), in_ours = ids_of(ours), in_theirs = ids_of(theirs);
    const auto old_order = common_order(base, in_ours, in_theirs, identity);
    const bool by_theirs = common_order(ours, in_base, in_theirs, identity) == old_order &&
                           common_order(theirs, in_base, in_ours, identity) != old_order;
    const std::vector<T>& first = by_theirs ? theirs : ours;
    const std::vector<T>& second = by_theirs ? ours : theirs;
    const std::set<std::string>& in_first = by_theirs ? in_theirs : in_ours;

    std::vector<T> result;
    std::map<std::string, std::vector<T>> after;
    std::vector<T>* inserted = &result;  // elements before the first common one begin the result
    for (const T& each : second) {
        if (in_first.contains(identity(each)))
            inserted = &after[identity(each)];
        else
            inserted->push_back(each);
    }
    for (const T& each : first) {
        result.push_back(each);
        const auto found = after.find(identity(each));
        if (found == after.end()) continue;
        result.insert(result.end(), found->second.begin(), found->second.end());
    }
    return result;
}

}  // namespace wrinkle::difference
