#include "cli/point_table.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/text.h"
#include "cli/arguments.h"
#include "cli/npy.h"
#include "ir/op.h"

namespace wrinkle::cli {
namespace {

constexpr std::string_view components = "xyzw";
constexpr size_t max_shown = 40;  // characters of an invalid number in a message

struct Column {
    InputNeed need;
    size_t lane = 0;
};

std::optional<Column> column_named(std::string_view name) {
    if (const auto whole = find_input(name); whole && lanes_of(*whole) == 1) {
        if (whole->variant != Variant::value) return {};  // facing has no differentials
        return Column{*whole, 0};
    }
    if (name.size() < 2 || name[name.size() - 2] != '.') return {};
    const auto need = find_input(name.substr(0, name.size() - 2));
    const size_t lane = components.find(name.back());
    if (!need || lanes_of(*need) == 1 || lane >= lanes_of(*need)) return {};
    return Column{*need, lane};
}

std::vector<InputNeed> all_values() {
    std::vector<InputNeed> values;
    for (int i = 0; i < surface_input_count; ++i)
        for (const Variant variant : {Variant::value, Variant::dx, Variant::dy})
            if (variant == Variant::value || static_cast<SurfaceInput>(i) != SurfaceInput::facing_)
                values.push_back({static_cast<SurfaceInput>(i), variant});
    return values;
}

std::vector<std::string> all_column_names() {
    std::vector<std::string> names;
    for (const InputNeed& need : all_values())
        for (size_t lane = 0; lane < lanes_of(need); ++lane)
            names.push_back(column_name(name_of(need), lane, lanes_of(need)));
    return names;
}

std::string_view unquoted(std::string_view text) {
    if (text.size() < 2 || text.front() != '"' || text.back() != '"') return text;
    return text.substr(1, text.size() - 2);
}

// Returns the text before the separator and advances `text` past it.
std::string_view take(std::string_view& text, char separator) {
    const size_t end = std::min(text.find(separator), text.size());
    const std::string_view taken = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return taken;
}

}  // namespace

std::string column_name(const std::string& value, size_t lane, size_t lanes) {
    return lanes == 1 ? value : value + "." + components[lane];
}

void PointTable::problem(uint32_t line, std::string message, std::string expected,
                         Diagnostics& diagnostics) const {
    const Location where = {name_, line, line == 0 ? 0U : 1U};
    diagnostics.add({Severity::error, where, "", "", std::move(message), std::move(expected)});
}

Location PointTable::where(size_t point) const {
    return {name_, first_line_ == 0 ? 0 : first_line_ + static_cast<uint32_t>(point),
            first_line_ == 0 ? 0U : 1U};
}

double PointTable::number(const Slot& slot, size_t point) const {
    const char* from = bytes_.data() + first_ + point * record_ + slot.offset;
    if (slot.is_double) {
        double value;
        std::memcpy(&value, from, sizeof value);
        return value;
    }
    float value;
    std::memcpy(&value, from, sizeof value);
    return static_cast<double>(value);
}

void PointTable::add_column(const std::string& name, size_t offset, bool is_double,
                            Diagnostics& diagnostics) {
    const auto column = column_named(name);
    const uint32_t line = first_line_ == 0 ? 0 : 1;
    if (!column) {
        const std::vector<std::string> names = all_column_names();
        return problem(line, "there is no column '" + name + "'",
                       did_you_mean(name, names, "such as position.x, dx.uv0.y or facing"),
                       diagnostics);
    }
    Slot& slot = slots(column->need)[column->lane];
    if (slot.given)
        return problem(line, "column '" + name + "' is there twice", "one of them", diagnostics);
    slot = {true, is_double, offset};
}

void PointTable::check_lanes(Diagnostics& diagnostics) const {
    for (const InputNeed& need : all_values()) {
        const Slots& lanes = slots(need);
        const auto end = lanes.begin() + static_cast<long>(lanes_of(need));
        const auto given = std::count_if(lanes.begin(), end, [](const Slot& p) { return p.given; });
        if (given == 0 || given == end - lanes.begin()) continue;
        const auto missing =
            std::find_if(lanes.begin(), end, [](const Slot& p) { return !p.given; });
        problem(first_line_ == 0 ? 0 : 1,
                "column '" +
                    column_name(name_of(need), static_cast<size_t>(missing - lanes.begin()),
                                lanes_of(need)) +
                    "' is missing",
                "all components of '" + name_of(need) + "'", diagnostics);
    }
}

void PointTable::check_numbers(Diagnostics& diagnostics) const {
    for (const InputNeed& need : all_values()) {
        if (!gives(need)) continue;
        const bool is_normal =
            need.input == SurfaceInput::normal_ && need.variant == Variant::value;
        for (size_t point = 0; point < count_; ++point) {
            bool zero = true;
            for (size_t lane = 0; lane < lanes_of(need); ++lane) {
                const double value = at(need, lane, point);
                zero = zero && value == 0;
                if (std::isfinite(value)) continue;
                problem(where(point).line,
                        "point " + std::to_string(point) + ": '" +
                            column_name(name_of(need), lane, lanes_of(need)) +
                            "' is not a finite number",
                        "", diagnostics);
            }
            if (is_normal && zero)
                problem(where(point).line, "point " + std::to_string(point) + ": normal is zero",
                        "a direction of any length but zero", diagnostics);
        }
    }
}

size_t PointTable::read_names(std::string_view line, Diagnostics& diagnostics) {
    size_t count = 0;
    for (const std::string_view name : split(line, ','))
        add_column(std::string(unquoted(trimmed(name))), 8 * count++, true, diagnostics);
    return count;
}

void PointTable::read_csv(std::string_view text, Diagnostics& diagnostics) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    first_line_ = 2;
    const size_t columns = read_names(take(text, '\n'), diagnostics);
    record_ = 8 * columns;
    const size_t last = text.find_last_not_of(" \t\r\n");
    text = text.substr(0, last == text.npos ? 0 : last + 1);
    for (; !text.empty(); ++count_) {
        std::string_view line = take(text, '\n');
        size_t fields = 0;
        for (bool more = true; more; ++fields) {
            more = line.find(',') != line.npos;
            const std::string_view field = trimmed(take(line, ','));
            double value = 0;
            if (!parse_number(field, value))
                problem(where(count_).line,
                        "point " + std::to_string(count_) + ": '" +
                            std::string(field.substr(0, max_shown)) + "' is not a number",
                        "a number such as 0.25 or -1e-3", diagnostics);
            if (fields < columns) bytes_.append(reinterpret_cast<const char*>(&value), 8);
        }
        if (fields == columns) continue;
        problem(where(count_).line,
                "point " + std::to_string(count_) + " has " + std::to_string(fields) + " numbers",
                std::to_string(columns) + ", as the first line has names", diagnostics);
        bytes_.resize((count_ + 1) * record_);
    }
}

void PointTable::read_npy_table(Diagnostics& diagnostics) {
    NpyProblem found;
    const auto table = read_npy(bytes_, found);
    if (!table) return problem(0, found.message, found.expected, diagnostics);
    first_ = table->first;
    record_ = table->record;
    count_ = table->count;
    for (const NpyField& field : table->fields)
        add_column(field.name, field.offset, field.is_double, diagnostics);
}

std::optional<PointTable> PointTable::read(TableForm form, std::string bytes,
                                           const std::string& name, Diagnostics& diagnostics) {
    Diagnostics own;
    PointTable table;
    table.name_ = name;
    if (form == TableForm::csv) {
        table.read_csv(bytes, own);
    } else {
        table.bytes_ = std::move(bytes);
        table.read_npy_table(own);
    }
    if (!own.has_errors()) table.check_lanes(own);
    if (!own.has_errors()) table.check_numbers(own);
    diagnostics.append(own);
    if (own.has_errors()) return {};
    return table;
}

}  // namespace wrinkle::cli
