// The sample graphs that come with the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wrinkle::editor {

struct Sample {
    std::filesystem::path file;
    std::filesystem::path picture;  // a small one of it; may not exist
    std::string name;               // as the graph says, else the file's
    size_t nodes = 0;
};

// Where they are: beside the installed program (share/wrinkle/graphs), or in the tree that it was
// built in; "" when nowhere.
std::filesystem::path samples_folder();
// By name; graphs that cannot be read are left out.
std::vector<Sample> list_samples(const std::filesystem::path& folder);

}  // namespace wrinkle::editor
