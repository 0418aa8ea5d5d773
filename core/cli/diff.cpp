// wrinkle diff A B and wrinkle textconv FILE: differences of graphs by node, not by line.
#include <chrono>

#include "base/printable.h"
#include "base/text.h"
#include "cli/arguments.h"
#include "cli/cli.h"
#include "cli/diff_results.h"
#include "cli/output.h"
#include "cli/test_report.h"
#include "difference/changes.h"
#include "gpu/context.h"
#include "report/results_json.h"

namespace wrinkle::cli {
namespace {

// As git diff: 2 is trouble.
constexpr int exit_different = 1, exit_trouble = 2;

// One line per check that is not the same. Changed GLSL is only in the report.
std::string result_lines(const report::Results& results) {
    std::string text;
    for (const report::Check& check : results.checks)
        if (check.status != report::Status::passed && check.kind != report::CheckKind::text)
            text += printable(check.id() + ": " + check.message) + "\n";
    return text;
}

struct DiffCommand {
    CommonOptions common;
    std::string before, after, report_folder;
    bool json = false, exit_zero = false, cost = false, renders = false;

    int run() {
        if (before == "-" && after == "-") return fail(exit_usage, "- is one of the two graphs");
        gpu::Context::prefer_quick_programs();
        Diagnostics problems;
        const auto a = read_graph_operand(before, problems);
        const auto b = read_graph_operand(after, problems);
        if (problems.has_errors()) {
            report(problems, common.diagnostics);
            return exit_trouble;
        }
        const difference::Changes changes = difference::changes_between(a->document, b->document);
        report::Results results;
        std::string environment;
        renders = renders || !report_folder.empty();
        if (cost || renders) {
            const auto start = std::chrono::steady_clock::now();
            const Nodes nodes = load_nodes(common, problems);
            const bool writes =
                !report_folder.empty() && make_report_folder(report_folder, environment);
            const DiffSettings settings{nodes.registry, common, renders,
                                        writes ? report_folder : ""};
            results = compare_materials(*a, *b, settings, problems, environment);
            const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
            results.seconds = passed.count();
        }
        return conclude(changes, results, environment, problems);
    }

    int conclude(const difference::Changes& changes, report::Results& results,
                 std::string& environment, const Diagnostics& problems) {
        if (!report_folder.empty() && environment.empty()) {
            complete(changes, results);
            write_report(results, report_folder, environment);
        }
        const int code = report(problems, common.diagnostics);
        const bool differs = results.count(report::Status::changed) > 0;
        const int written =
            write_result("-", json ? as_json(changes, results) : as_text(changes, results));
        if (written != exit_success) return written;
        if (!environment.empty()) return fail(exit_environment, environment);
        if (code != exit_success || results.count(report::Status::error) > 0) return exit_trouble;
        return (changes.same_material() && !differs) || exit_zero ? int{exit_success}
                                                                  : exit_different;
    }

    void complete(const difference::Changes& changes, report::Results& results) const {
        results.version = WRINKLE_VERSION;
        results.started = time_of_report();
        clear_durations_if_reproducible(results);
        results.changes = difference::change_lines(changes);
        results.command = "wrinkle diff " + shell_quoted(before) + " " + shell_quoted(after) +
                          " --report " + shell_quoted(report_folder);
    }

    std::string as_text(const difference::Changes& changes, const report::Results& results) const {
        const bool differs = results.count(report::Status::changed) > 0;
        std::string text;
        for (const std::string& line : difference::change_lines(changes))
            text += line + "\n";
        text += result_lines(results);
        if (!report_folder.empty()) text += "report: " + printable(report_folder) + "/index.html\n";
        return text +
               (differs && changes.same_material() ? "same graph, different files"
                                                   : difference::verdict(changes)) +
               "\n";
    }

    std::string as_json(const difference::Changes& changes, const report::Results& results) const {
        if (!cost && !renders) return difference::changes_json(changes);
        std::string members = report::to_json(results);
        members.pop_back();  // the line end
        return difference::changes_json(changes, {{"results", members}});
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
    sub.footer(
        "Exit codes: 0 same material, 1 different, 2 a graph cannot be read or run, 3 no OpenGL.");
    sub.add_option("BEFORE", c.before, "A graph, or REVISION:PATH of a Git repository; - is stdin")
        ->required();
    sub.add_option("AFTER", c.after, "The other graph")->required();
    sub.add_flag("--cost", c.cost, "Changes of the cost: operations, texture reads, values");
    sub.add_flag("--render", c.renders,
                 "Changes of the cost, of numbers at points, and of images, by the cases of "
                 "NAME.test.json");
    sub.add_option("--report", c.report_folder,
                   "Folder of a page with the changes and both images; implies --render")
        ->type_name("DIR");
    sub.add_flag("--json", c.json, "Prints JSON");
    sub.add_flag("--exit-zero", c.exit_zero, "Exit code 0 also for different graphs");
    declare_common(sub, c.common, false);
}

void declare_textconv(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<TextconvCommand>(
        app, run, "textconv", "A graph as one line per node input, for git diff");
    sub.add_option("FILE", c.file, "A graph; another file is printed unchanged")->required();
}

}  // namespace wrinkle::cli
