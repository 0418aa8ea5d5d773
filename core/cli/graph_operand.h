// A graph that `wrinkle diff` reads: a file, standard input, or a version of a Git repository.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/material_run.h"
#include "graph/document.h"

namespace wrinkle::cli {

struct GraphOperand {
    std::string name;  // as named by the user
    Document document;
    Diagnostics problems;        // found while reading; the graph need not compile
    std::filesystem::path file;  // NAME.json in the folder of its images; "" of standard input
    std::string revision;        // empty for a file
};

// Reports an error and returns std::nullopt if the text is not a graph.
std::optional<GraphOperand> read_graph_operand(const std::string& name, Diagnostics& diagnostics);

// Reads its sub-graphs. Those of a revision, and its images, are files of the working tree.
ReadGraph open_graph(const GraphOperand& operand, const CommonOptions& common);

// Reports a warning if files that the graph reads differ from those of its revision.
void warn_of_other_files(const GraphOperand& operand, const Project& project,
                         const Registry& registry, Diagnostics& diagnostics);

}  // namespace wrinkle::cli
