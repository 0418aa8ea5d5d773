// Sample graphs of the project.
#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

namespace wrinkle::test {

// Returns every graph below graphs/, sorted by path.
inline std::vector<std::filesystem::path> sample_graphs() {
    std::vector<std::filesystem::path> graphs;
    const std::filesystem::path folder = WRINKLE_SOURCE_DIR "/graphs";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().filename();
        if (name.ends_with(".json") && !name.ends_with(".test.json") &&
            !name.ends_with(".preset.json"))
            graphs.push_back(entry.path());
    }
    std::sort(graphs.begin(), graphs.end());
    return graphs;
}

}  // namespace wrinkle::test
