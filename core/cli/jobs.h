// Independent work on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace wrinkle::cli {

// Number of threads: `wanted`, or one per processor if it is 0; at most one per item, at least 1.
size_t thread_count(unsigned wanted, size_t items);

// Calls use(i) for each i < items, on this thread and `threads` - 1 others. Returns after all have
// ended, or rethrows one exception of `use`. Precondition: threads >= 1.
void for_each_item(size_t items, size_t threads, const std::function<void(size_t)>& use);

}  // namespace wrinkle::cli
