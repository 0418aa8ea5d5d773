// What is kept outside the graph's file, and what is known of that file.
#pragma once

#include <ctime>

#include "editor/document/folders.h"
#include "editor/document/journal.h"
#include "editor/document/settings.h"
#include "editor/document/watch.h"

namespace wrinkle::editor {

struct Keeping {
    Folders folders;
    Settings settings, written;  // as they are, and as the disk has them
    DiskCopy disk;
    Journal journal;
    uint64_t journalled = 0;  // the serial of the state that the journal ends with, if there is one
    std::time_t kept_at = 0;  // when the journal last grew
    std::string unkept;       // why edits are not kept for recovery now, "" when they are
    std::string unsettled;    // why the settings were not written last, "" when they were
    bool try_again = false;
    std::vector<Recoverable> recoverable;  // of programs that died
    double looked = 0;                     // when the file was last compared with the disk, seconds
};

}  // namespace wrinkle::editor
