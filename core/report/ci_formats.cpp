#include "report/ci_formats.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "base/printable.h"
#include "base/text.h"
#include "report/text_diff.h"

namespace wrinkle::report {
namespace {

constexpr size_t max_annotations = 10;
constexpr size_t max_text = 20'000;  // bytes of a difference in JUnit
constexpr const char* replacement = "\xef\xbf\xbd";

// Removes terminal sequences: ESC [ ... letter.
std::string without_sequences(std::string_view text) {
    std::string plain;
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\x1b' || i + 1 == text.size() || text[i + 1] != '[') {
            plain += text[i];
            continue;
        }
        i += 2;
        while (i < text.size() && (text[i] < '@' || text[i] > '~'))
            ++i;
    }
    return plain;
}

bool is_allowed(const Character& character) {
    const uint32_t code = character.code;
    return character.valid &&
           (code == '\t' || code == '\n' || code == '\r' || (code >= 0x20 && code <= 0xd7ff) ||
            (code >= 0xe000 && code <= 0xfffd) || (code >= 0x10000 && code <= 0x10ffff));
}

// `breaks` are the entities of tab, line feed and carriage return in an attribute.
std::string xml(std::string_view given, bool attribute) {
    const std::string text = without_sequences(given);
    std::string escaped;
    for (std::string_view rest = text; !rest.empty();) {
        const Character character = first_character(rest);
        const std::string_view bytes = rest.substr(0, character.bytes);
        rest.remove_prefix(character.bytes);
        if (!is_allowed(character))
            escaped += replacement;
        else if (bytes == "&")
            escaped += "&amp;";
        else if (bytes == "<")
            escaped += "&lt;";
        else if (bytes == ">")
            escaped += "&gt;";
        else if (attribute && bytes == "\"")
            escaped += "&quot;";
        else if (attribute && bytes == "'")
            escaped += "&apos;";
        else if (attribute && character.code < ' ')
            escaped += "&#" + std::to_string(character.code) + ";";
        else
            escaped += bytes;
    }
    return escaped;
}

std::string attribute(const char* name, std::string_view value) {
    return " " + std::string(name) + "=\"" + xml(value, true) + "\"";
}

std::string seconds_text(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6f", seconds);
    return text;
}

// How a CI system counts a check.
enum class Verdict : uint8_t { passed, failed, error, skipped };
Verdict verdict_of(const Check& check, const CiOptions& options) {
    switch (check.status) {
        case Status::passed:
            return Verdict::passed;
        case Status::error:
            return Verdict::error;
        case Status::added:
            return options.new_fails ? Verdict::failed : Verdict::skipped;
        default:
            return Verdict::failed;
    }
}

struct Tally {
    size_t tests = 0, failures = 0, errors = 0, skipped = 0;
    double seconds = 0;

    void add(const Check& check, const CiOptions& options) {
        const Verdict verdict = verdict_of(check, options);
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

std::string testcase(const Check& check, const CiOptions& options) {
    std::string name = check.test;
    std::ranges::replace(name, '/', '.');
    std::string text = "    <testcase" + attribute("name", check.name) +
                       attribute("classname", name) + attribute("file", check.file);
    if (check.line) text += attribute("line", std::to_string(check.line));
    text += attribute("time", seconds_text(check.seconds));
    const Verdict verdict = verdict_of(check, options);
    if (verdict == Verdict::passed) return text + "/>\n";
    text += ">\n";
    const std::string message = attribute("message", check.message);
    if (verdict == Verdict::skipped) {
        text += "      <skipped" + message + "/>\n";
    } else {
        const std::string tag = verdict == Verdict::error ? "error" : "failure";
        text += "      <" + tag + message + attribute("type", name_of(check.status)) + ">" +
                xml(difference_text(check), false) + "</" + tag + ">\n";
    }
    if (options.attachment && !check.joined_image.empty())
        text += "      <system-out>[[ATTACHMENT|" +
                xml(options.attachment(check.joined_image), false) + "]]</system-out>\n";
    return text + "    </testcase>\n";
}

// Escapes a value of a GitHub command; `property` escapes its separators too.
std::string github(std::string_view given, bool property) {
    std::string escaped;
    for (const char c : without_sequences(given)) {
        if (c == '%' || c == '\r' || c == '\n' || (property && (c == ':' || c == ','))) {
            char code[8];
            std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned char>(c));
            escaped += code;
        } else {
            escaped += c;
        }
    }
    return escaped;
}

std::string annotation(const Check& check, const CiOptions& options) {
    const bool fails = verdict_of(check, options) != Verdict::skipped;
    std::string text = fails ? "::error " : "::notice ";
    text += "file=" + github(check.file, true);
    if (check.line) text += ",line=" + std::to_string(check.line);
    if (check.column) text += ",col=" + std::to_string(check.column);
    return text + ",title=" + github(check.id(), true) + "::" + github(check.message, false) + "\n";
}

}  // namespace

std::string junit(const Results& results, const CiOptions& options) {
    Tally all;
    std::vector<std::string> names;  // in the order of the results
    std::map<std::string, std::pair<Tally, std::string>> suites;
    for (const Check& check : results.checks) {
        if (!suites.contains(check.test)) names.push_back(check.test);
        auto& [tally, cases] = suites[check.test];
        tally.add(check, options);
        all.add(check, options);
        cases += testcase(check, options);
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

std::string tap(const Results& results, const CiOptions& options) {
    std::string text = "TAP version 14\n1.." + std::to_string(results.checks.size()) + "\n";
    size_t number = 0;
    for (const Check& check : results.checks) {
        const Verdict verdict = verdict_of(check, options);
        const bool passes = verdict == Verdict::passed || verdict == Verdict::skipped;
        std::string name;
        for (const char c : printable(check.id()))
            name += c == '#' ? std::string("\\#") : std::string(1, c);
        text += (passes ? "ok " : "not ok ") + std::to_string(++number) + " - " + name;
        if (verdict == Verdict::skipped) text += " # SKIP " + printable(check.message);
        text += "\n";
        if (!passes)
            text += "  ---\n  message: " + json_quoted(printable(check.message)) +
                    "\n  file: " + json_quoted(printable(check.file)) +
                    "\n  line: " + std::to_string(check.line) + "\n  ...\n";
    }
    return text;
}

std::string github_annotations(const Results& results, const CiOptions& options) {
    const std::vector<size_t> order = results.by_severity();
    std::string text;
    const bool fit = order.size() <= max_annotations;
    const size_t shown = fit ? order.size() : max_annotations - 1;
    for (size_t i = 0; i < shown; ++i)
        text += annotation(results.checks[order[i]], options);
    if (!fit)
        text += "::error title=wrinkle test::and " + std::to_string(order.size() - shown) +
                " more checks; the report has them all\n";
    return text;
}

}  // namespace wrinkle::report
