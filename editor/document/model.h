// What follows from a snapshot, and never the other way round: the types of its nodes. Pure
// functions of the document and of the files that it names.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graph/subgraph.h"
#include "lower/types.h"

namespace wrinkle::editor {

// The document's types. Holds while no more than literals and layout change. Copies share what they
// hold and never change it, so another thread may read one.
struct Model {
    std::shared_ptr<const Project> project;
    std::shared_ptr<const Types> types;
    Diagnostics project_problems;  // of reading its sub-graphs

    const NodeType* type_of(std::string_view node) const;  // nullptr: unknown
    // The type of an output of a node, of a property of the surface or of an input of the graph.
    std::optional<PortType> type_of(const Link& from) const;
    // The type that an output of the graph wants; nothing when it takes any.
    static std::optional<PortType> wanted_by_output(std::string_view name);
};

// `folder` is that of the document's file; no name leads out of `root` ("": the same folder).
Model make_model(const Document& document, const std::filesystem::path& folder,
                 const Registry& registry, const std::filesystem::path& root = {});

// The same project with another top document, for compiling.
Project project_with(const Model& model, const Document& document);
// What reading a text could not use: check() takes it as reported.
void report_unread(const Document& document, Diagnostics& problems);
// The part of it that the outputs need, and what is wrong with the wires and sub-graphs of that:
// with errors nothing is made of it.
Project project_to_compile(const Model& model, const Document& document, Diagnostics& problems);

// Whether a wire may go there by its type, and if not, why: "" when it may.
std::string wire_problem(const Model& model, const Document& document, const Registry& registry,
                         const Link& from, std::string_view node, std::string_view port);
// The same for an output of the graph.
std::string output_problem(const Model& model, const Link& from, std::string_view output,
                           const Registry& registry);

}  // namespace wrinkle::editor
