// Adds the nodes of a graph for values of a MaterialX document.
//
// Arithmetic of numbers that are all known is done at once, in double precision. Ids come from the
// name given to begin().
#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "graph/document.h"
#include "import/mtlx_value.h"

namespace wrinkle::materialx {

using Numbers = std::vector<Number>;

Input wire_input(std::string port, const Link& link);
Input literal_input(std::string port, json::Value value);

class GraphBuilder {
public:
    // Sets the name of the nodes to come.
    void begin(std::string_view name) { name_ = valid_id(name); }
    size_t size() const { return nodes_.size(); }

    // Returns the output `output` of a new node.
    Link add(const char* type, const char* output, std::vector<Input> inputs);

    Input input(std::string port, const Number& number);
    Input input(std::string port, const Value& value);
    // Precondition: the value is not a literal.
    Link wire(const Value& value);
    Number part(const Value& value, int part);
    Value from_parts(Type type, const Numbers& parts);

    // A node of the family "math": `ports` are its inputs, the result is its output `result`.
    Number math(const char* type, const std::vector<const char*>& ports, const Numbers& numbers);
    Number add(const Number& a, const Number& b) { return math("add", {"a", "b"}, {a, b}); }
    Number subtract(const Number& a, const Number& b) {
        return math("subtract", {"a", "b"}, {a, b});
    }
    Number multiply(const Number& a, const Number& b) {
        return math("multiply", {"a", "b"}, {a, b});
    }
    Number divide(const Number& a, const Number& b) { return math("divide", {"a", "b"}, {a, b}); }

    // Returns {"input", name} of a new exposed input; of another name if it is taken.
    Link expose(GraphInput input);
    void output(std::string_view name, const Link& from);
    bool has_output(std::string_view name) const { return outputs_.contains(std::string(name)); }

    // Returns the graph without nodes and exposed inputs that no output needs.
    wrinkle::Document finish(std::string_view name);

private:
    std::string valid_id(std::string_view name) const;
    std::string free_name(const std::string& base);
    void make(ImageRead& image);
    // Returns the wire of which the parts are all components in their order.
    std::optional<Link> whole_of(const Numbers& parts) const;
    static std::unordered_set<std::string> needed(const std::vector<NodePtr>& nodes,
                                                  const std::vector<Output>& outputs);

    std::string name_ = "node";
    std::vector<NodePtr> nodes_;
    std::unordered_set<std::string> ids_;
    std::unordered_map<std::string, size_t> next_suffix_;
    std::unordered_map<std::string, std::string> separated_;  // node of components, by wire
    std::unordered_map<std::string, Link> wholes_;            // the wire, by that node
    std::vector<GraphInput> inputs_;
    std::unordered_set<std::string> input_names_;
    std::map<std::string, Link> outputs_;
};

}  // namespace wrinkle::materialx
