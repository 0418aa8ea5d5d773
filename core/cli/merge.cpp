// wrinkle merge BASE OURS THEIRS: three-way merge of graphs by node; a merge driver of Git.
#include <filesystem>

#include "base/file.h"
#include "base/text.h"
#include "cli/arguments.h"
#include "cli/cli.h"
#include "cli/conflict_file.h"
#include "cli/git.h"
#include "cli/output.h"
#include "cli/session.h"
#include "compile/shader.h"
#include "difference/merge.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

using difference::Merged;

// A side as read. The base may be empty: both sides added the file.
struct MergeInput {
    std::string text;
    Document document;
    Diagnostics diagnostics;

    bool is_blank() const { return trimmed(text).find_first_not_of('\n') == text.npos; }
    bool is_graph() const {
        return is_blank() ||
               (difference::entries_fault(document).empty() && document.source.has("wrinkle"));
    }
    bool looks_like_graph() const { return text.find("\"wrinkle\"") != text.npos; }
};

struct MergeCommand {
    CommonOptions common;
    std::string base, ours, theirs, output, path;
    int marker_size = 7;
    bool ancestor = false;

    int run() {
        for (const std::string& file : {base, ours, theirs})
            if (!stream_title(file).empty())
                return fail(exit_usage, file + " is a stream; merge reads files");
        if (output.empty()) output = ours;
        if (path.empty()) path = output == "-" ? ours : output;
        const std::string made[] = {output, conflict_file_of(path)};
        if (const std::string why = overwrite_fault_of_run(made, {base, theirs}); !why.empty())
            return fail(exit_usage, why);
        Diagnostics problems;
        const auto three = read_inputs(problems);
        if (const int code = report(problems, common.diagnostics); code != exit_success)
            return code;
        const auto& [a, b, c] = *three;
        if (a.is_graph() && b.is_graph() && c.is_graph() && !b.is_blank() && !c.is_blank())
            return merge_graphs(a, b, c);
        return merge_texts(a, b, c);
    }

    std::optional<std::array<MergeInput, 3>> read_inputs(Diagnostics& problems) const {
        std::array<MergeInput, 3> inputs;
        const std::array files = {&base, &ours, &theirs};
        for (size_t i = 0; i < inputs.size(); ++i) {
            const auto text = read_text(*files[i], problems);
            if (!text) continue;
            inputs[i].text = *text;
            if (inputs[i].is_blank()) {
                inputs[i].document.file = path;
                continue;
            }
            inputs[i].document = read_document(*text, path, inputs[i].diagnostics);
        }
        if (problems.has_errors()) return {};
        return inputs;
    }

    int merge_graphs(const MergeInput& a, const MergeInput& b, const MergeInput& c) const {
        const auto purpose =
            ancestor ? difference::MergePurpose::ancestor : difference::MergePurpose::result;
        Merged merged = merge(a.document, b.document, c.document, purpose);
        if (!ancestor) add_compile_errors(merged);
        std::vector<Result> results = {{output, merged.text}};
        const bool is_listed = !merged.conflicts.empty() && !ancestor;
        if (is_listed)
            results.push_back({conflict_file_of(path), conflicts_text(merged.conflicts)});
        if (const int code = write_results(results); code != exit_success) return code;
        if (is_listed) print_conflicts(merged.conflicts);
        warn_of_old_list(is_listed);
        return merged.conflicts.empty() ? exit_success : exit_input;
    }

    // Types and ports are known to the registry only. With other conflicts, `wrinkle check` reports
    // these errors after them.
    void add_compile_errors(Merged& merged) const {
        Diagnostics ignored;
        const Nodes nodes = load_nodes(common, ignored);
        Diagnostics reading;
        const Document result = read_document(merged.text, path, reading);
        if (reading.has_errors() || !merged.conflicts.empty()) return;
        add_new_errors(compile_errors(merged.ours, nodes.registry),
                       compile_errors(merged.theirs, nodes.registry),
                       compile_errors(result, nodes.registry), merged.conflicts);
    }

    Diagnostics compile_errors(const Document& document, const Registry& registry) const {
        Diagnostics diagnostics;
        ProjectOptions options;
        options.root = common.root;
        const fs::path folder = fs::path(path).parent_path();
        const Project project =
            load_project(document, folder.empty() ? "." : folder, options, diagnostics);
        compile_or_check(project, registry, {}, diagnostics);
        return diagnostics;
    }

    void print_conflicts(const std::vector<difference::Conflict>& conflicts) const {
        for (const difference::Conflict& conflict : conflicts)
            print_error(path + ": conflict: " + sentence_of(conflict));
        print_error(path + ": wrinkle settle " + path + " settles conflicts");
    }

    void warn_of_old_list(bool is_listed) const {
        std::error_code error;
        if (is_listed || ancestor || !fs::exists(conflict_file_of(path), error)) return;
        print_error(conflict_file_of(path) + " is the list of an earlier merge; wrinkle settle " +
                    path + " --current removes it");
    }

    // A file that is not a graph is merged by lines. A graph that cannot be read is a conflict even
    // if its lines merge: its nodes were not compared.
    int merge_texts(const MergeInput& a, const MergeInput& b, const MergeInput& c) const {
        for (const MergeInput* input : {&a, &b, &c})
            if (!is_utf8(input->text))
                return fail(exit_input, path + " cannot be merged: a side is not UTF-8 text");
        bool is_damaged = false;
        for (const MergeInput* input : {&a, &b, &c}) {
            if (!input->looks_like_graph() || input->is_graph()) continue;
            is_damaged = true;
            report(input->diagnostics, common.diagnostics);
        }
        const GitResult lines =
            run_git({"merge-file", "-p", "--marker-size=" + std::to_string(marker_size), "-L",
                     "ours", "-L", "base", "-L", "theirs", ours, base, theirs});
        if (lines.code < 0 || lines.code > 127)
            return fail(exit_input, path + " cannot be merged: git merge-file failed");
        if (const int code = write_result(output, lines.output); code != exit_success) return code;
        if (is_damaged) print_error(path + ": a side is not a valid graph: merged by lines");
        return lines.code == 0 && !is_damaged ? exit_success : exit_input;
    }
};

}  // namespace

void declare_merge(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<MergeCommand>(app, run, "merge",
                                              "Merges two versions of a graph by node, for Git");
    sub.footer(
        "Exit codes: 0 merged, 1 conflicts: the result has the values of OURS, and "
        "NAME.json.conflicts lists them.");
    sub.add_option("BASE", c.base, "The common version (Git's %O); empty if both added the file")
        ->required();
    sub.add_option("OURS", c.ours, "Our version (%A); replaced by the result")->required();
    sub.add_option("THEIRS", c.theirs, "Their version (%B)")->required();
    sub.add_option("-o", c.output, "The result; default: OURS; - is standard output")
        ->type_name("GRAPH");
    sub.add_option("--path", c.path,
                   "Name of the graph in the repository (%P); default: the result")
        ->type_name("GRAPH");
    sub.add_option("--marker-size", c.marker_size,
                   "Length of conflict markers of lines (%L), for files that are not graphs")
        ->type_name("N")
        ->check(CLI::Range(1, 1000));
    sub.add_flag("--ancestor", c.ancestor,
                 "The result is the base of another merge (merge.NAME.recursive of Git)");
    sub.add_option("--root", c.common.root,
                   "Where the files of the graph must lie; default: its own folder")
        ->type_name("DIR");
    declare_plugin_path(sub, c.common);
    declare_diagnostics(sub, c.common.diagnostics);
}

}  // namespace wrinkle::cli
