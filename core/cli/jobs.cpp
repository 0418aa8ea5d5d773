#include "cli/jobs.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace wrinkle::cli {

size_t thread_count(unsigned wanted, size_t items) {
    const unsigned threads = wanted ? wanted : std::max(1u, std::thread::hardware_concurrency());
    return std::clamp<size_t>(threads, 1, std::max<size_t>(items, 1));
}

void for_each_item(size_t items, size_t threads, const std::function<void(size_t)>& use) {
    std::atomic<size_t> next{0};
    const auto work = [&] {
        for (size_t i = next++; i < items; i = next++)
            use(i);
    };
    std::vector<std::future<void>> helpers(threads - 1);
    for (std::future<void>& helper : helpers)
        helper = std::async(std::launch::async, work);
    work();
    for (std::future<void>& helper : helpers)
        helper.get();
}

}  // namespace wrinkle::cli
