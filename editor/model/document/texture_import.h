// Graph of a folder of textures, as by `wrinkle import` (core/import): read in a background task,
// then opened as a new graph without a file, in that folder. The import is the first step of its
// history.
#pragma once

#include <filesystem>

#include "editor/model/session.h"

namespace wrinkle::editor {

// Starts the task. After success it requests the action `import`, which prompts for unsaved work.
// Warnings are listed among the problems; after an error nothing is opened. Returns false, with
// the reason in the status, if another task is running.
bool import_folder(Session& session, const std::filesystem::path& folder);

// Opens the graph of the action `import`.
void open_imported(Session& session, const PendingAction& import);

}  // namespace wrinkle::editor
