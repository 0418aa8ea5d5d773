#include "cli/graph_files.h"

#include "base/file_problem.h"

namespace wrinkle::cli {
namespace {

bool is_graph(std::string_view file) {
    return !file.ends_with(test_suffix) && !file.ends_with(preset_suffix);
}

}  // namespace

bool report_no_graph(const std::string& file, Diagnostics& diagnostics) {
    if (is_graph(file)) return false;
    const bool test = file.ends_with(test_suffix);
    diagnostics.add(
        file_problem(Severity::error, file,
                     test ? "is a regression test, not a graph" : "is a preset, not a graph",
                     test ? "wrinkle test runs it" : "name the graph that it belongs to"));
    return true;
}

std::vector<std::string> graphs_among(const std::vector<std::string>& files,
                                      Diagnostics& diagnostics) {
    std::vector<std::string> graphs, others;
    for (const std::string& file : files)
        (is_graph(file) ? graphs : others).push_back(file);
    if (graphs.empty() || others.empty()) return files;
    constexpr size_t max_names = 3;
    std::string names;
    for (size_t i = 0; i < others.size() && i < max_names; ++i)
        names += (i ? ", " : "") + others[i];
    if (others.size() > max_names)
        names += " and " + std::to_string(others.size() - max_names) + " more";
    diagnostics.add(file_problem(Severity::warning, "",
                                 "left out, as tests and presets are not graphs: " + names, ""));
    return graphs;
}

}  // namespace wrinkle::cli
