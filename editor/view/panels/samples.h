// Sample graphs that are installed with the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wrinkle::editor {

struct Sample {
    std::filesystem::path file;
    std::filesystem::path picture;  // small image of its result; may not exist
    std::string name;               // name of the graph; if it has none, of the file
    size_t nodes = 0;
};

// Returns the folder of the samples: ../share/wrinkle/graphs relative to the program's folder, or
// graphs in the source tree that it was built in; "" if neither exists.
std::filesystem::path samples_folder();
// Returns the samples sorted by name; skips graphs that cannot be read.
std::vector<Sample> list_samples(const std::filesystem::path& folder);

}  // namespace wrinkle::editor
