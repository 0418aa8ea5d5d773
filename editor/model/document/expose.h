// Graph inputs made of ports, and ports with values made of graph inputs.
#pragma once

#include <string>
#include <vector>

#include "editor/model/document/model.h"

namespace wrinkle::editor {

// Returns the reason why the port cannot become an input of the graph, a sentence; "" if it can: it
// is a number, an image or an option that has a value and no wire.
std::string why_not_exposed(const Node& node, const Port& port);
// Returns the ports of the node that can.
std::vector<const Port*> exposable_ports(const Node& node, const NodeType& type);

struct Exposed {
    Document document;
    std::string input;  // name of the new input
};
// Adds an input of the graph that feeds the port. Its default is the port's value; slider, unit and
// choices are the port's. It is named after the port, if that name is or was taken after node and
// port. The port must be exposable.
Exposed expose(const Document& document, const Node& node, const Port& port);

// Removes an input of the graph. Ports that read it get its default as their value, if it fits.
Document without_input(const Model& model, const Document& document, const std::string& name);

}  // namespace wrinkle::editor
