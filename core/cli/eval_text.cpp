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

void append_bytes(std::string& text, auto value) {
    text.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void append_finite(std::string& text, double value, Precision precision) {
    if (precision == Precision::single)
        append_shortest(text, static_cast<float>(value));
    else
        text += shortest(value);
}

// Calls use(value) for each number of the outputs at a point.
template <class Use>
void each_number(const std::vector<OutputColumn>& columns, size_t point, Use use) {
    for (const OutputColumn& column : columns)
        for (size_t lane = 0; lane < column.lanes; ++lane)
            use(column.values[point * column.lanes + lane]);
}

}  // namespace

void EvalText::begin(const std::vector<OutputColumn>& columns) {
    begun_ = true;
    const std::vector<std::string> names = names_of(columns);
    if (form_ == EvalForm::json) text_ = "\"points\": [";
    if (form_ == EvalForm::npy) text_ = npy_header(names, precision_ == Precision::full, points_);
    if (form_ == EvalForm::csv) text_ = joined(names, ",") + '\n';
}

void EvalText::add_csv(double value) {
    if (text_.back() != '\n') text_ += ',';
    if (std::isnan(value))
        text_ += "nan";
    else if (std::isinf(value))
        text_ += value > 0 ? "inf" : "-inf";
    else
        append_finite(text_, value, precision_);
}

void EvalText::add_binary(double value) {
    if (precision_ == Precision::single)
        append_bytes(text_, static_cast<float>(value));
    else
        append_bytes(text_, value);
}

void EvalText::add(size_t count, const std::vector<OutputColumn>& columns) {
    if (!begun_) begin(columns);
    for (size_t point = 0; point < count; ++point, ++done_) {
        if (form_ == EvalForm::json) {
            text_ += done_ > 0 ? ",\n  " : "\n  ";
            text_ += values_json(columns, point, precision_);
        } else if (form_ == EvalForm::csv) {
            each_number(columns, point, [this](double value) { add_csv(value); });
            text_ += '\n';
        } else {
            each_number(columns, point, [this](double value) { add_binary(value); });
        }
    }
}

std::string EvalText::take() {
    if (form_ == EvalForm::json) text_ += done_ > 0 ? "\n]" : "]";
    return std::move(text_);
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
