#include "difference/merge.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "difference/merge_entries.h"
#include "difference/renames.h"
#include "graph/edit.h"
#include "graph/read.h"
#include "graph/write.h"

namespace wrinkle::difference {
namespace {

struct Sides {
    Document base, ours, theirs;
};

Conflict node_conflict(ConflictKind kind, const std::string& id) {
    Conflict conflict;
    conflict.kind = kind;
    conflict.id = id;
    return conflict;
}

json::Value node_value(const Document& document, const std::string& id) {
    return find_entry(entries_of(document)[Section::nodes], id)->value;
}

// Renames nodes so that one id is one node in all three documents.
class RenameMatch {
public:
    RenameMatch(Sides& sides, std::vector<Conflict>& conflicts)
        : sides_(sides), conflicts_(conflicts) {}

    void run() {
        const Entries base = entries_of(sides_.base);
        const Renames ours = find_renames(base, entries_of(sides_.ours));
        const Renames theirs = find_renames(base, entries_of(sides_.theirs));
        for (const auto& [id, new_id] : ours) {
            const auto other = theirs.find(id);
            if (other == theirs.end())
                follow(id, new_id, sides_.theirs, ConflictKind::deleted_by_theirs);
            else
                match_both(id, new_id, other->second);
        }
        for (const auto& [id, new_id] : theirs)
            if (!ours.contains(id)) follow(id, new_id, sides_.ours, ConflictKind::deleted_by_ours);
    }

private:
    // One side renamed the node: renames it in `other` too, unless `other` deleted it.
    void follow(const std::string& id, const std::string& new_id, Document& other,
                ConflictKind if_deleted) {
        if (other.find(new_id)) return;  // another node: it is deleted and added
        if (!other.find(id)) {
            const bool by_ours = if_deleted == ConflictKind::deleted_by_ours;
            const Document& renamed = by_ours ? sides_.theirs : sides_.ours;
            Conflict conflict = node_conflict(if_deleted, new_id);
            conflict.base = node_value(sides_.base, id);
            (by_ours ? conflict.theirs : conflict.ours) = node_value(renamed, new_id);
            conflicts_.push_back(std::move(conflict));
            return;
        }
        other = rename_node(other, id, new_id);
        sides_.base = rename_node(sides_.base, id, new_id);
    }

    void match_both(const std::string& id, const std::string& by_ours,
                    const std::string& by_theirs) {
        if (by_ours != by_theirs) {
            if (sides_.theirs.find(by_ours) || sides_.ours.find(by_theirs)) return;
            Conflict conflict = node_conflict(ConflictKind::renamed, by_ours);
            conflict.base = json::Value::string(id);
            conflict.ours = json::Value::string(by_ours);
            conflict.theirs = json::Value::string(by_theirs);
            conflicts_.push_back(std::move(conflict));
            sides_.theirs = rename_node(sides_.theirs, by_theirs, by_ours);
        }
        sides_.base = rename_node(sides_.base, id, by_ours);
    }

    Sides& sides_;
    std::vector<Conflict>& conflicts_;
};

std::set<std::string_view> node_ids(const Entries& entries) {
    std::set<std::string_view> ids;
    for (const Entry& node : entries[Section::nodes])
        ids.insert(node.id);
    return ids;
}

// Removes positions of nodes that a side deleted.
void drop_positions(const Entries& base, Entries& merged) {
    const auto before = node_ids(base), after = node_ids(merged);
    std::erase_if(merged[Section::positions], [&](const Entry& position) {
        return before.contains(position.id) && !after.contains(position.id);
    });
}

Diagnostics errors_of(std::string text) {
    Diagnostics diagnostics;
    read_document(std::move(text), "", diagnostics);
    return diagnostics;
}

std::tuple<std::string, std::string, std::string> identity(const Diagnostic& diagnostic) {
    return {diagnostic.node, diagnostic.pointer, diagnostic.message};
}

// Returns the text with the bytes of a side if that has equal content.
std::string spelled_as_read(std::string text, const Document& ours, const Document& theirs) {
    for (const Document* side : {&ours, &theirs})
        if (canonical_text(*side) == text) return write_document(*side);
    return text;
}

}  // namespace

void add_new_errors(const Diagnostics& ours, const Diagnostics& theirs, const Diagnostics& result,
                    std::vector<Conflict>& conflicts) {
    std::set<std::tuple<std::string, std::string, std::string>> known;
    for (const Diagnostics* side : {&ours, &theirs})
        for (const Diagnostic& each : side->list())
            known.insert(identity(each));
    for (const Diagnostic& each : result.list()) {
        if (each.severity != Severity::error || !known.insert(identity(each)).second) continue;
        Conflict conflict = node_conflict(ConflictKind::error, each.node);
        conflict.message = each.message;
        conflicts.push_back(std::move(conflict));
    }
}

Merged merge(const Document& base, const Document& ours, const Document& theirs,
             MergePurpose purpose) {
    Merged merged;
    Sides sides{base, ours, theirs};
    RenameMatch(sides, merged.conflicts).run();
    const Entries base_entries = entries_of(sides.base);
    const Entries our_entries = entries_of(sides.ours), their_entries = entries_of(sides.theirs);
    Entries result;
    for (size_t i = 0; i < section_names.size(); ++i) {
        const auto section = static_cast<Section>(i);
        const EntriesOfSides entries{base_entries[section], our_entries[section],
                                     their_entries[section]};
        result[section] = merge_section(section, entries, purpose, merged.conflicts);
    }
    drop_positions(base_entries, result);
    merged.text = graph_text(result);
    if (purpose == MergePurpose::result)
        add_new_errors(errors_of(canonical_text(sides.ours)),
                       errors_of(canonical_text(sides.theirs)), errors_of(merged.text),
                       merged.conflicts);
    merged.text = spelled_as_read(std::move(merged.text), ours, theirs);
    merged.ours = std::move(sides.ours);
    merged.theirs = std::move(sides.theirs);
    return merged;
}

}  // namespace wrinkle::difference
