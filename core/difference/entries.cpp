#include "difference/entries.h"

#include <algorithm>
#include <map>

#include "base/text.h"
#include "graph/read.h"
#include "graph/write.h"
#include "json/parse.h"
#include "json/write.h"

namespace wrinkle::difference {
namespace {

using json::Kind;
using json::Value;

constexpr std::string_view frames_key = "$frames", notes_key = "$notes";

std::optional<Section> section_named(std::string_view key) {
    for (const Section section :
         {Section::inputs, Section::presets, Section::nodes, Section::outputs})
        if (key == section_names[size_t(section)]) return section;
    return {};
}

bool is_single(Section section, const Value& value) {
    return section == Section::graph || section == Section::outputs ||
           section == Section::positions || !value.is(Kind::object);
}

void read_section(Section section, const Value& value, std::vector<Entry>& entries) {
    for (const json::Member& member : value.children())
        entries.push_back(entry_of(section, member.key, member.value));
}

void read_layout_section(const Value& layout, Entries& entries) {
    for (const json::Member& member : layout.children()) {
        if (member.key == frames_key)
            read_section(Section::frames, member.value, entries[Section::frames]);
        else if (member.key == notes_key)
            read_section(Section::notes, member.value, entries[Section::notes]);
        else
            entries[Section::positions].push_back(
                entry_of(Section::positions, member.key, member.value));
    }
}

std::string member_text(std::string_view key, const std::string& value) {
    return json_quoted(key) + ": " + value;
}

std::string members_text(const std::vector<Entry>& entries) {
    return joined(entries, ",\n",
                  [](const Entry& entry) { return member_text(entry.id, entry_text(entry)); });
}

std::string object_text(const std::vector<Entry>& entries) {
    return "{" + members_text(entries) + "}";
}

std::string layout_text(const Entries& entries) {
    std::vector<std::string> parts;
    if (!entries[Section::positions].empty())
        parts.push_back(members_text(entries[Section::positions]));
    if (!entries[Section::frames].empty())
        parts.push_back(member_text(frames_key, object_text(entries[Section::frames])));
    if (!entries[Section::notes].empty())
        parts.push_back(member_text(notes_key, object_text(entries[Section::notes])));
    return "{" + joined(parts, ",\n") + "}";
}

bool has_extra(const std::vector<Extra>& extras, std::string_view key) {
    return std::ranges::find(extras, key, &Extra::key) != extras.end();
}

}  // namespace

const Key* Entry::find(const Key& key) const {
    const auto found =
        std::ranges::find_if(keys, [&](const Key& each) { return each.same_name(key); });
    return found == keys.end() ? nullptr : &*found;
}

bool operator==(const Entry& a, const Entry& b) {
    if (a.is_single != b.is_single || a.keys.size() != b.keys.size()) return false;
    return std::ranges::all_of(a.keys, [&](const Key& key) {
        const Key* other = b.find(key);
        return other && other->value == key.value;
    });
}

const Entry* find_entry(const std::vector<Entry>& entries, std::string_view id) {
    const auto found = std::ranges::find(entries, id, &Entry::id);
    return found == entries.end() ? nullptr : &*found;
}

std::string entries_fault(const Document& document) {
    if (!document.lost.empty()) return document.lost;
    for (const char* section : {"nodes", "inputs", "presets", "outputs", "layout"})
        if (has_extra(document.unknown, section)) return json_quoted(section) + " is not an object";
    for (const std::string_view section : {frames_key, notes_key})
        if (has_extra(document.unknown_layout, section))
            return json_quoted(section) + " is not an object";
    for (const NodePtr& node : document.nodes)
        if (has_extra(node->unknown, "in"))
            return "\"in\" of node " + json_quoted(node->id) + " is not an object";
    return {};
}

Entry entry_of(Section section, std::string_view id, const Value& value) {
    Entry entry;
    entry.id = id;
    entry.value = value;
    entry.is_single = is_single(section, value);
    if (entry.is_single) {
        entry.keys.push_back({false, "", value});
        return entry;
    }
    for (const json::Member& member : value.children()) {
        const bool ports = section == Section::nodes && member.key == "in";
        if (ports) {
            for (const json::Member& port : member.value.children())
                entry.keys.push_back({true, std::string(port.key), port.value});
        } else {
            entry.keys.push_back({false, std::string(member.key), member.value});
        }
    }
    return entry;
}

// Canonical text has one form for equal content: defaults such as "muted": false are absent.
Entries entries_of(const Document& document) {
    Entries entries;
    Diagnostics none;
    const Value root = json::parse(canonical_text(document), document.file, none).root;
    for (const json::Member& member : root.children()) {
        if (const auto section = section_named(member.key))
            read_section(*section, member.value, entries[*section]);
        else if (member.key == "layout")
            read_layout_section(member.value, entries);
        else
            entries[Section::graph].push_back(entry_of(Section::graph, member.key, member.value));
    }
    return entries;
}

std::string entry_text(const Entry& entry) {
    if (entry.is_single) return json::one_line(entry.keys.front().value);
    std::vector<std::string> members, ports;
    for (const Key& key : entry.keys)
        (key.is_port ? ports : members).push_back(member_text(key.name, json::one_line(key.value)));
    if (!ports.empty()) members.push_back(member_text("in", "{" + joined(ports, ", ") + "}"));
    return "{" + joined(members, ", ") + "}";
}

std::string graph_text(const Entries& entries) {
    std::vector<std::string> members;
    if (!entries[Section::graph].empty()) members.push_back(members_text(entries[Section::graph]));
    for (const Section section :
         {Section::inputs, Section::presets, Section::nodes, Section::outputs})
        members.push_back(
            member_text(section_names[size_t(section)], object_text(entries[section])));
    members.push_back(member_text("layout", layout_text(entries)));
    Diagnostics none;
    return canonical_text(read_document("{" + joined(members, ",\n") + "}", "", none));
}

std::optional<Link> link_of(const Value& value) {
    const Value from = value.find("from");
    if (value.size() != 1 || !from.is(Kind::string)) return {};
    const std::string_view text = from.as_string();
    const size_t dot = text.find('.');
    if (dot == text.npos) return {};
    return Link{std::string(text.substr(0, dot)), std::string(text.substr(dot + 1))};
}

}  // namespace wrinkle::difference
