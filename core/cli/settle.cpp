// wrinkle settle FILE [ID...]: takes a side of the open conflicts of a merge, or lists them.
#include <algorithm>
#include <filesystem>

#include "base/file.h"
#include "base/printable.h"
#include "cli/cli.h"
#include "cli/conflict_file.h"
#include "cli/output.h"
#include "cli/session.h"

namespace wrinkle::cli {
namespace {

using difference::Conflict;
using difference::ConflictKind;
using difference::Side;

// "weave" and "weave.scale" select a conflict of node weave, port scale.
bool is_selected(const Conflict& conflict, const std::string& word) {
    return word == conflict.id || word == conflict.id + "." + conflict.key.name;
}

struct SettleCommand {
    std::string file, diagnostics = "text";
    std::vector<std::string> ids;
    bool ours = false, theirs = false, current = false;

    int run() const {
        if (ours + theirs + current > 1)
            return fail(exit_usage, "--ours, --theirs and --current exclude each other");
        if (!stream_title(file).empty()) return fail(exit_usage, file + " is a stream");
        Diagnostics problems;
        const auto conflicts = open_conflicts(file, problems);
        const bool is_list = !(ours || theirs || current);
        if (conflicts && is_list && ids.empty()) return list(*conflicts);
        std::vector<Conflict> open;
        const auto text =
            conflicts && !is_list ? settled(*conflicts, open, problems) : std::nullopt;
        if (const int code = report(problems, diagnostics); code != exit_success) return code;
        if (is_list) return fail(exit_usage, "name a side: --ours, --theirs or --current");
        return write(*text, open);
    }

    int list(const std::vector<Conflict>& conflicts) const {
        std::string text;
        for (const Conflict& conflict : conflicts)
            text += printable(sentence_of(conflict)) + "\n";
        if (conflicts.empty()) text = "no open conflicts\n";
        const int code = write_result("-", text);
        return code == exit_success && !conflicts.empty() ? int{exit_input} : code;
    }

    // Returns the new text of the graph and the conflicts that remain open.
    std::optional<std::string> settled(const std::vector<Conflict>& conflicts,
                                       std::vector<Conflict>& open, Diagnostics& problems) const {
        for (const std::string& id : ids)
            if (std::ranges::none_of(conflicts,
                                     [&](const Conflict& each) { return is_selected(each, id); }))
                problems.add(file_problem(Severity::error, RuleId::option, file,
                                          "has no open conflict of " + id,
                                          "wrinkle settle " + file + " lists them"));
        auto text = read_text(file, problems);
        if (problems.has_errors()) return {};
        for (const Conflict& conflict : conflicts) {
            const bool is_chosen =
                ids.empty() || std::ranges::any_of(ids, [&](const std::string& id) {
                    return is_selected(conflict, id);
                });
            if (!is_chosen)
                open.push_back(conflict);
            else if (!current)
                text = with_choice(std::move(*text), conflict, problems);
            if (problems.has_errors()) return {};
        }
        return text;
    }

    std::string with_choice(std::string text, const Conflict& conflict,
                            Diagnostics& problems) const {
        if (conflict.kind == ConflictKind::error) {
            problems.add(file_problem(Severity::error, RuleId::option, file,
                                      "has no side to choose: " + sentence_of(conflict),
                                      "edit the graph, then --current"));
            return text;
        }
        Diagnostics own;
        const Document document = read_document(text, file, own);
        if (difference::entries_fault(document).empty())
            return with_side(document, conflict, ours ? Side::ours : Side::theirs);
        problems.append(own);
        return text;
    }

    int write(const std::string& text, const std::vector<Conflict>& open) const {
        std::vector<Result> results = {{file, text}};
        if (!open.empty()) results.push_back({conflict_file_of(file), conflicts_text(open)});
        if (const int code = write_results(results); code != exit_success) return code;
        if (!open.empty()) return exit_success;
        std::error_code error;
        std::filesystem::remove(conflict_file_of(file), error);
        return error ? fail(exit_environment,
                            conflict_file_of(file) + " cannot be removed: " + error.message())
                     : int{exit_success};
    }
};

}  // namespace

void declare_settle(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<SettleCommand>(app, run, "settle",
                                               "Takes a side of the conflicts of a merged graph");
    sub.footer("Without a side it lists the open conflicts; exit code 1 if there are any.");
    sub.add_option("FILE", c.file, "A graph that wrinkle merge left with conflicts")->required();
    sub.add_option("ID", c.ids, "Node, output or input, or NODE.PORT; default: all conflicts")
        ->type_name("");
    sub.add_flag("--ours", c.ours, "Takes the value of our side, which the graph has already");
    sub.add_flag("--theirs", c.theirs, "Takes the value of their side");
    sub.add_flag("--current", c.current, "Leaves the graph as edited since");
    declare_diagnostics(sub, c.diagnostics);
}

}  // namespace wrinkle::cli
