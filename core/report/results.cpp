#include "report/results.h"

#include <algorithm>

namespace wrinkle::report {

size_t Results::count(Status status) const {
    return static_cast<size_t>(std::ranges::count(checks, status, &Check::status));
}

}  // namespace wrinkle::report
