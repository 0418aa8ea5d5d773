// Contents of a folder for the file browser.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::editor {

struct Entry {
    std::string name;
    bool folder = false;
};

struct Listing {
    static constexpr size_t max_entries = 100'000;

    std::vector<Entry> entries;  // folders first, then files, each in name_before() order
    std::string error_text;      // why the list is empty or incomplete
};

// Lists folders and the files with one of the extensions (".png", lower case; empty: all files).
// Names that begin with a dot are skipped.
Listing list_folder(const std::filesystem::path& folder, std::span<const std::string> extensions);

// Returns the indices of the entries with names that match the query, best first; all for "".
std::vector<size_t> filtered(const Listing& listing, std::string_view query);

// Natural order (strverscmp), case-insensitive: "wood2" before "wood10".
bool name_before(std::string_view a, std::string_view b);

// Return the image files, or the graphs, below `folder`, relative to it, sorted: at most `limit`.
// The search stops after `max_entries` files and folders; hidden ones are skipped. A graph is a
// file NAME.json, not NAME.test.json or NAME.preset.json, with "wrinkle" in its first 512 bytes.
std::vector<std::string> image_files(const std::filesystem::path& folder, size_t limit = 500,
                                     size_t max_entries = 20'000);
std::vector<std::string> graph_files(const std::filesystem::path& folder, size_t limit = 200,
                                     size_t max_entries = 2'000);

}  // namespace wrinkle::editor
