// wrinkle diff A B and wrinkle textconv FILE: differences of graphs by node, not by line.
#include "base/text.h"
#include "cli/git.h"
#include "cli/output.h"
#include "cli/session.h"
#include "difference/changes.h"

namespace wrinkle::cli {
namespace {

// Reads a graph for a comparison: errors in its meaning are allowed, it need not compile.
std::optional<Document> read_graph(const std::string& file, Diagnostics& diagnostics) {
    if (report_no_graph(file, diagnostics)) return {};
    const auto text = read_operand(file, diagnostics);
    if (!text) return {};
    Diagnostics own;
    Document document = read_document(*text, file, own);
    const std::string fault = difference::entries_fault(document);
    if (fault.empty()) return document;
    if (own.has_errors())
        diagnostics.append(own);
    else
        diagnostics.add(file_problem(Severity::error, RuleId::wrong_file, file,
                                     "is not a graph: " + fault, ""));
    return {};
}

// As git diff: 2 is trouble.
constexpr int exit_different = 1, exit_trouble = 2;

struct DiffCommand {
    std::string before, after, diagnostics = "text";
    bool json = false, exit_zero = false;

    int run() const {
        if (before == "-" && after == "-") return fail(exit_usage, "- is one of the two graphs");
        Diagnostics problems;
        const auto a = read_graph(before, problems), b = read_graph(after, problems);
        if (report(problems, diagnostics) != exit_success) return exit_trouble;
        const difference::Changes changes = difference::changes_between(*a, *b);
        const int code = write_result("-", json ? changes_json(changes) : changes_text(changes));
        if (code != exit_success) return code;
        return changes.same_material() || exit_zero ? int{exit_success} : exit_different;
    }
};

struct TextconvCommand {
    std::string file;

    int run() const {
        Diagnostics problems;
        const auto text = read_text(file, problems);
        if (!text) {
            report(problems, "text");
            return exit_input;
        }
        Diagnostics ignored;  // the text is printed instead
        const Document document = read_document(*text, file, ignored);
        const bool is_graph =
            difference::entries_fault(document).empty() && document.source.has("wrinkle");
        return write_result("-", is_graph ? difference::listing(document) : *text);
    }
};

}  // namespace

void declare_diff(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<DiffCommand>(app, run, "diff",
                                             "Differences of two graphs by node, input and wire");
    sub.footer("Exit codes: 0 same material, 1 different, 2 a graph cannot be read.");
    sub.add_option("BEFORE", c.before, "A graph, or REVISION:PATH of a Git repository; - is stdin")
        ->required();
    sub.add_option("AFTER", c.after, "The other graph")->required();
    sub.add_flag("--json", c.json, "Prints JSON");
    sub.add_flag("--exit-zero", c.exit_zero, "Exit code 0 also for different graphs");
    declare_diagnostics(sub, c.diagnostics);
}

void declare_textconv(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<TextconvCommand>(
        app, run, "textconv", "A graph as one line per node input, for git diff");
    sub.add_option("FILE", c.file, "A graph; another file is printed unchanged")->required();
}

}  // namespace wrinkle::cli
