#include "report/page.h"

#include <algorithm>
#include <cstdio>
#include <set>

#include "base/base64.h"
#include "base/checksum.h"
#include "report/case_markup.h"
#include "report/colormap.h"
#include "report/markup.h"
#include "report/page_contents.h"
#include "report/page_texts.h"

namespace wrinkle::report {
namespace fs = std::filesystem;
namespace {

std::string script() {
    std::string colors = "\"use strict\";\n// Colors of the maps.\nconst magma = [";
    for (const uint32_t color : magma)
        colors += std::to_string(color) + ",";
    return colors + "];\n" + std::string(page_texts::report_js) +
           std::string(page_texts::pixels_js) + std::string(page_texts::images_js) +
           std::string(page_texts::start_js);
}

std::string hash_source(const std::string& text) {
    std::string digest;
    const std::string digits = sha256(text);
    for (size_t i = 0; i + 1 < digits.size(); i += 2)
        digest += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    return "'sha256-" + base64(digest) + "'";
}

std::string style() {
    return "\n" + std::string(page_texts::report_css) + std::string(page_texts::images_css);
}

std::string policy() {
    return "default-src 'none'; base-uri 'none'; form-action 'none'; img-src data:; style-src " +
           hash_source(style()) + "; script-src " + hash_source(script());
}

std::string chips(const Results& results) {
    std::vector<Status> shown = {Status::failed, Status::error, Status::added, Status::deleted,
                                 Status::passed};
    if (results.compares_graphs()) shown = {Status::changed, Status::error, Status::passed};
    std::string text;
    for (const Status status : shown) {
        const std::string name(name_of(status));
        text += "<button type=\"button\" class=\"chip " + name + "\" data-status=\"" + name +
                "\" aria-pressed=\"" + (status == Status::passed ? "false" : "true") + "\">" +
                std::to_string(results.count(status)) + " " +
                (status == Status::passed ? passed_name(results) : name) + "</button>\n";
    }
    return text;
}

std::string command(const char* label, const char* id, const std::string& text) {
    return "<div class=\"command\"><span>" + std::string(label) + "</span><code id=\"" + id +
           "\">" + html(text) + "</code><button type=\"button\" data-copy=\"" + id + "\">Copy" +
           "<span class=\"hidden\"> " + html(label) + "</span></button></div>\n";
}

std::string facts(const Results& results) {
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.3g s", results.seconds);
    std::string text = "Wrinkle " + results.version + ", " + results.started + ", " + seconds;
    if (!results.driver.empty()) text += ", " + results.driver;
    return html(text);
}

// "3 of 40 cases differ; 2 images changed within their limits".
std::string summary(const Results& results) {
    std::set<std::string_view> all, differing;
    size_t changed = 0;
    for (const Check& check : results.checks) {
        if (check.status == Status::deleted) continue;  // belongs to no case
        all.insert(check.test);
        if (check.status != Status::passed)
            differing.insert(check.test);
        else if (check.kind == CheckKind::image && check.excess() > 0)
            ++changed;
    }
    std::string text =
        std::to_string(differing.size()) + " of " + std::to_string(all.size()) + " cases differ";
    if (changed > 0)
        text += "; " + std::to_string(changed) + (changed == 1 ? " image" : " images") +
                " changed within the limits";
    return "<p class=\"summary\">" + text + "</p>\n";
}

std::string verdict(const Results& results) {
    const bool passes = !results.fails();
    if (results.compares_graphs())
        return passes && results.changes.empty() ? "<h1>Same</h1>\n" : "<h1>Different</h1>\n";
    return std::string("<h1 class=\"") + (passes ? "passes" : "fails") + "\">" +
           (!passes                            ? "Failed"
            : results.count(Status::added) > 0 ? "Passed, with new checks"
                                               : "Passed") +
           "</h1>\n";
}

// The two graphs, and their changes as a list.
std::string graphs_markup(const Results& results) {
    if (!results.compares_graphs()) return "";
    std::string text =
        "<p class=\"source\">" + html(results.before) + " → " + html(results.after) + "</p>\n";
    if (results.changes.empty()) return text;
    text += "<p>Changes of the graph</p>\n<ul class=\"changes\">\n";
    for (const std::string& change : results.changes) {
        const char* kind = change.starts_with('+')   ? " class=\"added\""
                           : change.starts_with('-') ? " class=\"removed\""
                                                     : "";
        const size_t indent = change.find_first_not_of(' ');
        text += "<li" + std::string(kind) + "><code>" + html(change.substr(std::min(indent, 2UL))) +
                "</code></li>\n";
    }
    return text + "</ul>\n";
}

std::string header(const Results& results, const Contents& contents) {
    std::string text = "<header>\n" + verdict(results) + summary(results) + "<p class=\"facts\">" +
                       facts(results) + "</p>\n" + graphs_markup(results);
    for (const std::string& problem : results.problems)
        text += "<p class=\"problem\">" + html(problem) + "</p>\n";
    if (contents.images_left_out + contents.lines_left_out > 0)
        text += "<p class=\"problem\">This page would be too large: the images of " +
                std::to_string(contents.images_left_out) + " checks and the lines of " +
                std::to_string(contents.lines_left_out) + " checks are only in its folder.</p>\n";
    if (!results.causes.empty()) {
        text += "<p>Likely causes</p>\n<ul class=\"causes\">\n";
        for (const std::string& cause : results.causes)
            text += "<li>" + html(cause) + "</li>\n";
        text += "</ul>\n";
    }
    if (!results.command.empty()) text += command("Repeat", "repeat", results.command);
    if (!results.approval.empty())
        text += command("Accept", "accept", results.approval + " --review");
    return text + "</header>\n";
}

std::string filters(const Results& results) {
    return "<div class=\"filters\" role=\"search\" aria-label=\"Filters\">\n" + chips(results) +
           "<label>Search <input type=\"search\" id=\"search\"></label>\n<label>Order "
           "<select id=\"order\"><option value=\"severity\">severity</option><option "
           "value=\"name\">name</option><option value=\"time\">time</option></select></label>\n"
           "<button type=\"button\" id=\"help-button\">Keys</button></div>\n";
}

std::string passed_list(const Results& results) {
    std::string items;
    for (const Check& check : results.checks)
        if (check.status == Status::passed) items += "<li>" + html(check.id()) + "</li>\n";
    if (items.empty()) return "";
    return "<details id=\"passed\"><summary>" + std::to_string(results.count(Status::passed)) +
           " " + passed_name(results) + "</summary>\n<ul>\n" + items + "</ul>\n</details>\n";
}

std::string cases_markup(const Results& results, const std::vector<Case>& cases,
                         const std::vector<CheckParts>& parts) {
    std::string text;
    bool is_first = true;
    for (const Case& each : cases) {
        text += "<section class=\"case\" data-name=\"" + html(each.name) + "\">\n" +
                heading_markup(results, each) + points_markup(results, each, is_first);
        for (const size_t i : each.differing) {
            text += check_markup(results.checks[i], parts[i], is_first);
            is_first = false;
        }
        text += "</section>\n";
    }
    return text.empty() ? "<p>No check differs.</p>\n" : text;
}

}  // namespace

std::string page(const Results& results, const fs::path& folder, uint64_t max_bytes) {
    const std::vector<Case> cases = cases_by_severity(results);
    const std::string passed = passed_list(results);
    const uint64_t fixed = passed.size() + style().size() + script().size() + 8192;
    const Contents contents = contents_within(results, cases, folder, max_bytes, fixed);
    const std::string title =
        results.compares_graphs()
            ? "Wrinkle diff: " + std::to_string(results.count(Status::changed)) + " changed"
            : "Wrinkle test: " +
                  std::to_string(results.count(Status::failed) + results.count(Status::error)) +
                  " failed";
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
           "http-equiv=\"Content-Security-Policy\" content=\"" +
           policy() + "\">\n<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
           title + "</title>\n<style>" + style() + "</style>\n</head>\n<body>\n" +
           header(results, contents) + filters(results) +
           "<main>\n<h2 class=\"hidden\">Checks</h2>\n<p id=\"none\" hidden>No check is shown: "
           "change "
           "the filters.</p>\n<div id=\"checks\">\n" +
           cases_markup(results, cases, contents.parts) + "</div>\n" + passed + "</main>\n" +
           std::string(page_texts::help_html) +
           "<div id=\"announcement\" class=\"hidden\" role=\"status\"></div>\n<script>" + script() +
           "</script>\n</body>\n</html>\n";
}

}  // namespace wrinkle::report
