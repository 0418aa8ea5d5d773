// Selects the graphs among the files on a command line.
//
// NAME.test.json is a regression test (cli/test_case.h) and NAME.preset.json a set of values; both
// are in the folder of the graph NAME.json, so `*.json` matches them too.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"

namespace wrinkle::cli {

inline constexpr std::string_view test_suffix = ".test.json";
inline constexpr std::string_view preset_suffix = ".preset.json";

// Reports an error with a hint and returns true if `file` is named like a test or a preset.
bool report_no_graph(const std::string& file, Diagnostics& diagnostics);

// Returns the graphs and reports one warning that lists the other files. If there are no graphs,
// returns all files, and reading them reports the errors.
std::vector<std::string> graphs_among(const std::vector<std::string>& files,
                                      Diagnostics& diagnostics);

}  // namespace wrinkle::cli
