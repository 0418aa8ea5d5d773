// The library: graphs of the user for any project, below `Folders::library`. An entry is a folder
// NAME with NAME.json and the files that the graph names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "editor/model/session.h"

namespace wrinkle::editor {

struct LibraryEntry {
    std::string name;
    std::filesystem::path file;  // NAME/NAME.json
};

// Returns the entries by name; folders without their graph are left out.
std::vector<LibraryEntry> library_entries(const Folders& folders);

// Returns why the graph cannot be added, a sentence; "" if it can.
std::string_view why_not_in_library(const Session& session);
// Copies the open graph as it is displayed, and the files that it names, to an entry named after
// its file. Prompts before it replaces an entry. The status has the result.
void add_to_library(Session& session);
void replace_in_library(Session& session);  // answer to that prompt

// Copies an entry to a folder NAME in the folder of the open graph, or NAME2, NAME3, ... if there
// are other files; equal files are left as they are. Returns its graph as nodes name it:
// "rock/rock.json"; "" with the reason in the status on failure.
std::string copy_from_library(Session& session, const LibraryEntry& entry);

}  // namespace wrinkle::editor
