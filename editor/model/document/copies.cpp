#include "editor/model/document/copies.h"

#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

// Returns "noise" for "noise12", so that a copy of a copy is "noise13".
std::string stem_of(std::string_view id) {
    const size_t last = id.find_last_not_of("0123456789");
    return std::string(last == id.npos ? id : id.substr(0, last + 1));
}

}  // namespace

Copies copies_of(const Document& source, const std::set<std::string>& ids, const Document& target,
                 const std::function<bool(const Link&)>& keep) {
    Copies copies;
    std::set<std::string> taken;
    std::vector<Node> nodes;
    for (const NodePtr& node : source.nodes) {
        if (!ids.contains(node->id)) continue;
        Node copy = *node;
        copy.id = free_id(target, stem_of(node->id), taken);
        taken.insert(copy.id);
        copies.new_id[node->id] = copy.id;
        nodes.push_back(std::move(copy));
    }
    Document work = add_nodes({}, std::move(nodes), {});
    for (const auto& [old, id] : copies.new_id)
        for (const Input& input : source.find(old)->inputs) {
            if (input.kind != Input::Kind::link) continue;
            const auto inside = copies.new_id.find(input.link.node);
            if (inside != copies.new_id.end())
                work = connect(work, {inside->second, input.link.port}, id, input.port);
            else if (!keep(input.link))
                work = disconnect(work, id, input.port);
        }
    for (const NodePtr& node : work.nodes)
        copies.nodes.push_back(*node);
    return copies;
}

}  // namespace wrinkle::editor
