// Rules of the source tree that a text search can check: allowed includes (one table, in
// rules.cpp), the length of files, functions and lines, words that mark unfinished work, the names
// of test files.
//
// A Source is a file's text with its path from the root of the repository, with '/' between
// folders. Each check returns one sentence per violation, beginning with "path:line: "; an empty
// list means that the file passes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::layout {

inline constexpr size_t max_file_lines = 400;
inline constexpr size_t max_function_lines = 40;
inline constexpr size_t max_columns = 100;

struct Source {
    std::string path;  // "core/ir/module.h"
    std::string text;
};

// "core/ir" of "core/ir/x/module.h", "editor/model" of "editor/model/words.h", "nodes" of
// "nodes/uv.cpp".
std::string folder_of(std::string_view path);

// Checks core, nodes, plugins and editor. A folder that is not in the table is a violation.
std::vector<std::string> include_violations(const Source& source);

// Length in characters, not bytes. Tables between `clang-format off` and `on` and raw strings may
// have any width and number of lines. A line without a space (a long address) is exempt, and the
// labels of a switch are not counted.
std::vector<std::string> column_violations(const Source& source);
std::vector<std::string> length_violations(const Source& source);
std::vector<std::string> word_violations(const Source& source);

// In tests, a file is named NAME_test.cpp if and only if it contains a TEST.
std::vector<std::string> name_violations(const Source& source);

std::vector<std::string> all_violations(const Source& source);

}  // namespace wrinkle::layout
