// How far what follows from the document has come: which snapshot was given to the compiler, which
// one the texts are of, and which values the preview shows.
#pragma once

#include <cstdint>
#include <memory>

#include "editor/document/compiler.h"

namespace wrinkle::editor {

struct Follow {
    Compiler* compiler = nullptr;  // nullptr: refresh() compiles by itself, at once
    uint64_t asked = 0;            // the newest job's version
    uint64_t came = 0;             // that of the newest result
    uint64_t first = 0;            // of the file that is open; older results are another's
    Document asked_of, built_of;
    bool names_stale = false;  // the texts have former names of nodes
    bool code_shown = false;   // somebody looks at the texts; said anew on every frame

    // What the preview runs. It may be older than the texts: other names make no other program.
    std::optional<Shader> running;
    Document running_of;
    Document sent;  // whose values it has

    bool building() const { return came < asked; }
};

}  // namespace wrinkle::editor
