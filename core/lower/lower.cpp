#include "lower/lower.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>

#include "base/mapped.h"
#include "base/standard_outputs.h"
#include "ir/normal_variance.h"
#include "lower/call.h"

namespace wrinkle {
namespace {

constexpr size_t instructions_of_a_node = 10;  // estimate, to reserve memory

// Returns the value as an output of the program has it: numbers.
Id as_number(Module& module, PortType type, Id value) {
    if (type == PortType::gradient_) return module.add(Op::gradient_vector_, {value});
    if (type == PortType::derivative_) return module.add(Op::slope_, {value});
    return value;
}

ModuleOutput module_output(Module& module, std::string_view name, PortType type, Id value) {
    ModuleOutput output;
    output.name = output_name(name);
    output.port_type = static_cast<uint32_t>(type);
    output.value = as_number(module, type, value);
    return output;
}

// Writes the channels of a material that the graph has no other output for; without channels its
// color, as a module needs an output.
void write_channels(Lowering& lowering, const Document& document, uint32_t passthrough) {
    Module& module = lowering.module();
    const Id material = lowering.input(passthrough, 0);
    Record record = lowering.records().of(material);
    if (record.empty() && document.outputs.size() == 1)
        record = {{"color", PortType::color_,
                   lowering.records().channel(material, "color", PortType::color_)}};
    for (const Channel& channel : record) {
        if (document.find_output(channel.name)) continue;
        const PortType type = standard_output(channel.name).value_or(channel.type);
        const Id value =
            lowering.convert(channel.value, conversion(channel.type, type), passthrough);
        module.outputs.push_back(module_output(module, channel.name, type, value));
    }
}

void write_outputs(Lowering& lowering, const Document& document) {
    const FlatGraph& graph = lowering.graph();
    for (size_t i = 0; i < graph.outputs.size(); ++i) {
        const uint32_t pass = graph.outputs[i];
        const PortType type = graph.nodes[pass].passthrough->type;
        if (type == PortType::material_) {
            write_channels(lowering, document, pass);
            continue;
        }
        Module& module = lowering.module();
        module.outputs.push_back(module_output(module, document.outputs[graph.output_index[i]].name,
                                               type, lowering.input(pass, 0)));
    }
}

// Selects the outputs of these names in their order; reports an error for an unknown name.
void select_outputs(Module& module, const std::vector<std::string>& names, const Document& document,
                    Diagnostics& diagnostics) {
    std::vector<ModuleOutput> chosen;
    for (const std::string& name : names) {
        const auto found =
            std::ranges::find(module.outputs, output_name(name), &ModuleOutput::name);
        if (found != module.outputs.end())
            chosen.push_back(*found);
        else
            diagnostics.add(unknown_output(
                document, name, mapped<std::string>(module.outputs, &ModuleOutput::name)));
    }
    module.outputs = std::move(chosen);
}

// Lowers the top graph, with a stack of the functions that must be lowered first.
class Lowerer {
public:
    Lowerer(const Project& project, const Types& types, const LowerOptions& options,
            Diagnostics& diagnostics)
        : project_(project),
          types_(types),
          options_(options),
          diagnostics_(diagnostics),
          own_files_(project),
          files_(options.files ? *options.files : own_files_),
          nodes_left_(options.max_nodes),
          facts_(result_.module) {
        result_.module.most_values = options.max_values;
        result_.module.nodes[0].title = result_.module.titles.add(project.top().name);
        result_.places.push_back({});
    }

    Lowered run() {
        try {
            return run_all();
        } catch (const OverLimit& over) {
            diagnostics_.add(over_limit(over, project_, result_.places));
            result_.over_limit = true;
            return std::move(result_);
        }
    }

private:
    Lowered run_all() {
        FlatRoot top;
        top.outputs = requested_outputs(project_.top(), options_, diagnostics_);
        functions_ = plan_functions(project_, types_, options_, top.outputs);
        if (diagnostics_.has_errors() || !open(top, nullptr)) return std::move(result_);
        while (!frames_.empty())
            step();
        const bool inlining_required = functions_.any() && wants_normal_variance(result_.module);
        if (inlining_required && !diagnostics_.has_errors()) return lower_inlined();
        Module& m = result_.module;
        report_problems(m.problems, m, project_, result_.places, diagnostics_);
        if (!options_.outputs.empty() && !diagnostics_.has_errors())
            select_outputs(m, options_.outputs, project_.top(), diagnostics_);
        return std::move(result_);
    }

    // Sentence 3 of the rule in lower/functions.h.
    Lowered lower_inlined() const {
        LowerOptions options = options_;
        options.inline_up_to = std::numeric_limits<uint64_t>::max();
        return Lowerer(project_, types_, options, diagnostics_).run();
    }

    struct Frame {
        FlatGraph graph;
        std::optional<Lowering> lowering;
        size_t next = 0;  // in graph.order
        uint32_t file = 0;
        uint32_t first_input = 0;
        std::vector<OpenInput> leaves;
        uint32_t* region = nullptr;  // functions only: receives its region
    };
    using Variant = std::pair<uint32_t, std::string>;  // file and kinds of arguments

    bool open(FlatRoot root, CallInputs* inputs) {
        auto graph = flatten(project_, types_, functions_, root, nodes_left_, result_);
        if (!graph) return refuse_size();
        nodes_left_ -= std::min(nodes_left_, graph->nodes.size());
        infer_bases(*graph);
        order_nodes(*graph, project_, result_, diagnostics_);
        Module& m = result_.module;
        if (frames_.empty()) m.reserve(graph->nodes.size() * instructions_of_a_node);
        auto frame = std::make_unique<Frame>();
        frame->graph = std::move(*graph);
        frame->file = root.file;
        if (inputs) {
            frame->first_input = add_leaves(m, *inputs);
            frame->leaves = inputs->leaves;
        }
        frame->lowering.emplace(m, frame->graph, project_, files_, options_.srgb,
                                inputs ? &inputs->bound : nullptr);
        frames_.push_back(std::move(frame));
        return true;
    }

    bool refuse_size() {
        diagnostics_.add(
            diagnose(project_.top(), RuleId::over_limit,
                     "the graph needs more than " + std::to_string(options_.max_nodes) + " nodes",
                     "each inlined use of a sub-graph counts"));
        frames_.clear();
        return false;
    }

    void step() {
        Frame& frame = *frames_.back();
        if (frame.next == frame.graph.order.size()) return close();
        const uint32_t node = frame.graph.order[frame.next];
        const FlatNode& flat = frame.graph.nodes[node];
        if (flat.function != FlatNode::none) {
            if (!call(frame, node)) return;
        } else if (flat.is_passthrough()) {
            frame.lowering->input(node, 0);
        } else {
            build_node(*frame.lowering, node);
        }
        ++frame.next;
    }

    // Returns false if the function has to be lowered first.
    bool call(Frame& frame, uint32_t node) {
        Module& m = result_.module;
        const FlatNode& flat = frame.graph.nodes[node];
        m.current_node = flat.instance;
        CallInputs inputs =
            call_inputs(*frame.lowering, node, functions_.files[flat.function].inputs, facts_);
        const auto [variant, added] =
            variants_.try_emplace({flat.function, std::move(inputs.key)}, 0);
        if (added) {
            FlatRoot root{flat.function, flat.instance, m.nodes[flat.instance].path,
                          needed_outputs(flat.function)};
            if (open(std::move(root), &inputs)) frames_.back()->region = &variant->second;
            return false;
        }
        const Id tuple = m.apply_region(variant->second, inputs.arguments);
        const std::vector<uint32_t> outputs = needed_outputs(flat.function);
        for (uint32_t k = 0; k < outputs.size(); ++k)
            take_result(frame, node, outputs[k], m.result(tuple, k));
        m.current_node = 0;
        return true;
    }

    void take_result(Frame& frame, uint32_t node, uint32_t output, Id value) {
        Module& m = result_.module;
        const FlatNode& flat = frame.graph.nodes[node];
        const std::string& name = project_.files[flat.function].document.outputs[output].name;
        const uint32_t port = flat.type->find_output(name);
        if (value != poison) m.named.push_back({value, flat.instance, name, true});
        if (flat.type->ports[port].type == PortType::gradient_)
            value = m.add(Op::gradient_from_volume_, {value}, poison);
        frame.lowering->set_output(node, port, value);
    }

    std::vector<uint32_t> needed_outputs(uint32_t file) const {
        const std::vector<bool>& needed = functions_.files[file].outputs;
        std::vector<uint32_t> outputs;
        for (uint32_t i = 0; i < needed.size(); ++i)
            if (needed[i]) outputs.push_back(i);
        return outputs;
    }

    void close() {
        Frame& frame = *frames_.back();
        if (frame.region)
            *frame.region = make_function(frame);
        else
            write_outputs(*frame.lowering, project_.top());
        frames_.pop_back();
    }

    uint32_t make_function(Frame& frame) {
        Module& m = result_.module;
        const Project::File& file = project_.files[frame.file];
        Region region;
        region.first_input = frame.first_input;
        region.name = file.path.stem().string();
        for (const OpenInput& leaf : frame.leaves)
            region.params.push_back(leaf.type);
        for (size_t i = 0; i < frame.graph.outputs.size(); ++i) {
            const uint32_t pass = frame.graph.outputs[i];
            const PortType type = frame.graph.nodes[pass].passthrough->type;
            const Id value = as_number(m, type, frame.lowering->input(pass, 0));
            region.results.push_back(
                value ? value
                      : m.zero(type == PortType::gradient_ ? Type::vec3_ : value_type(type)));
            region.result_names.push_back(file.document.outputs[frame.graph.output_index[i]].name);
        }
        return m.intern_region(std::move(region));
    }

    const Project& project_;
    const Types& types_;
    const LowerOptions& options_;
    Diagnostics& diagnostics_;
    NamedFiles own_files_;
    NamedFiles& files_;
    size_t nodes_left_;
    Lowered result_;
    ValueAnalysis facts_;
    FunctionPlan functions_;
    std::map<Variant, uint32_t> variants_;  // the open function of each variant
    std::vector<std::unique_ptr<Frame>> frames_;
};

}  // namespace

Lowered lower(const Project& project, const Types& types, const LowerOptions& options,
              Diagnostics& diagnostics) {
    return Lowerer(project, types, options, diagnostics).run();
}

Diagnostic over_limit(const OverLimit& over, const Project& project,
                      const std::vector<NodePlace>& places) {
    return diagnose(project, places[over.node], over.path, RuleId::over_limit, over.message,
                    over.expected);
}

void report_problems(const std::vector<Problem>& problems, const Module& module,
                     const Project& project, const std::vector<NodePlace>& places,
                     Diagnostics& diagnostics) {
    for (const Problem& problem : problems)
        diagnostics.add(diagnose(project, places[problem.node], module.nodes[problem.node].path,
                                 problem.rule, problem.message, problem.expected));
}

}  // namespace wrinkle
