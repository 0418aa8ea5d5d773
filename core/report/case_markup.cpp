#include "report/case_markup.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "report/markup.h"

namespace wrinkle::report {
namespace {

// ", +12"; "" for 0.
std::string difference_text(double value) {
    return value == 0 ? "" : (value < 0 ? ", \u2212" : ", +") + number(std::abs(value));
}

// "alu 212 / 200, +12": the cost, its budget, and their difference.
std::string cost_text(const Results& results, const Measured& cost) {
    if (results.compares_graphs())
        return cost.name + " " + cost.expected + " \u2192 " + cost.actual +
               difference_text(cost.value);
    return cost.name + " " + number(cost.value) + " / " + number(cost.limit) +
           difference_text(cost.value - cost.limit);
}

std::string costs_markup(const Results& results, const Case& each) {
    std::string text;
    for (const size_t i : each.checks) {
        if (results.checks[i].kind != CheckKind::cost) continue;
        for (const Measured& cost : results.checks[i].measured) {
            const bool is_over = !results.compares_graphs() && !cost.within();
            text += std::string("<span class=\"cost") + (is_over ? " over" : "") + "\">" +
                    html(cost_text(results, cost)) + "</span>";
        }
    }
    return text;
}

std::vector<const Check*> points_of(const Results& results, const Case& each) {
    std::vector<const Check*> points;
    for (const size_t i : each.checks)
        if (results.checks[i].kind == CheckKind::point) points.push_back(&results.checks[i]);
    return points;
}

bool differs(const Check* check) {
    return check->status != Status::passed;
}

// One number for each output that a point has, in the order of their first points.
std::vector<const Measured*> outputs_of(const std::vector<const Check*>& points) {
    std::vector<const Measured*> outputs;
    for (const Check* point : points)
        for (const Measured& each : point->measured)
            if (std::ranges::find(outputs, each.name, &Measured::name) == outputs.end())
                outputs.push_back(&each);
    return outputs;
}

std::string with_unit(double value, const Measured& measured) {
    return number(value) + (measured.unit.empty() ? "" : " " + measured.unit);
}

std::string head_of(const Measured& output, bool has_limit) {
    std::string text = "<th scope=\"col\">" + html(output.name);
    if (!output.node.empty()) text += "<br><code>" + html(output.node) + "</code>";
    if (has_limit && !output.actual.empty())
        text += "<br>limit " + html(with_unit(output.limit, output));
    return text + "</th>";
}

std::string cell_of(const Check& point, const std::string& output) {
    const auto found = std::ranges::find(point.measured, output, &Measured::name);
    if (found == point.measured.end()) return "<td></td>";
    const bool is_missing = found->actual.empty();
    const std::string difference = is_missing ? "missing" : with_unit(found->value, *found);
    if (found->within() && !is_missing) return "<td>" + html(difference) + "</td>";
    return "<td class=\"over\"><strong>" + html(difference) + "</strong><br>" +
           html(found->expected + " \u2192 " + (is_missing ? "none" : found->actual)) + "</td>";
}

std::string row_of(const Results& results, const Check& point,
                   const std::vector<const Measured*>& outputs) {
    if (point.status == Status::passed)
        return "<tr><th scope=\"row\">" + html(point.name) + "</th><td colspan=\"" +
               std::to_string(outputs.size()) + "\">" + passed_name(results) + "</td></tr>\n";
    std::string text = "<tr><th scope=\"row\"><a href=\"#" + html(point.id()) + "\">" +
                       html(point.name) + "</a></th>";
    if (point.measured.empty())
        return text + "<td colspan=\"" + std::to_string(outputs.size()) + "\">" +
               html(point.message) + "</td></tr>\n";
    for (const Measured* output : outputs)
        text += cell_of(point, output->name);
    return text + "</tr>\n";
}

}  // namespace

const char* passed_name(const Results& results) {
    return results.compares_graphs() ? "same" : "passed";
}

std::string heading_markup(const Results& results, const Case& each) {
    std::vector<std::string> passed;
    for (const size_t i : each.checks)
        if (results.checks[i].status == Status::passed) passed.push_back(results.checks[i].name);
    std::string text = "<h3>" + html(each.name) + costs_markup(results, each);
    if (!passed.empty())
        text += "<span class=\"others\">" + std::string(passed_name(results)) + ": " +
                html(joined(passed, ", ")) + "</span>";
    return text + "</h3>\n";
}

std::string points_markup(const Results& results, const Case& each, bool is_open) {
    const std::vector<const Check*> points = points_of(results, each);
    const auto differing = std::ranges::count_if(points, differs);
    const std::vector<const Measured*> outputs = outputs_of(points);
    if (points.size() < 2 || outputs.empty()) return "";
    std::string text = std::string("<div><details class=\"numbers\"") + (is_open ? " open" : "") +
                       "><summary>" + std::to_string(differing) + " of " +
                       std::to_string(points.size()) + " points differ</summary>\n" +
                       "<noscript><div class=\"scroll\"><table class=\"points\"><thead><tr>" +
                       "<th scope=\"col\">Point</th>";
    for (const Measured* output : outputs)
        text += head_of(*output, !results.compares_graphs());
    text += "</tr></thead><tbody>\n";
    for (const Check* point : points)
        text += row_of(results, *point, outputs);
    return text + "</tbody></table></div></noscript></details></div>\n";
}

}  // namespace wrinkle::report
