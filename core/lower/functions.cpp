#include "lower/functions.h"

#include <algorithm>

#include "graph/subgraph.h"
#include "lower/flat.h"
#include "lower/reachable.h"

namespace wrinkle {
namespace {

// Returns true for a node that depends on values beyond the boundary of its sub-graph.
bool requires_inlining(const NodeType& type, const Node& node) {
    return std::any_of(type.ports.begin(), type.ports.end(), [&](const Port& port) {
        if (!is_base(port) && port.kind != Port::Kind::field) return false;
        const Input* input = node.find(port.name);
        return input && input->kind == Input::Kind::link && !input->link.is_surface();
    });
}

class Planner {
public:
    Planner(const Project& project, const Types& types) : project_(project), types_(types) {
        for (const Project::File& file : project.files) {
            const Document& document = file.document;
            FunctionPlan::File& planned = plan_.files.emplace_back();
            planned.inputs.resize(document.inputs.size());
            planned.outputs.resize(document.outputs.size());
            needed_.emplace_back(document.nodes.size());
        }
        uses_.resize(project.files.size());
    }

    FunctionPlan run(uint64_t inline_up_to, const std::vector<uint32_t>& outputs) {
        for (const uint32_t output : outputs)
            need_output(0, output);
        while (!open_.empty()) {
            const auto [file, link] = open_.back();
            open_.pop_back();
            follow(file, *link);
        }
        const std::vector<uint32_t> order = files_in_order(project_);
        if (inlined_node_count(order) <= inline_up_to || any_requires_inlining(order))
            return std::move(plan_);
        std::vector<uint32_t> depth(project_.files.size(), 0);
        for (const uint32_t f : order) {
            uint32_t below = 0;
            each_use(f, [&](uint32_t inner) { below = std::max(below, depth[inner]); });
            plan_.files[f].function =
                f != 0 && uses_[f].size() > 1 && below < FunctionPlan::deepest && of_numbers(f);
            depth[f] = below + (plan_.files[f].function ? 1 : 0);
        }
        return std::move(plan_);
    }

private:
    const Document& document(uint32_t file) const { return project_.files[file].document; }

    // Finds the nodes that the outputs need, and the inputs and outputs of files, for all uses of a
    // file together.
    void need_output(uint32_t file, size_t output) {
        if (output == Table<Output>::npos || plan_.files[file].outputs[output]) return;
        plan_.files[file].outputs[output] = true;
        open_.emplace_back(file, &document(file).outputs[output].from.link);
    }

    void need_port(uint32_t file, size_t node, std::string_view port) {
        const Input* input = document(file).nodes[node]->find(port);
        if (input && input->kind == Input::Kind::link) open_.emplace_back(file, &input->link);
    }

    void need_input(uint32_t file, size_t input) {
        if (input == Table<GraphInput>::npos || plan_.files[file].inputs[input]) return;
        plan_.files[file].inputs[input] = true;
        for (const auto& [user, node] : uses_[file])
            need_port(user, node, document(file).inputs[input].name);
    }

    void follow(uint32_t file, const Link& link) {
        if (link.is_surface()) return;
        if (link.is_input()) return need_input(file, document(file).inputs.index_of(link.port));
        const size_t node = document(file).nodes.index_of(link.node);
        if (node == Table<NodePtr>::npos) return;
        const uint32_t inner = opened(file, node);
        if (!needed_[file][node]) {
            needed_[file][node] = true;
            if (inner != Project::File::none)
                enter(file, node, inner);
            else
                for (const Input& input : document(file).nodes[node]->inputs)
                    need_port(file, node, input.port);
        }
        if (inner != Project::File::none)
            need_output(inner, document(inner).outputs.index_of(link.port));
    }

    void enter(uint32_t file, size_t node, uint32_t inner) {
        uses_[inner].emplace_back(file, node);
        for (size_t i = 0; i < plan_.files[inner].inputs.size(); ++i)
            if (plan_.files[inner].inputs[i]) need_port(file, node, document(inner).inputs[i].name);
    }

    // Returns the file that the node is a use of; none for other nodes and for muted ones.
    uint32_t opened(uint32_t file, size_t node) const {
        return document(file).nodes[node]->muted ? Project::File::none
                                                 : project_.files[file].subgraphs[node];
    }

    template <class Visit>
    void each_use(uint32_t f, Visit visit) const {
        for (size_t i = 0; i < needed_[f].size(); ++i)
            if (needed_[f][i] && opened(f, i) != Project::File::none) visit(opened(f, i));
    }

    // Returns the number of nodes after complete inlining, each use of a file counted.
    uint64_t inlined_node_count(const std::vector<uint32_t>& order) const {
        std::vector<uint64_t> nodes(project_.files.size(), 0);
        for (const uint32_t f : order) {
            nodes[f] = static_cast<uint64_t>(std::ranges::count(needed_[f], true));
            each_use(f, [&](uint32_t inner) { nodes[f] = saturating_sum(nodes[f], nodes[inner]); });
        }
        return nodes[0];
    }

    bool any_requires_inlining(const std::vector<uint32_t>& order) const {
        return std::ranges::any_of(order, [&](uint32_t f) {
            for (size_t i = 0; i < needed_[f].size(); ++i) {
                const NodeType* type = types_.of(f, i);
                if (!needed_[f][i] || !type || document(f).nodes[i]->subgraph()) continue;
                if (requires_inlining(*type, *document(f).nodes[i])) return true;
            }
            return false;
        });
    }

    bool of_numbers(uint32_t f) const {
        const auto& [function, outputs, inputs] = plan_.files[f];
        for (size_t i = 0; i < outputs.size(); ++i) {
            const auto type = types_.output(f, document(f).outputs[i]);
            if (outputs[i] && (!type || *type == PortType::derivative_ ||
                               *type == PortType::image_ || *type == PortType::material_))
                return false;
        }
        for (size_t i = 0; i < inputs.size(); ++i) {
            const auto type = port_type_named(document(f).inputs[i].type);
            if (inputs[i] &&
                (!type || type == PortType::derivative_ || type == PortType::material_))
                return false;
        }
        return true;
    }

    const Project& project_;
    const Types& types_;
    FunctionPlan plan_;
    std::vector<std::vector<bool>> needed_;                       // by file and node
    std::vector<std::vector<std::pair<uint32_t, size_t>>> uses_;  // by file: file and node
    std::vector<std::pair<uint32_t, const Link*>> open_;          // file that has the link
};

}  // namespace

FunctionPlan plan_functions(const Project& project, const Types& types, const LowerOptions& options,
                            const std::vector<uint32_t>& outputs) {
    if (project.files.size() == 1) return {{FunctionPlan::File{}}};
    return Planner(project, types).run(options.inline_up_to, outputs);
}

}  // namespace wrinkle
