// The program `wrinkle`, to be set beside the library, and graphs for both.
#pragma once

#include <gtest/gtest.h>
#include <wrinkle/wrinkle.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/files.h"

namespace wrinkle::test {

namespace fs = std::filesystem;

struct Said {
    int code = -1;
    std::string out, err;
};

// With words that need no quoting.
Said run_wrinkle(const std::vector<std::string>& words);

// Without the plugins of whoever runs the tests.
const api::Library& library();

// A surface tilted along x by `slope`; its normal is (-slope, 0, 1) made unit, whatever the point.
std::string tilt_graph(const std::string& slope = "0.75");

bool says(const api::Problems& problems, const std::string& words);

}  // namespace wrinkle::test
