#include "cli/eval_text.h"

#include <cmath>

#include "base/text.h"
#include "cli/npy.h"
#include "cli/output.h"
#include "cli/points.h"

namespace wrinkle::cli {
namespace {

std::vector<std::string> names_of(const std::vector<OutputColumn>& columns) {
    std::vector<std::string> names;
    for (const OutputColumn& column : columns)
        for (size_t lane = 0; lane < column.lanes; ++lane)
            names.push_back(column_name(column.name, lane, column.lanes));
    return names;
}

void append_finite(std::string& text, double value, Precision precision) {
    if (precision == Precision::single)
        text += shortest(static_cast<float>(value));
    else
        text += shortest(value);
}

void append_csv(std::string& text, double value, Precision precision) {
    if (text.back() != '\n') text += ',';
    if (std::isnan(value))
        text += "nan";
    else if (std::isinf(value))
        text += value > 0 ? "inf" : "-inf";
    else
        append_finite(text, value, precision);
}

void append_binary(std::string& text, double value, Precision precision) {
    const auto single = static_cast<float>(value);
    if (precision == Precision::single)
        text.append(reinterpret_cast<const char*>(&single), sizeof single);
    else
        text.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string json_text(const std::vector<OutputColumn>& columns, size_t points,
                      Precision precision) {
    std::string text = "\"points\": [";
    for (size_t point = 0; point < points; ++point) {
        text += point > 0 ? ",\n  " : "\n  ";
        text += values_json(columns, point, precision);
    }
    return text + (points > 0 ? "\n]" : "]");
}

}  // namespace

std::string eval_text(std::string_view form, const std::vector<OutputColumn>& columns,
                      size_t points, Precision precision) {
    if (form == "json") return json_text(columns, points, precision);
    const bool is_csv = form == "csv";
    const std::vector<std::string> names = names_of(columns);
    std::string text = is_csv ? joined(names, ",") + '\n'
                              : npy_header(names, precision == Precision::full, points);
    for (size_t point = 0; point < points; ++point) {
        for (const OutputColumn& column : columns)
            for (size_t i = point * column.lanes; i < (point + 1) * column.lanes; ++i)
                (is_csv ? append_csv : append_binary)(text, column.values[i], precision);
        if (is_csv) text += '\n';
    }
    return text;
}

std::string values_json(const std::vector<OutputColumn>& columns, size_t point,
                        Precision precision) {
    std::string text = "{";
    for (const OutputColumn& column : columns) {
        if (text.size() > 1) text += ", ";
        text += json_quoted(column.name) + (column.lanes > 1 ? ": [" : ": ");
        for (size_t lane = 0; lane < column.lanes; ++lane) {
            if (lane > 0) text += ", ";
            const double value = column.values[point * column.lanes + lane];
            if (std::isfinite(value))
                append_finite(text, value, precision);
            else
                text += "null";
        }
        if (column.lanes > 1) text += ']';
    }
    return text + '}';
}

}  // namespace wrinkle::cli
