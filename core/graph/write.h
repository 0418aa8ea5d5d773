// Document to text.
//
// Canonical text has its keys in a fixed order and its nodes in the document's. A node stands on
// one line when it has at most two inputs and no unknown keys, else each input has its own line; a
// port's value is always on one line. So the lines depend on names and never on values, and a
// change of one value is a change of one line.
#pragma once

#include <string>

#include "graph/document.h"

namespace wrinkle {

// The original bytes while untouched, else canonical text.
std::string write_document(const Document& document);

// Untouched numbers keep their spelling; ends with a newline.
std::string canonical_text(const Document& document);

// Canonical text in parts that follow each other: head, every node, middle, every position, end. A
// part depends on what it is named after and on `first`: of the nodes, of the positions; of the
// document (nothing but "{" stands before it). So who has the text of one snapshot makes that of
// the next from what differs. Has no nodes where has_node_parts() is false.
struct CanonicalParts {
    const Document& document;

    bool has_node_parts() const;  // false: "nodes" is something else, kept as it was
    std::string head() const;
    static std::string node(const Node& node, bool first);
    std::string middle(bool first) const;
    static std::string position(const Position& position, bool first);
    std::string end(bool first) const;
};

}  // namespace wrinkle
