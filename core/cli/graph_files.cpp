#include "cli/graph_files.h"

namespace wrinkle::cli {
namespace {

bool is_graph(std::string_view file) {
    return !file.ends_with(test_suffix) && !file.ends_with(preset_suffix);
}

}  // namespace

bool report_no_graph(const std::string& file, Diagnostics& diagnostics) {
    if (is_graph(file)) return false;
    const bool test = file.ends_with(test_suffix);
    Diagnostic problem;
    problem.where.file = file;
    problem.message = test ? "is a regression test, not a graph" : "is a preset, not a graph";
    problem.expected = test ? "wrinkle test runs it" : "name the graph that it belongs to";
    diagnostics.add(std::move(problem));
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
    Diagnostic note;
    note.severity = Severity::warning;
    note.message = "left out, as tests and presets are not graphs: " + names;
    diagnostics.add(std::move(note));
    return graphs;
}

}  // namespace wrinkle::cli
