// Measures the throughput of a function.
#pragma once

#include <time.h>

#include <algorithm>
#include <vector>

#include "bench/texels/job.h"

namespace wrinkle::bench {

inline double seconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Returns medians over `rounds`. On a shared machine, processor time varies less than wall time.
template <class Work>
Rate measure(int rounds, int threads, Work work) {
    std::vector<double> wall, processor;
    for (int k = 0; k < rounds; ++k) {
        const double wall_start = seconds(CLOCK_MONOTONIC);
        const double start = seconds(CLOCK_PROCESS_CPUTIME_ID);
        work();
        processor.push_back(seconds(CLOCK_PROCESS_CPUTIME_ID) - start);
        wall.push_back(seconds(CLOCK_MONOTONIC) - wall_start);
    }
    std::sort(wall.begin(), wall.end());
    std::sort(processor.begin(), processor.end());
    const double mega = 1e-6 * static_cast<double>(texel_count);
    const auto middle = static_cast<size_t>(rounds / 2);
    return {mega / wall[middle], mega * threads / processor[middle]};
}

}  // namespace wrinkle::bench
