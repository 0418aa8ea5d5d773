#include "editor/model/document/request.h"

#include <set>

#include "editor/model/document/wiring.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

bool has_normal(PortType type) {
    return type == PortType::gradient_ || type == PortType::normal_ || type == PortType::height_ ||
           type == PortType::derivative_ || type == PortType::float_;
}

void wire(Node& node, const char* port, Link from) {
    node.inputs.push_back({port, Input::Kind::link, std::move(from), {}});
}

// Adds a node and returns its id.
std::string add(Document& document, Node node) {
    std::string id = node.id;
    document = add_node(document, std::move(node));
    return id;
}

Document with_outputs(Document document, const std::vector<std::pair<std::string, Link>>& wanted) {
    document.outputs = Table<Output>();
    for (const auto& [name, from] : wanted)
        document = set_output(document, name, from);
    return document;
}

// Builds the other side of a comparison with a blend.
class Blend {
public:
    Blend(const Document& document, std::string choice)
        : result_{document, {}, 0, {}}, choice_(std::move(choice)) {}

    Requested run() {
        const Output* normal = result_.document.find_output("normal");
        if (normal && normal->from.kind == Input::Kind::link) find_sums(normal->from.link.node);
        if (result_.replaced == 0) {
            result_.why_not = "The normal depends on no sum of bumps, so there is none to replace.";
            return std::move(result_);
        }
        const Document before = result_.document;
        for (const NodePtr& node : before.nodes)
            if (const auto twin = twins_.find(node->id); twin != twins_.end())
                sums_.contains(node->id) ? replace(*node, twin->second) : copy(*node, twin->second);
        result_.document = set_output(result_.document, against_output, other(normal->from.link));
        return std::move(result_);
    }

private:
    // Finds the sums that `end` depends on, and names a copy of each node from them to `end`.
    void find_sums(const std::string& end) {
        const Document& document = result_.document;
        const std::set<std::string> before = reachable(document, {end}, Direction::upstream);
        for (const NodePtr& node : document.nodes)
            if (node->type == "gradient_add" && !node->muted && before.contains(node->id))
                sums_.insert(node->id);
        std::set<std::string> taken;
        for (const std::string& sum : sums_)
            for (const std::string& after : reachable(document, {sum}, Direction::downstream)) {
                if (!before.contains(after) || twins_.contains(after)) continue;
                twins_[after] = free_id(document, after + "_against", taken);
                taken.insert(twins_[after]);
            }
        result_.replaced = sums_.size();
    }

    Link other(const Link& link) const {
        const auto twin = twins_.find(link.node);
        return twin == twins_.end() ? link : Link{twin->second, link.port};
    }

    void copy(const Node& node, const std::string& twin) {
        Node copied = node;
        copied.id = twin;
        for (Input& input : copied.inputs)
            if (input.kind == Input::Kind::link) input.link = other(input.link);
        result_.copied[twin] = node.id;
        add(result_.document, std::move(copied));
    }

    void replace(const Node& sum, const std::string& twin) {
        Node blend = new_node(result_.document, twin, "compare_bump_blend");
        blend.id = twin;
        for (const char* port : {"a", "b"})
            if (const Input* input = sum.find(port); input && input->kind == Input::Kind::link)
                wire(blend, port, other(input->link));
        blend.inputs.push_back({"blend", Input::Kind::literal, {}, json::Value::string(choice_)});
        add(result_.document, std::move(blend));
    }

    Requested result_;
    std::string choice_;
    std::set<std::string> sums_;
    std::map<std::string, std::string> twins_;
};

// Adds the other normal from the value of a link.
void add_against(Requested& result, const Link& from, std::optional<PortType> type) {
    Document& document = result.document;
    if (!type || !has_normal(*type)) {
        result.why_not = from.text() + " has no normal to compare with.";
        return;
    }
    Node resolved = new_node(document, "against", "resolve");
    wire(resolved, "gradient", from);
    const Link normal =
        *type == PortType::normal_ ? from : Link{add(document, std::move(resolved)), "normal"};
    document = set_output(document, against_output, normal);
}

void show_node(Requested& result, const Model& model, const std::string& id) {
    const Port* port = shown_port(model.type_of(id));
    if (!port) {
        result.why_not = id + " makes nothing that can be shown on a surface.";
        return;
    }
    const Link from{id, port->name};
    const PortType what = model.type_of(from).value_or(PortType::normal_);
    if (what == PortType::material_)
        result.document = with_outputs(result.document, {{"material", from}});
    else if (what == PortType::color_ || what == PortType::vec3_)
        result.document = with_outputs(result.document, {{"color", from}});
    else if (what == PortType::height_ || what == PortType::float_)
        result.document = with_outputs(result.document, {{"normal", from}, {"height", from}});
    else
        result.document = with_outputs(result.document, {{"normal", from}});
}

}  // namespace

const Port* shown_port(const NodeType* type) {
    const Port* best = first_output(
        type, {PortType::gradient_, PortType::normal_, PortType::height_, PortType::color_});
    if (best) return best;
    return first_output(
        type, {PortType::derivative_, PortType::float_, PortType::vec3_, PortType::material_});
}

Requested requested_document(const Document& document, const Model& model,
                             const PreviewRequest& request) {
    Requested result{document, {}, 0, {}};
    if (!request.node.empty()) show_node(result, model, request.node);
    if (!result.why_not.empty()) return result;
    switch (request.against) {
        case Against::nothing:
            break;
        case Against::output:
            if (const Output* output = document.outputs.find(request.name))
                add_against(result, output->from.link, model.type_of(output->from.link));
            else
                result.why_not = "The graph has no output " + request.name + ".";
            break;
        case Against::node: {
            const Port* port = shown_port(model.type_of(request.name));
            const Link from{request.name, port ? port->name : ""};
            add_against(result, from, model.type_of(from));
            break;
        }
        case Against::blend:
            return Blend(result.document, request.name).run();
    }
    return result;
}

}  // namespace wrinkle::editor
