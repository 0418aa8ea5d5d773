#include "cli/test_compare.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/normals.h"
#include "base/standard_outputs.h"
#include "base/text.h"
#include "cli/comparison.h"
#include "image/texels.h"
#include "json/write.h"
#include "report/colormap.h"
#include "report/pooling.h"

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

std::string lanes_text(const Lanes& lanes) {
    std::string text;
    for (const double lane : lanes)
        text += (text.empty() ? "" : ", ") + shortest(static_cast<float>(lane));
    return lanes.size() == 1 ? text : "[" + text + "]";
}

report::Measured measured(const TestCase& test, const OutputColumn& column, const Lanes& expected,
                          const Lanes& got) {
    const bool is_normal = column.port_type == WR_PORT_normal;
    report::Measured result;
    result.name = column.name;
    result.expected = lanes_text(expected);
    result.actual = lanes_text(got);
    result.value = is_normal ? degrees_between(expected, got) : max_distance(expected, got);
    result.limit = is_normal ? test.tolerance_deg : test.tolerance;
    result.unit = is_normal ? "degrees" : "";
    return result;
}

std::string disagreement(const report::Measured& measured) {
    const std::string unit = measured.unit.empty() ? "" : " " + measured.unit;
    return "expected " + measured.expected + ", got " + measured.actual + ": " +
           short_number(measured.value) + unit + " apart, " + short_number(measured.limit) + unit +
           " allowed";
}

std::string source_of(const Document& document, const std::string& output) {
    const Output* found = document.find_output(output);
    return found ? found->from.link.text() : "";
}

// For an expected output that the graph lacks.
std::string outputs_advice(const report::Measured& missing,
                           const std::vector<OutputColumn>& columns) {
    std::vector<std::string> names;
    for (const OutputColumn& column : columns)
        names.push_back(column.name);
    return did_you_mean(missing.name, names, "its outputs are " + joined(names, ", "));
}

// Compares one output; returns one sentence, or "" if it is within the limit.
std::string compare_output(const TestCase& test, const json::Member& expected,
                           const std::vector<OutputColumn>& columns, size_t point,
                           report::Measured& result) {
    const auto column = std::ranges::find(columns, result.name, &OutputColumn::name);
    if (column == columns.end())
        return "the graph has no such output; " + outputs_advice(result, columns);
    const auto wanted = lanes_of(expected.value, column->lanes);
    if (!wanted)
        return "expected " + json::one_line(expected.value) + ", which is not " +
               std::to_string(column->lanes) + " numbers";
    const auto first = column->values.begin() + static_cast<long>(point * column->lanes);
    const std::string node = result.node;
    result =
        measured(test, *column, *wanted, Lanes(first, first + static_cast<long>(column->lanes)));
    result.node = node;
    return result.within() ? "" : disagreement(result);
}

struct Measure {
    Image map;
    double mean = 0;
};

Measure measure(const std::string& metric, Image expected, Image got) {
    Measure result;
    result.map = map_of(metric, std::move(expected), std::move(got));
    const report::Pooling pooled(result.map);
    result.mean = mean_of(metric, pooled);
    return result;
}

const char* unit_of(const std::string& metric) {
    return metric == "rms" ? "of 255" : metric == "degrees" ? "degrees" : "FLIP";
}

// Holds the numbers of a measure to the limits of the case.
std::vector<report::Measured> held(const RenderCase& render, const Measure& measure) {
    const report::Pooling pooled(measure.map);
    std::vector<report::Measured> all;
    const auto hold = [&](const char* name, double value, double limit, const char* unit) {
        all.push_back({name, "", shortest(limit), short_number(value), value, limit, unit});
    };
    const char* unit = unit_of(render.metric);
    hold(render.metric == "rms" ? "root mean square" : "mean", measure.mean,
         render.tolerance.value_or(default_tolerance(render.metric)), unit);
    if (render.max_pixel) hold("largest", pooled.max(), *render.max_pixel, unit);
    if (render.max_over)
        hold("pixels over",
             static_cast<double>(pooled.count_above(static_cast<float>(render.over))),
             *render.max_over, "pixels");
    return all;
}

std::string place_of(const report::Pooling& pooled) {
    return "at most " + short_number(pooled.max()) + " at " + std::to_string(pooled.max_x()) + "," +
           std::to_string(pooled.max_y());
}

}  // namespace

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

CaseComparison compare_point(const TestCase& test, const Document& document,
                             const json::Value& expected, const std::vector<OutputColumn>& columns,
                             size_t point) {
    CaseComparison result;
    for (const json::Member& member : expected.children()) {
        report::Measured& output = result.measured.emplace_back();
        output.name = output_name(member.key);
        output.node = source_of(document, output.name);
        output.expected = json::one_line(member.value);
        const std::string fault = compare_output(test, member, columns, point, output);
        if (fault.empty()) continue;
        result.difference += (result.difference.empty() ? "" : "; ") + ("output '" + output.name) +
                             "'" + (output.node.empty() ? "" : " (" + output.node + ")") + ": " +
                             fault;
    }
    return result;
}

std::string map_metric(const RenderCase& render) {
    if (render.metric != "rms") return render.metric;
    return render.options.view == gpu::View::normal ? "degrees" : "flip";
}

ImageComparison compare_images(const RenderCase& render, const Image& expected, const Image& got) {
    ImageComparison result;
    if (expected.width != got.width || expected.height != got.height) {
        result.difference =
            "the image is " + size_text(got) + ", its golden file " + size_text(expected);
        return result;
    }
    result.measured = held(render, measure(render.metric, expected, got));
    for (const report::Measured& each : result.measured)
        if (!each.within())
            result.difference += (result.difference.empty() ? "the image differs by " : "; ") +
                                 each.actual + " " + each.unit + ", " + each.expected + " allowed";
    if (result.difference.empty()) return result;
    result.map_measure = map_metric(render);
    const Measure shown = measure(result.map_measure, expected, got);
    const report::Pooling pooled(shown.map);
    if (pooled.max() > 0 && result.map_measure == "degrees") result.map_scale = pooled.max();
    result.map = report::colored(shown.map, report::magma, result.map_scale);
    result.largest = std::string(unit_of(result.map_measure)) + " " + short_number(shown.mean) +
                     " on average, " + place_of(pooled);
    result.difference += "; " + result.largest;
    return result;
}

Image side_by_side(const std::vector<const Image*>& images) {
    const uint32_t width = images.front()->width, height = images.front()->height;
    Image joined =
        make_image(width * static_cast<uint32_t>(images.size()), height, 3, PixelType::u8);
    for (size_t i = 0; i < images.size(); ++i) {
        const Image rgba = to_rgba(*images[i]);
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x)
                std::copy_n(rgba.texel(x, y), 3,
                            joined.texel(static_cast<uint32_t>(i) * width + x, y));
    }
    return joined;
}

}  // namespace wrinkle::cli
