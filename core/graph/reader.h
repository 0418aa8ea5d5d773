// The parts of reading, one per section of the file; for core/graph alone.
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "graph/document.h"

namespace wrinkle::reading {

// Collects the problems of one file. After more than can be kept they are only counted.
class Report {
public:
    void at(const json::Value& value, std::string node, std::string message, std::string expected);
    void at_key(const json::Value& value, std::string node, std::string message,
                std::string expected);
    // False, and reported, when the value is of another kind; `name` is what it should be.
    bool expect(const json::Value& value, json::Kind kind, std::string_view name,
                std::string_view node) {
        if (!value.is(kind)) wrong_kind(value, kind, name, node);
        return value.is(kind);
    }
    // False, and reported, when the key of `value` cannot be an id or name.
    bool expect_id(const json::Value& value, std::string_view what, std::string_view id,
                   bool reserved);

    Diagnostics& list() { return list_; }

private:
    void wrong_kind(const json::Value& value, json::Kind kind, std::string_view name,
                    std::string_view node);

    Diagnostics list_;
};

void read_node(std::string_view id, const json::Value& value, Report& report, Node& node);
// A port's value: {"from": ...} is a link, all else a literal.
void read_input(std::string_view port, const json::Value& value, std::string_view node,
                Report& report, Input& input);
Output read_output(std::string_view name, const json::Value& value, Report& report);
GraphInput read_graph_input(std::string_view name, const json::Value& value, Report& report);
void read_layout(const json::Value& layout, Document& document, Report& report);

}  // namespace wrinkle::reading
