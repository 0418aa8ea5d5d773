// Results as JSON, "version": 1, for programs, for merging the reports of shards and for accepting
// results later. Members are named like those of Results, Check and Measured; members with their
// default value are left out, but for the status.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "report/results.h"

namespace wrinkle::report {

// Numbers that are not finite, as of a cost that is not a number, are written as null. One check
// per line.
std::string to_json(const Results& results);

// Returns std::nullopt and reports an error if the file cannot be read, is not JSON of this
// version, has a member of another kind, or names an image by an absolute path or with "..".
// Unknown members are ignored. A null is NaN.
std::optional<Results> read_results(const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace wrinkle::report
