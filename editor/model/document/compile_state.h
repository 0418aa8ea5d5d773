// Progress of the data derived from the document: the snapshot given to the compiler, the snapshot
// of the newest build, and the values that the preview shows.
#pragma once

#include <cstdint>
#include <memory>

#include "editor/model/document/compiler.h"

namespace wrinkle::editor {

struct CompileState {
    Compiler* compiler = nullptr;    // nullptr: refresh() compiles by itself, at once
    uint64_t requested_version = 0;  // version of the newest job
    uint64_t finished_version = 0;   // version of the newest result
    uint64_t first = 0;              // first of the open file; older results are discarded
    Document requested_snapshot, built_snapshot;
    PreviewRequest requested;

    // Shader that the preview runs. Its nodes may have been renamed since; that does not change the
    // program.
    std::optional<Shader> running;
    Document running_snapshot;
    PreviewRequest running_for;
    std::map<std::string, std::string> copied;  // Build::copied of `running`
    std::shared_ptr<const Displacement> displacement;
    Document sent_snapshot;  // snapshot with the uniform values that the preview has

    // Costs of the newest source that was counted. nullptr: costs are only estimated.
    CostCounter* counter = nullptr;
    std::string counting;      // source of the last count request
    uint64_t counting_of = 0;  // version of that source
    std::optional<CountedCosts> counted;
    bool is_counting() const { return counter && !counter->idle(); }
    bool is_counted() const { return counted && counted->version >= first; }

    uint64_t diagnosed_version = 0;  // version of the newest preview with known problems

    bool building() const { return finished_version < requested_version; }
};

}  // namespace wrinkle::editor
