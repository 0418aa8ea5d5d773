// Compiles documents on a worker thread. The newest document wins: a new job replaces a waiting
// one, and results are returned in the order of their versions.
#pragma once

#include <string>

#include "editor/model/document/build.h"
#include "editor/model/worker.h"

namespace wrinkle::editor {

using Compiler = Worker<CompileJob, Build>;

// Progress of the data derived from the document: the snapshot given to the compiler, the snapshot
// of the newest build, and the values that the preview shows.
struct CompileState {
    Compiler* compiler = nullptr;    // nullptr: refresh() compiles by itself, at once
    uint64_t requested_version = 0;  // version of the newest job
    uint64_t first = 0;              // first of the open file; older results are discarded
    Document requested_snapshot;
    PreviewRequest requested;

    // The newest build with a shader, which the preview runs. Its nodes may have been renamed
    // since; that does not change the program.
    Build drawn;
    Document sent_snapshot;   // snapshot with the uniform values that the preview has
    std::string sent_preset;  // the preset that it is shown with

    // Costs of the newest source that was counted. nullptr: costs are only estimated.
    CostCounter* counter = nullptr;
    std::string counting;      // source of the last count request
    uint64_t counting_of = 0;  // version of that source
    std::optional<Costs> counted;
    bool is_counting() const { return counter && !counter->idle(); }
    bool is_counted() const { return counted && counted->version >= first; }

    uint64_t diagnosed_version = 0;  // version of the newest preview with known problems
};

}  // namespace wrinkle::editor
