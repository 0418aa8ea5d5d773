#include "report/markup.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/printable.h"
#include "base/text.h"

namespace wrinkle::report {
namespace {

std::string cell(const std::string& text, const char* kind = "") {
    return "<td" + std::string(kind) + ">" + html(text) + "</td>";
}

// "" if it was not measured.
std::string milliseconds(double seconds) {
    if (seconds == 0) return "";
    char text[32];
    std::snprintf(text, sizeof text, seconds < 0.01 ? "%.1f ms" : "%.0f ms", seconds * 1000);
    return text;
}

std::string numbers_markup(const Check& check) {
    if (check.measured.empty()) return "";
    const bool is_change = check.status == Status::changed;
    const bool of_outputs = check.kind == CheckKind::point;
    const bool has_sides = of_outputs || (is_change && check.kind == CheckKind::cost);
    const bool has_nodes = std::ranges::any_of(
        check.measured, [](const Measured& each) { return !each.node.empty(); });
    std::string rows;
    for (const Measured& each : check.measured) {
        const bool is_missing = of_outputs && each.actual.empty();
        rows += each.within() && !is_missing ? "<tr>" : "<tr class=\"over\">";
        rows += "<th scope=\"row\">" + html(each.name) + "</th>";
        if (has_nodes) rows += cell(each.node);
        if (has_sides) rows += cell(each.expected) + cell(each.actual);
        rows += cell(is_missing ? "missing" : number(each.value) + " " + each.unit,
                     " class=\"number\"");
        if (!is_change) rows += cell(number(each.limit), " class=\"number\"");
        rows += "</tr>\n";
    }
    std::vector<std::string> heads = {of_outputs ? "Output" : "Measure"};
    if (has_nodes) heads.emplace_back("Node");
    if (has_sides) heads.insert(heads.end(), {expected_name(check), actual_name(check)});
    const bool is_cost = check.kind == CheckKind::cost && !is_change;
    heads.emplace_back(is_cost ? "Cost" : "Difference");
    if (!is_change) heads.emplace_back("Limit");
    return "<table><thead><tr><th scope=\"col\">" + joined(heads, "</th><th scope=\"col\">") +
           "</th></tr></thead><tbody>\n" + rows + "</tbody></table>\n";
}

// The largest difference of two graphs, as text. Costs are in the heading of their case.
std::string largest_markup(const Check& check) {
    const auto largest = std::ranges::max_element(check.measured, {}, &Measured::value);
    if (largest == check.measured.end() || check.kind == CheckKind::cost) return "";
    return "<span class=\"worst\">" +
           html(largest->name + " " + number(largest->value) + " " + largest->unit) + "</span>";
}

// The number that exceeds its limit most, as text and as a bar.
std::string worst_markup(const Check& check) {
    if (check.status == Status::changed) return largest_markup(check);
    const auto worst = std::ranges::max_element(check.measured, {},
                                                [](const Measured& each) { return each.excess(); });
    const auto missing = std::ranges::find(check.measured, "", &Measured::actual);
    if (check.kind == CheckKind::point && missing != check.measured.end())
        return "<span class=\"worst\">" + html(missing->name) + " missing</span>";
    if (worst == check.measured.end() || worst->within()) return "";
    // Logarithmic: the limit is at a quarter, 1000 times the limit at the end.
    const double part = std::clamp(0.25 + std::log10(worst->excess()) / 4, 0.0, 1.0) * 64;
    return "<span class=\"worst\"><svg class=\"bar\" viewBox=\"0 0 64 8\" width=\"64\" "
           "height=\"8\" aria-hidden=\"true\"><rect class=\"over\" width=\"" +
           number(part) + "\" height=\"8\"/><rect class=\"limit\" x=\"15\" width=\"2\" " +
           "height=\"8\"/></svg>" +
           html(number(worst->value) + " " + worst->unit + " / " + number(worst->limit)) +
           "</span>";
}

std::string lines_markup(const Check& check, const CheckParts& parts) {
    if (check.kind != CheckKind::text || check.actual_text.empty()) return "";
    if (parts.lines.empty()) return "<p>The lines that differ are not in this page.</p>\n";
    if (parts.nodes.empty()) return parts.lines;
    return "<p>Nodes of these lines: <code>" + html(parts.nodes) + "</code></p>\n" + parts.lines;
}

std::string body_markup(const Check& check, const CheckParts& parts) {
    const std::string source =
        check.line ? check.file + ":" + std::to_string(check.line) : check.file;
    const std::string hint =
        check.expected.empty() ? "" : "<p class=\"hint\">" + html(check.expected) + "</p>\n";
    return hint + "<p class=\"source\">" + html(source) + "</p>\n" +
           images_markup(check, parts.images) + numbers_markup(check) + lines_markup(check, parts);
}

// Errors could not run, a budget is a limit, and a change has no baseline: --accept writes none.
bool is_acceptable(const Check& check) {
    return check.status != Status::error && check.status != Status::changed &&
           check.kind != CheckKind::cost;
}

// Names of nodes, for the search of the page.
std::string searched_nodes(const Check& check, const CheckParts& parts) {
    std::string names = parts.nodes;
    for (const Measured& each : check.measured)
        names += " " + each.node;
    return names;
}

}  // namespace

std::string number(double value) {
    char text[32];
    const bool is_count = value == std::floor(value) && std::abs(value) < 1e9;
    std::snprintf(text, sizeof text, is_count ? "%.0f" : "%.4g", value);
    return text;
}

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

std::string check_markup(const Check& check, const CheckParts& parts, bool is_open) {
    const std::string status(name_of(check.status));
    return "<details class=\"check " + status + "\" id=\"" + html(check.id()) +
           "\" data-status=\"" + status + "\" data-seconds=\"" + number(check.seconds) +
           "\" data-nodes=\"" + html(searched_nodes(check, parts)) + "\"" +
           (is_acceptable(check) ? " data-acceptable" : "") + (is_open ? " open" : "") +
           ">\n<summary><span class=\"status\">" + status + "</span><span class=\"name\">" +
           html(check.name) + "</span>" + worst_markup(check) + "<span class=\"time\">" +
           milliseconds(check.seconds) + "</span></summary>\n<div class=\"body\">\n<p class=\"" +
           "message\">" + html(check.message) + "</p>\n<noscript>\n" + body_markup(check, parts) +
           "</noscript></div>\n</details>\n";
}

}  // namespace wrinkle::report
