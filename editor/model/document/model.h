// The node types of a snapshot, derived from it. Pure functions of the document and of the files
// that it names.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>

#include "graph/subgraph.h"
#include "lower/types.h"

namespace wrinkle::editor {

// Types of the document. Valid while only literals and layout change. Copies share immutable data,
// so another thread may read one.
struct Model {
    const Registry* registry = nullptr;
    std::shared_ptr<const Project> project;
    std::shared_ptr<const Types> types;
    Diagnostics project_problems;  // from reading its sub-graphs

    const NodeType* type_of(std::string_view node) const;  // nullptr: unknown
    // Returns the type of a node output, of a surface property or of a graph input.
    std::optional<PortType> type_of(const Link& from) const;
};

// Return the port of that name; nullptr if there is none, or no type.
const Port* input_port(const NodeType* type, std::string_view name);
const Port* output_port(const NodeType* type, std::string_view name);
// Returns the first output of one of the types, by default of any; nullptr if there is none.
const Port* first_output(const NodeType* type, std::initializer_list<PortType> wanted = {});

// `folder` is the folder of the document's file; names must stay inside `root` ("": the same
// folder).
Model make_model(const Document& document, const std::filesystem::path& folder,
                 const Registry& registry, const std::filesystem::path& root = {});

// Returns the type of a node with the sub-graph `file`, a path as written in the document, as
// Node::type names it; std::nullopt and a sentence in `why` if the document cannot use that file.
std::optional<NodeType> subgraph_type(const Model& model, const std::string& file,
                                      std::string& why);

// Returns the same project with another top document, for compilation.
Project project_with(const Model& model, const Document& document);
// Reports ports, outputs and keys of the graph's inputs that could not be read: check() assumes
// that they are reported.
void report_unread(const Document& document, Diagnostics& problems);
// Returns the part of the project that the outputs need, and reports the problems of its wires and
// sub-graphs. If there are errors, it must not be compiled.
Project project_to_compile(const Model& model, const Document& document, Diagnostics& problems);

}  // namespace wrinkle::editor
