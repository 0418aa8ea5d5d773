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
    PreviewRequest asked_for;

    // What the preview runs. Its nodes may have other names by now: they make no other program.
    std::optional<Shader> running;
    Document running_of;
    PreviewRequest running_for;
    std::map<std::string, std::string> copied;  // Build::copied of it
    std::shared_ptr<const Displacement> displacement;
    Document sent;  // whose values it has

    // The costs of the newest text that was counted. nullptr: they are only estimated.
    CostCounter* counter = nullptr;
    std::string counting;      // the text that was given to it
    uint64_t counting_of = 0;  // its version
    std::optional<CountedCosts> counted;
    bool is_counting() const { return counter && !counter->idle(); }
    bool is_counted() const { return counted && counted->version >= first; }

    uint64_t heard = 0;  // the newest picture's version whose problems are known

    bool building() const { return came < asked; }
};

}  // namespace wrinkle::editor
