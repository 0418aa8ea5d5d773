// Godot 3 under Xvfb: one project draws all jobs in a viewport and writes their pixels.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "emit/emit.h"

namespace wrinkle::test {

struct GodotJob {
    std::string name;                   // without white space
    std::string shader;                 // for a canvas item
    std::vector<SamplerInfo> samplers;  // all of them read the image of hosts/pass.h
};

// Pixels by name: rgba, rows in the order of the sheet; none for a shader that Godot rejects. `log`
// receives Godot's output.
std::map<std::string, std::vector<uint8_t>> run_in_godot(const std::vector<GodotJob>& jobs,
                                                         const std::filesystem::path& folder,
                                                         std::string& log);

}  // namespace wrinkle::test
