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

}  // namespace wrinkle
