// What a bake from the editor is asked for: plain values that the dialog shows and the settings
// keep, and the files that come of them.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bake/maps.h"
#include "bake/options.h"
#include "editor/document/settings.h"
#include "image/image.h"

namespace wrinkle::editor {

// A format and the type of its numbers: those of `wrinkle bake` that go together, and no others.
struct StoredAs {
    std::string key;    // of the settings: "png u8"
    std::string label;  // "PNG, 8 bits"
    std::string extension;
    PixelType type = PixelType::u8;

    bool integers() const { return type == PixelType::u8 || type == PixelType::u16; }
};
std::span<const StoredAs> stored_kinds();
// How a map is stored where this kind was chosen: what fits no integers is OpenEXR, half.
const StoredAs& stored_for(const StoredAs& chosen, std::string_view map);

// Names of compressions that the kind's format knows, "none" among them; none for most.
std::vector<std::string_view> compressions_of(const StoredAs& stored);
inline constexpr uint32_t bake_tiles[] = {0, 64, 128, 256, 512};  // 0: rows

inline constexpr uint32_t bake_sizes[] = {
    16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768, most_baked_side};

struct BakeChoices {
    std::string mesh;               // a shape's name, or the path of an OBJ or glTF file
    std::vector<std::string> maps;  // by name, in the order of the graph's
    std::string packs;              // as `--pack` has them, with a ; between two
    uint32_t width = 1024;          // texels
    uint32_t square_or_height = 0;  // texels; 0: as wide
    bool object_space = false, green_down = false, udim = false;
    const StoredAs* stored = stored_kinds().data();
    BakeTuning tuning;
    // A folder; or of one map its file, when it ends like one of that format.
    std::filesystem::path into;

    uint32_t height() const { return square_or_height ? square_or_height : width; }
    // What of the tuning the format of these files knows.
    std::string compression_in(const StoredAs& kind) const;
    uint32_t tile_in(const StoredAs& kind) const;
    bool one_file() const;
    bool operator==(const BakeChoices&) const = default;
};

// All but the mesh and the place, which belong to one graph.
BakeChoices choices_of(const BakeSettings& settings);
BakeSettings settings_of(const BakeChoices& choices);

// All that is asked for, maps before packs, each with how it is stored.
struct AskedMap {
    MapRequest request;
    const StoredAs* stored = nullptr;
};
// What can be used of it; `why` says in one sentence what cannot.
std::vector<AskedMap> asked_maps(const BakeChoices& choices, std::string& why);

// The same bake by `wrinkle bake`, for a shell. A line for each kind of files, since a call has one
// type.
std::string bake_command(const BakeChoices& choices, const std::filesystem::path& graph);

// The files of a picture, by map; of a UDIM tile with its number: ".1001".
std::vector<std::filesystem::path> baked_files(const BakeChoices& choices,
                                               const std::string& suffix = {});

}  // namespace wrinkle::editor
