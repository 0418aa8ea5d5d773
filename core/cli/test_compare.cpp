// Comparison of results with the expected values of a test.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/normals.h"
#include "base/standard_outputs.h"
#include "base/text.h"
#include "cli/test_run.h"
#include "json/write.h"

namespace wrinkle::cli {
namespace {

using Lanes = std::vector<double>;

// Returns the numbers of a value; std::nullopt if it is not a number or an array, or does not hold
// `count` numbers.
std::optional<Lanes> lanes_of(const json::Value& value, size_t count) {
    Lanes lanes;
    if (value.is(json::Kind::number)) lanes.push_back(value.as_number());
    if (value.is(json::Kind::array))
        for (const json::Member& member : value.children()) {
            if (!member.value.is(json::Kind::number)) return {};
            lanes.push_back(member.value.as_number());
        }
    if (lanes.size() != count) return {};
    return lanes;
}

double max_distance(const Lanes& a, const Lanes& b) {
    double largest = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        const double distance = std::abs(a[i] - b[i]);
        if (!(distance <= largest)) largest = distance;
    }
    return largest;
}

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string lanes_text(const Lanes& lanes) {
    std::string text;
    for (const double lane : lanes)
        text += (text.empty() ? "" : ", ") + shortest(static_cast<float>(lane));
    return lanes.size() == 1 ? text : "[" + text + "]";
}

// Returns one sentence if the values differ by more than the tolerance, otherwise "".
std::string disagreement(const TestCase& test, uint32_t port_type, const Lanes& expected,
                         const Lanes& got) {
    const bool is_normal = port_type == WR_PORT_normal;
    const double tolerance = is_normal ? test.tolerance_deg : test.tolerance;
    const double distance =
        is_normal ? degrees_between(expected, got) : max_distance(expected, got);
    if (distance <= tolerance) return "";
    const std::string unit = is_normal ? " degrees" : "";
    return "expected " + lanes_text(expected) + ", got " + lanes_text(got) + ": " +
           short_number(distance) + unit + " apart, " + short_number(tolerance) + unit + " allowed";
}

std::string source_of(const Document& document, const std::string& output) {
    const Output* found = document.find_output(output);
    return found ? " (" + found->from.link.text() + ")" : "";
}

}  // namespace

std::vector<std::string> differences(const TestCase& test, const Document& document,
                                     const json::Value& expected,
                                     const std::vector<OutputColumn>& columns, size_t point) {
    std::vector<std::string> result;
    for (const json::Member& member : expected.children()) {
        const std::string name(output_name(member.key));
        const std::string what = "output '" + name + "'" + source_of(document, name) + ": ";
        const auto column = std::ranges::find(columns, name, &OutputColumn::name);
        if (column == columns.end()) {
            result.push_back(what + "the graph has no such output");
            continue;
        }
        const auto wanted = lanes_of(member.value, column->lanes);
        if (!wanted) {
            result.push_back(what + "expected " + json::one_line(member.value) + ", which is not " +
                             std::to_string(column->lanes) + " numbers");
            continue;
        }
        const auto first = column->values.begin() + static_cast<long>(point * column->lanes);
        const Lanes got(first, first + static_cast<long>(column->lanes));
        const std::string difference = disagreement(test, column->port_type, *wanted, got);
        if (!difference.empty()) result.push_back(what + difference);
    }
    return result;
}

double image_difference(const Image& expected, const Image& got) {
    if (expected.width != got.width || expected.height != got.height) return -1;
    const Image a = to_rgba(expected), b = to_rgba(got);
    double sum = 0;
    for (size_t i = 0; i < a.data.size(); ++i)
        sum += std::pow((a.data[i] - b.data[i]) * 255.0, 2);
    return std::sqrt(sum / static_cast<double>(a.data.size()));
}

}  // namespace wrinkle::cli
