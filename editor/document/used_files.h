// The files that the open graph and its preview are made of, and the plugins: what another program
// changes is read again by itself.
//
// Their dates are looked at once a second, on a thread of their own: a slow disk holds up no frame.
// A file that is gone is believed to be so after a second look, since some programs replace files
// in two steps; a plugin is loaded when it has not changed for one.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "editor/document/model.h"
#include "editor/document/watch.h"
#include "editor/worker.h"

namespace wrinkle::editor {

struct State;

enum class Use : uint8_t { image, subgraph, mesh, light, plugin };

struct UsedFile {
    Use use = Use::image;
    std::filesystem::path path;
    Stamp stamp;
    std::string name = {};  // of a picture of the graph itself, as it writes it
};

// Of what the files are to be found out.
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
        Stamp read, last;  // as it was when it was read, and when it was looked at last
    };
    FileLooker* looker = nullptr;  // nullptr: looked at at once
    double looked = 0;             // seconds
    std::shared_ptr<const Project> looked_of;
    std::map<std::filesystem::path, Known> known;
    uint64_t changes = 0;  // files that were read again
};

// Once a frame. True when something is to be shown.
bool follow_files(State& state);

}  // namespace wrinkle::editor
