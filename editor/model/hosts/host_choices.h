// Choices of an export to a host, and the exports of a graph that are repeated at every save.
#pragma once

#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "export/export.h"

namespace wrinkle::editor {

inline constexpr uint32_t host_sizes[] = {256, 512, 1024, 2048, 4096, max_export_size};

struct HostChoices {
    const Host* host = &hosts().front();
    std::string mesh;    // a shape's name, or the path of an OBJ or glTF file
    std::string preset;  // name in the graph; "": the defaults of its inputs
    uint32_t size = 1024;
    std::filesystem::path into;  // a folder
};

struct RepeatedExports {
    std::vector<HostChoices> chosen;  // at most one for each host
    std::vector<HostChoices> due;     // not begun since the last save, the first one next
    size_t begun = 0, done = 0;       // exports; one that fails or is cancelled is never done
    std::time_t written = 0;          // time of the last one that was done

    // After a save: all are due, and failures before it no longer count. `running`: a task runs.
    void start_again(bool running) {
        due = chosen;
        begun = done + (running && begun > done ? 1 : 0);
    }
};

}  // namespace wrinkle::editor
