#include "difference/conflicts.h"

#include <algorithm>

#include "base/text.h"
#include "difference/changes.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "json/parse.h"
#include "json/write.h"

namespace wrinkle::difference {
namespace {

using json::Kind;
using json::Value;

std::string member(std::string_view key, const std::string& value) {
    return json_quoted(key) + ": " + value;
}

std::string conflict_json(const Conflict& conflict) {
    std::vector<std::string> members = {
        member("kind", json_quoted(conflict_kinds[size_t(conflict.kind)])),
        member("section", json_quoted(section_names[size_t(conflict.section)])),
        member("id", json_quoted(conflict.id))};
    if (!conflict.key.name.empty())
        members.push_back(
            member(conflict.key.is_port ? "port" : "key", json_quoted(conflict.key.name)));
    if (conflict.base) members.push_back(member("base", json::one_line(*conflict.base)));
    if (conflict.ours) members.push_back(member("ours", json::one_line(*conflict.ours)));
    if (conflict.theirs) members.push_back(member("theirs", json::one_line(*conflict.theirs)));
    if (!conflict.message.empty())
        members.push_back(member("message", json_quoted(conflict.message)));
    return "{ " + joined(members, ", ") + " }";
}

std::string text_of(const Value& object, std::string_view key) {
    const Value value = object.find(key);
    return value.is(Kind::string) ? std::string(value.as_string()) : "";
}

std::optional<Value> value_of(const Value& object, std::string_view key) {
    return object.has(key) ? std::optional(object.find(key)) : std::nullopt;
}

std::optional<Conflict> read_conflict(const Value& object) {
    const auto kind = enumerator_named<ConflictKind>(conflict_kinds, text_of(object, "kind"));
    const auto section = enumerator_named<Section>(section_names, text_of(object, "section"));
    if (!kind || !section) return {};
    if (*kind == ConflictKind::renamed)
        for (const char* side : {"ours", "theirs"})
            if (text_of(object, side).empty()) return {};
    Conflict conflict{*kind, *section, text_of(object, "id"), {}, {}, {}, {}, {}};
    conflict.key.is_port = object.has("port");
    conflict.key.name = text_of(object, conflict.key.is_port ? "port" : "key");
    conflict.base = value_of(object, "base");
    conflict.ours = value_of(object, "ours");
    conflict.theirs = value_of(object, "theirs");
    conflict.message = text_of(object, "message");
    return conflict;
}

std::string side_text(const std::optional<Value>& value) {
    return value ? value_text(*value, false) : "unset";
}

// Sets or removes a key of an entry.
void set_key(Entry& entry, const Key& key, const std::optional<Value>& value) {
    std::erase_if(entry.keys, [&](const Key& each) { return each.same_name(key) && !value; });
    if (!value) return;
    const auto found =
        std::ranges::find_if(entry.keys, [&](const Key& each) { return each.same_name(key); });
    if (found == entry.keys.end())
        entry.keys.push_back({key.is_port, key.name, *value});
    else
        found->value = *value;
}

void set_entry(Section section, std::vector<Entry>& entries, const std::string& id,
               const std::optional<Value>& value) {
    const auto found = std::ranges::find(entries, id, &Entry::id);
    if (!value) {
        if (found != entries.end()) entries.erase(found);
    } else if (found == entries.end()) {
        entries.push_back(entry_of(section, id, *value));
    } else {
        *found = entry_of(section, id, *value);
    }
}

}  // namespace

std::string sentence_of(const Conflict& conflict) {
    const std::string subject = key_text(conflict.section, conflict.id, conflict.key);
    switch (conflict.kind) {
        case ConflictKind::both_changed: {
            const bool was = conflict.base && conflict.base->is(Kind::array) &&
                             conflict.base->size() == 3 &&
                             conflict.base->at(0) == Value::string("conflict");
            return subject + ": " + side_text(conflict.ours) + " in ours, " +
                   side_text(conflict.theirs) + " in theirs" +
                   (was ? "" : "; it was " + side_text(conflict.base));
        }
        case ConflictKind::both_added:
            return subject + ": added by both with other content";
        case ConflictKind::deleted_by_ours:
            return subject + ": deleted by ours, changed by theirs";
        case ConflictKind::deleted_by_theirs:
            return subject + ": deleted by theirs, changed by ours";
        case ConflictKind::renamed:
            return subject + ": " + side_text(conflict.base) + " was renamed " +
                   side_text(conflict.ours) + " by ours, " + side_text(conflict.theirs) +
                   " by theirs";
        case ConflictKind::error:
            break;
    }
    return (conflict.id.empty() ? "" : subject + ": ") + conflict.message +
           " (neither side had this error)";
}

std::string conflicts_text(const std::vector<Conflict>& conflicts) {
    return "{\n  \"wrinkle_conflicts\": 1,\n  \"conflicts\": [\n    " +
           joined(conflicts, ",\n    ", conflict_json) + "\n  ]\n}\n";
}

std::optional<std::vector<Conflict>> read_conflicts(std::string text, std::string file,
                                                    Diagnostics& diagnostics) {
    Diagnostics own;
    const json::Parsed parsed = json::parse(std::move(text), file, own);
    diagnostics.append(own);
    if (own.has_errors()) return {};
    std::vector<Conflict> conflicts;
    bool is_valid = parsed.root.is(Kind::object) && parsed.root.has("wrinkle_conflicts");
    for (const json::Member& each : parsed.root.find("conflicts").children()) {
        auto conflict = read_conflict(each.value);
        is_valid &= conflict.has_value();
        if (conflict) conflicts.push_back(std::move(*conflict));
    }
    if (is_valid) return conflicts;
    diagnostics.add(file_problem(Severity::error, RuleId::wrong_file, std::move(file),
                                 "is not a list of conflicts",
                                 "the file that wrinkle merge wrote"));
    return {};
}

std::string with_side(const Document& document, const Conflict& conflict, Side side) {
    const auto& value = side == Side::ours ? conflict.ours : conflict.theirs;
    if (conflict.kind == ConflictKind::renamed)
        return write_document(rename_node(document, conflict.id, std::string(value->as_string())));
    Entries entries = entries_of(document);
    std::vector<Entry>& section = entries[conflict.section];
    const auto found = std::ranges::find(section, conflict.id, &Entry::id);
    if (!conflict.key.name.empty() && found != section.end() && !found->is_single)
        set_key(*found, conflict.key, value);
    if (conflict.key.name.empty()) {
        set_entry(conflict.section, section, conflict.id, value);
        if (conflict.section == Section::nodes && !value)
            set_entry(Section::positions, entries[Section::positions], conflict.id, {});
    }
    return graph_text(entries);
}

}  // namespace wrinkle::difference
