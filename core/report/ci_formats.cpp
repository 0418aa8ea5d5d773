#include "report/ci_formats.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "base/printable.h"
#include "base/text.h"
#include "report/annotations.h"
#include "report/repository.h"
#include "report/text_diff.h"
#include "report/xml.h"

namespace wrinkle::report {
namespace {

constexpr size_t max_text = 20'000;  // bytes of a difference in JUnit

std::string attribute(const char* name, std::string_view value) {
    return " " + std::string(name) + "=\"" + xml_attribute(value) + "\"";
}

std::string seconds_text(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6f", seconds);
    return text;
}

// How a CI system counts a check.
enum class Verdict : uint8_t { passed, failed, error, skipped };
Verdict verdict_of(const Check& check, const Results& results) {
    if (check.status == Status::passed) return Verdict::passed;
    if (check.status == Status::error) return Verdict::error;
    return results.fails(check) ? Verdict::failed : Verdict::skipped;
}

struct Tally {
    size_t tests = 0, failures = 0, errors = 0, skipped = 0;
    double seconds = 0;

    void add(const Check& check, Verdict verdict) {
        ++tests;
        failures += verdict == Verdict::failed;
        errors += verdict == Verdict::error;
        skipped += verdict == Verdict::skipped;
        seconds += check.seconds;
    }
    std::string attributes() const {
        return attribute("tests", std::to_string(tests)) +
               attribute("failures", std::to_string(failures)) +
               attribute("errors", std::to_string(errors)) +
               attribute("skipped", std::to_string(skipped)) +
               attribute("time", seconds_text(seconds));
    }
};

std::string difference_text(const Check& check) {
    std::string text = check.message + "\n";
    if (!check.expected.empty()) text += check.expected + "\n";
    for (const Measured& each : check.measured)
        text += each.name + ": " + each.expected + " -> " + each.actual + "\n";
    if (check.kind != CheckKind::text) return text;
    for (const DiffLine& line : diff_lines(check.expected_text, check.actual_text)) {
        text += " -+~"[static_cast<size_t>(line.kind)] + std::string(line.text) + "\n";
        if (text.size() > max_text) return text + "...\n";
    }
    return text;
}

std::string testcase(const Check& check, Verdict verdict, const CiOptions& options) {
    std::string name = check.test;
    std::ranges::replace(name, '/', '.');
    std::string text = "    <testcase" + attribute("name", check.name) +
                       attribute("classname", name) + attribute("file", check.file);
    if (check.line) text += attribute("line", std::to_string(check.line));
    text += attribute("time", seconds_text(check.seconds));
    if (verdict == Verdict::passed) return text + "/>\n";
    text += ">\n";
    const std::string message = attribute("message", check.message);
    if (verdict == Verdict::skipped) {
        text += "      <skipped" + message + "/>\n";
    } else {
        const std::string tag = verdict == Verdict::error ? "error" : "failure";
        text += "      <" + tag + message + attribute("type", name_of(check.status)) + ">" +
                xml_text(difference_text(check)) + "</" + tag + ">\n";
    }
    if (options.attachment && !check.joined_image.empty())
        text += "      <system-out>[[ATTACHMENT|" +
                xml_text(options.attachment(check.joined_image)) + "]]</system-out>\n";
    return text + "    </testcase>\n";
}

// A description ends at '#'; a backslash escapes both.
std::string tap_description(std::string_view text) {
    std::string escaped;
    for (const char c : printable(text)) {
        if (c == '#' || c == '\\') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

}  // namespace

std::string junit(const Results& results, const CiOptions& options) {
    Tally all;
    std::vector<std::string> names;  // in the order of the results
    std::map<std::string, std::pair<Tally, std::string>> suites;
    for (const Check& check : results.checks) {
        if (!suites.contains(check.test)) names.push_back(check.test);
        auto& [tally, cases] = suites[check.test];
        const Verdict verdict = verdict_of(check, results);
        tally.add(check, verdict);
        all.add(check, verdict);
        cases += testcase(check, verdict, options);
    }
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" +
                       attribute("name", "wrinkle test") + all.attributes() + ">\n";
    for (const std::string& name : names) {
        const auto& [tally, cases] = suites[name];
        text += "  <testsuite" + attribute("name", name) + tally.attributes();
        if (!results.started.empty()) text += attribute("timestamp", results.started);
        text += ">\n" + cases + "  </testsuite>\n";
    }
    return text + "</testsuites>\n";
}

std::string tap(const Results& results) {
    std::string text = "TAP version 14\n1.." + std::to_string(results.checks.size()) + "\n";
    size_t number = 0;
    for (const Check& check : results.checks) {
        const Verdict verdict = verdict_of(check, results);
        const bool passes = verdict == Verdict::passed || verdict == Verdict::skipped;
        text += (passes ? "ok " : "not ok ") + std::to_string(++number) + " - " +
                tap_description(check.id());
        if (verdict == Verdict::skipped) text += " # SKIP " + tap_description(check.message);
        text += "\n";
        if (!passes)
            text += "  ---\n  message: " + json_quoted(printable(check.message)) +
                    "\n  file: " + json_quoted(printable(check.file)) +
                    "\n  line: " + std::to_string(check.line) + "\n  ...\n";
    }
    return text;
}

std::string github_annotations(const Results& results, const std::filesystem::path& root) {
    std::vector<Annotation> annotations;
    for (const size_t i : results.by_severity()) {
        const Check& check = results.checks[i];
        const bool fails = results.fails(check);
        annotations.push_back({fails ? Annotation::Level::error : Annotation::Level::notice,
                               path_in_repository(check.file, root), check.line, check.column,
                               check.id(), check.message});
    }
    return github_commands(std::move(annotations), "checks; the report has them all");
}

}  // namespace wrinkle::report
