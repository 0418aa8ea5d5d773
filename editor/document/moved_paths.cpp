#include "editor/document/moved_paths.h"

#include <algorithm>

#include "base/file.h"
#include "graph/edit.h"
#include "lower/literal.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

json::Value with_file(const json::Value& value, const std::string& file) {
    if (value.is(json::Kind::string)) return json::Value::string(file);
    std::vector<std::pair<std::string, json::Value>> members;
    for (const json::Member& member : value.children())
        members.emplace_back(member.key,
                             member.key == "file" ? json::Value::string(file) : member.value);
    return json::Value::object(members);
}

class Mover {
public:
    Mover(MovedPaths& result, const fs::path& from, const fs::path& to)
        : result_(result), from_(real_path(from)), to_(real_path(to)) {}

    bool stays() const { return from_ == to_; }

    // The name from the new folder.
    std::string moved(const std::string& name) {
        if (name.empty() || name.find('\0') != name.npos) return name;
        const fs::path file = (from_ / name).lexically_normal();
        if (inside(from_, file) && !inside(to_, file)) {
            auto& outside = result_.outside;
            if (std::find(outside.begin(), outside.end(), name) == outside.end())
                outside.push_back(name);
        }
        return fs::path(name).is_absolute() ? name : file.lexically_relative(to_).string();
    }

    json::Value moved_image(const json::Value& value) {
        const std::string name(literal_image(value).file);
        const std::string to = moved(name);
        return to == name ? value : with_file(value, to);
    }

private:
    MovedPaths& result_;
    const fs::path from_, to_;
};

}  // namespace

MovedPaths move_paths(const Document& document, const Model& model, const fs::path& from,
                      const fs::path& to) {
    constexpr std::string_view prefix = "graph:";
    MovedPaths result{document, {}};
    Mover mover(result, from, to);
    if (mover.stays()) return result;
    for (const NodePtr& node : document.nodes) {
        if (const auto file = node->subgraph())
            result.document =
                set_type(result.document, node->id,
                         std::string(prefix) + mover.moved(std::string(*file)), node->version);
        const NodeType* type = model.type_of(node->id);
        for (const Input& input : node->inputs) {
            const uint32_t port = type ? type->find_input(input.port) : NodeType::none;
            if (port == NodeType::none || type->ports[port].type != PortType::image_ ||
                input.kind != Input::Kind::literal)
                continue;
            result.document =
                set_value(result.document, node->id, input.port, mover.moved_image(input.value));
        }
    }
    for (GraphInput input : document.inputs) {
        if (port_type_named(input.type) != PortType::image_) continue;
        input.default_value = mover.moved_image(input.default_value);
        result.document = set_graph_input(result.document, std::move(input));
    }
    return result;
}

}  // namespace wrinkle::editor
