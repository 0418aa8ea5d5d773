#include "report/markup.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/base64.h"
#include "base/file.h"
#include "base/printable.h"
#include "base/text.h"
#include "report/text_diff.h"

namespace wrinkle::report {
namespace fs = std::filesystem;
namespace {

std::string cell(const std::string& text, const char* kind = "") {
    return "<td" + std::string(kind) + ">" + html(text) + "</td>";
}

std::string number(double value) {
    char text[32];
    const bool is_count = value == std::floor(value) && std::abs(value) < 1e9;
    std::snprintf(text, sizeof text, is_count ? "%.0f" : "%.4g", value);
    return text;
}

std::string milliseconds(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, seconds < 0.01 ? "%.1f ms" : "%.0f ms", seconds * 1000);
    return text;
}

std::string numbers_markup(const Check& check) {
    if (check.measured.empty()) return "";
    const bool of_outputs = check.kind == CheckKind::point;
    std::string rows;
    for (const Measured& each : check.measured) {
        rows += each.within() ? "<tr>" : "<tr class=\"over\">";
        rows += "<th scope=\"row\">" + html(each.name) + "</th>" + cell(each.node);
        if (of_outputs) rows += cell(each.expected) + cell(each.actual);
        rows += cell(number(each.value) + " " + each.unit, " class=\"number\"") +
                cell(number(each.limit), " class=\"number\"") + "</tr>\n";
    }
    return "<table><thead><tr><th scope=\"col\">" + std::string(of_outputs ? "Output" : "Measure") +
           "</th><th scope=\"col\">Node</th>" +
           (of_outputs ? "<th scope=\"col\">Expected</th><th scope=\"col\">Actual</th>" : "") +
           "<th scope=\"col\">" + (check.kind == CheckKind::cost ? "Cost" : "Difference") +
           "</th><th scope=\"col\">Limit</th></tr></thead><tbody>\n" + rows + "</tbody></table>\n";
}

// Returns a line with its indentation; tabs are four spaces.
std::string code(std::string_view line) {
    std::string spaced;
    for (const char c : line)
        spaced += c == '\t' ? std::string("    ") : std::string(1, c);
    return html(spaced);
}

std::string diff_row(const DiffLine& line, const Check& check) {
    using Kind = DiffLine::Kind;
    if (line.kind == Kind::skipped)
        return "<tr class=\"skipped\"><td colspan=\"5\">\u22ef</td></tr>\n";
    const auto at = [](uint32_t place) { return place ? std::to_string(place) : ""; };
    const char* mark = line.kind == Kind::removed ? "\u2212" : line.kind == Kind::added ? "+" : "";
    const char* name = line.kind == Kind::removed ? " class=\"removed\""
                       : line.kind == Kind::added ? " class=\"added\""
                                                  : "";
    const size_t index = line.actual_line - size_t{1};
    const std::string node =
        line.actual_line && index < check.nodes_of_lines.size() ? check.nodes_of_lines[index] : "";
    return "<tr" + std::string(name) + ">" + cell(at(line.expected_line), " class=\"number\"") +
           cell(at(line.actual_line), " class=\"number\"") + cell(node, " class=\"node\"") +
           cell(mark) + "<td><code>" + code(line.text) + "</code></td></tr>\n";
}

std::string diff_markup(const Check& check) {
    if (check.kind != CheckKind::text || check.actual_text.empty()) return "";
    std::string rows;
    for (const DiffLine& line : diff_lines(check.expected_text, check.actual_text))
        rows += diff_row(line, check);
    return "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Lines of " +
           html(check.id()) +
           "\"><table class=\"diff\"><thead><tr><th scope=\"col\">Old</th><th "
           "scope=\"col\">New</th><th scope=\"col\">Node</th><th scope=\"col\"><span "
           "class=\"hidden\">Mark</span></th><th scope=\"col\">Line</th></tr></thead><tbody>\n" +
           rows + "</tbody></table></div>\n";
}

// `path` is that of the image file, "" if the check has none.
std::string figure(const char* name, const std::string& label, const std::string& path,
                   const std::string& uri, const Check& check) {
    if (path.empty()) return "";
    const std::string open = "<figure class=\"" + std::string(name) + "\">";
    const std::string caption = "<figcaption>" + html(label) + "</figcaption></figure>\n";
    if (uri.empty()) return open + "<p>" + html(path) + " is not in this page.</p>" + caption;
    const std::string size = check.width ? " width=\"" + std::to_string(check.width) +
                                               "\" height=\"" + std::to_string(check.height) + "\""
                                         : "";
    return open + "<div class=\"frame\"><img src=\"" + uri + "\"" + size + " alt=\"" +
           html(label + " of " + check.test) + "\"></div>" + caption;
}

std::string images_markup(const Check& check, const InlinedImages& images) {
    if (check.actual_image.empty() && check.expected_image.empty()) return "";
    const std::string scale = check.map_measure == "degrees"
                                  ? "Difference: 0 to " + number(check.map_scale) + " degrees"
                                  : "Difference: FLIP, 0 to " + number(check.map_scale);
    return "<div class=\"images\" data-measure=\"" + html(check.map_measure) + "\">\n" +
           figure("expected", "Expected", check.expected_image, images.expected, check) +
           figure("actual", "Actual", check.actual_image, images.actual, check) +
           figure("map", scale, check.map_image, images.map, check) + "</div>\n";
}

std::string data_uri(const std::string& image, const fs::path& folder) {
    std::string why;
    if (image.empty()) return "";
    const auto path = inside(folder, folder / image);
    const auto bytes = path ? read_file(*path, why) : std::nullopt;
    return bytes ? "data:image/png;base64," + base64(*bytes) : "";
}

// The number that exceeds its limit most, as text and as a bar.
std::string worst_markup(const Check& check) {
    const auto worst = std::ranges::max_element(check.measured, {},
                                                [](const Measured& each) { return each.excess(); });
    if (worst == check.measured.end()) return "";
    // Logarithmic: the limit is at a quarter, 1000 times the limit at the end.
    const double part = std::clamp(0.25 + std::log10(worst->excess()) / 4, 0.0, 1.0) * 100;
    return "<span class=\"worst\"><span class=\"bar\" aria-hidden=\"true\"><span style=\"width:" +
           number(part) + "%\"></span></span>" +
           html(number(worst->value) + " " + worst->unit + " / " + number(worst->limit)) +
           "</span>";
}

}  // namespace

std::string html(std::string_view text) {
    std::string escaped;
    for (const char c : printable(text)) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

InlinedImages inlined_images(const Check& check, const fs::path& folder) {
    return {data_uri(check.expected_image, folder), data_uri(check.actual_image, folder),
            data_uri(check.map_image, folder)};
}

std::string check_markup(const Check& check, const InlinedImages& images, bool is_open) {
    const std::string status(name_of(check.status)), id = html(check.id());
    const std::string source =
        check.line ? check.file + ":" + std::to_string(check.line) : check.file;
    const std::string hint =
        check.expected.empty() ? "" : "<p class=\"hint\">" + html(check.expected) + "</p>\n";
    return "<details class=\"check " + status + "\" id=\"" + id + "\" data-status=\"" + status +
           "\" data-excess=\"" + number(check.excess()) + "\" data-seconds=\"" +
           number(check.seconds) + "\"" + (is_open ? " open" : "") + ">\n<summary><span " +
           "class=\"status\">" + status + "</span><span class=\"name\">" + id + "</span>" +
           worst_markup(check) + "<span class=\"time\">" + milliseconds(check.seconds) +
           "</span></summary>\n<div class=\"body\">\n<p class=\"message\">" + html(check.message) +
           "</p>\n" + hint + "<p class=\"source\">" + html(source) + "</p>\n" +
           images_markup(check, images) + numbers_markup(check) + diff_markup(check) +
           "</div>\n</details>\n";
}

}  // namespace wrinkle::report
