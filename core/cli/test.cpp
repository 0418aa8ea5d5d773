// wrinkle test PATH...: runs regression cases (cli/test_case.h), reviews and accepts their results.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <set>

#include "base/checksum.h"
#include "base/file.h"
#include "base/printable.h"
#include "cli/arguments.h"
#include "cli/cli.h"
#include "cli/jobs.h"
#include "cli/output.h"
#include "cli/test_accept.h"
#include "cli/test_baselines.h"
#include "cli/test_formats.h"
#include "cli/test_report.h"
#include "cli/test_review.h"
#include "cli/test_run.h"
#include "cli/test_selection.h"
#include "gpu/context.h"
#include "report/results_json.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

using report::Check;
using report::Results;
using report::Status;

// Returns the part, 1 to `count`, of a name: by its hash, so that a new test moves no other.
unsigned shard_of(const std::string& name, unsigned count) {
    return static_cast<unsigned>(std::stoull(sha256(name).substr(0, 8), nullptr, 16) % count) + 1;
}

struct TestCommand {
    CommonOptions common;
    CiFormats formats;
    std::vector<std::string> paths, names, shards, filters;
    std::string report_folder, cache_folder, shard, revision;
    unsigned jobs = 0;
    bool schema = false, update = false, review = false, is_ci = false;

    int run() {
        gpu::Context::prefer_quick_programs();
        if (schema) return write_result("-", case_schema());
        if (const std::string why = wrong_usage(); !why.empty()) return fail(exit_usage, why);
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        if (!shards.empty()) return merge();
        if (paths.empty()) return approve_last_run(nodes.registry);
        const auto tests = find_tests(paths, diagnostics);
        if (diagnostics.has_errors()) return report(diagnostics, common.diagnostics);
        return run_tests(tests, nodes.registry, diagnostics);
    }

    std::string wrong_usage() {
        const bool approves = review || !names.empty();
        if (!shards.empty() && !(paths.empty() && !approves && !update))
            return "--merge goes with --report and the formats of CI systems only";
        if (!shards.empty() && report_folder.empty()) return "--merge needs --report DIR";
        if (paths.empty() && !approves && shards.empty())
            return "test needs NAME.test.json, or a folder with such files; --help lists more";
        if (!names.empty() && !paths.empty())
            return "--accept takes the results of the last run: run the tests first, without it";
        if (!names.empty() && (review || update))
            return "--accept, --review and --update exclude each other";
        if (review && update) return "--review and --update exclude each other";
        if (paths.empty() && !(filters.empty() && revision.empty()))
            return "--filter and --changed-since select among the tests of PATH";
        if (is_ci && (update || approves)) return "--ci writes no baselines";
        if (!shard.empty() && !parse_shard())
            return "--shard " + shard + ": expected I/N with 1 <= I <= N, such as 2/4";
        return "";
    }

    struct Shard {
        unsigned index = 1, count = 1;
    };
    std::optional<Shard> parse_shard() const {
        if (shard.empty()) return Shard{};
        unsigned numbers[2];
        if (!parse_numbers<unsigned>(shard, '/', numbers)) return {};
        if (numbers[0] < 1 || numbers[0] > numbers[1]) return {};
        return Shard{numbers[0], numbers[1]};
    }

    fs::path folder() const { return report_folder.empty() ? default_report : report_folder; }

    int run_tests(const std::vector<fs::path>& tests, const Registry& registry,
                  Diagnostics& diagnostics) {
        const auto start = std::chrono::steady_clock::now();
        Results results;
        results.version = WRINKLE_VERSION;
        results.command = command_of_run();
        results.approval = approval();
        results.started = time_of_report();
        results.added_fails = in_ci();
        std::optional<Cache> images;
        if (!cache_folder.empty()) images.emplace(cache_folder, Cache::default_limit);
        const TestSettings settings{registry, common, folder(), images ? &*images : nullptr};
        std::vector<TestFile> files(tests.size());
        for_each_item(tests.size(), thread_count(jobs, tests.size()),
                      [&](size_t i) { files[i] = read_test_file(tests[i]); });
        const std::vector<Check> deleted = deleted_of(files);
        select(files, registry, diagnostics);
        if (diagnostics.has_errors()) return report(diagnostics, common.diagnostics);
        std::vector<TestOutcome> outcomes(files.size());
        for_each_item(files.size(), thread_count(jobs, files.size()),
                      [&](size_t i) { outcomes[i] = run_test_file(files[i], settings); });
        if (images) images->prune();
        std::string environment;
        std::vector<report::CaseUses> uses;
        for (TestOutcome& outcome : outcomes) {
            uses.insert(uses.end(), outcome.uses.begin(), outcome.uses.end());
            take(outcome, results, environment, diagnostics);
        }
        results.causes = report::likely_causes(uses);
        results.checks.insert(results.checks.end(), deleted.begin(), deleted.end());
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        results.seconds = passed.count();
        clear_durations_if_reproducible(results);
        if (!environment.empty()) results.problems.push_back(environment);
        return finish(results, environment, registry, diagnostics);
    }

    static void take(TestOutcome& outcome, Results& results, std::string& environment,
                     Diagnostics& diagnostics) {
        diagnostics.append_once(outcome.problems);
        if (results.driver.empty()) results.driver = outcome.driver;
        if (environment.empty()) environment = outcome.environment;
        results.checks.insert(results.checks.end(), std::make_move_iterator(outcome.checks.begin()),
                              std::make_move_iterator(outcome.checks.end()));
    }

    // Searches the folders that were named, not those of files that were named.
    std::vector<Check> deleted_of(const std::vector<TestFile>& files) const {
        std::error_code ignored;
        std::set<fs::path> folders;
        for (const TestFile& file : files)
            if (std::ranges::any_of(paths, [&](const std::string& path) {
                    return fs::is_directory(path, ignored) && inside(path, file.path);
                }))
                folders.insert(file.path.parent_path());
        std::vector<fs::path> unread = unread_baselines(folders, files);
        std::erase_if(unread, [&](const fs::path& file) {
            const fs::path name = file.parent_path().parent_path() / file.stem();
            return !is_in_shard(file) ||
                   !has_selected_name(filters, near_path(name).generic_string());
        });
        return deleted_checks(unread);
    }

    // Removes the cases that the options leave out. A file that cannot be read remains.
    void select(std::vector<TestFile>& files, const Registry& registry,
                Diagnostics& diagnostics) const {
        std::optional<ChangedFiles> changed;
        if (!revision.empty()) changed = ChangedFiles::since(revision, diagnostics);
        if (diagnostics.has_errors()) return;
        size_t selected = 0;
        for (TestFile& file : files) {
            std::erase_if(file.cases, [&](const TestCase& test) {
                return !has_selected_name(filters, test.full_name());
            });
            selected += file.cases.size() + file.problems.has_errors();
        }
        if (selected == 0 && !filters.empty())
            diagnostics.error(RuleId::option,
                              "--filter " + joined(filters, ", ") + ": no case has such a name",
                              "a part of a name such as graphs/rings, or a pattern such as '*/r*'");
        std::erase_if(files, [&](const TestFile& file) { return !is_in_shard(file.path); });
        if (!changed) return;
        for_each_item(files.size(), thread_count(jobs, files.size()), [&](size_t i) {
            std::erase_if(files[i].cases, [&](const TestCase& test) {
                return !has_changed(test, *changed, registry, common);
            });
        });
    }

    bool is_in_shard(const fs::path& file) const {
        const Shard part = *parse_shard();
        return part.count == 1 ||
               shard_of(near_path(file).generic_string(), part.count) == part.index;
    }

    int finish(Results& results, std::string& environment, const Registry& registry,
               Diagnostics& diagnostics) {
        Acceptance accepted;
        const auto to_update = [&](const Check& check) {
            return update && (check.status == Status::failed || check.status == Status::added);
        };
        if (update) accepted = accept(results, folder(), to_update, registry, common);
        if (review) accepted = review_results(results, folder(), registry, common);
        if (environment.empty()) environment = accepted.environment;
        for (const std::string& sentence : accepted.refused)
            diagnostics.error(RuleId::test_failed, sentence);
        write_outputs(results, environment);
        return conclude(results, environment, diagnostics);
    }

    void write_outputs(const Results& results, std::string& environment) const {
        write_folder(results, environment);
        std::string why;
        if (!write_formats(formats, results, folder(), why) && environment.empty())
            environment = why;
    }

    // The default folder is written only for checks that are not passed. That it cannot be written
    // matters only if a folder was named, or if something is to be accepted from it.
    void write_folder(const Results& results, std::string& environment) const {
        if (report_folder.empty() && results.count(Status::passed) == results.checks.size())
            return remove_report(folder());
        std::string why;
        if (write_report(results, folder(), why)) return;
        if (!report_folder.empty() && environment.empty()) environment = why;
    }

    int conclude(const Results& results, const std::string& environment,
                 Diagnostics& diagnostics) const {
        const bool json = common.diagnostics == "json";
        if (json) diagnostics.append(failed_checks(results));
        if (json && !environment.empty()) diagnostics.error(RuleId::environment, environment);
        std::fputs(failures_text(results).c_str(), stdout);
        for (const std::string& cause : results.causes)
            std::printf("likely cause: %s\n", printable(cause).c_str());
        const int code = report(diagnostics, common.diagnostics);
        if (!json && !environment.empty()) print_error(environment);
        if (const std::string hint = hint_of(results); !hint.empty())
            std::printf("%s\n", printable(hint).c_str());
        std::printf("%s\n", counts_text(results).c_str());
        if (!environment.empty()) return exit_environment;
        return results.fails() ? int{exit_input} : code;
    }

    // Failures of cases that ran, as problems.
    static Diagnostics failed_checks(const Results& results) {
        Diagnostics failures;
        for (const Check& check : results.checks)
            if (is_pending(check) ||
                (check.kind == report::CheckKind::cost && check.status != Status::passed))
                failures.add({RuleId::test_failed,
                              Severity::error,
                              {check.file, check.line, check.column},
                              check.pointer,
                              "",
                              check.message,
                              check.expected});
        return failures;
    }

    bool in_ci() const {
        const char* value = std::getenv("CI");
        return is_ci || (value && *value && std::string_view(value) != "false");
    }

    std::string hint_of(const Results& results) const {
        if (std::ranges::none_of(results.checks, is_pending)) return "";
        return "report: " + (folder() / page_file).string() + "; " + results.approval +
               " --review shows each difference, --accept ID writes it";
    }

    // --accept and --review of the last run.
    int approve_last_run(const Registry& registry) {
        Diagnostics diagnostics;
        std::error_code ignored;
        if (!fs::exists(folder() / results_file, ignored))
            return fail(
                exit_usage,
                folder().string() + " has no results that differ; run `wrinkle test PATH` first");
        auto results = report::read_results(folder() / results_file, diagnostics);
        if (!results) return report(diagnostics, common.diagnostics);
        const Acceptance accepted = review ? review_results(*results, folder(), registry, common)
                                           : accept_named(*results, registry, diagnostics);
        std::string environment = accepted.environment;
        if (!diagnostics.has_errors()) write_folder(*results, environment);
        if (!review)
            for (const std::string& file : accepted.written)
                std::printf("%s\n", printable(file).c_str());
        for (const std::string& sentence : accepted.refused)
            diagnostics.error(RuleId::test_failed, sentence);
        const int code = report(diagnostics, common.diagnostics);
        return environment.empty() ? code : fail(exit_environment, environment);
    }

    Acceptance accept_named(Results& results, const Registry& registry, Diagnostics& diagnostics) {
        for (const std::string& name : names)
            if (std::ranges::none_of(results.checks, [&](const Check& check) {
                    return is_pending(check) && selects(name, check);
                }))
                diagnostics.error(
                    RuleId::option,
                    "--accept " + name + ": no result of the last run that differs has this name",
                    "new, changed, deleted, all, or an id that the run printed");
        if (diagnostics.has_errors()) return {};
        const auto accepts = [&](const Check& check) {
            return std::ranges::any_of(
                names, [&](const std::string& name) { return selects(name, check); });
        };
        return accept(results, folder(), accepts, registry, common);
    }

    int merge() {
        Results results;
        results.version = WRINKLE_VERSION;
        results.approval = approval();
        results.added_fails = in_ci();
        std::string why;
        if (!make_report_folder(folder(), why)) return fail(exit_environment, why);
        for (const std::string& each : shards)
            if (!merge_report(each, folder(), results, why)) return fail(exit_input, why);
        std::ranges::stable_sort(results.checks, {}, &Check::test);
        std::string environment;
        write_outputs(results, environment);
        Diagnostics diagnostics;
        return conclude(results, environment, diagnostics);
    }

    std::string approval() const {
        return report_folder.empty() ? "wrinkle test"
                                     : "wrinkle test --report " + shell_quoted(report_folder);
    }

    std::string command_of_run() const {
        std::string command = "wrinkle test";
        for (const std::string& path : paths)
            command += " " + shell_quoted(path);
        for (const std::string& filter : filters)
            command += " --filter " + shell_quoted(filter);
        if (!revision.empty()) command += " --changed-since " + shell_quoted(revision);
        for (const std::string& path : common.plugin_paths)
            command += " --plugin-path " + shell_quoted(path);
        if (!common.root.empty()) command += " --root " + shell_quoted(common.root);
        if (common.no_tangents) command += " --no-tangents";
        return command;
    }
};

}  // namespace

void declare_test(CLI::App& app, Run& run) {
    auto [sub, c] =
        add_command<TestCommand>(app, run, "test", "Runs the regression cases of graphs");
    sub.add_option("PATH", c.paths, "NAME.test.json, or folders that are searched for such files");
    sub.add_flag("--schema", c.schema, "Prints the JSON Schema of such files, and runs none");
    sub.add_option("-j", c.jobs, "Threads; 0 is one for each core")->capture_default_str();
    sub.add_option(
           "--filter", c.filters,
           "Runs the cases with this text in their name, or that match a pattern of *, ? and []")
        ->type_name("TEXT|GLOB")
        ->allow_extra_args(false)  // one value each: the next word may be a PATH
        ->take_all();
    sub.add_option("--changed-since", c.revision,
                   "Runs the cases with files that changed since a Git revision")
        ->type_name("REV");
    sub.add_option("--shard", c.shard, "Runs part I of N of the test files")->type_name("I/N");
    sub.add_flag("--update", c.update,
                 "Writes the golden files and the 'expect' values that differ or are new");
    sub.add_flag(
        "--review", c.review,
        "Shows each difference and reads whether to write it; without PATH, those of the last run");
    sub.add_option("--accept", c.names,
                   "Writes differences of the last run: new, changed, deleted, all, or ids")
        ->type_name("NAME...");
    sub.add_flag("--ci", c.is_ci, "New cases fail, and nothing is accepted; set if CI is");
    sub.add_option("--report", c.report_folder,
                   std::string("Folder of the report; default: ") + default_report +
                       ", if there is a difference")
        ->type_name("DIR");
    sub.add_option("--cache", c.cache_folder,
                   "Takes images of unchanged cases from here, and stores others; holds 1GB")
        ->type_name("DIR");
    sub.add_option("--merge", c.shards, "Merges the reports of shards into --report; runs no case")
        ->type_name("DIR...");
    declare_formats(sub, c.formats);
    declare_common(sub, c.common, false);
}

}  // namespace wrinkle::cli
