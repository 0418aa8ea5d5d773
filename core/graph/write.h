// Serialisation of a Document.
//
// Canonical text has its keys in a fixed order and its nodes in the document's order. A node is
// written on one line if it has at most two inputs and no unknown keys, else each input has its own
// line; a port's value is always on one line. So line breaks depend on names and never on values,
// and a change of one value is a change of one line.
#pragma once

#include <string>

#include "graph/document.h"

namespace wrinkle {

// Returns the original bytes if unedited, else canonical text.
std::string write_document(const Document& document);

// Unedited numbers retain their spelling; the text ends with a newline.
std::string canonical_text(const Document& document);

// Canonical text as consecutive parts: head, every node, middle, every position, end. node() and
// position() depend only on their arguments, the others on the document except for the contents of
// its nodes and positions, so callers can update the text of a snapshot incrementally. `first`:
// true for the first node or position; for middle() and end(), true if only "{" precedes. There are
// no node parts if has_node_parts() is false.
struct CanonicalParts {
    const Document& document;

    bool has_node_parts() const;  // false: "nodes" is not an object, stored verbatim
    std::string head() const;
    static std::string node(const Node& node, bool first);
    std::string middle(bool first) const;
    static std::string position(const Position& position, bool first);
    std::string end(bool first) const;
};

}  // namespace wrinkle
