// Tables of points: CSV and NPY files.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "base/mapped.h"
#include "base/text.h"
#include "cli/arguments.h"
#include "cli/npy.h"
#include "cli/points.h"
#include "ir/op.h"

namespace wrinkle::cli {
namespace {

constexpr std::string_view components = "xyzw";
constexpr size_t max_shown = 40;  // characters of an invalid number in a message

struct Column {
    std::string name;
    InputNeed need;
    size_t lane = 0;
};

// All columns that a table may have; facing has no differentials.
std::vector<Column> all_columns() {
    std::vector<Column> columns;
    for (int i = 0; i < surface_input_count; ++i)
        for (const Variant variant : {Variant::value, Variant::dx, Variant::dy}) {
            const InputNeed need{static_cast<SurfaceInput>(i), variant};
            if (need.input == SurfaceInput::facing_ && variant != Variant::value) continue;
            for (size_t lane = 0; lane < lanes_of(need); ++lane)
                columns.push_back({column_name(name_of(need), lane, lanes_of(need)), need, lane});
        }
    return columns;
}

std::string_view unquoted(std::string_view text) {
    if (text.size() < 2 || text.front() != '"' || text.back() != '"') return text;
    return text.substr(1, text.size() - 2);
}

// Returns the first line and advances `text` past it.
std::string_view take_line(std::string_view& text) {
    const size_t end = std::min(text.find('\n'), text.size());
    const std::string_view taken = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return taken;
}

class TableReader {
public:
    TableReader(PointList& list, Diagnostics& diagnostics)
        : list_(list), diagnostics_(diagnostics) {}

    void read_csv(std::string_view text) {
        if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
        list_.first_line = 2;
        for (const std::string_view name : split(take_line(text), ','))
            add_column(std::string(unquoted(trimmed(name))));
        const size_t last = text.find_last_not_of(" \t\r\n");
        text = text.substr(0, last == text.npos ? 0 : last + 1);
        for (; !text.empty(); ++list_.given.count)
            read_point(split(take_line(text), ','));
    }

    void read_npy(std::string_view bytes) {
        const NpyTable table = cli::read_npy(bytes);
        list_.given.count = table.count;
        for (const NpyField& field : table.fields)
            add_column(field.name);
        for (size_t i = 0; i < columns_.size(); ++i)
            for (size_t point = 0; point < table.count; ++point)
                put(i, point, table.number(bytes, table.fields[i], point));
    }

    // Reports the first missing component of each input.
    void check_columns() {
        for (const Column& column : all_) {
            const std::string input = name_of(column.need);
            if (names_.contains(column.name) || inputs_.erase(input) == 0) continue;
            problem(1, "column '" + column.name + "' is missing",
                    "all components of '" + input + "'");
        }
    }

    void check_numbers() {
        const auto report = [&](size_t point, const std::string& message, const char* expected) {
            list_.report(point, RuleId::point, Severity::error, message, expected, diagnostics_);
        };
        for (const Column& first : all_) {
            if (first.lane > 0) continue;
            const std::vector<double>& values =
                list_.given.at(first.need.input, first.need.variant);
            const size_t lanes = lanes_of(first.need);
            for (size_t i = 0; i < values.size(); ++i)
                if (!std::isfinite(values[i]))
                    report(i / lanes, "'" + (&first)[i % lanes].name + "' is not a finite number",
                           "");
        }
        const std::vector<double>& normals = list_.given.at(SurfaceInput::normal_);
        for (size_t i = 0; i < normals.size(); i += 3)
            if (normals[i] == 0 && normals[i + 1] == 0 && normals[i + 2] == 0)
                report(i / 3, "normal is zero", "a direction of any length but zero");
    }

private:
    void add_column(const std::string& name) {
        const auto column = std::ranges::find(all_, name, &Column::name);
        columns_.push_back(column == all_.end() ? nullptr : &*column);
        if (column == all_.end())
            problem(1, "there is no column '" + name + "'",
                    did_you_mean(name, mapped<std::string>(all_, &Column::name),
                                 "such as position.x, dx.uv0.y or facing"));
        else if (!names_.insert(name).second)
            problem(1, "column '" + name + "' is there twice", "one of them");
        else
            inputs_.insert(name_of(column->need));
    }

    void read_point(const std::vector<std::string_view>& fields) {
        const size_t point = list_.given.count;
        for (size_t i = 0; i < fields.size(); ++i) {
            const std::string_view field = trimmed(fields[i]);
            double value = 0;
            if (!parse_number(field, value))
                list_.report(point, RuleId::point, Severity::error,
                             "'" + std::string(field.substr(0, max_shown)) + "' is not a number",
                             "a number such as 0.25 or -1e-3", diagnostics_);
            if (i < columns_.size()) put(i, point, value);
        }
        if (fields.size() != columns_.size())
            problem(list_.first_line + static_cast<uint32_t>(point),
                    "point " + std::to_string(point) + " has " + std::to_string(fields.size()) +
                        " numbers",
                    std::to_string(columns_.size()) + ", as the first line has names");
    }

    void put(size_t column, size_t point, double value) {
        if (const Column* to = columns_[column]) list_.set(to->need, point, to->lane, value);
    }

    void problem(uint32_t line, std::string message, std::string expected) {
        Diagnostic found = file_problem(Severity::error, RuleId::point, list_.file,
                                        std::move(message), std::move(expected));
        if (list_.first_line > 0) found.where = {list_.file, line, 1};
        diagnostics_.add(std::move(found));
    }

    PointList& list_;
    Diagnostics& diagnostics_;
    const std::vector<Column> all_ = all_columns();
    std::vector<const Column*> columns_;  // in the order of the table; null: unknown
    std::set<std::string> names_, inputs_;
};

}  // namespace

std::string column_name(const std::string& value, size_t lane, size_t lanes) {
    return lanes == 1 ? value : value + "." + components[lane];
}

PointList read_table(const std::string& file, std::string_view bytes, Diagnostics& diagnostics) {
    Diagnostics own;
    PointList list;
    list.file = file;
    TableReader reader(list, own);
    try {
        if (file.ends_with(".csv"))
            reader.read_csv(bytes);
        else
            reader.read_npy(bytes);
    } catch (const NpyProblem& problem) {
        own.add(
            file_problem(Severity::error, RuleId::point, file, problem.message, problem.expected));
    }
    if (!own.has_errors()) reader.check_columns();
    list.finish();
    if (!own.has_errors()) reader.check_numbers();
    diagnostics.append(own);
    return own.has_errors() ? PointList() : list;
}

}  // namespace wrinkle::cli
