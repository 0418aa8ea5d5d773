#include "lower/functions.h"

#include <algorithm>

#include "graph/subgraph.h"
#include "lower/flat.h"
#include "lower/reachable.h"

namespace wrinkle {
namespace {

// Finds the nodes that the outputs need, and the inputs and outputs of files, for all uses of a
// file together.
class Needs {
public:
    explicit Needs(const Project& project) : project_(project) {
        for (const Project::File& file : project.files) {
            const Document& document = file.document;
            files_.push_back({std::vector<bool>(document.nodes.size(), false),
                              std::vector<bool>(document.inputs.size(), false),
                              std::vector<bool>(document.outputs.size(), false),
                              {}});
        }
    }

    struct File {
        std::vector<bool> nodes, inputs, outputs;
        struct Use {
            uint32_t file;
            size_t node;
        };
        std::vector<Use> uses;
    };

    std::vector<File> run(const std::vector<uint32_t>& outputs) {
        for (const uint32_t output : outputs)
            need_output(0, output);
        while (!open_.empty()) {
            const Open open = open_.back();
            open_.pop_back();
            follow(open.file, *open.link);
        }
        return std::move(files_);
    }

private:
    struct Open {
        uint32_t file;
        const Link* link;
    };

    const Document& document(uint32_t file) const { return project_.files[file].document; }

    void need_output(uint32_t file, size_t output) {
        if (output == Table<Output>::npos || files_[file].outputs[output]) return;
        files_[file].outputs[output] = true;
        open_.push_back({file, &document(file).outputs[output].from.link});
    }

    void need_port(uint32_t file, size_t node, std::string_view port) {
        const Input* input = document(file).nodes[node]->find(port);
        if (input && input->kind == Input::Kind::link) open_.push_back({file, &input->link});
    }

    void need_input(uint32_t file, size_t input) {
        if (input == Table<GraphInput>::npos || files_[file].inputs[input]) return;
        files_[file].inputs[input] = true;
        for (const File::Use& use : files_[file].uses)
            need_port(use.file, use.node, document(file).inputs[input].name);
    }

    void follow(uint32_t file, const Link& link) {
        if (link.is_surface()) return;
        if (link.is_input()) return need_input(file, document(file).inputs.index_of(link.port));
        const size_t node = document(file).nodes.index_of(link.node);
        if (node == Table<NodePtr>::npos) return;
        const uint32_t inner = project_.files[file].subgraphs[node];
        const bool opened = inner != Project::File::none && !document(file).nodes[node]->muted;
        if (!files_[file].nodes[node]) {
            files_[file].nodes[node] = true;
            if (opened)
                enter(file, node, inner);
            else
                for (const Input& input : document(file).nodes[node]->inputs)
                    need_port(file, node, input.port);
        }
        if (opened) need_output(inner, document(inner).outputs.index_of(link.port));
    }

    void enter(uint32_t file, size_t node, uint32_t inner) {
        files_[inner].uses.push_back({file, node});
        for (size_t i = 0; i < files_[inner].inputs.size(); ++i)
            if (files_[inner].inputs[i]) need_port(file, node, document(inner).inputs[i].name);
    }

    const Project& project_;
    std::vector<File> files_;
    std::vector<Open> open_;
};

// Returns true for a node that depends on values beyond the boundary of its sub-graph.
bool requires_inlining(const NodeType& type, const Node& node) {
    return std::any_of(type.ports.begin(), type.ports.end(), [&](const Port& port) {
        const bool base = port.name == "base" && port.type == PortType::normal_;
        if (!base && port.kind != Port::Kind::field) return false;
        const Input* input = node.find(port.name);
        return input && input->kind == Input::Kind::link && !input->link.is_surface();
    });
}

class Planner {
public:
    Planner(const Project& project, const Types& types, std::vector<Needs::File> needs)
        : project_(project), types_(types), needs_(std::move(needs)) {}

    FunctionPlan run(uint64_t inline_up_to) {
        plan_.files.resize(project_.files.size());
        for (size_t f = 0; f < needs_.size(); ++f) {
            plan_.files[f].outputs = needs_[f].outputs;
            plan_.files[f].inputs = needs_[f].inputs;
        }
        const std::vector<uint32_t> order = files_in_order(project_);
        if (inlined_node_count(order) <= inline_up_to || any_requires_inlining(order))
            return std::move(plan_);
        std::vector<uint32_t> depth(project_.files.size(), 0);
        for (const uint32_t f : order) {
            uint32_t below = 0;
            each_use(f, [&](uint32_t inner) { below = std::max(below, depth[inner]); });
            plan_.files[f].function = f != 0 && needs_[f].uses.size() > 1 &&
                                      below < FunctionPlan::deepest && of_numbers(f);
            depth[f] = below + (plan_.files[f].function ? 1 : 0);
        }
        return std::move(plan_);
    }

private:
    const Document& document(uint32_t file) const { return project_.files[file].document; }

    template <class Visit>
    void each_use(uint32_t f, Visit visit) const {
        const std::vector<uint32_t>& subgraphs = project_.files[f].subgraphs;
        for (size_t i = 0; i < subgraphs.size(); ++i)
            if (needs_[f].nodes[i] && subgraphs[i] != Project::File::none &&
                !document(f).nodes[i]->muted)
                visit(subgraphs[i]);
    }

    // Returns the number of nodes after complete inlining, each use of a file counted.
    uint64_t inlined_node_count(const std::vector<uint32_t>& order) const {
        std::vector<uint64_t> nodes(project_.files.size(), 0);
        for (const uint32_t f : order) {
            const auto own = std::count(needs_[f].nodes.begin(), needs_[f].nodes.end(), true);
            nodes[f] = static_cast<uint64_t>(own);
            each_use(f, [&](uint32_t inner) { nodes[f] = saturating_sum(nodes[f], nodes[inner]); });
        }
        return nodes[0];
    }

    bool any_requires_inlining(const std::vector<uint32_t>& order) const {
        return std::any_of(order.begin(), order.end(), [&](uint32_t f) {
            for (size_t i = 0; i < needs_[f].nodes.size(); ++i) {
                const NodeType* type = types_.of(f, i);
                if (!needs_[f].nodes[i] || !type || document(f).nodes[i]->subgraph()) continue;
                if (requires_inlining(*type, *document(f).nodes[i])) return true;
            }
            return false;
        });
    }

    bool of_numbers(uint32_t f) const {
        for (size_t i = 0; i < needs_[f].outputs.size(); ++i) {
            if (!needs_[f].outputs[i]) continue;
            const auto type = types_.output(f, document(f).outputs[i]);
            if (!type || *type == PortType::derivative_ || *type == PortType::image_) return false;
        }
        for (size_t i = 0; i < needs_[f].inputs.size(); ++i)
            if (needs_[f].inputs[i] &&
                port_type_named(document(f).inputs[i].type) == PortType::derivative_)
                return false;
        return true;
    }

    const Project& project_;
    const Types& types_;
    const std::vector<Needs::File> needs_;
    FunctionPlan plan_;
};

}  // namespace

FunctionPlan plan_functions(const Project& project, const Types& types, const LowerOptions& options,
                            const std::vector<uint32_t>& outputs) {
    if (project.files.size() == 1) return {{FunctionPlan::File{}}};
    return Planner(project, types, Needs(project).run(outputs)).run(options.inline_up_to);
}

}  // namespace wrinkle
