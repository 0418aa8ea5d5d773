#include "editor/bake/choices.h"

#include <algorithm>
#include <iterator>

#include "bake/map_files.h"
#include "bake/maps.h"
#include "base/text.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

constexpr StoredAs kinds[] = {
    {"png u8", "PNG, 8 bits", ".png", PixelType::u8},
    {"png u16", "PNG, 16 bits", ".png", PixelType::u16},
    {"tif u8", "TIFF, 8 bits", ".tif", PixelType::u8},
    {"tif u16", "TIFF, 16 bits", ".tif", PixelType::u16},
    {"tif float", "TIFF, floats", ".tif", PixelType::float32},
    {"exr half", "OpenEXR, halves", ".exr", PixelType::half},
    {"exr float", "OpenEXR, floats", ".exr", PixelType::float32},
};

template <class Matches>
const StoredAs& kind_where(Matches&& matches) {
    const auto found = std::find_if(std::begin(kinds), std::end(kinds), matches);
    return found == std::end(kinds) ? kinds[0] : *found;
}

}  // namespace

std::span<const StoredAs> stored_kinds() {
    return kinds;
}

const StoredAs& stored_for(const StoredAs& chosen, std::string_view map) {
    if (!chosen.integers() || fits_integers(map)) return chosen;
    return kind_where([](const StoredAs& kind) { return kind.key == "exr half"; });
}

bool BakeChoices::one_file() const {
    return maps.size() == 1 && into.extension() == stored_for(*stored, maps[0]).extension;
}

BakeChoices choices_of(const BakeSettings& settings) {
    BakeChoices choices;
    for (const std::string_view map : split(settings.maps, ','))
        if (!map.empty()) choices.maps.emplace_back(map);
    const auto size = static_cast<uint32_t>(settings.size);
    if (std::find(std::begin(bake_sizes), std::end(bake_sizes), size) != std::end(bake_sizes))
        choices.size = size;
    choices.object_space = settings.space == "object";
    choices.green_down = settings.green == "dx";
    choices.udim = settings.udim != 0;
    choices.stored = &kind_where([&](const StoredAs& kind) { return kind.key == settings.stored; });
    return choices;
}

BakeSettings settings_of(const BakeChoices& choices) {
    BakeSettings settings;
    settings.maps.clear();
    for (const std::string& map : choices.maps)
        settings.maps += (settings.maps.empty() ? "" : ",") + map;
    settings.size = static_cast<int>(choices.size);
    settings.space = choices.object_space ? "object" : "tangent";
    settings.green = choices.green_down ? "dx" : "gl";
    settings.stored = choices.stored->key;
    settings.udim = choices.udim;
    return settings;
}

std::vector<fs::path> baked_files(const BakeChoices& choices, const std::string& suffix) {
    std::vector<fs::path> files;
    for (const std::string& map : choices.maps) {
        const std::string extension(stored_for(*choices.stored, map).extension);
        files.push_back(map_path(choices.into, choices.one_file(), map, suffix, extension));
    }
    return files;
}

}  // namespace wrinkle::editor
