// WebGL 2 in a headless Chromium, in software: one page that links and draws everything it is given
// and leaves the results in its text.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "glsl/emit.h"

namespace wrinkle::test {

struct BrowserJob {
    std::string name;              // without white space
    std::string vertex, fragment;  // linked, and drawn where `draw` says so
    bool draw = false;
    std::vector<SamplerInfo> samplers;  // all of them read the picture of webgl/pass.h
};

struct BrowserResult {
    std::string log;              // why it was not linked; "" when it was
    std::vector<uint8_t> pixels;  // rgba, rows from the bottom, of what was drawn
};

// By name. `why` says what is wrong with the browser itself.
std::map<std::string, BrowserResult> run_in_browser(const std::vector<BrowserJob>& jobs,
                                                    const std::filesystem::path& folder,
                                                    std::string& why);

}  // namespace wrinkle::test
