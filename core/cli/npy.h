// Files of NumPy's format NPY that hold a table: one dimension of records whose fields are floats.
//
//   numpy.zeros(n, [("uv0.x", "<f4"), ("uv0.y", "<f4")])
//
// Versions 1.0 to 3.0, fields of type <f4 or <f8, and |V fields of an aligned record, which are
// passed over. Anything else is refused: other types, big-endian numbers, Fortran order, arrays
// without field names or of more than one dimension, files that are shorter or longer than their
// header says.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::cli {

struct NpyField {
    std::string name;
    size_t offset = 0;  // in a record
    bool is_double = false;
};

struct NpyTable {
    std::vector<NpyField> fields;
    size_t first = 0;   // byte of the first record
    size_t record = 0;  // bytes
    size_t count = 0;   // records
};

struct NpyProblem {
    std::string message, expected;
};

// Empty with the problem.
std::optional<NpyTable> read_npy(std::string_view bytes, NpyProblem& problem);

// The bytes before the records of a table of floats, or doubles.
std::string npy_header(const std::vector<std::string>& names, bool doubles, size_t count);

}  // namespace wrinkle::cli
