#include "difference/merge_entries.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "difference/merge_order.h"

namespace wrinkle::difference {
namespace {

using json::Value;

template <class T>
struct ThreeOf {
    const T *base = nullptr, *ours = nullptr, *theirs = nullptr;
};

template <class T>
bool same(const T* a, const T* b) {
    return a == b || (a && b && *a == *b);
}

// Returns the side that has all changes; std::nullopt if both changed and differ.
template <class T>
std::optional<const T*> changed_side(const ThreeOf<T>& sides) {
    if (same(sides.ours, sides.theirs) || same(sides.base, sides.theirs)) return sides.ours;
    if (same(sides.base, sides.ours)) return sides.theirs;
    return {};
}

std::optional<Value> optional_value(const Value* value) {
    return value ? std::optional(*value) : std::nullopt;
}
std::optional<Value> optional_value(const Entry* entry) {
    return entry ? std::optional(entry->value) : std::nullopt;
}

// Value of a conflict in an ancestor: not equal to a value of a side.
Value conflict_mark(const std::optional<Value>& ours, const std::optional<Value>& theirs) {
    const std::array items = {Value::string("conflict"), ours.value_or(Value()),
                              theirs.value_or(Value())};
    return Value::array(items);
}

// Values that differ without a conflict: coordinates on the canvas.
bool is_coordinate(Section section, const Key& key) {
    return section == Section::positions || (is_layout(section) && key.name == "rect");
}

class SectionMerge {
public:
    SectionMerge(Section section, MergePurpose purpose, std::vector<Conflict>& conflicts)
        : section_(section), purpose_(purpose), conflicts_(conflicts) {}

    // Returns the merged entry; std::nullopt if it is deleted.
    std::optional<Entry> merged(const ThreeOf<Entry>& sides) {
        if (const auto side = changed_side(sides))
            return *side ? std::optional(**side) : std::nullopt;
        if (sides.base && sides.ours && sides.theirs && !sides.base->is_single &&
            !sides.ours->is_single && !sides.theirs->is_single)
            return merged_keys(sides);
        if (!sides.ours || !sides.theirs) return with_deletion(sides);
        if (is_same_apart_from_coordinates(*sides.ours, *sides.theirs)) return *sides.ours;
        return in_conflict(sides.base ? ConflictKind::both_changed : ConflictKind::both_added,
                           sides, *sides.ours);
    }

private:
    bool is_same_apart_from_coordinates(Entry a, Entry b) const {
        for (Entry* entry : {&a, &b})
            std::erase_if(entry->keys,
                          [&](const Key& key) { return is_coordinate(section_, key); });
        return is_layout(section_) && a == b;
    }

    // One side deleted the entry and the other changed it.
    std::optional<Entry> with_deletion(const ThreeOf<Entry>& sides) {
        const Entry* left = sides.ours ? sides.ours : sides.theirs;
        if (is_same_apart_from_coordinates(*sides.base, *left)) return {};
        return in_conflict(
            sides.ours ? ConflictKind::deleted_by_theirs : ConflictKind::deleted_by_ours, sides,
            *left);
    }

    Entry in_conflict(ConflictKind kind, const ThreeOf<Entry>& sides, const Entry& result) {
        Conflict conflict;
        conflict.kind = kind;
        conflict.section = section_;
        conflict.id = result.id;
        conflict.base = optional_value(sides.base);
        conflict.ours = optional_value(sides.ours);
        conflict.theirs = optional_value(sides.theirs);
        conflicts_.push_back(conflict);
        if (purpose_ == MergePurpose::result) return result;
        return entry_of(section_, result.id, conflict_mark(conflict.ours, conflict.theirs));
    }

    Entry merged_keys(const ThreeOf<Entry>& sides) {
        Entry result;
        result.id = sides.ours->id;
        for (const Key& name :
             merged_order(sides.base->keys, sides.ours->keys, sides.theirs->keys, key_identity)) {
            const ThreeOf<Key> keys{sides.base->find(name), sides.ours->find(name),
                                    sides.theirs->find(name)};
            const ThreeOf<Value> values{keys.base ? &keys.base->value : nullptr,
                                        keys.ours ? &keys.ours->value : nullptr,
                                        keys.theirs ? &keys.theirs->value : nullptr};
            if (auto value = merged_value(result.id, name, values))
                result.keys.push_back({name.is_port, name.name, std::move(*value)});
        }
        return result;
    }

    std::optional<Value> merged_value(const std::string& id, const Key& key,
                                      const ThreeOf<Value>& values) {
        if (const auto side = changed_side(values)) return optional_value(*side);
        if (is_coordinate(section_, key)) return optional_value(values.ours);
        Conflict conflict;
        conflict.section = section_;
        conflict.id = id;
        conflict.key = {key.is_port, key.name, {}};
        conflict.base = optional_value(values.base);
        conflict.ours = optional_value(values.ours);
        conflict.theirs = optional_value(values.theirs);
        conflicts_.push_back(conflict);
        if (purpose_ == MergePurpose::result) return conflict.ours;
        return conflict_mark(conflict.ours, conflict.theirs);
    }

    static std::string key_identity(const Key& key) { return (key.is_port ? "." : ":") + key.name; }

    Section section_;
    MergePurpose purpose_;
    std::vector<Conflict>& conflicts_;
};

std::map<std::string_view, const Entry*> by_id(const std::vector<Entry>& entries) {
    std::map<std::string_view, const Entry*> index;
    for (const Entry& entry : entries)
        index.emplace(entry.id, &entry);
    return index;
}

}  // namespace

std::vector<Entry> merge_section(Section section, const EntriesOfSides& sides, MergePurpose purpose,
                                 std::vector<Conflict>& conflicts) {
    const auto base = by_id(sides.base), ours = by_id(sides.ours), theirs = by_id(sides.theirs);
    const auto find = [](const auto& index, const std::string& id) {
        const auto found = index.find(id);
        return found == index.end() ? nullptr : found->second;
    };
    SectionMerge merge(section, purpose, conflicts);
    std::vector<Entry> result;
    for (const Entry& entry : merged_order(sides.base, sides.ours, sides.theirs,
                                           [](const Entry& each) { return each.id; })) {
        auto merged =
            merge.merged({find(base, entry.id), find(ours, entry.id), find(theirs, entry.id)});
        if (merged) result.push_back(std::move(*merged));
    }
    return result;
}

}  // namespace wrinkle::difference
