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

}  // namespace wrinkle
