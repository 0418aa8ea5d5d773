// What the editor remembers from one start to the next, in `settings.json` of the config folder.
// A new field is a member here and a row in settings.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bake/options.h"
#include "editor/document/folders.h"

namespace wrinkle::editor {

// How maps were baked last, in the words of `wrinkle bake`.
struct BakeSettings {
    std::string maps = "normal";  // "normal,height"
    int size = 1024;              // texels
    int height = 0;               // texels; 0: as wide
    std::string space = "tangent", green = "gl";
    std::string stored = "png u8";
    int udim = 0;
    std::string packs;  // "orm: r=occlusion g=roughness; ..."
    BakeTuning tuning;

    bool operator==(const BakeSettings&) const = default;
};

struct Settings {
    static constexpr size_t most_recent = 10, most_dismissed = 500;

    int width = 1600, height = 900;  // of the window
    // Panes as fractions (panels/panes.h); 0 is the usual size.
    float side = 0, preview = 0, problems = 0;
    std::string theme = "dark";                 // or "light"
    float scale = 1;                            // of the interface
    std::vector<std::filesystem::path> recent;  // absolute, the latest first
    BakeSettings bake;
    // Remarks about pictures that nobody wants to see again, by their marks (images/remarks.h).
    std::vector<std::string> dismissed;  // the latest last

    bool operator==(const Settings&) const = default;
};

// Defaults where nothing is kept. What cannot be used is a sentence in `trouble`; a file that is no
// settings at all is kept as settings.json.bak.
Settings read_settings(const Folders& folders, std::string& trouble);
// The error's words, "" when they are written or nothing is kept.
std::string write_settings(const Folders& folders, const Settings& settings);

// To the front of the list that is on the disk now: another window may have written it.
void remember_recent(const Folders& folders, Settings& settings, const std::filesystem::path& file);

}  // namespace wrinkle::editor
