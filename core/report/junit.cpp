#include <cstdio>
#include <map>

#include "report/ci_formats.h"
#include "report/outcome.h"
#include "report/xml.h"

namespace wrinkle::report {
namespace {

std::string seconds_text(double seconds) {
    char text[64];
    std::snprintf(text, sizeof text, "%.3f", seconds >= 0 && seconds < 1e9 ? seconds : 0.0);
    return text;
}

struct JunitCounts {
    size_t tests = 0, failures = 0, errors = 0, skipped = 0;
    double seconds = 0;

    void add(const Check& check, const CiOptions& options) {
        const Outcome outcome = outcome_of(check, options);
        ++tests;
        failures += outcome == Outcome::failure;
        errors += outcome == Outcome::error;
        skipped += outcome == Outcome::skipped;
        if (check.seconds > 0 && check.seconds < 1e9) seconds += check.seconds;
    }
    std::string attributes() const {
        return " tests=\"" + std::to_string(tests) + "\" failures=\"" + std::to_string(failures) +
               "\" errors=\"" + std::to_string(errors) + "\" skipped=\"" + std::to_string(skipped) +
               "\" time=\"" + seconds_text(seconds) + "\"";
    }
};

std::string xml_member(const char* name, std::string_view value) {
    return " " + std::string(name) + "=\"" + xml_attribute(value) + "\"";
}

// Returns the line that names the image of a check; "" if there is none, or its path would end the
// line or the brackets.
std::string attachment_of(const Check& check, const CiOptions& options) {
    std::string image = check.joined_image;
    if (image.empty()) image = check.actual_image;
    if (image.empty()) return "";
    const std::string path = (std::filesystem::path(options.attachments) / image).generic_string();
    if (path.find("]]") != path.npos || xml_characters(path) != path) return "";
    if (path.find_first_of("\r\n") != path.npos) return "";
    return "[[ATTACHMENT|" + path + "]]";
}

std::string testcase(const Check& check, const CiOptions& options) {
    std::string text =
        "    <testcase" + xml_member("name", check.name) + xml_member("classname", check.test);
    if (!check.file.empty()) text += xml_member("file", file_of(check, options));
    if (check.line > 0) text += " line=\"" + std::to_string(check.line) + "\"";
    text += " time=\"" + seconds_text(check.seconds) + "\"";
    const Outcome outcome = outcome_of(check, options);
    if (outcome == Outcome::passed) return text + "/>\n";
    text += ">\n";
    const std::string message = xml_member("message", message_of(check));
    if (outcome == Outcome::skipped) {
        text += "      <skipped" + message + "/>\n";
    } else {
        const char* element = outcome == Outcome::error ? "error" : "failure";
        text += std::string("      <") + element + message +
                xml_member("type", std::string(name_of(check.kind)) + "-" +
                                       std::string(name_of(check.status))) +
                ">" + xml_text(message_of(check) + "\n" + details_of(check)) + "</" + element +
                ">\n";
    }
    if (const std::string line = attachment_of(check, options); !line.empty())
        text += "      <system-out>" + xml_text(line) + "</system-out>\n";
    return text + "    </testcase>\n";
}

// Checks of one case, in the order of the first check of each.
struct JunitSuite {
    std::string name;
    std::vector<const Check*> checks;
};

std::vector<JunitSuite> suites_of(const std::vector<Check>& checks) {
    std::vector<JunitSuite> suites;
    std::map<std::string_view, size_t> index;
    for (const Check& check : checks) {
        const auto [at, is_new] = index.emplace(check.test, suites.size());
        if (is_new) suites.push_back({check.test, {}});
        suites[at->second].checks.push_back(&check);
    }
    return suites;
}

}  // namespace

std::string junit(const Results& results, const CiOptions& options) {
    std::vector<Check> checks = checks_of_run(results);
    checks.insert(checks.end(), results.checks.begin(), results.checks.end());
    JunitCounts all;
    std::string body;
    for (const JunitSuite& suite : suites_of(checks)) {
        JunitCounts counts;
        std::string cases;
        for (const Check* check : suite.checks) {
            all.add(*check, options);
            counts.add(*check, options);
            cases += testcase(*check, options);
        }
        body += "  <testsuite" + xml_member("name", suite.name) + counts.attributes();
        if (!results.started.empty()) body += xml_member("timestamp", results.started);
        body += ">\n" + cases + "  </testsuite>\n";
    }
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"wrinkle test\"" +
           all.attributes() + ">\n" + body + "</testsuites>\n";
}

}  // namespace wrinkle::report
