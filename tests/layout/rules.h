// The rules of the source tree that a text search can see: who may include whom (one table, in
// rules.cpp), the length of files, functions and lines, words that stand for unfinished work,
// the names of files of tests.
//
// A Source is a file's text under its path from the root of the repository, with '/' between
// folders. Each check gives one sentence per violation, beginning with "path:line: "; none means
// that the file is fine.
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

// "core/ir" of "core/ir/x/module.h", "nodes" of "nodes/uv.cpp".
std::string folder_of(std::string_view path);

// Of core, nodes, plugins and editor. A folder that the table does not know is a violation itself.
std::vector<std::string> include_violations(const Source& source);

// Length in characters, not bytes. Tables between `clang-format off` and `on` and raw strings are
// data of any width and count; a line without a space (a long address) cannot be broken; the labels
// of a switch are not counted.
std::vector<std::string> column_violations(const Source& source);
std::vector<std::string> length_violations(const Source& source);
std::vector<std::string> word_violations(const Source& source);

// Below tests: a file with a TEST is called NAME_test.cpp, and no other is.
std::vector<std::string> name_violations(const Source& source);

std::vector<std::string> all_violations(const Source& source);

}  // namespace wrinkle::layout
