// Reads and writes NumPy's NPY format for tables: one dimension of records with float fields.
//
//   numpy.zeros(n, [("uv0.x", "<f4"), ("uv0.y", "<f4")])
//
// Accepts versions 1.0 to 3.0, fields of type <f4 or <f8, and |V padding fields of aligned records,
// which are skipped. Refuses other types, big-endian numbers, Fortran order, arrays without field
// names or with more than one dimension, and files with a size that differs from their header.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::cli {

struct NpyField {
    std::string name;
    size_t offset = 0;  // bytes from the start of a record
    bool is_double = false;
};

struct NpyTable {
    std::vector<NpyField> fields;
    size_t first = 0;   // byte offset of the first record
    size_t record = 0;  // bytes
    size_t count = 0;   // records

    // Returns the number of a field of one record. Precondition: `bytes` are those of read_npy().
    double number(std::string_view bytes, const NpyField& field, size_t point) const;
};

struct NpyProblem {
    std::string message, expected;
};

// Throws an NpyProblem on failure.
NpyTable read_npy(std::string_view bytes);

// Returns the bytes before the records of a table of floats, or of doubles.
std::string npy_header(const std::vector<std::string>& names, bool doubles, size_t count);

}  // namespace wrinkle::cli
