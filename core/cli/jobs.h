// Independent work on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace wrinkle::cli {

// Number of threads: `wanted`, or one per processor if it is 0; at most one per item, at least 1.
size_t thread_count(unsigned wanted, size_t items);

// Calls use(i) for each i < items, on this thread and helpers. Rethrows an exception of `use`.
void for_each_item(size_t items, size_t threads, const std::function<void(size_t)>& use);

}  // namespace wrinkle::cli
