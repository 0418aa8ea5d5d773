// Helpers shared by the edits; private to core/graph.
#pragma once

#include "graph/document.h"

namespace wrinkle::editing {

// Removes stored values of the wrong kind for known keys that an edit has replaced; sets
// Document::edited.
void mark_edited(Document& document);
void mark_edited(Node& node);

// Returns a copy to edit; a source that is not an object is dropped, as the edit makes it a node.
Node copy_of(const Node& node);

// Replaces the link and updates the stored value; other keys of the value are preserved.
void set_link(Input& input, Link link);

}  // namespace wrinkle::editing
