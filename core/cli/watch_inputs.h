// The files on which the last build depends, and their contents when it read them.
#pragma once

#include <filesystem>
#include <map>
#include <set>

#include "base/file_log.h"

namespace wrinkle::cli {

class WatchedInputs {
public:
    // Replaces the files by the inputs of a build that are not its outputs; after a failed build,
    // adds them, because it may have ended before it opened all.
    void set(const FileLog& log, bool succeeded);
    // Reads the files that are new or changed since the last call. Returns true if one changed
    // after the build had opened it. Call it when the files of files() are watched.
    bool read();
    // Returns true if the contents of a file differ from those read; they are read again.
    bool changed();

    std::set<std::filesystem::path> files() const;

private:
    struct Known {
        DiskCopy copy;
        bool is_recent = false;  // written just before it was read: a later write may have its date
        bool is_read = false;    // false: only the stamp is known
    };
    static Known read_now(const std::filesystem::path& file);

    std::map<std::filesystem::path, Known> known_;  // by absolute path
};

}  // namespace wrinkle::cli
