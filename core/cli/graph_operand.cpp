#include "cli/graph_operand.h"

#include "base/file.h"
#include "base/text.h"
#include "cli/git.h"
#include "difference/entries.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

std::string without_line_end(std::string text) {
    while (text.ends_with('\n'))
        text.pop_back();
    return text;
}

// Sets the revision and the path of REVISION:PATH, which Git takes from the top of the repository
// unless PATH begins with "./" or "../". REVISION may be empty or ":0", the index.
void set_revision(GraphOperand& operand) {
    const size_t colon = operand.name.find(':', operand.name.starts_with(':') ? 1 : 0);
    const size_t end = colon == operand.name.npos ? 0 : colon;
    operand.revision = end == 0 ? ":" : operand.name.substr(0, end);
    const std::string path = operand.name.substr(end + 1);
    const bool is_relative = path.starts_with("./") || path.starts_with("../");
    const GitResult top = run_git({"rev-parse", "--show-toplevel"});
    operand.file = is_relative || top.code != 0 ? fs::path(path)
                                                : fs::path(without_line_end(top.output)) / path;
}

}  // namespace

std::optional<GraphOperand> read_graph_operand(const std::string& name, Diagnostics& diagnostics) {
    if (report_no_graph(name, diagnostics)) return {};
    auto text = read_operand(name, diagnostics);
    if (!text) return {};
    GraphOperand operand;
    operand.name = name;
    const std::string stream = stream_title(name);
    operand.document =
        read_document(std::move(*text), stream.empty() ? name : stream, operand.problems);
    std::error_code ignored;
    if (name.find(':') != name.npos && !fs::exists(name, ignored))
        set_revision(operand);
    else if (stream.empty())
        operand.file = name;
    const std::string fault = difference::entries_fault(operand.document);
    if (fault.empty()) return operand;
    if (operand.problems.has_errors())
        diagnostics.append(operand.problems);
    else
        diagnostics.add(file_problem(Severity::error, RuleId::wrong_file, name,
                                     "is not a graph: " + fault, ""));
    return {};
}

ReadGraph open_graph(const GraphOperand& operand, const CommonOptions& common) {
    ReadGraph graph;
    graph.problems = operand.problems;
    const ProjectOptions options{common.root, {}};
    graph.project =
        load_project(operand.document, operand.file.parent_path(), options, graph.problems);
    return graph;
}

void warn_of_other_files(const GraphOperand& operand, const Project& project,
                         const Registry& registry, Diagnostics& diagnostics) {
    if (operand.revision.empty() || operand.revision.starts_with(':')) return;
    std::vector<std::string> words = {"diff", "--name-only", operand.revision, "--"};
    const size_t options = words.size();
    std::error_code ignored;
    for (std::string& file : input_paths(project, registry))
        if (!fs::equivalent(file, operand.file, ignored)) words.push_back(std::move(file));
    if (words.size() == options) return;  // Git would compare all files
    const GitResult changed = run_git(words);
    if (changed.code != 0 || changed.output.empty()) return;
    const std::string output = without_line_end(changed.output);
    const auto files = split(output, '\n');
    diagnostics.add(
        file_problem(Severity::warning, RuleId::wrong_file, operand.name,
                     "is drawn with files of the working tree that differ from those of " +
                         operand.revision + ": " + joined(files, ", "),
                     "a work tree of that revision (git worktree) has its own"));
}

}  // namespace wrinkle::cli
