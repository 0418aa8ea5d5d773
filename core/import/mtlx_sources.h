// Sources of the inputs of a MaterialX document: through interfaces of node graphs,
// outputs, and nodes that the document itself defines as graphs of others.
//
// A scope is one use of a node graph. Nodes of a definition exist once for each use, so a node is
// named by its scope and its element.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "materialx/document.h"

namespace wrinkle::materialx {

struct NodeKey {
    uint32_t scope = 0;
    uint32_t element = no_element;
    auto operator<=>(const NodeKey&) const = default;
};

struct Source {
    enum class Kind : uint8_t {
        absent,    // no value and no connection: the default of the node
        constant,  // the `value` of `input`
        exposed,   // the same, and `input` is the interface of a node graph
        node,      // the output `output` of `node`
        bad,       // reported
    };
    Kind kind = Kind::absent;
    uint32_t input = no_element;
    NodeKey node = {};
    std::string output = {};  // "" for the only one
};

class Sources {
public:
    Sources(const Document& document, Diagnostics& diagnostics);

    // Returns the source of a node's input; `absent` if the node does not have it.
    Source input(NodeKey node, std::string_view name);
    // Returns the source of an element <input> or <output>.
    Source follow(uint32_t scope, uint32_t element);

    // Returns true if a source led through this node, which the document defines.
    bool is_used(uint32_t node) const { return used_.contains(node); }

private:
    struct Scope {
        uint32_t graph = 0;              // the element that holds the nodes
        uint32_t instance = no_element;  // the node, for a definition
        uint32_t parent = 0;
        int depth = 0;
    };
    struct At {
        uint32_t scope;
        uint32_t element;  // <input> or <output>
    };
    // The next step from an element: another element, or a result.
    struct Step {
        bool is_result = false;
        At next = {};
        Source result = {};
    };

    static Step result(Source source) { return {true, {}, std::move(source)}; }
    static Step to(uint32_t scope, uint32_t element) { return {false, {scope, element}, {}}; }
    Step bad(uint32_t element, std::string message, std::string expected = {});

    Step step(At at);
    Step from_interface(At at, std::string_view name);
    Step from_graph(At at, std::string_view name);
    Step from_node(At at, std::string_view name);
    Step output_of(uint32_t scope, uint32_t graph, At at);

    uint32_t container(uint32_t element) const;
    uint32_t scope_of(uint32_t graph, uint32_t instance, uint32_t parent);
    uint32_t definition(const Element& node) const;  // the <nodedef>, or no_element
    uint32_t graph_of(uint32_t definition) const;    // the <nodegraph>, or no_element

    const Document& document_;
    Diagnostics& diagnostics_;
    std::vector<Scope> scopes_ = {{}};
    std::set<uint32_t> used_;
    std::map<std::tuple<uint32_t, uint32_t, uint32_t>, uint32_t> scope_by_use_;
    std::map<std::string, std::vector<uint32_t>, std::less<>> definitions_;  // by category
    std::map<std::string, uint32_t, std::less<>> graphs_;  // by name of the nodedef
};

}  // namespace wrinkle::materialx
