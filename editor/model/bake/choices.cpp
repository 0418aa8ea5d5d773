#include "editor/model/bake/choices.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>

#include "bake/map_files.h"
#include "bake/maps.h"
#include "base/text.h"
#include "image/formats.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

struct FormatName {
    std::string_view format, name;
};
constexpr FormatName format_names[] = {
    {"png", "PNG"}, {"tif", "TIFF"}, {"exr", "OpenEXR"}, {"hdr", "Radiance"}};

std::string label_of(std::string_view format, PixelType type) {
    constexpr std::array numbers = {"8 bits", "16 bits", "halves", "floats"};
    std::string name(format);
    for (const FormatName& each : format_names)
        if (each.format == format) name = each.name;
    return name + ", " + numbers[static_cast<size_t>(type)];
}

std::vector<StoredAs> all_kinds() {
    std::vector<StoredAs> kinds;
    for (const std::string format : bake_formats) {
        const std::vector<std::string_view> types =
            split(format_to_write("x." + format)->types, ' ');
        for (const PixelType type :
             {PixelType::u8, PixelType::u16, PixelType::half, PixelType::float32})
            if (std::ranges::find(types, name_of(type)) != types.end())
                kinds.push_back({format + " " + std::string(name_of(type)), label_of(format, type),
                                 "." + format, type});
    }
    return kinds;
}

template <class Matches>
const StoredAs& kind_where(Matches&& matches) {
    const auto kinds = stored_kinds();
    const auto found = std::ranges::find_if(kinds, matches);
    return found == kinds.end() ? kinds[0] : *found;
}

uint32_t listed_size(uint32_t size, uint32_t otherwise) {
    const auto* found = std::ranges::find(bake_sizes, size);
    return found == std::end(bake_sizes) ? otherwise : size;
}

// Returns the text unchanged if it needs no quotes in a shell.
std::string shell_word(const std::string& text) {
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) ||
               std::string_view("_-./,:=+@%").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (!text.empty() && std::ranges::all_of(text, plain)) return text;
    std::string quoted = "'";
    for (const char c : text)
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

// Returns the call for maps stored in the same way; `out` is a file if there is only one map.
std::string call(const BakeChoices& choices, const fs::path& graph, const StoredAs& stored,
                 const std::string& maps, const std::vector<std::string>& packs,
                 const fs::path& out, bool one) {
    const BakeTuning usual, &tuning = choices.tuning;
    std::string text = "wrinkle bake " + shell_word(graph.string());
    const auto add = [&](const char* option, const std::string& value, bool wanted = true) {
        if (wanted) text += std::string(" ") + option + " " + shell_word(value);
    };
    add("--preset", choices.preset, !choices.preset.empty());
    add("--mesh", choices.mesh);
    add("--map", maps, !maps.empty());
    for (const std::string& pack : packs)
        add("--pack", pack);
    const std::string wide = std::to_string(choices.width);
    const bool square = choices.height() == choices.width;
    add("--size", square ? wide : wide + "x" + std::to_string(choices.height()));
    add("--space", "object", choices.object_space);
    if (choices.green_down) text += " --dx";
    if (choices.udim) text += " --udim";
    add("--scale", shortest(tuning.scale), tuning.scale != usual.scale);
    add("--samples", std::to_string(tuning.samples), tuning.samples != usual.samples);
    add("--dilate", std::to_string(tuning.dilate), tuning.dilate != usual.dilate);
    add("--type", std::string(name_of(stored.type)));
    add("--format", stored.extension.substr(1), !one);
    add("--compression", choices.compression_in(stored), !choices.compression_in(stored).empty());
    add("--tile", std::to_string(choices.tile_in(stored)), choices.tile_in(stored) != 0);
    add("-o", out.string());
    return text;
}

}  // namespace

std::span<const StoredAs> stored_kinds() {
    static const std::vector<StoredAs> kinds = all_kinds();
    return kinds;
}

const StoredAs& stored_for(const StoredAs& chosen, std::string_view map) {
    if (!chosen.integers() || fits_integers(map)) return chosen;
    return kind_where([](const StoredAs& kind) { return kind.key == "exr half"; });
}

std::vector<std::string_view> compressions_of(const StoredAs& stored) {
    const Writable* format = format_to_write("x" + stored.extension);
    std::vector<std::string_view> names;
    if (format && *format->compressions) names = split(format->compressions, ' ');
    return names;
}

std::string BakeChoices::compression_in(const StoredAs& kind) const {
    const auto known = compressions_of(kind);
    const bool fits = std::ranges::find(known, tuning.compression) != known.end();
    return fits ? tuning.compression : "";
}

uint32_t BakeChoices::tile_in(const StoredAs& kind) const {
    const Writable* format = format_to_write("x" + kind.extension);
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
        const bool twice = std::ranges::any_of(
            asked, [&](const AskedMap& each) { return each.request.name == request.name; });
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
    static_cast<BakeLayout&>(choices) = settings;
    for (const std::string_view map : split(settings.maps, ','))
        if (!map.empty()) choices.maps.emplace_back(map);
    choices.width = listed_size(settings.width, BakeLayout().width);
    choices.square_or_height = listed_size(settings.square_or_height, 0);
    choices.object_space = settings.space == "object";
    choices.green_down = settings.green == "dx";
    const auto& counts = bake_sample_counts;
    if (std::ranges::find(counts, choices.tuning.samples) == counts.end())
        choices.tuning.samples = BakeTuning().samples;
    if (choices.tuning.tile % 16 != 0) choices.tuning.tile = 0;
    choices.stored = &kind_where([&](const StoredAs& kind) { return kind.key == settings.stored; });
    return choices;
}

BakeSettings settings_of(const BakeChoices& choices) {
    BakeSettings settings{choices};
    settings.maps = joined(choices.maps, ",", [](const std::string& map) { return map; });
    settings.space = choices.object_space ? "object" : "tangent";
    settings.green = choices.green_down ? "dx" : "gl";
    settings.stored = choices.stored->key;
    return settings;
}

std::vector<fs::path> baked_files(const BakeChoices& choices, const std::string& suffix) {
    std::vector<fs::path> files;
    std::string ignored;
    const bool one = choices.one_file();
    for (const AskedMap& map : asked_maps(choices, ignored))
        files.push_back(
            map_path(choices.into, one, map.request.name, suffix, map.stored->extension));
    return files;
}

std::string bake_command(const BakeChoices& choices, const fs::path& graph) {
    std::string why, text;
    const std::vector<AskedMap> asked = asked_maps(choices, why);
    const std::vector<fs::path> files = baked_files(choices);
    for (const StoredAs& kind : stored_kinds()) {
        std::string maps;
        std::vector<std::string> packs;
        size_t count = 0, last = 0;
        for (size_t i = 0; i < asked.size(); ++i) {
            if (asked[i].stored != &kind) continue;
            ++count;
            last = i;
            if (asked[i].request.pack.empty())
                maps += (maps.empty() ? "" : ",") + asked[i].request.name;
            else
                packs.push_back(text_of(asked[i].request));
        }
        if (count == 0) continue;
        const bool one = count == 1;
        text += (text.empty() ? "" : "\n") +
                call(choices, graph, kind, maps, packs, one ? files[last] : choices.into, one);
    }
    return text;
}

}  // namespace wrinkle::editor
