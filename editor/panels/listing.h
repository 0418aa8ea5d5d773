// What a folder holds, as the file browser shows it.
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
    static constexpr size_t most_entries = 100'000;

    std::vector<Entry> entries;  // folders first, each in the order of their names
    std::string trouble;         // why nothing, or not everything, is listed
};

// Folders and the files with one of the extensions (".png", small letters; none: every file).
// Names that begin with a dot are left out.
Listing list_folder(const std::filesystem::path& folder, std::span<const std::string> extensions);

// The indices of the entries whose names answer what was typed, best first; all for "".
std::vector<size_t> filtered(const Listing& listing, std::string_view query);

// Letters by the alphabet, numbers by their value: "wood2" before "wood10".
bool name_before(std::string_view a, std::string_view b);

}  // namespace wrinkle::editor
