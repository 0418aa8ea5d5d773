// A `wrinkle` wrapper for the PATH of job runners: runs the real program, but kills it half-way,
// once, when it bakes one of the shards. The program is stopped while its progress is read, so that
// it does not end first. Calls are logged in the file `calls`.
#pragma once

#include "cli/support.h"

namespace wrinkle::test {

// Returns "PATH=..." for a process, with the wrapper's folder first. `folder` belongs to one test.
inline std::string path_with_killer(const fs::path& folder, const std::string& shard) {
    const fs::path file = folder / "killer/wrinkle";
    fs::create_directories(file.parent_path());
    const std::string script = R"(#!/bin/sh
here=FOLDER
echo "$*" >> $here/calls
case "$*" in
*"--shard SHARD "*)
    if [ ! -e $here/killed ]; then
        touch $here/killed
        for word; do case $last in -o) part=$word ;; esac; last=$word; done
        WRINKLE "$@" &
        until
            kill -STOP $!
            begun=$(sed -n 's/.*"rows_of_tiles": \[\([0-9]*\),.*/\1/p' "$part/bake.json" 2>/dev/null) &&
                [ "$begun" ] && ! grep -q "\"done\": $begun,\$" "$part/bake.json"
        do
            kill -CONT $!
            sleep 0.005
        done
        kill -9 $!
        kill -9 $$
    fi ;;
esac
exec WRINKLE "$@"
)";
    std::string text = script;
    const std::pair<std::string, std::string> words[] = {
        {"FOLDER", folder / "killer"},
        {"SHARD", shard},
        {"WRINKLE", WRINKLE_BINARY_DIR "/bin/wrinkle"}};
    for (const auto& [from, to] : words)
        for (size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
    std::ofstream(file, std::ios::binary) << text;
    fs::permissions(file, fs::perms::owner_all);
    return "PATH=" + file.parent_path().string() + ":" + std::string(getenv("PATH"));
}

// Returns the logged calls, one per line, and clears the log.
inline std::string take_calls(const fs::path& folder) {
    const std::string calls = bytes_of(folder / "killer/calls");
    fs::remove(folder / "killer/calls");
    return calls;
}

inline size_t times(const std::string& text, const std::string& words) {
    size_t count = 0;
    for (size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1))
        ++count;
    return count;
}

}  // namespace wrinkle::test
