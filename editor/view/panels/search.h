// Match rank of a name for a query, with the matching letters. Case-insensitive.
//
//   0  the entire title or id         4  the beginning of another word of the id
//   1  the beginning of the title     5  within the title
//   2  the beginning of the id        6  within the id
//   3  the beginning of another       7  letters of the title, in order
//      word of the title, or of       8  the beginning of a word of the doc line
//      a name in another program
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/case.h"

namespace wrinkle::editor {

struct Match {
    int rank = 0;
    std::vector<size_t> letters;  // bytes of the title, ascending
};

// Precondition: `query` is in lower case. Returns std::nullopt if it does not match; an empty query
// matches everything at rank 0. The doc line is searched only for queries of three bytes or more.
std::optional<Match> match(std::string_view title, std::string_view id, std::string_view doc,
                           std::string_view query);

// The name of a node type in another program.
struct OtherName {
    std::string_view type, name;
};
std::span<const OtherName> other_names();

// Returns the first other name of the type with a word that begins with the query; "" if there is
// none, or if the query has fewer than three bytes. Precondition: as of match().
std::string_view other_name(std::string_view type, std::string_view query);
inline constexpr int rank_of_other_name = 3;

// Returns the values in ascending order of their keys; equal keys stay in order.
template <class Key, class Value>
std::vector<Value> best_first(std::vector<std::pair<Key, Value>> found) {
    std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Value> values;
    for (auto& [key, value] : found)
        values.push_back(std::move(value));
    return values;
}

// Returns the indices of the elements with names, `name` of the element, that match, best first.
template <class List, class Name>
std::vector<size_t> find_matches(const List& list, Name name, std::string_view query) {
    const std::string wanted = lower_case(query);
    std::vector<std::pair<int, size_t>> found;
    for (size_t i = 0; i < list.size(); ++i)
        if (const auto matched = match(std::invoke(name, list[i]), "", "", wanted))
            found.emplace_back(matched->rank, i);
    return best_first(std::move(found));
}

}  // namespace wrinkle::editor
