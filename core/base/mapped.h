// A list made from another, element by element: std::ranges::to of C++23.
#pragma once

#include <functional>
#include <vector>

namespace wrinkle {

// Returns of(each) for the elements of the list; `of` is a function or a pointer to a member.
template <class T, class List, class Of>
std::vector<T> mapped(const List& list, Of of) {
    std::vector<T> result;
    for (const auto& each : list)
        result.emplace_back(std::invoke(of, each));
    return result;
}

}  // namespace wrinkle
