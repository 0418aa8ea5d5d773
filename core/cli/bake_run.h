// Runs a bake into its output files or into a folder with a part of it (cli/bake_parts.h), and
// merges parts into output files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/bake_job.h"
#include "cli/bake_parts.h"
#include "cli/progress.h"

namespace wrinkle::cli {

struct BakeOutcome {
    bool done = false;               // else failed, or interrupted if `environment` has no error
    std::vector<std::string> files;  // written files
    Diagnostics warnings;            // about the contents of the maps
    Diagnostics environment;         // reason of a failure
};

BakeOutcome bake_files(const BakeJob& job, const PartHeader& header, Progress& progress);
BakeOutcome bake_part(const BakeJob& job, const std::filesystem::path& folder, PartHeader header,
                      Progress& progress);

struct Part {
    std::filesystem::path folder;
    PartHeader header;
};
// Reads and checks all parts of one bake. Returns them by shard; an empty list and errors if a part
// is missing, incomplete or damaged.
std::vector<Part> read_parts(const std::vector<std::string>& folders, Diagnostics& diagnostics);
BakeOutcome join_parts(const std::vector<Part>& parts, const std::string& output, uint32_t threads,
                       Progress& progress);

}  // namespace wrinkle::cli
