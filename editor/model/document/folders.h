// Folders of files that belong to no graph: $XDG_CONFIG_HOME/wrinkle (settings),
// $XDG_STATE_HOME/wrinkle (recovery files) and $XDG_DATA_HOME/wrinkle/library (document/library.h),
// by the XDG Base Directory Specification.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace wrinkle::editor {

struct Folders {
    std::filesystem::path config, state, library;  // all empty: nothing is stored
};

// Reads the environment; all folders are empty if it names no home.
Folders user_folders();
// Returns folders below a given one, for scripts and tests.
Folders folders_below(const std::filesystem::path& folder);

// Expands "~" and "~/x" to the home folder; returns other paths unchanged.
std::filesystem::path with_home(const std::filesystem::path& typed);

// Paths that are made for a result; the destructor removes them unless keep() is called.
class NewPaths {
public:
    NewPaths() = default;
    NewPaths(const NewPaths&) = delete;
    NewPaths& operator=(const NewPaths&) = delete;
    ~NewPaths();
    void add(const std::filesystem::path& path) { paths_.push_back(path); }
    void add_missing(std::filesystem::path folder);  // this folder and those above it
    void keep() { paths_.clear(); }

private:
    std::vector<std::filesystem::path> paths_;  // a folder before its contents
};

// Returns the reason why a file could not be written, as the end of a sentence: "the disk is full".
std::string disk_words(const std::error_code& error);
// Same for a message of the core that ends with the system's error message.
std::string disk_words(std::string_view why);

}  // namespace wrinkle::editor
