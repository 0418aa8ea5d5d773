#include "report/results.h"

#include <algorithm>

namespace wrinkle::report {

double Measured::excess() const {
    if (within() && limit == 0) return 0;
    const double ratio = value / limit;  // infinite or NaN for a limit of 0
    return ratio <= max_excess ? ratio : max_excess;
}

double Check::excess() const {
    double largest = 0;
    for (const Measured& each : measured)
        largest = std::max(largest, each.excess());
    return largest;
}

size_t Results::count(Status status) const {
    return static_cast<size_t>(std::ranges::count(checks, status, &Check::status));
}

bool Results::fails(const Check& check) const {
    return check.status != Status::passed && (check.status != Status::added || added_fails);
}

bool Results::fails() const {
    return std::ranges::any_of(checks, [&](const Check& check) { return fails(check); });
}

std::vector<size_t> Results::by_severity() const {
    std::vector<size_t> order;
    for (size_t i = 0; i < checks.size(); ++i)
        if (checks[i].status != Status::passed) order.push_back(i);
    constexpr std::array<int, status_names.size()> ranks = {4, 1, 0, 3, 2, 1};  // by Status
    std::ranges::stable_sort(order, {}, [&](size_t i) {
        return std::pair(ranks[static_cast<size_t>(checks[i].status)], -checks[i].excess());
    });
    return order;
}

}  // namespace wrinkle::report
