#include <algorithm>
#include <set>
#include <utility>

#include "base/text.h"
#include "difference/changes.h"
#include "json/write.h"

namespace wrinkle::difference {
namespace {

// A key on the left of its value: ".scale" for a port, ": type" for another key.
std::string key_suffix(const Key& key) {
    if (key.is_port) return "." + key.name;
    return key.name.empty() ? "" : ": " + key.name;
}

std::string assignment(const Key& key) {
    return (link_of(key.value) ? " <- " : " = ") + value_text(key.value, false);
}

// "gradient_scale, gradient <- weave.gradient, amount = 0.6": the type, then the other keys.
std::string entry_summary(const Change& change, const json::Value& value) {
    std::vector<std::string> parts;
    for (const Key& key : entry_of(change.section, change.id, value).keys) {
        const bool is_type = key.name == "type" && !key.is_port;
        parts.push_back(is_type || key.name.empty() ? value_text(key.value, false)
                                                    : key.name + assignment(key));
    }
    return joined(parts, ", ");
}

std::string change_line(const Change& change) {
    const std::string entry = std::string(entry_names[size_t(change.section)]) + " " + change.id;
    switch (change.kind) {
        case ChangeKind::added:
            return "+ " + entry + ": " + entry_summary(change, change.after);
        case ChangeKind::removed:
            return "- " + entry + ": " + entry_summary(change, change.before);
        case ChangeKind::renamed:
            return "  " + entry + " renamed " + change.new_id;
        case ChangeKind::changed:
            break;
    }
    const bool is_rewired = link_of(change.before) || link_of(change.after);
    return "  " + key_text(change.section, change.id, change.key) +
           (is_rewired ? " rewired: " : ": ") + value_text(change.before, !change.before.tree()) +
           " -> " + value_text(change.after, !change.after.tree());
}

std::string counted(size_t count, std::string_view noun, std::string_view verb) {
    return std::to_string(count) + " " + std::string(noun) + (count == 1 ? " " : "s ") +
           std::string(verb);
}

// "layout: 3 positions changed, 1 note added"; "" without changes.
std::string layout_line(const Changes& changes) {
    constexpr std::array<std::string_view, 4> verbs = {"added", "removed", "renamed", "changed"};
    std::vector<std::string> parts;
    for (const Section section : {Section::positions, Section::frames, Section::notes})
        for (const ChangeKind kind :
             {ChangeKind::added, ChangeKind::removed, ChangeKind::changed}) {
            std::set<std::string> ids;
            for (const Change& change : changes.layout)
                if (change.section == section && change.kind == kind) ids.insert(change.id);
            if (!ids.empty())
                parts.push_back(
                    counted(ids.size(), entry_names[size_t(section)], verbs[size_t(kind)]));
        }
    if (changes.reordered) parts.emplace_back("another order in the file");
    return parts.empty() ? "" : "layout: " + joined(parts, ", ");
}

std::string change_json(const Change& change) {
    constexpr std::array<std::string_view, 4> kinds = {"added", "removed", "renamed", "changed"};
    std::string text = "{\"section\": " + json_quoted(section_names[size_t(change.section)]) +
                       ", \"id\": " + json_quoted(change.id) +
                       ", \"change\": " + json_quoted(kinds[size_t(change.kind)]);
    if (change.kind == ChangeKind::renamed) text += ", \"new_id\": " + json_quoted(change.new_id);
    if (!change.key.name.empty())
        text +=
            (change.key.is_port ? ", \"port\": " : ", \"key\": ") + json_quoted(change.key.name);
    if (change.before.tree()) text += ", \"before\": " + json::one_line(change.before);
    if (change.after.tree()) text += ", \"after\": " + json::one_line(change.after);
    return text + "}";
}

std::string list_json(const std::vector<Change>& changes) {
    return changes.empty() ? "[]" : "[\n    " + joined(changes, ",\n    ", change_json) + "\n  ]";
}

std::string json_word(bool value) {
    return value ? "true" : "false";
}

}  // namespace

std::string value_text(const json::Value& value, bool is_absent) {
    if (is_absent) return "unset";
    if (const auto link = link_of(value)) return link->text();
    return json::one_line(value);
}

std::string key_text(Section section, std::string_view id, const Key& key) {
    return std::string(entry_names[size_t(section)]) + " " + std::string(id) + key_suffix(key);
}

std::vector<std::string> change_lines(const Changes& changes) {
    std::vector<std::string> lines;
    for (const Change& change : changes.material)
        lines.push_back(printable(change_line(change)));
    if (std::string layout = layout_line(changes); !layout.empty())
        lines.push_back(std::move(layout));
    return lines;
}

std::string verdict(const Changes& changes) {
    if (changes.same_bytes) return "same";
    if (!changes.same_material()) return "different";
    return changes.layout.empty() && !changes.reordered ? "other text, same material"
                                                        : "other layout, same material";
}

std::string changes_text(const Changes& changes) {
    return joined(change_lines(changes), "", [](const std::string& line) { return line + "\n"; }) +
           verdict(changes) + "\n";
}

std::string changes_json(const Changes& changes, const std::vector<JsonMember>& members) {
    return "{\n  \"version\": 1,\n  \"same\": " + json_word(changes.same_material()) +
           ",\n  \"same_bytes\": " + json_word(changes.same_bytes) +
           ",\n  \"changes\": " + list_json(changes.material) +
           ",\n  \"layout\": " + list_json(changes.layout) +
           ",\n  \"reordered\": " + json_word(changes.reordered) +
           joined(members, "",
                  [](const JsonMember& member) {
                      return ",\n  " + json_quoted(member.name) + ": " + member.value;
                  }) +
           "\n}\n";
}

std::string listing(const Document& document) {
    std::string text;
    Entries entries = entries_of(document);
    for (size_t i = 0; i < section_names.size(); ++i) {
        const auto section = static_cast<Section>(i);
        if (is_layout(section)) continue;
        std::ranges::stable_sort(entries[section], {}, &Entry::id);
        for (Entry& entry : entries[section]) {
            // Other keys than ports are in the order of canonical text, which begins with "type".
            std::ranges::stable_sort(entry.keys, {}, [](const Key& key) {
                return std::pair(key.is_port, key.is_port ? key.name : std::string());
            });
            if (section == Section::graph && entry.id == "wrinkle") continue;  // the format
            for (const Key& key : entry.keys)
                text += printable(key_text(section, entry.id, key) + assignment(key)) + "\n";
        }
    }
    return text;
}

}  // namespace wrinkle::difference
