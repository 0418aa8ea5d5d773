// Visits all wires of a document, those to its outputs last.
#pragma once

#include "editor/model/document/wiring.h"

namespace wrinkle::editor {

template <class Visit>
void each_wire(const Document& document, Visit visit) {
    for (const NodePtr& node : document.nodes)
        for (const Input& input : node->inputs)
            if (input.kind == Input::Kind::link)
                visit(Connection{input.link, node->id, input.port});
    for (const Output& output : document.outputs)
        if (output.from.kind == Input::Kind::link)
            visit(Connection{output.from.link, "", output.name});
}

}  // namespace wrinkle::editor
