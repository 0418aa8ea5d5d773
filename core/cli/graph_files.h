// Which of the files that a command line names are graphs.
//
// NAME.test.json is a regression test (cli/test_case.h) and NAME.preset.json a set of values; both
// are beside the graph NAME.json, where `*.json` finds them too.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"

namespace wrinkle::cli {

inline constexpr std::string_view test_suffix = ".test.json";
inline constexpr std::string_view preset_suffix = ".preset.json";

// What such a file is and what to do with it, as an error; false of any other name.
bool report_no_graph(const std::string& file, Diagnostics& diagnostics);

// Those that are graphs, with one warning of the others. Where there are no graphs among them all
// are left, and reading them reports why.
std::vector<std::string> graphs_among(const std::vector<std::string>& files,
                                      Diagnostics& diagnostics);

}  // namespace wrinkle::cli
