// Documentation of node types: reference pages of `wrinkle nodes`, the JSON Schema of graph files,
// and the texts about one port that these consist of.
#pragma once

#include <string>

#include "registry/registry.h"

namespace wrinkle {

std::string list_text(const Registry& registry);  // one line per node, by family
std::string page_text(const NodeType& type);      // everything about one node

std::string list_json(const Registry& registry);  // {"version": 1, "nodes": [...]}
std::string page_json(const NodeType& type);      // one object

std::string list_markdown(const Registry& registry);  // one page of all nodes, by family
std::string page_markdown(const NodeType& type);

// JSON Schema (draft 2020-12) of a graph file: completes node types, ports and choices, checks the
// values of known ports, and accepts unknown types, ports and keys.
std::string graph_schema(const Registry& registry);

std::string_view kind_word(Port::Kind kind);  // "input", "choice"
std::string kind_text(const Port& port);      // "float", "choice", "field of height"
std::string details_text(const Port& port);   // "m, default 0.1, 0 to 1"; may be empty
std::string default_json(const Port& port);   // "" if it has none; a surface default is a link
std::string port_json(const Port& port);      // one object
std::string range_json(double least, double most);   // "[0, 1]"; an infinite end is null
std::string padded(std::string text, size_t width);  // with spaces at its end
// The first members of an object: {"id": ..., "version": 1
std::string head_json(const NodeType& type);

}  // namespace wrinkle
