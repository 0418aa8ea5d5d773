#include "cli/map_kind.h"

#include <algorithm>
#include <array>

#include "maps/lint.h"

namespace wrinkle::cli {
namespace {

struct KindName {
    const char* name;
    maps::Kind kind;
    maps::Green green = maps::Green::gl;
};
constexpr std::array target_kinds = {
    KindName{"derivative", maps::Kind::derivative}, KindName{"normal", maps::Kind::normal},
    KindName{"slopes", maps::Kind::slopes}, KindName{"moments", maps::Kind::moments},
    KindName{"height", maps::Kind::height}};
constexpr std::array source_kinds = {KindName{"height", maps::Kind::height},
                                     KindName{"normal_gl", maps::Kind::normal},
                                     KindName{"normal_dx", maps::Kind::normal, maps::Green::dx},
                                     KindName{"derivative", maps::Kind::derivative}};

template <size_t count>
std::vector<std::string> names_in(const std::array<KindName, count>& table) {
    std::vector<std::string> names;
    for (const KindName& row : table)
        names.emplace_back(row.name);
    return names;
}

template <size_t count>
const KindName& named(const std::array<KindName, count>& table, std::string_view name) {
    const auto found = std::find_if(table.begin(), table.end(),
                                    [&](const KindName& row) { return row.name == name; });
    return found == table.end() ? table.front() : *found;
}

}  // namespace

std::vector<std::string> kind_names() {
    return names_in(target_kinds);
}

maps::Kind kind_named(const std::string& name) {
    return named(target_kinds, name).kind;
}

std::vector<std::string> source_names() {
    return names_in(source_kinds);
}

maps::Source source_named(const std::string& name) {
    const KindName& row = named(source_kinds, name);
    maps::Source source;
    source.kind = row.kind;
    source.green = row.green;
    return source;
}

std::optional<maps::Source> source_found(const Image& image, const std::string& file,
                                         Diagnostics& diagnostics) {
    const maps::Look look = maps::examine(image, Wrap::clamp).look;
    const std::string name(name_of(look));
    Diagnostic said;
    said.where.file = file;
    said.message = "is taken for " + std::string(description_of(look));
    said.expected = "--from says what it is";
    const std::vector<std::string> names = source_names();
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        said.message = "looks like " + std::string(description_of(look));
        said.expected = "--from height, normal_gl, normal_dx or derivative";
        diagnostics.add(std::move(said));
        return {};
    }
    said.severity = Severity::warning;
    diagnostics.add(std::move(said));
    return source_named(name);
}

}  // namespace wrinkle::cli
