// Writes the dialog's choices as calls of `wrinkle bake`.
#include <algorithm>
#include <cctype>

#include "base/text.h"
#include "editor/model/bake/choices.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

// Returns the text unchanged if it needs no quotes in a shell.
std::string shell_word(const std::string& text) {
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) ||
               std::string_view("_-./,:=+@%").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
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
