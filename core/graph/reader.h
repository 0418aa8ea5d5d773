// Readers of the sections of a graph file; private to core/graph.
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "graph/document.h"

namespace wrinkle::reading {

// Collects the problems of one file. Problems beyond the limit of Diagnostics are only counted.
class Report {
public:
    void at(const json::Value& value, std::string node, RuleId rule, std::string message,
            std::string expected);
    void at_key(const json::Value& value, std::string node, RuleId rule, std::string message,
                std::string expected);
    // Reports an error and returns false if the value is of another kind; `name` names it in the
    // message.
    bool expect(const json::Value& value, json::Kind kind, std::string_view name,
                std::string_view node);
    // Reports an error and returns false if the key of `value` is not a valid id or name.
    bool expect_id(const json::Value& value, std::string_view what, std::string_view id,
                   bool reserved);

    Diagnostics& list() { return list_; }

private:
    Diagnostics list_;
};

NodePtr read_node(std::string_view id, const json::Value& value, Report& report);
// Reads a port's value: {"from": ...} is a link, anything else a literal.
void read_input(std::string_view port, const json::Value& value, std::string_view node,
                Report& report, Input& input);
Output read_output(std::string_view name, const json::Value& value, Report& report);
GraphInput read_graph_input(std::string_view name, const json::Value& value, Report& report);
Preset read_preset(std::string_view name, const json::Value& value, Report& report);
void read_layout(const json::Value& layout, Document& document, Report& report);

}  // namespace wrinkle::reading
