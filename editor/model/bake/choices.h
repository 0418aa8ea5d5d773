// Options of a bake from the editor: plain values shown by the dialog and stored in the settings,
// and the resulting files.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bake/maps.h"
#include "bake/options.h"
#include "editor/model/document/settings.h"
#include "image/image.h"

namespace wrinkle::editor {

// A format and its pixel type: only combinations that `wrinkle bake` accepts.
struct StoredAs {
    std::string key;    // key in the settings: "png u8"
    std::string label;  // "PNG, 8 bits"
    std::string extension;
    PixelType type = PixelType::u8;

    bool integers() const { return type == PixelType::u8 || type == PixelType::u16; }
};
std::span<const StoredAs> stored_kinds();
// Returns how a map is stored for the chosen kind: maps that do not fit integers use OpenEXR, half.
const StoredAs& stored_for(const StoredAs& chosen, std::string_view map);

// Returns the compressions of the kind's format, including "none"; empty for most formats.
std::vector<std::string_view> compressions_of(const StoredAs& stored);
inline constexpr uint32_t bake_tiles[] = {0, 64, 128, 256, 512};  // 0: rows

inline constexpr uint32_t bake_sizes[] = {16,   32,   64,   128,   256,   512,           1024,
                                          2048, 4096, 8192, 16384, 32768, max_baked_side};

struct BakeChoices : BakeLayout {
    std::string mesh;               // a shape's name, or the path of an OBJ or glTF file
    std::vector<std::string> maps;  // names, in the order of the graph's maps
    std::string preset;             // name in the graph; "": the defaults of its inputs
    bool object_space = false, green_down = false;
    const StoredAs* stored = stored_kinds().data();
    // A folder; or the file of a single map, if it has the extension of that format.
    std::filesystem::path into;

    uint32_t height() const { return square_or_height ? square_or_height : width; }
    // Tuning values that the format supports: "" or 0 if it does not.
    std::string compression_in(const StoredAs& kind) const;
    uint32_t tile_in(const StoredAs& kind) const;
    bool one_file() const;
    bool operator==(const BakeChoices&) const = default;
};

// All choices except the mesh and the path, which belong to one graph.
BakeChoices choices_of(const BakeSettings& settings);
BakeSettings settings_of(const BakeChoices& choices);

// A requested map (maps before packs) and how it is stored.
struct AskedMap {
    MapRequest request;
    const StoredAs* stored = nullptr;
};
// Returns the usable requests; `why` receives one sentence on those that are not.
std::vector<AskedMap> asked_maps(const BakeChoices& choices, std::string& why);

// Returns the same bake as `wrinkle bake` calls for a shell, one line for each kind of files, since
// a call has one type.
std::string bake_command(const BakeChoices& choices, const std::filesystem::path& graph);

// Returns the files of a bake, by map; with the number of a UDIM tile as suffix: ".1001".
std::vector<std::filesystem::path> baked_files(const BakeChoices& choices,
                                               const std::string& suffix = {});

}  // namespace wrinkle::editor
