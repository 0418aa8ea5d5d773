// Log of the files that this process opens, looks for in vain or replaces, written while it runs:
// `wrinkle watch` reads it to learn on which files a build depends, also after a failed build.
//
// Without start_file_log() the functions do nothing. They may be called from any thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/disk_copy.h"

namespace wrinkle {

// Appends one record per call to an open file descriptor, which must have O_APPEND semantics.
void start_file_log(int descriptor);

void log_input(const std::filesystem::path& file);     // before it is opened or looked for
void log_output(const std::filesystem::path& file);    // may be replaced
void log_replaced(const std::filesystem::path& file);  // has new contents

struct FileLog {
    struct Input {
        std::filesystem::path path;  // as spelled by the caller
        Stamp stamp;                 // before it was read
    };
    std::vector<Input> inputs;  // in the order of the calls, with repetitions
    std::vector<std::filesystem::path> outputs, replaced;

    // Returns the outputs; of several paths to one file, the first.
    std::vector<std::filesystem::path> distinct_outputs() const;
};
// Returns all bytes of an open file, from its beginning, without moving its offset.
std::string bytes_of_descriptor(int descriptor);

// Reads the records of a log, without paths that have a name of base/temporary.h.
FileLog read_file_log(int descriptor);

}  // namespace wrinkle
