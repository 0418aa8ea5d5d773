// Runs the program `wrinkle` for comparison with the library, and builds graphs for both.
#pragma once

#include <gtest/gtest.h>
#include <wrinkle/wrinkle.hpp>

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

// The arguments must not need shell quoting.
Said run_wrinkle(const std::vector<std::string>& words);

// Does not load the plugins of the user who runs the tests.
const api::Library& library();

// A surface tilted along x by `slope`; its normal is normalize(-slope, 0, 1) at every point.
std::string tilt_graph(const std::string& slope = "0.75");

bool says(const api::Problems& problems, const std::string& words);

}  // namespace wrinkle::test
