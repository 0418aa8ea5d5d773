#include "report/ci_formats.h"

#include "base/text.h"
#include "report/annotations.h"
#include "report/outcome.h"

namespace wrinkle::report {
namespace {

// A description ends at '#'; a backslash escapes.
std::string tap_description(std::string_view text) {
    std::string result;
    for (const char c : printable(text)) {
        if (c == '#' || c == '\\') result += '\\';
        result += c;
    }
    return result;
}

std::string tap_point(size_t number, const Check& check, const CiOptions& options) {
    const Outcome outcome = outcome_of(check, options);
    const bool ok = outcome == Outcome::passed || outcome == Outcome::skipped;
    std::string text =
        (ok ? "ok " : "not ok ") + std::to_string(number) + " - " + tap_description(check.id());
    if (outcome == Outcome::skipped) text += " # SKIP " + tap_description(message_of(check));
    text += "\n";
    if (ok) return text;
    // A string of JSON is one of YAML.
    text += "  ---\n  message: " + json_quoted(message_of(check)) +
            "\n  status: " + std::string(name_of(check.status)) + "\n";
    if (const std::string details = details_of(check); !details.empty())
        text += "  details: " + json_quoted(details) + "\n";
    if (!check.file.empty())
        text += "  at:\n    file: " + json_quoted(file_of(check, options)) +
                "\n    line: " + std::to_string(check.line) +
                "\n    column: " + std::to_string(check.column) + "\n";
    return text + "  ...\n";
}

}  // namespace

std::string tap(const Results& results, const CiOptions& options) {
    const size_t count = results.checks.size() + results.problems.size();
    std::string text = "TAP version 14\n1.." + std::to_string(count) + "\n";
    size_t number = 0;
    for (const Check& check : results.checks)
        text += tap_point(++number, check, options);
    for (const Check& check : checks_of_run(results))
        text += tap_point(++number, check, options);
    return text;
}

std::string github_annotations(const Results& results, const CiOptions& options) {
    std::vector<Annotation> annotations;
    const auto add = [&](const Check& check) {
        const Outcome outcome = outcome_of(check, options);
        if (outcome == Outcome::passed) return;
        const std::string details = details_of(check);
        annotations.push_back({outcome != Outcome::skipped, file_of(check, options), check.line,
                               check.column, check.id(),
                               message_of(check) + (details.empty() ? "" : "\n" + details)});
    };
    for (const Check& check : checks_of_run(results))
        add(check);
    for (const size_t i : results.by_severity())
        add(results.checks[i]);
    return github_commands(std::move(annotations));
}

}  // namespace wrinkle::report
