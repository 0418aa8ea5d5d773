// Settings of the editor, stored in `settings.json` of the config folder. To add a field, add a
// member here and a row in settings.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bake/options.h"
#include "editor/model/document/folders.h"

namespace wrinkle::editor {

// Options of a bake that the dialog and the settings store in the same form.
struct BakeLayout {
    uint32_t width = 1024;          // texels
    uint32_t square_or_height = 0;  // texels; 0: same as width
    bool udim = false;
    std::string packs;  // as for `--pack`, separated by ;
    BakeTuning tuning;

    bool operator==(const BakeLayout&) const = default;
};

// Options of the last bake, as strings of `wrinkle bake`.
struct BakeSettings : BakeLayout {
    std::string maps = "normal";  // "normal,height"
    std::string space = "tangent", green = "gl";
    std::string stored = "png u8";

    bool operator==(const BakeSettings&) const = default;
};

struct Settings {
    static constexpr size_t max_recent = 10, max_dismissed = 500, max_favorites = 100;

    int width = 1600, height = 900;  // window size
    // Panes as fractions (panels/regions.h); 0 is the default size.
    float side = 0, preview = 0, problems = 0;
    std::string theme = "dark";                 // or "light"
    float scale = 1;                            // interface scale
    std::vector<std::filesystem::path> recent;  // absolute, the latest first
    BakeSettings bake;
    std::vector<std::string> favorites;  // node types of the search, as nodes name them
    std::string host = "gltf";           // of the last export (export/export.h)
    // Dismissed remarks about images, by their marks (images/remarks.h).
    std::vector<std::string> dismissed;  // the latest last

    bool operator==(const Settings&) const = default;
};

// Returns defaults if nothing is stored. `error_text` receives a sentence about unusable entries; a
// file that is not a settings file is renamed to settings.json.bak.
Settings read_settings(const Folders& folders, std::string& error_text);
// Returns the error message; "" on success or if there is no config folder.
std::string write_settings(const Folders& folders, const Settings& settings);

// Adds to the front of the list on disk, which another window may have written meanwhile.
void remember_recent(const Folders& folders, Settings& settings, const std::filesystem::path& file);

}  // namespace wrinkle::editor
