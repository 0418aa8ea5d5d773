// Watches the files of the open graph and its preview, and the plugins: files that another program
// changes are read again.
//
// Their dates are checked once a second on a separate thread, so that a slow disk does not delay a
// frame. A missing file is reported only after a second check, since some programs replace files in
// two steps; a plugin is loaded when it is unchanged between two checks.
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
    std::string name = {};  // for an image of the top graph: its name there
};

// Inputs of a check.
struct FileQuestion {
    Model model;
    Document document;
    std::string mesh, light;
    std::vector<std::string> plugins;  // files and folders
};
std::vector<UsedFile> look_at_files(const FileQuestion& question);

using FileLooker = Worker<FileQuestion, std::vector<UsedFile>>;

struct UsedFiles {
    struct Known {
        Stamp read, last;  // at the last read, and at the last check
    };
    FileLooker* looker = nullptr;  // nullptr: checks run on the calling thread
    double looked = 0;             // seconds
    std::shared_ptr<const Project> looked_of;
    std::map<std::filesystem::path, Known> known;
    uint64_t changes = 0;  // number of files that were read again
};

// Files that the window uses besides those of the graph.
struct WindowFiles {
    std::string mesh, light;                     // used by the preview; "": none
    std::vector<std::filesystem::path> dropped;  // images that wait to be examined
};
// Called once a frame: reads changed sub-graphs and plugins again. Returns all changed files.
std::vector<UsedFile> follow_files(Session& session, const WindowFiles& window);

}  // namespace wrinkle::editor
