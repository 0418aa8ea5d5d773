// Watches the files of the open graph and its preview, and the plugins, by polling: a file that
// another program changes is read again.
//
// Sizes and dates are checked once a second on a separate thread, so that a slow disk does not
// delay a frame. A missing file is reported only after a second check, because some programs
// replace files in two steps. A changed plugin is reloaded only after two equal checks, when it is
// fully written.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "editor/model/document/model.h"
#include "editor/model/document/watch.h"
#include "editor/model/worker.h"

namespace wrinkle::editor {

struct Session;

enum class Use : uint8_t { image, subgraph, mesh, light, plugin };

struct UsedFile {
    Use use = Use::image;
    std::filesystem::path path;
    Stamp stamp;
    std::string name = {};  // for an image of the top graph: its name in that graph
};

// Inputs of a check.
struct FileQuestion {
    Model model;
    Document document;
    std::string mesh, light;
    std::vector<std::string> plugins;  // files and folders
};
// Returns the used files with their current stamps. Callable from any thread.
std::vector<UsedFile> look_at_files(const FileQuestion& question);

using FileLooker = Worker<FileQuestion, std::vector<UsedFile>>;

struct UsedFiles {
    struct Known {
        Stamp read, last;  // at the last read, and at the last check
    };
    FileLooker* looker = nullptr;                    // nullptr: checks run on the calling thread
    double checked_at = 0;                           // time of the last check, seconds
    std::shared_ptr<const Project> checked_project;  // project at the last check
    std::map<std::filesystem::path, Known> known;
    uint64_t changes = 0;  // number of files that were read again
};

// Files that the window uses besides those of the graph.
struct WindowFiles {
    std::string mesh, light;                     // used by the preview; "": none
    std::vector<std::filesystem::path> dropped;  // images that wait to be examined
};
// Called once a frame. Reloads changed plugins and has changed sub-graphs read again; returns all
// changed files, of which the caller reads the others.
std::vector<UsedFile> follow_files(Session& session, const WindowFiles& window);

}  // namespace wrinkle::editor
