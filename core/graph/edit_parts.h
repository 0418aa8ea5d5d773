// What the edits of core/graph share; for core/graph alone.
#pragma once

#include "graph/document.h"

namespace wrinkle::editing {

// A known key of the wrong kind was kept among the unknown ones; what is now edited replaces it.
void mark_edited(Document& document);
void mark_edited(Node& node);

// For changing: what was read as no object becomes a node by the edit.
Node copy_of(const Node& node);

// The link, renamed, in the value that it was read as.
void set_link(Input& input, Link link);

}  // namespace wrinkle::editing
