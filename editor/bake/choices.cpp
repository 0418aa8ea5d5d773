#include "editor/bake/choices.h"

#include <algorithm>
#include <iterator>

#include "bake/map_files.h"
#include "bake/maps.h"
#include "base/text.h"
#include "image/writable.h"

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

std::vector<std::string_view> compressions_of(const StoredAs& stored) {
    const Writable* format = format_to_write("x" + std::string(stored.extension));
    std::vector<std::string_view> names;
    if (format && *format->compressions) names = split(format->compressions, ' ');
    return names;
}

std::string BakeChoices::compression_in(const StoredAs& kind) const {
    const auto known = compressions_of(kind);
    const bool fits = std::find(known.begin(), known.end(), tuning.compression) != known.end();
    return fits ? tuning.compression : "";
}

uint32_t BakeChoices::tile_in(const StoredAs& kind) const {
    const Writable* format = format_to_write("x" + std::string(kind.extension));
    return format && format->tiles ? tuning.tile : 0;
}

bool BakeChoices::one_file() const {
    std::string ignored;
    const std::vector<AskedMap> asked = asked_maps(*this, ignored);
    return asked.size() == 1 && into.extension() == asked[0].stored->extension;
}

std::vector<AskedMap> asked_maps(const BakeChoices& choices, std::string& why) {
    std::vector<AskedMap> asked;
    const auto add = [&](MapRequest request) {
        const bool twice = std::any_of(asked.begin(), asked.end(), [&](const AskedMap& each) {
            return each.request.name == request.name;
        });
        if (twice) {
            why = "Two maps would be called " + request.name +
                  ". A pack begins with its name: orm: r=occlusion.";
            return;
        }
        const StoredAs& stored = stored_for(*choices.stored, request.name);
        request.integers = stored.integers();
        asked.push_back({std::move(request), &stored});
    };
    for (const std::string& map : choices.maps)
        add({map, {}, true});
    for (const std::string_view text : split(choices.packs, ';')) {
        if (text.find_first_not_of(' ') == text.npos) continue;
        Diagnostics problems;
        if (auto request = parse_pack(std::string(text), problems))
            add(std::move(*request));
        else
            why = "\"" + std::string(text) +
                  "\" packs no channels. Write orm: r=occlusion g=roughness.";
    }
    return asked;
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
    choices.packs = settings.packs;
    choices.tuning = settings.tuning;
    const auto& counts = bake_sample_counts;
    if (std::find(counts.begin(), counts.end(), choices.tuning.samples) == counts.end())
        choices.tuning.samples = BakeTuning().samples;
    if (choices.tuning.tile % 16 != 0) choices.tuning.tile = 0;
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
    settings.packs = choices.packs;
    settings.tuning = choices.tuning;
    return settings;
}

std::vector<fs::path> baked_files(const BakeChoices& choices, const std::string& suffix) {
    std::vector<fs::path> files;
    std::string ignored;
    const bool one = choices.one_file();
    for (const AskedMap& map : asked_maps(choices, ignored))
        files.push_back(map_path(choices.into, one, map.request.name, suffix,
                                 std::string(map.stored->extension)));
    return files;
}

}  // namespace wrinkle::editor
