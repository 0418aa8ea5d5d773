// wrinkle test PATH...: runs regression cases (cli/test_case.h).
#include <cstdio>

#include "cli/output.h"
#include "cli/test_run.h"
#include "gpu/context.h"

namespace wrinkle::cli {
namespace {

struct TestCommand {
    CommonOptions common;
    TestOptions options;
    std::vector<std::string> paths;
    bool schema = false;

    int run() const {
        gpu::Context::prefer_quick_programs();
        if (schema) return write_result("-", case_schema());
        if (paths.empty())
            return fail(exit_usage,
                        "test needs NAME.test.json, or a folder with such files; "
                        "--help lists more");
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        const auto tests = find_tests(paths, diagnostics);
        if (diagnostics.has_errors()) return report(diagnostics, common.diagnostics);
        TestRun run(nodes.registry, common, options);
        for (const auto& file : tests)
            run.test(file, diagnostics);
        const TestTally& tally = run.tally();
        const bool json = common.diagnostics == "json";
        if (json) diagnostics.append(run.failures());
        if (json && !tally.environment.empty()) diagnostics.error(tally.environment);
        const int code = report(diagnostics, common.diagnostics);
        if (!json && !tally.environment.empty()) print_error(tally.environment);
        std::printf("%zu passed, %zu failed\n", tally.passed, tally.failed);
        if (!tally.environment.empty()) return exit_environment;
        return tally.failed > 0 ? int{exit_input} : code;
    }
};

}  // namespace

void declare_test(CLI::App& app, Run& run) {
    auto [sub, c] =
        add_command<TestCommand>(app, run, "test", "Runs the regression cases of graphs");
    sub.add_option("PATH", c.paths, "NAME.test.json, or folders that are searched for such files");
    sub.add_flag("--schema", c.schema, "Prints the JSON Schema of such files, and runs none");
    sub.add_flag("--update", c.options.update,
                 "Writes golden files and the 'expect' values that differ");
    sub.add_option("--report", c.options.report,
                   "Gets the texts and pictures that differ from golden files")
        ->type_name("DIR");
    declare_common(sub, c.common, false);
}

}  // namespace wrinkle::cli
