#include "editor/view/edit/edits.h"

#include "base/file.h"
#include "editor/model/document/copies.h"
#include "editor/model/document/field.h"
#include "editor/model/document/folders.h"
#include "editor/model/document/group.h"
#include "editor/model/document/levels.h"
#include "editor/model/document/wiring.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/canvas/new_cards.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"
#include "graph/write.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

std::string free_file(const fs::path& folder) {
    std::error_code ignored;
    std::string name = "group.json";
    for (size_t n = 2; fs::exists(folder / name, ignored); ++n)
        name = "group" + std::to_string(n) + ".json";
    return name;
}

ImVec2 middle_of(const State& state) {
    const std::vector<const Card*> cards = selected_cards(state);
    ImVec2 sum(0, 0);
    for (const Card* card : cards)
        sum = sum + card->at;
    return cards.empty() ? sum : sum * (1 / static_cast<float>(cards.size()));
}

class Ungrouper {
public:
    Ungrouper(const Document& outer, const Node& node, const Document& inner,
              std::vector<Extent> places)
        : result(outer), node_(node), inner_(inner), places_(std::move(places)) {}

    void run(ImVec2 at) {
        std::set<std::string> ids;
        for (const NodePtr& each : inner_.nodes)
            ids.insert(each->id);
        copies = copies_of(inner_, ids, result, [](const Link&) { return true; });
        place(at);
        for (const auto& [old, id] : copies.new_id)
            for (const Input& input : inner_.find(old)->inputs)
                if (input.kind == Input::Kind::link && input.link.is_input())
                    feed(id, input.port, input.link.port);
        lead_out();
        result = remove_node(result, node_.id);
    }

    Document result;
    Copies copies;

private:
    const Node& node_;
    const Document& inner_;
    const std::vector<Extent> places_;

    void place(ImVec2 at) {
        const ImVec2 by = at - around(places_).low;
        std::vector<NodePosition> positions;
        for (size_t i = 0; i < copies.nodes.size(); ++i)
            positions.push_back(
                {copies.nodes[i].id, places_[i].low.x + by.x, places_[i].low.y + by.y});
        result = add_nodes(result, copies.nodes, positions);
    }

    // Connects a port that read an input of the inner graph to that input's source in the outer
    // graph.
    void feed(const std::string& id, const std::string& port, const std::string& name) {
        const Input* given = node_.find(name);
        result = disconnect(result, id, port);
        if (given && given->kind == Input::Kind::link)
            result = connect(result, given->link, id, port);
        else if (result.find(id)->type == reroute_type)
            return;
        else if (given)
            result = set_value(result, id, port, given->value);
        else if (const GraphInput* input = inner_.inputs.find(name))
            feed_default(id, port, *input);
    }

    void feed_default(const std::string& id, const std::string& port, const GraphInput& input) {
        const auto type = port_type_named(input.type);
        if (!input.default_value.is(json::Kind::null)) {
            result = set_value(result, id, port, input.default_value);
        } else if (type == PortType::normal_) {
            result = connect(result, {std::string(Link::surface), "normal"}, id, port);
        } else if (const int lanes = type ? lanes_of(*type) : 0; lanes > 0) {
            result = set_value(result, id, port, literal_of({}, lanes));
        }
    }

    // Returns the source of an output of the node after inlining; std::nullopt if it is not
    // connected.
    std::optional<Link> source_of(const std::string& port) const {
        const Output* output = inner_.outputs.find(port);
        if (!output || output->from.kind != Input::Kind::link) return std::nullopt;
        const Link& link = output->from.link;
        if (link.is_surface()) return link;
        if (link.is_input()) {
            const Input* given = node_.find(link.port);
            const bool fed = given && given->kind == Input::Kind::link;
            return fed ? std::optional(given->link) : std::nullopt;
        }
        const auto copy = copies.new_id.find(link.node);
        if (copy == copies.new_id.end()) return std::nullopt;
        return Link{copy->second, link.port};
    }

    void lead_out() {
        const Document before = result;
        each_wire(before, [&](const Connection& wire) {
            if (wire.from.node != node_.id) return;
            if (const auto source = source_of(wire.from.port))
                result = with_wire(result, *source, wire.node, wire.port);
        });
    }
};

}  // namespace

const Node* selected_node(const State& state) {
    return state.view.selected.size() == 1 ? state.document().find(*state.view.selected.begin())
                                           : nullptr;
}

const Node* selected_group(const State& state) {
    const Node* node = selected_node(state);
    return node && node->subgraph() ? node : nullptr;
}

void open_selected_group(State& state) {
    if (const Node* node = selected_group(state))
        open_group(state, *node);
    else
        state.status = "Select one node that is a sub-graph.";
}

void group_selected(State& state) {
    if (state.path.empty()) {
        state.status = "Save the graph first; the group becomes a file in the same folder.";
        return;
    }
    const std::string file = free_file(state.folder());
    std::string why;
    const auto group = make_group(state.model, state.document(), state.view.selected, file, why);
    if (!group) {
        state.status = why;
        return;
    }
    if (!write_file(state.folder() / file, canonical_text(group->inner), why)) {
        state.status = file + " was not written: " + disk_words(why) + ".";
        return;
    }
    // The type of the new file's node is known only with the next model; the card without it has
    // the same width.
    const ImVec2 at = free_place(state, state.document(), middle_of(state),
                                 *group->outer.find(group->node), nullptr, state.view.selected);
    state.commit("Group in " + file,
                 settled(state, move_node(group->outer, group->node, at.x, at.y)));
    show_new(state, {group->node});
}

void ungroup_selected(State& state) {
    const Node* node = selected_node(state);
    const Project::File* file = node ? state.model.project->subgraph(0, node->id) : nullptr;
    if (!file) {
        state.status = "Select one node that is a sub-graph.";
        return;
    }
    if (node->muted) {
        state.status = node->id + " is muted. Unmute it first.";
        return;
    }
    if (file->path.parent_path() != state.model.project->files[0].path.parent_path()) {
        state.status = file->path.filename().string() +
                       " is in another folder; what it names would not be found from here.";
        return;
    }
    const Card* card = state.layout.find(node->id);
    Ungrouper ungrouper(state.document(), *node, file->document,
                        places_off_canvas(state, file->document));
    ungrouper.run(card ? card->at : ImVec2(0, 0));
    std::set<std::string> fresh;
    for (const auto& [old, id] : ungrouper.copies.new_id)
        fresh.insert(id);
    state.commit("Ungroup " + node->id,
                 without_invalid_links(ungrouper.result, fresh, state.folder(), *state.registry));
    show_new(state, fresh);
}

}  // namespace wrinkle::editor
