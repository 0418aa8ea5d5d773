// WebGL 2 and WebGPU in a headless Chromium, with software rendering: one page compiles and draws
// all jobs and posts the results to a local server.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "emit/emit.h"

namespace wrinkle::test {

struct BrowserJob {
    std::string name;              // without white space
    std::string vertex, fragment;  // linked, and drawn if `draw` is set
    bool draw = false;
    std::vector<SamplerInfo> samplers;  // all of them read the image of hosts/pass.h
    bool webgpu = false;                // WGSL; a drawn job is one module, in `fragment`
    int block = -1;                     // WGSL: binding of the block of numbers, which are zero
};

struct BrowserResult {
    std::string log;              // the link error; "" on success
    std::vector<uint8_t> pixels;  // rgba, rows from the bottom, of the drawn image
};

// Results by name. `why` receives an error of the browser itself.
std::map<std::string, BrowserResult> run_in_browser(const std::vector<BrowserJob>& jobs,
                                                    const std::filesystem::path& folder,
                                                    std::string& why);

}  // namespace wrinkle::test
