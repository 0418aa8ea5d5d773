#include "import/mtlx_sources.h"

#include <algorithm>

namespace wrinkle::materialx {
namespace {

constexpr int max_steps = 10'000;  // from an input through interfaces and outputs to its source
constexpr int max_uses = 64;       // definitions in each other

// Returns the type of the only output of a definition, "multioutput" if it has several.
std::string_view output_type(const Document& document, const Element& definition) {
    std::string_view type = definition.attribute("type");
    int count = 0;
    for (const uint32_t child : definition.children)
        if (document[child].category == "output") {
            type = document[child].attribute("type");
            ++count;
        }
    return count > 1 ? "multioutput" : type;
}

}  // namespace

Sources::Sources(const Document& document, Diagnostics& diagnostics)
    : document_(document), diagnostics_(diagnostics) {
    for (const uint32_t child : document[0].children) {
        const Element& element = document[child];
        if (element.category == "nodedef")
            definitions_[std::string(element.attribute("node"))].push_back(child);
        if (element.category == "nodegraph" && element.has("nodedef"))
            graphs_.emplace(element.attribute("nodedef"), child);
        if (element.category == "implementation" && element.has("nodegraph")) {
            const uint32_t graph = document.child(0, element.attribute("nodegraph"));
            if (graph != no_element) graphs_.emplace(element.attribute("nodedef"), graph);
        }
    }
}

uint32_t Sources::definition(const Element& node) const {
    const auto found = definitions_.find(node.category);
    if (found == definitions_.end()) return no_element;
    const std::string_view named = node.attribute("nodedef"), type = node.attribute("type");
    for (const uint32_t each : found->second)
        if (!named.empty() && document_[each].name == named) return each;
    for (const uint32_t each : found->second)
        if (output_type(document_, document_[each]) == type) return each;
    return found->second.front();
}

uint32_t Sources::graph_of(uint32_t definition) const {
    if (definition == no_element) return no_element;
    const auto found = graphs_.find(document_[definition].name);
    return found == graphs_.end() ? no_element : found->second;
}

Source Sources::input(NodeKey node, std::string_view name) {
    const uint32_t element = document_.child(node.element, name);
    return element == no_element ? Source{} : follow(node.scope, element);
}

Source Sources::follow(uint32_t scope, uint32_t element) {
    At at{scope, element};
    for (int i = 0; i < max_steps; ++i) {
        Step next = step(at);
        if (next.is_result) return next.result;
        at = next.next;
    }
    return bad(element, "is connected in a circle").result;
}

Sources::Step Sources::bad(uint32_t element, std::string message, std::string expected) {
    const Element& at = document_[element];
    const Element& parent = document_[at.parent];
    diagnostics_.add({RuleId::materialx_value, Severity::error, document_.location(element), "",
                      at.parent == 0 ? at.name : parent.name,
                      at.category + " '" + at.name + "' " + std::move(message),
                      std::move(expected)});
    Source source;
    source.kind = Source::Kind::bad;
    return result(std::move(source));
}

// The element that holds the nodes which an element can be connected to.
uint32_t Sources::container(uint32_t element) const {
    const uint32_t parent = document_[element].parent;
    if (document_[element].category == "output" || parent == 0) return parent;
    return document_[parent].parent;
}

Sources::Step Sources::step(At at) {
    const Element& element = document_[at.element];
    if (element.has("interfacename")) return from_interface(at, element.attribute("interfacename"));
    if (element.has("nodegraph")) return from_graph(at, element.attribute("nodegraph"));
    if (element.has("nodename")) return from_node(at, element.attribute("nodename"));
    if (element.category == "input" && element.has("output") && !element.has("value")) {
        const uint32_t output = document_.child(container(at.element), element.attribute("output"));
        if (output == no_element || document_[output].category != "output")
            return bad(at.element, "has no output '" + std::string(element.attribute("output")) +
                                       "' in the same graph");
        return to(at.scope, output);
    }
    Source source;
    source.input = at.element;
    if (element.has("value")) {
        const bool is_interface =
            document_[element.parent].category == "nodegraph" && element.category == "input";
        source.kind = is_interface ? Source::Kind::exposed : Source::Kind::constant;
    }
    return result(std::move(source));
}

Sources::Step Sources::from_interface(At at, std::string_view name) {
    const Scope& scope = scopes_[at.scope];
    if (scope.instance != no_element) {
        const uint32_t given = document_.child(scope.instance, name);
        if (given != no_element) return to(scope.parent, given);
        const uint32_t defined = document_.child(definition(document_[scope.instance]), name);
        if (defined != no_element) return to(scope.parent, defined);
    }
    const uint32_t graph_input = document_.child(scope.graph, name);
    if (graph_input == no_element || document_[graph_input].category != "input") {
        const uint32_t named = document_.child(
            0, document_[scope.graph].attribute("nodedef"));  // an unused definition
        const uint32_t defined = named == no_element ? no_element : document_.child(named, name);
        if (defined != no_element) return to(0, defined);
        return bad(at.element, "names the interface '" + std::string(name) +
                                   "', which the node graph does not have");
    }
    return to(scope.parent, graph_input);
}

Sources::Step Sources::from_graph(At at, std::string_view name) {
    const uint32_t graph = document_.child(0, name);
    if (graph == no_element || document_[graph].category != "nodegraph")
        return bad(at.element, "is connected to the node graph '" + std::string(name) +
                                   "', which does not exist");
    return output_of(scope_of(graph, no_element, 0), graph, at);
}

Sources::Step Sources::from_node(At at, std::string_view name) {
    const uint32_t node = document_.child(container(at.element), name);
    if (node == no_element)
        return bad(at.element,
                   "is connected to the node '" + std::string(name) + "', which does not exist");
    const Element& element = document_[node];
    if (element.category == "nodegraph")
        return output_of(scope_of(node, no_element, at.scope), node, at);
    const uint32_t graph = graph_of(definition(element));
    if (graph != no_element) {
        if (scopes_[at.scope].depth >= max_uses)
            return bad(at.element, "uses definitions that use each other more than 64 deep");
        return output_of(scope_of(graph, node, at.scope), graph, at);
    }
    Source source;
    source.kind = Source::Kind::node;
    source.input = at.element;
    source.node = {at.scope, node};
    source.output = std::string(document_[at.element].attribute("output"));
    return result(std::move(source));
}

Sources::Step Sources::output_of(uint32_t scope, uint32_t graph, At at) {
    const std::string_view wanted = document_[at.element].attribute("output");
    for (const uint32_t child : document_[graph].children) {
        const Element& element = document_[child];
        if (element.category == "output" && (wanted.empty() || element.name == wanted))
            return to(scope, child);
    }
    return bad(at.element, wanted.empty() ? "is connected to a node graph without an output"
                                          : "is connected to the output '" + std::string(wanted) +
                                                "', which the node graph does not have");
}

uint32_t Sources::scope_of(uint32_t graph, uint32_t instance, uint32_t parent) {
    const auto [found, is_new] =
        scope_by_use_.try_emplace({graph, instance, parent}, static_cast<uint32_t>(scopes_.size()));
    if (instance != no_element) used_.insert(instance);
    if (is_new) scopes_.push_back({graph, instance, parent, scopes_[parent].depth + 1});
    return found->second;
}

}  // namespace wrinkle::materialx
