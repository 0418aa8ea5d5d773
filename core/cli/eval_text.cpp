#include "cli/eval_text.h"

#include <cmath>

#include "base/text.h"
#include "cli/evaluation.h"
#include "cli/npy.h"

namespace wrinkle::cli {
namespace {

std::vector<std::string> names_of(const std::vector<OutputColumn>& columns) {
    std::vector<std::string> names;
    for (const OutputColumn& column : columns)
        for (size_t lane = 0; lane < column.lanes; ++lane)
            names.push_back(column_name(column.name, lane, column.lanes));
    return names;
}

template <class T>
void append_bytes(std::string& text, T value) {
    text.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void append_csv(std::string& text, double value, Precision precision) {
    if (std::isnan(value))
        text += "nan";
    else if (std::isinf(value))
        text += value > 0 ? "inf" : "-inf";
    else if (precision == Precision::single)
        append_shortest(text, static_cast<float>(value));
    else
        text += shortest(value);
}

}  // namespace

void EvalText::begin(const std::vector<OutputColumn>& columns) {
    begun_ = true;
    const std::vector<std::string> names = names_of(columns);
    if (form_ == EvalForm::json) text_ = "\"points\": [";
    if (form_ == EvalForm::npy) text_ = npy_header(names, precision_ == Precision::full, points_);
    if (form_ != EvalForm::csv) return;
    for (const std::string& name : names)
        text_ += (text_.empty() ? "" : ",") + name;
    text_ += '\n';
}

void EvalText::add_csv(size_t point, const std::vector<OutputColumn>& columns) {
    for (const OutputColumn& column : columns)
        for (size_t lane = 0; lane < column.lanes; ++lane) {
            if (text_.back() != '\n') text_ += ',';
            append_csv(text_, column.values[point * column.lanes + lane], precision_);
        }
    text_ += '\n';
}

void EvalText::add_record(size_t point, const std::vector<OutputColumn>& columns) {
    for (const OutputColumn& column : columns)
        for (size_t lane = 0; lane < column.lanes; ++lane) {
            const double value = column.values[point * column.lanes + lane];
            if (precision_ == Precision::single)
                append_bytes(text_, static_cast<float>(value));
            else
                append_bytes(text_, value);
        }
}

void EvalText::add(size_t count, const std::vector<OutputColumn>& columns) {
    if (!begun_) begin(columns);
    for (size_t point = 0; point < count; ++point, ++done_) {
        if (form_ == EvalForm::csv) add_csv(point, columns);
        if (form_ == EvalForm::npy) add_record(point, columns);
        if (form_ != EvalForm::json) continue;
        text_ += done_ > 0 ? ",\n  " : "\n  ";
        append_values_json(text_, columns, point, precision_);
    }
}

std::string EvalText::take() {
    if (form_ == EvalForm::json) text_ += done_ > 0 ? "\n]" : "]";
    return std::move(text_);
}

}  // namespace wrinkle::cli
