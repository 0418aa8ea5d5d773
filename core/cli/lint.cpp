// wrinkle lint IMAGE...: detects the kind of maps and reports their defects.
#include <cstdio>

#include "base/printable.h"
#include "base/text.h"
#include "cli/cli.h"
#include "cli/output.h"
#include "maps/lint.h"

namespace wrinkle::cli {
namespace {

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string as_text(const std::string& file, const maps::Verdict& verdict) {
    std::string text = printable(file) + ": " + std::string(name_of(verdict.map_class)) + ": " +
                       std::string(description_of(verdict.map_class)) + "\n";
    text += "  evidence:";
    for (const maps::Measure& measure : verdict.evidence)
        text += " " + measure.name + " " + number(measure.value);
    text += "\n";
    for (const maps::Finding& finding : verdict.findings)
        text += std::string("  ") + (finding.is_defect ? "defect" : "note") + ": " +
                std::string(name_of(finding.defect)) + ": " + finding.message + "\n";
    return text;
}

std::string as_json(const maps::Measure& measure) {
    return json_quoted(measure.name) + ": " + number(measure.value);
}

std::string as_json(const maps::Finding& finding) {
    return "{\"name\": " + json_quoted(name_of(finding.defect)) +
           ", \"defect\": " + (finding.is_defect ? "true" : "false") +
           ", \"message\": " + json_quoted(finding.message) + "}";
}

std::string as_json(const std::string& file, const maps::Verdict& verdict) {
    const auto text_of = [](const auto& part) { return as_json(part); };
    return "{\"file\": " + json_quoted(file) + ", \"look\": \"" +
           std::string(name_of(verdict.map_class)) + "\", \"evidence\": {" +
           joined(verdict.evidence, ", ", text_of) + "}, \"findings\": [" +
           joined(verdict.findings, ", ", text_of) + "]}";
}

struct LintCommand {
    std::vector<std::string> files;
    std::string expect, wrap, diagnostics = "text";
    bool json = false;

    // Makes seams defects if --wrap repeat is given, even for an image classified as an atlas.
    static void hold_to_repeat(maps::Verdict& verdict) {
        for (maps::Finding& finding : verdict.findings)
            finding.is_defect |= finding.defect == maps::MapDefect::seam_u ||
                                 finding.defect == maps::MapDefect::seam_v;
    }

    int run() const {
        Diagnostics problems;
        std::string text;
        bool healthy = true;
        size_t count = 0;
        for (const std::string& file : files) {
            auto examined =
                maps::examine(file, *wrap_named(wrap.empty() ? "repeat" : wrap), problems);
            if (!examined) continue;
            maps::Verdict& verdict = examined->verdict;
            if (wrap == "repeat") hold_to_repeat(verdict);
            if (!expect.empty() && name_of(verdict.map_class) != expect)
                verdict.findings.push_back(
                    {maps::MapDefect::unexpected, "it was to be " + expect, true});
            healthy = healthy && !verdict.has_defects();
            text += json ? (count ? ",\n" : "") + as_json(file, verdict) : as_text(file, verdict);
            ++count;
        }
        if (json) text = "{\"images\": [" + text + "]}\n";
        const int code = report(problems, diagnostics);
        if (write_result("-", text) != exit_success) return exit_environment;
        return code == exit_success && !healthy ? int{exit_input} : code;
    }
};

}  // namespace

void declare_lint(CLI::App& app, Run& run) {
    auto [sub, c] =
        add_command<LintCommand>(app, run, "lint", "Finds the kinds and the defects of maps");
    sub.add_option("IMAGE", c.files, "Normal maps and height maps")->required();
    add_choice(sub, "--expect", c.expect, {"normal_gl", "normal_dx", "height"},
               "Expected kind; any other is a defect");
    add_choice(sub, "--wrap", c.wrap, {"repeat", "clamp"},
               "clamp: a seam is not a defect; repeat: it is, in an atlas too; default: it is, "
               "but in an atlas");
    sub.add_flag("--json", c.json, "Verdicts and numbers for programs");
    declare_diagnostics(sub, c.diagnostics);
}

}  // namespace wrinkle::cli
