// State that is stored outside the graph's file, and the known state of that file.
#pragma once

#include <ctime>

#include "editor/model/document/folders.h"
#include "editor/model/document/recovery_file.h"
#include "editor/model/document/settings.h"

namespace wrinkle::editor {

struct Persistence {
    Folders folders;
    Settings settings, written;  // current values, and the values on disk
    std::time_t kept_at = 0;     // time of the last write to the recovery file
    std::string unkept;          // why edits are not in the recovery file, "" if they are
    std::string unsettled;       // why the settings were last not written, "" if they were
    bool try_again = false;
    std::vector<Recoverable> recoverable;  // left by crashed programs
    double looked = 0;                     // last comparison of the file with the disk, seconds
};

}  // namespace wrinkle::editor
