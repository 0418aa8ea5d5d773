// Stores the unsaved edits of the open document, and recovers those of a crashed program.
#pragma once

#include <ctime>

#include "editor/model/document/folders.h"
#include "editor/model/document/recovery_file.h"
#include "editor/model/document/settings.h"

namespace wrinkle::editor {

struct Session;

// State that is stored outside the graph's file.
struct Persistence {
    Folders folders;
    Settings settings, written;  // current values, and the values on disk
    std::time_t kept_at = 0;     // time of the last write to the recovery file
    std::string unkept;          // why edits are not in the recovery file, "" if they are
    std::string unsettled;       // why the settings were last not written, "" if they were
    bool try_again = false;
    std::vector<Recoverable> recoverable;  // left by crashed programs
    double checked_at = 0;                 // last comparison of the file with the disk, seconds
};

// Called once a frame after its edits; all committed edits are written when it returns. Steps of a
// drag are written at its end.
void keep_edits(Session& session, bool dragging);
// Writes at once, even during a drag. Returns false on an error or if there is no state folder.
bool keep_edits_now(Session& session);

// Text for the status bar: "Saved", "All edits kept 14:02"; "" for a new graph.
std::string kept_words(const Session& session);

// Fills session.keeping.recoverable.
void look_for_recoverable(Session& session);
// Prompts for the latest recovery file of the open graph; if it has no file, for the latest of all.
void offer_recovery(Session& session);
// Opens its graph and commits the unsaved edits, so that undo returns to the file.
void recover(Session& session, const Recoverable& found);
// Discards its edits.
void forget(Session& session, const Recoverable& found);

}  // namespace wrinkle::editor
