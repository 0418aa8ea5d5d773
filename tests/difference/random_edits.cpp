#include "difference/random_edits.h"

#include <random>

namespace wrinkle::test {
namespace {

enum Side { ours, theirs, side_count };

std::string quoted(const std::string& text) {
    return "\"" + text + "\"";
}

class Generator {
public:
    explicit Generator(unsigned seed) : random_(seed) {}

    EditPair pair() {
        make_base();
        for (Model* model : {&pair_.ours, &pair_.theirs, &pair_.expected})
            *model = pair_.base;
        for (int i = 0, count = 4 + below(12); i < count; ++i)
            edit();
        apply_renames();
        return std::move(pair_);
    }

private:
    int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    Side side() { return static_cast<Side>(below(side_count)); }
    std::string number() { return std::to_string(++numbers_) + ".5"; }
    std::string node(int i) { return "n" + std::to_string(i); }
    std::string wire_to(int i) {
        return "{ \"from\": " + quoted(node(i) + ".out" + std::to_string(below(3))) + " }";
    }
    Model& of(Side which) { return which == ours ? pair_.ours : pair_.theirs; }
    static Side other(Side which) { return which == ours ? theirs : ours; }

    void make_base() {
        nodes_ = 6 + below(10);
        for (int i = 0; i < nodes_; ++i) {
            ModelKeys& keys = pair_.base["nodes"][node(i)];
            keys["type"] = quoted("type" + std::to_string(below(4)));
            keys["in.tag"] = number();  // nodes are different
            for (int port = 0, count = below(4); port < count; ++port)
                keys["in.p" + std::to_string(port)] =
                    i > 0 && below(2) ? wire_to(below(i)) : number();
            pair_.base["positions"][node(i)][""] = "[ " + number() + ", 0 ]";
        }
        for (const char* name : {"normal", "color", "height"})
            pair_.base["outputs"][name][""] = wire_to(below(nodes_));
        for (const char* name : {"wear", "age"})
            pair_.base["inputs"][name] = {{"type", "\"float\""}, {"default", number()}};
        pair_.base["presets"]["Old"] = {{"wear", number()}};
    }

    bool is_read(const std::string& id) const {
        for (const Model* model : {&pair_.base, &pair_.ours, &pair_.theirs})
            for (const auto& [section, entries] : *model)
                for (const auto& [entry, keys] : entries)
                    for (const auto& [key, value] : keys)
                        if (value.find(quoted(id).substr(0, id.size() + 1) + ".") != value.npos)
                            return true;
        return false;
    }

    // Returns true once for a key: no two edits concern it.
    bool take(const std::string& section, const std::string& id, const std::string& key) {
        return taken_.insert(section + "/" + id + "/" + key).second;
    }
    bool is_touched(const std::string& section, const std::string& id) const {
        const auto found = taken_.lower_bound(section + "/" + id + "/");
        return found != taken_.end() && found->starts_with(section + "/" + id + "/");
    }

    void log(Side which, const std::string& line) {
        pair_.log.push_back((which == ours ? "ours: " : "theirs: ") + line);
    }
    // Sets a key, or removes it for "".
    static void set(Model& model, const std::string& section, const std::string& id,
                    const std::string& key, const std::string& value) {
        if (value.empty())
            model[section][id].erase(key);
        else
            model[section][id][key] = value;
    }

    struct Cell {
        std::string section, id, key, value;
    };

    // A random new value of a key that exists or not.
    Cell cell() {
        switch (below(9)) {
            case 0:
                return {"outputs", below(2) ? "normal" : "roughness", "", wire_to(live_node())};
            case 1:
                return {"inputs", "wear", below(2) ? "default" : "step", number()};
            case 2:
                return {"presets", "Old", below(2) ? "wear" : "age", number()};
            default:
                break;
        }
        const int i = below(nodes_);
        const std::string port = "in.p" + std::to_string(below(6));
        switch (below(6)) {
            case 0:
                return {"nodes", node(i), "type", quoted("other" + number())};
            case 1:
                return {"nodes", node(i), "muted", "true"};
            case 2:
                return {"nodes", node(i), "mine", "[ " + number() + " ]"};  // an unknown key
            case 3:
                return {"nodes", node(i), port, ""};
            case 4:
                if (i > 0) {
                    const int source = below(i);
                    if (!gone_.contains(node(source)))
                        return {"nodes", node(i), port, wire_to(source)};
                }
                [[fallthrough]];
            default:
                return {"nodes", node(i), port, number()};
        }
    }
    int live_node() {
        for (;;)
            if (const int i = below(nodes_); !gone_.contains(node(i))) return i;
    }

    // Edits of a node that a side deleted or renamed are left to the other side.
    bool may_set(Side which, const Cell& cell) {
        if (gone_.contains(cell.id)) return false;
        if (cell.section == "nodes" && renamed_[which].contains(cell.id)) return false;
        const ModelSection& entries = pair_.base.at(cell.section);
        const auto entry = entries.find(cell.id);
        const ModelKeys keys = entry == entries.end() ? ModelKeys() : entry->second;
        const auto old = keys.find(cell.key);
        for (const auto& [id, new_id] : renamed_[which]) {
            if (old != keys.end() &&
                old->second.find(quoted(id).substr(0, id.size() + 1) + ".") != std::string::npos)
                return false;
        }
        return (old == keys.end() ? "" : old->second) != cell.value;  // it is a change
    }

    void edit() {
        switch (below(12)) {
            case 0:
                return add_node();
            case 1:
                return remove_node();
            case 2:
                return rename_node();
            case 3:
                return conflict_of_values();
            case 4:
                return conflict_of_deletion();
            case 5:
                return conflict_of_additions();
            case 6:
                return same_edit();
            case 7:
                return move_node();
            default:
                return set_value();
        }
    }

    void set_value() {
        const Side which = side();
        const Cell c = cell();
        if (!may_set(which, c) || !take(c.section, c.id, c.key)) return;
        log(which, c.id + " " + c.key + " = " + c.value);
        set(of(which), c.section, c.id, c.key, c.value);
        set(pair_.expected, c.section, c.id, c.key, c.value);
    }

    void same_edit() {
        const Cell c = cell();
        if (!may_set(ours, c) || !may_set(theirs, c) || !take(c.section, c.id, c.key)) return;
        log(ours, "and theirs: " + c.id + " " + c.key + " = " + c.value);
        for (Model* model : {&pair_.ours, &pair_.theirs, &pair_.expected})
            set(*model, c.section, c.id, c.key, c.value);
    }

    void conflict_of_values() {
        const Cell c = cell();
        if (c.key == "muted" || !may_set(ours, c) || !may_set(theirs, c)) return;
        if (!take(c.section, c.id, c.key)) return;
        const std::string another = c.key.empty()     ? "{ \"from\": \"input.age\" }"
                                    : c.key == "type" ? quoted("other" + number())
                                                      : number();
        log(ours, "conflict: " + c.id + " " + c.key + " = " + c.value);
        log(theirs, "conflict: " + c.id + " " + c.key + " = " + another);
        set(pair_.ours, c.section, c.id, c.key, c.value);
        set(pair_.theirs, c.section, c.id, c.key, another);
        set(pair_.expected, c.section, c.id, c.key, c.value);
        pair_.conflicts.emplace(c.section, c.id, c.key);
    }

    void add_node() {
        const Side which = side();
        const std::string id = "new" + number().substr(0, 2) + std::to_string(++added_);
        const ModelKeys keys = {
            {"type", "\"added\""}, {"in.tag", number()}, {"in.p0", wire_to(live_node())}};
        log(which, "adds " + id);
        for (Model* model : {&of(which), &pair_.expected}) {
            (*model)["nodes"][id] = keys;
            (*model)["positions"][id][""] = "[ 1, 2 ]";
            if (which == ours)
                (*model)["outputs"][id][""] = "{ \"from\": " + quoted(id + ".x") + " }";
        }
    }

    // Returns a node that no edit concerns and no wire reads, which may be deleted; "" without one.
    std::string free_node() {
        const std::string id = node(below(nodes_));
        const bool is_free = !gone_.contains(id) && !renamed_[ours].contains(id) &&
                             !renamed_[theirs].contains(id) && !is_touched("nodes", id) &&
                             !is_touched("positions", id) && !is_read(id);
        return is_free ? id : "";
    }
    static void erase_node(Model& model, const std::string& id) {
        model["nodes"].erase(id);
        model["positions"].erase(id);
    }

    void remove_node() {
        const std::string id = free_node();
        if (id.empty()) return;
        const Side which = side();
        log(which, "deletes " + id);
        gone_.insert(id);
        erase_node(of(which), id);
        erase_node(pair_.expected, id);
        if (below(3) == 0) erase_node(of(other(which)), id);
    }

    void conflict_of_deletion() {
        const std::string id = free_node();
        if (id.empty()) return;
        const Side which = side();
        log(which, "deletes " + id + ", which the other changes");
        gone_.insert(id);
        erase_node(of(which), id);
        for (Model* model : {&of(other(which)), &pair_.expected})
            (*model)["nodes"][id]["in.tag"] = std::to_string(numbers_ + 1) + ".5";
        ++numbers_;
        pair_.expected["positions"].erase(id);  // the deletion of an unchanged position
        pair_.conflicts.emplace("nodes", id, "");
    }

    void conflict_of_additions() {
        const std::string id = "both" + std::to_string(++added_);
        log(ours, "and theirs add " + id);
        for (Model* model : {&pair_.ours, &pair_.theirs})
            (*model)["nodes"][id] = {{"type", "\"added\""}, {"in.tag", number()}};
        pair_.expected["nodes"][id] = pair_.ours["nodes"][id];
        pair_.conflicts.emplace("nodes", id, "");
    }

    void move_node() {
        const Side which = side();
        const int i = below(nodes_);
        if (gone_.contains(node(i)) || !take("positions", node(i), "")) return;
        const std::string place = "[ " + number() + ", 5 ]";
        log(which, "moves " + node(i));
        set(of(which), "positions", node(i), "", place);
        set(pair_.expected, "positions", node(i), "", place);
        if (below(2))  // both do: ours wins
            set(of(other(which)), "positions", node(i), "", which == ours ? "[ 0, 7 ]" : place);
    }

    // Returns false for keys of deleted entries.
    static bool was_changed(const Model& model, const std::string& section, const std::string& id,
                            const std::string& key, const std::string& value) {
        const auto entry = model.at(section).find(id);
        if (entry == model.at(section).end()) return false;
        const auto found = entry->second.find(key);
        return found == entry->second.end() || found->second != value;
    }

    // A side that renames a node does not change it or its wires.
    void rename_node() {
        const Side which = side();
        const std::string id = node(below(nodes_));
        if (gone_.contains(id) || renamed_[ours].contains(id) || renamed_[theirs].contains(id))
            return;
        if (of(which)["nodes"][id] != pair_.base["nodes"][id]) return;
        const std::string begin = quoted(id).substr(0, id.size() + 1) + ".";
        for (const auto& [section, entries] : pair_.base)
            for (const auto& [entry, keys] : entries)
                for (const auto& [key, value] : keys)
                    if (value.find(begin) != value.npos &&
                        was_changed(of(which), section, entry, key, value))
                        return;
        renamed_[which][id] = "renamed_" + id;
        log(which, "renames " + id);
    }

    static Model with_renames(const Model& model,
                              const std::map<std::string, std::string>& renames) {
        Model result;
        for (const auto& [section, entries] : model)
            for (const auto& [id, keys] : entries) {
                const auto renamed =
                    section == "nodes" || section == "positions" ? renames.find(id) : renames.end();
                ModelKeys& changed =
                    result[section][renamed == renames.end() ? id : renamed->second];
                for (auto [key, value] : keys) {
                    for (const auto& [old_id, new_id] : renames)
                        if (const size_t at = value.find("\"" + old_id + "."); at != value.npos) {
                            value.replace(at + 1, old_id.size(), new_id);
                            break;
                        }
                    changed[key] = value;
                }
            }
        return result;
    }

    void apply_renames() {
        std::map<std::string, std::string> all = renamed_[ours];
        all.insert(renamed_[theirs].begin(), renamed_[theirs].end());
        pair_.ours = with_renames(pair_.ours, renamed_[ours]);
        pair_.theirs = with_renames(pair_.theirs, renamed_[theirs]);
        pair_.expected = with_renames(pair_.expected, all);
        std::set<ModelConflict> conflicts;
        for (auto [section, id, key] : pair_.conflicts) {
            if (section == "nodes" && all.contains(id)) id = all[id];
            conflicts.emplace(section, id, key);
        }
        pair_.conflicts = conflicts;
    }

    std::mt19937 random_;
    EditPair pair_;
    int nodes_ = 0, numbers_ = 0, added_ = 0;
    std::set<std::string> taken_, gone_;
    std::map<std::string, std::string> renamed_[side_count];
};

}  // namespace

EditPair random_edits(unsigned seed) {
    return Generator(seed).pair();
}

}  // namespace wrinkle::test
