// Surface points as a table: a CSV file with a header line, or an NPY file (cli/npy.h).
//
//   uv0.x,uv0.y,normal.x,normal.y,normal.z,dx.uv0.x,dx.uv0.y
//   0.25,0.5,0,0,1,0.001,0
//
// A column is one component of a surface input or of its differential to the next pixel:
// [dx.|dy.]NAME.x, .y, .z or .w; `facing` has neither differentials nor a suffix. Columns may have
// any order; an input needs all its components. Numbers are finite and no normal is zero. Errors
// name the file, the line (CSV only) and the point. Reading is O(numbers).
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "cpu/columns.h"

namespace wrinkle::cli {

// Returns the name of one column: "uv0.x", "dx.normal.z", "facing".
std::string column_name(const std::string& value, size_t lane, size_t lanes);

enum class TableForm : uint8_t { csv, npy };

class PointTable {
public:
    // Returns std::nullopt and reports errors on failure. `name` is the file name for messages.
    static std::optional<PointTable> read(TableForm form, std::string bytes,
                                          const std::string& name, Diagnostics& diagnostics);

    size_t count() const { return count_; }
    // Returns true if the table has this input or differential.
    bool gives(const InputNeed& need) const { return slots(need)[0].given; }
    // Returns component `lane`. Precondition: gives(need).
    double at(const InputNeed& need, size_t lane, size_t point) const {
        return number(slots(need)[lane], point);
    }
    // Location of a point for messages; without a line for NPY.
    Location where(size_t point) const;

private:
    struct Slot {
        bool given = false, is_double = true;
        size_t offset = 0;  // bytes from the start of a record
    };
    using Slots = std::array<Slot, 4>;

    Slots& slots(const InputNeed& need) {
        return slots_[static_cast<size_t>(need.input)][static_cast<size_t>(need.variant)];
    }
    const Slots& slots(const InputNeed& need) const {
        return slots_[static_cast<size_t>(need.input)][static_cast<size_t>(need.variant)];
    }
    double number(const Slot& slot, size_t point) const;
    void problem(uint32_t line, std::string message, std::string expected,
                 Diagnostics& diagnostics) const;
    void add_column(const std::string& name, size_t offset, bool is_double,
                    Diagnostics& diagnostics);
    void read_csv(std::string_view text, Diagnostics& diagnostics);
    size_t read_names(std::string_view line, Diagnostics& diagnostics);
    void read_npy_table(Diagnostics& diagnostics);
    void check_lanes(Diagnostics& diagnostics) const;
    void check_numbers(Diagnostics& diagnostics) const;

    // A CSV file is converted to records of doubles; an NPY file is not converted.
    std::string name_, bytes_;
    size_t first_ = 0, record_ = 0, count_ = 0;  // offset and size of records, in bytes; points
    uint32_t first_line_ = 0;                    // line of the first point; 0: no lines (NPY)
    std::array<std::array<Slots, 3>, PointSet::inputs> slots_;
};

}  // namespace wrinkle::cli
