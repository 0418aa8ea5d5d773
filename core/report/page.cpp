#include "report/page.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "base/base64.h"
#include "base/checksum.h"
#include "report/markup.h"
#include "report/page_texts.h"

namespace wrinkle::report {
namespace fs = std::filesystem;
namespace {

std::string script() {
    return std::string(page_texts::report_js) + std::string(page_texts::images_js);
}

std::string policy() {
    std::string digest;
    const std::string digits = sha256(script());
    for (size_t i = 0; i + 1 < digits.size(); i += 2)
        digest += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    return "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-" +
           base64(digest) + "'";
}

std::string chips(const Results& results) {
    std::string text;
    for (const Status status :
         {Status::failed, Status::error, Status::added, Status::deleted, Status::passed}) {
        const std::string name(name_of(status));
        text += "<button type=\"button\" class=\"chip " + name + "\" data-status=\"" + name +
                "\" aria-pressed=\"" + (status == Status::passed ? "false" : "true") + "\">" +
                std::to_string(results.count(status)) + " " + name + "</button>\n";
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

std::string header(const Results& results, size_t left_out) {
    const bool passes = results.count(Status::failed) + results.count(Status::error) +
                            results.count(Status::deleted) ==
                        0;
    const size_t added = results.count(Status::added);
    const std::string verdict = !passes     ? "Failed"
                                : added > 0 ? "Passed, with new checks"
                                            : "Passed";
    std::string text = "<header>\n<h1 class=\"" + std::string(passes ? "passes" : "fails") + "\">" +
                       verdict + "</h1>\n<p class=\"facts\">" + facts(results) + "</p>\n";
    for (const std::string& problem : results.problems)
        text += "<p class=\"problem\">" + html(problem) + "</p>\n";
    if (left_out > 0)
        text += "<p class=\"problem\">This page would be too large: the images of " +
                std::to_string(left_out) + " checks are only in its folder.</p>\n";
    if (!results.causes.empty()) {
        text += "<p>Likely causes</p>\n<ul class=\"causes\">\n";
        for (const std::string& cause : results.causes)
            text += "<li>" + html(cause) + "</li>\n";
        text += "</ul>\n";
    }
    text += "<div class=\"filters\" role=\"group\" aria-label=\"Filters\">\n" + chips(results) +
            "<label>Search <input type=\"search\" id=\"search\"></label>\n<label>Order "
            "<select id=\"order\"><option value=\"severity\">severity</option><option "
            "value=\"name\">name</option><option value=\"time\">time</option></select></label>\n"
            "<button type=\"button\" id=\"help-button\">Keys</button></div>\n";
    text += command("Repeat", "repeat", results.command) +
            command("Accept", "accept", "wrinkle test --review") + "</header>\n";
    return text;
}

std::string passed_list(const Results& results) {
    std::string items;
    for (const Check& check : results.checks)
        if (check.status == Status::passed) items += "<li>" + html(check.id()) + "</li>\n";
    if (items.empty()) return "";
    return "<details id=\"passed\"><summary>" + std::to_string(results.count(Status::passed)) +
           " passed</summary>\n<ul>\n" + items + "</ul>\n</details>\n";
}

}  // namespace

std::string page(const Results& results, const fs::path& folder, uint64_t max_bytes) {
    const std::vector<size_t> order = results.by_severity();
    std::string checks;
    size_t left_out = 0;
    for (const size_t i : order) {
        const Check& check = results.checks[i];
        InlinedImages images = inlined_images(check, folder);
        if (images.bytes() > 0 && checks.size() + images.bytes() > max_bytes) {
            images = {};
            ++left_out;
        }
        checks += check_markup(check, images, i == order.front());
    }
    if (order.empty()) checks = "<p>No check differs.</p>\n";
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
           "http-equiv=\"Content-Security-Policy\" content=\"" +
           policy() +
           "\">\n<meta name=\"viewport\" content=\"width=device-width\">\n<title>Wrinkle test: " +
           std::to_string(results.count(Status::failed) + results.count(Status::error)) +
           " failed</title>\n<style>\n" + std::string(page_texts::report_css) +
           "</style>\n</head>\n<body>\n" + header(results, left_out) +
           "<main>\n<h2 class=\"hidden\">Checks</h2>\n<div id=\"checks\">\n" + checks + "</div>\n" +
           passed_list(results) + "</main>\n" + std::string(page_texts::help_html) +
           "<div id=\"announcement\" class=\"hidden\" role=\"status\"></div>\n<script>" + script() +
           "</script>\n</body>\n</html>\n";
}

}  // namespace wrinkle::report
