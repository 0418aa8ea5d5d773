#include "lower/check.h"

#include <algorithm>
#include <functional>

#include "base/text.h"
#include "graph/named_files.h"
#include "graph/order.h"
#include "lower/conversion.h"
#include "lower/flat.h"
#include "lower/literal.h"
#include "lower/named_images.h"
#include "lower/reachable.h"
#include "registry/reference.h"

namespace wrinkle {
namespace {

std::string join(std::span<const std::string> names) {
    return joined(names, ", ");
}

std::string in_quotes(std::string_view name) {
    return "'" + std::string(name) + "'";
}

// The checks of one file.
class Checker {
public:
    Checker(const Project& project, const Registry& registry, const Types& types, size_t file,
            NamedFiles& files, Diagnostics& diagnostics)
        : project_(project),
          registry_(registry),
          types_(types),
          file_(file),
          document_(project.files[file].document),
          diagnostics_(diagnostics),
          files_(files) {}

    void node(size_t index) {
        const Node& node = *document_.nodes[index];
        const NodeType* type = types_.of(file_, index);
        if (!type) return unknown_type(node);
        version(node, *type);
        const std::span<const NamedInput> named = types_.inputs(file_, index);
        for (size_t i = 0; i < named.size(); ++i)
            input(node, *type, node.inputs[i], named[i]);
        for (const Port& port : type->ports)
            required(node, index, port);
        warn_of_projection(document_, node, *type, registry_, diagnostics_);
    }

    void graph_input(size_t index) {
        const GraphInput& input = document_.inputs[index];
        const std::string subject = "input " + in_quotes(input.name) + " ";
        const auto type = port_type_named(input.type);
        if (!type && !option_kind(input.type)) {
            const auto words = port_type_names();
            std::vector<std::string> names(words.begin(), words.end());
            names.insert(names.end(), option_type_names.begin(), option_type_names.end());
            return report(diagnose(document_, input, RuleId::input_type,
                                   subject + "has the unknown type " + json_quoted(input.type),
                                   did_you_mean(input.type, names, "expected " + join(names))));
        }
        const Port& port = types_.graph_input(file_, index);
        check_keys(document_, input, port, diagnostics_);
        if (input.default_value.is(json::Kind::null)) {
            if (port.is_option())
                report(diagnose(document_, input, RuleId::input_type,
                                subject + "is a " + input.type + " and has no default",
                                "it is known while compiling"));
            else if (*type == PortType::image_ && file_ == 0)
                report(diagnose(document_, input, RuleId::input_type,
                                subject + "is an image and has no default",
                                "expected \"default\": a path"));
            return;
        }
        if (is_of_preset(input.default_value)) return;
        const auto here = [&](RuleId rule, std::string message, std::string expected) {
            return diagnose(document_, input, rule, std::move(message), std::move(expected));
        };
        literal(
            input.default_value, port, [&] { return subject; }, "", here);
    }

    void preset(const Preset& preset) {
        for (const Extra& value : preset.values) {
            const std::string subject =
                "preset " + in_quotes(preset.name) + ", input " + in_quotes(value.key) + " ";
            const size_t index = document_.inputs.index_of(value.key);
            const auto here = [&](RuleId rule, std::string message, std::string expected) {
                return value.value.has_location()
                           ? diagnose(value.value, "", rule, std::move(message),
                                      std::move(expected))
                           : diagnose(document_, rule, std::move(message), std::move(expected));
            };
            if (index == Table<GraphInput>::npos)
                no_input(value.key, subject, here);
            else if (port_type_named(document_.inputs[index].type) ||
                     option_kind(document_.inputs[index].type))
                literal(
                    value.value, types_.graph_input(file_, index), [&] { return subject; }, "",
                    here);
        }
    }

    void output(const Output& output) {
        const auto here = [&](RuleId rule, std::string message, std::string expected) {
            return diagnose(document_, output, rule, std::move(message), std::move(expected));
        };
        if (const Output* first = document_.find_output(output.name); first != &output)
            report(here(RuleId::unknown_output,
                        "output " + in_quotes(output.name) + " is another name of " +
                            in_quotes(first->name) + ", which the graph has too",
                        "remove one of them"));
        if (output.from.kind != Input::Kind::link) return;
        const Link& link = output.from.link;
        const auto from = source(link, types_.source(file_, link), here);
        if (!from) return;
        const PortType to = standard_output(output.name).value_or(*from);
        const std::string subject = "output " + in_quotes(output.name) + " ";
        if (conversion(*from, to) == Conversion::illegal)
            report(here(RuleId::type_mismatch, mismatch(subject, link, *from, to),
                        alternative(*from, to, registry_)));
        else if (to == PortType::material_ && file_ == 0 && output.name != material_output)
            report(here(RuleId::type_mismatch, subject + "is a material",
                        "name it 'material'; each of its channels is then an output"));
        else if (to == PortType::image_ && file_ == 0)
            report(here(RuleId::type_mismatch, subject + "is an image",
                        "sample it; an output is a value"));
    }

private:
    // Problems beyond the limit of the list are only counted; returns true for them.
    bool only_count() {
        if (diagnostics_.dropped() == 0) return false;
        diagnostics_.add({});
        return true;
    }
    void report(Diagnostic diagnostic) { diagnostics_.add(std::move(diagnostic)); }

    // True for a default that is a preset's value; it is checked there.
    bool is_of_preset(const json::Value& value) const {
        return std::ranges::any_of(document_.presets, [&](const Preset& preset) {
            return std::ranges::any_of(preset.values,
                                       [&](const Extra& each) { return each.value.same(value); });
        });
    }

    // Reports a preset's value for `key`, which no input has as its name.
    template <class Diagnose>
    void no_input(const std::string& key, const std::string& subject, Diagnose here) {
        if (only_count()) return;
        const std::string twice = set_twice(key, document_.inputs);
        const std::vector<std::string> names = keys_of(document_.inputs);
        report(twice.empty() ? here(RuleId::unknown_input, subject + "does not exist",
                                    did_you_mean(key, names, "the graph has " + join(names)))
                             : here(RuleId::former_name, subject + twice, set_once));
    }

    void unknown_type(const Node& node) {
        const Input* rerouted = node.type == reroute_type ? node.find("in") : nullptr;
        if (rerouted && rerouted->link.is_input())
            source(rerouted->link, {}, [&](RuleId rule, std::string message, std::string expected) {
                return diagnose_port(document_, node, "in", rule, std::move(message),
                                     std::move(expected));
            });
        const bool reported_elsewhere =
            node.type.empty() || node.subgraph() || node.type == reroute_type;
        if (reported_elsewhere || only_count()) return;
        if (ids_.empty()) {
            ids_ = registry_.ids();
            ids_.emplace_back(reroute_type);
        }
        const std::string near = nearest(node.type, ids_);
        report(diagnose(
            document_, node, RuleId::unknown_node_type, "unknown node type " + in_quotes(node.type),
            near.empty() ? "a plugin may be missing; 'wrinkle plugins' lists those found"
                         : "did you mean '" + near + "', or is a plugin missing?"));
    }

    void version(const Node& node, const NodeType& type) {
        const auto made_for = static_cast<uint32_t>(node.version);
        if (made_for == type.version) return;
        const std::string text = "made for version " + std::to_string(made_for) + " of " +
                                 in_quotes(node.type) + "; this program has version " +
                                 std::to_string(type.version);
        report(diagnose(document_, node, RuleId::node_version, text,
                        made_for > type.version ? "a newer program or plugin is needed"
                                                : "'wrinkle upgrade' migrates it"));
    }

    void input(const Node& node, const NodeType& type, const Input& input,
               const NamedInput& named) {
        if (named.port == NodeType::none) return unknown_port(node, type, input);
        const Port& port = type.ports[named.port];
        const auto subject = [&] { return "port " + in_quotes(port.name) + " "; };
        const auto here = [&](RuleId rule, std::string message, std::string expected) {
            return diagnose_port(document_, node, input.port, rule, std::move(message),
                                 std::move(expected));
        };
        if (input.kind == Input::Kind::literal)
            literal(input.value, port, subject, node.id, here);
        else if (input.kind == Input::Kind::link)
            wire(input.link, named.source, port, subject, here);
    }

    void unknown_port(const Node& node, const NodeType& type, const Input& input) {
        if (only_count()) return;
        const Project::File* inner = project_.subgraph(file_, node.id);
        const std::string twice = inner ? set_twice(input.port, inner->document.inputs) : "";
        std::string expected = twice.empty() ? "" : set_once;
        for (const Rename& rename : type.renames)
            if (rename.old_name == input.port)
                expected = "since version " + std::to_string(rename.version) + " it is '" +
                           rename.new_name + "'; 'wrinkle upgrade' renames it";
        const std::vector<std::string> names = port_names(type, false);
        if (expected.empty())
            expected = did_you_mean(input.port, names,
                                    names.empty() ? "it has no inputs" : "it has " + join(names));
        const std::string name = in_quotes(input.port);
        report(diagnose_port(document_, node, input.port, RuleId::unknown_port,
                             twice.empty() ? "unknown port " + name : "port " + name + " " + twice,
                             std::move(expected)));
    }

    static std::string mismatch(const std::string& subject, const Link& link, PortType from,
                                PortType to) {
        return subject + "takes " + std::string(name_of(to)) + ", but " + in_quotes(link.text()) +
               " is " + std::string(name_of(from));
    }

    // `subject` returns the first words of a message, `here` a diagnostic at the wire.
    template <class Subject, class Diagnose>
    void wire(const Link& link, LinkSource at, const Port& port, Subject subject, Diagnose here) {
        if (port.is_option()) return option(link, port, subject, here);
        const auto from = source(link, at, here);
        if (from && conversion(*from, port.type) == Conversion::illegal)
            report(here(RuleId::type_mismatch, mismatch(subject(), link, *from, port.type),
                        alternative(*from, port.type, registry_)));
    }

    // Returns the graph input that a link leads to, if it is for options; null otherwise.
    const Port* option_input(const Link& link) const {
        const size_t index =
            link.is_input() ? document_.inputs.index_of(link.port) : Table<GraphInput>::npos;
        if (index == Table<GraphInput>::npos) return nullptr;
        const Port& port = types_.graph_input(file_, index);
        return port.is_option() ? &port : nullptr;
    }

    // The wire of an option comes from an input of the graph with the same kind and no other value.
    template <class Subject, class Diagnose>
    void option(const Link& link, const Port& port, Subject subject, Diagnose here) {
        const Port* from = option_input(link);
        const std::string kind(kind_word(port.kind));
        if (!from || from->kind != port.kind)
            return report(here(RuleId::option_wire,
                               subject() + "is known while compiling and takes no wire",
                               "write a value, or take an input of the graph of type " + kind));
        if (port.kind == Port::Kind::choice && from->choices.empty())
            report(here(RuleId::option_wire,
                        "the input " + in_quotes(from->name) +
                            " is read by several ports and has no \"choices\"",
                        "expected some of " + join(port.choices)));
        for (const std::string& choice : from->choices)
            if (std::ranges::count(port.choices, choice) == 0)
                report(here(RuleId::option_wire,
                            subject() + "has no choice " + json_quoted(choice) + ", which input " +
                                in_quotes(from->name) + " has",
                            did_you_mean(choice, port.choices,
                                         "expected \"choices\" of " + one_of(port.choices))));
        if (!port.has_hard_range() || port.kind != Port::Kind::count) return;
        const bool inside = from->has_hard_range() && from->hard_min >= port.hard_min &&
                            from->hard_max <= port.hard_max;
        const std::string range = shortest(port.hard_min) + ", " + shortest(port.hard_max);
        if (!inside)
            report(
                here(RuleId::option_wire,
                     subject() + "takes less than the input " + in_quotes(from->name) + " may be",
                     "expected \"limits\": [" + range + "] at the input"));
    }

    // Returns the type that a link carries; if there is none, std::nullopt, and an error unless
    // reading reported it.
    template <class Diagnose>
    std::optional<PortType> source(const Link& link, LinkSource at, Diagnose here) {
        const auto type = types_.link(file_, link, at);
        if (type || only_count()) return type;
        if (link.is_surface()) {
            std::vector<std::string> names;
            for (const SurfaceProperty& property : surface_properties())
                names.emplace_back(property.name);
            report(here(RuleId::unknown_source,
                        "the surface has no property " + in_quotes(link.port),
                        did_you_mean(link.port, names, "it has " + join(names))));
        } else if (link.is_node()) {
            if (at.node == LinkSource::none || !types_.of(file_, at.node)) return {};
            if (is_broken_output(at.node, link.port)) return {};
            const std::vector<std::string> names = port_names(*types_.of(file_, at.node), true);
            report(
                here(RuleId::unknown_source,
                     "node " + in_quotes(link.node) + " has no output " + in_quotes(link.port),
                     did_you_mean(link.port, names,
                                  names.empty() ? "it has no outputs" : "it has " + join(names))));
        } else if (const Port* option = option_input(link)) {
            report(here(RuleId::option_wire,
                        "the input " + in_quotes(link.port) + " is a " +
                            std::string(kind_word(option->kind)) +
                            ", which is known while compiling",
                        "connect it to such an option of a node"));
        }
        return {};
    }

    // Returns true if the sub-graph has an output of this name; it is invalid, and reported there.
    bool is_broken_output(size_t node, std::string_view port) const {
        const Project::File* inner = project_.subgraph(file_, document_.nodes[node]->id);
        return inner && inner->document.outputs.find(port);
    }

    template <class Subject, class Diagnose>
    void literal(const json::Value& value, const Port& port, Subject subject,
                 const std::string& node, Diagnose here) {
        const std::vector<LiteralProblem> problems = literal_problems(value, port);
        for (const LiteralProblem& problem : problems) {
            Diagnostic diagnostic =
                problem.where.has_location()
                    ? diagnose(problem.where, node, problem.rule, subject() + problem.message,
                               problem.expected)
                    : here(problem.rule, subject() + problem.message, problem.expected);
            diagnostic.severity = problem.severity;
            report(std::move(diagnostic));
        }
        if (problems.empty() && port.type == PortType::image_ && port.is_value())
            image_file(literal_image(value).file, subject, here);
    }

    template <class Subject, class Diagnose>
    void image_file(std::string_view name, Subject subject, Diagnose here) {
        if (const auto fault = image_fault(files_.find(file_, name), project_.root))
            report(here(fault->rule, subject() + "names " + json_quoted(name) + ", " + fault->text,
                        fault->expected));
    }

    void required(const Node& node, size_t index, const Port& port) {
        if (!port.is_required() || node.find(port.name)) return;
        if (const Project::File* inner = project_.subgraph(file_, document_.nodes[index]->id)) {
            const GraphInput* input = inner->document.inputs.find(port.name);
            if (input && !input->default_value.is(json::Kind::null)) return;
        }
        const std::string type(name_of(port.type));
        report(diagnose(document_, node, RuleId::port_not_set,
                        "port " + in_quotes(port.name) + " is not set",
                        port.type == PortType::image_ ? "it needs a path to an image"
                                                      : "it needs a " + type + " or a wire"));
    }

    const Project& project_;
    const Registry& registry_;
    const Types& types_;
    const size_t file_;
    const Document& document_;
    Diagnostics& diagnostics_;
    NamedFiles& files_;
    std::vector<std::string> ids_;  // ids of all types; filled on first use
};

}  // namespace

void check(const Project& project, const Registry& registry, const Types& types,
           Diagnostics& diagnostics, const CheckOptions& options) {
    const std::vector<std::vector<bool>> reached =
        options.reachable_only ? reachable_nodes(project) : std::vector<std::vector<bool>>{};
    NamedFiles own(project);
    NamedFiles& files = options.files ? *options.files : own;
    for (size_t f = 0; f < project.files.size(); ++f) {
        const Document& document = project.files[f].document;
        if (document.edited) check_links(document, diagnostics);
        report_unknown(document, diagnostics);
        Checker checker(project, registry, types, f, files, diagnostics);
        for (size_t i = 0; i < document.nodes.size(); ++i)
            if (!options.reachable_only || reached[f][i]) checker.node(i);
        for (size_t i = 0; i < document.inputs.size(); ++i)
            checker.graph_input(i);
        check_renamed(document, diagnostics);
        for (const Preset& preset : document.presets)
            checker.preset(preset);
        for (const Output& output : document.outputs)
            checker.output(output);
    }
    if (!project.top().outputs.empty() || diagnostics.has_errors()) return;
    Diagnostic nothing =
        diagnose(project.top(), RuleId::no_output, "the graph has no outputs, so nothing is made",
                 "connect a node under \"outputs\"");
    nothing.severity = Severity::warning;
    diagnostics.add(std::move(nothing));
}

}  // namespace wrinkle
