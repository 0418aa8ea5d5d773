// Saved state of a parent graph while one of its sub-graphs is on the canvas.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "editor/model/document/history.h"
#include "editor/model/document/journal.h"
#include "editor/model/document/watch.h"
#include "editor/view/view.h"

namespace wrinkle::editor {

struct Level {
    std::filesystem::path path;
    History history;
    uint64_t saved_serial = 0;
    std::string save_refused;
    DiskCopy disk;
    Journal journal;
    uint64_t journalled = 0;
    View view;

    bool dirty() const { return history.serial() != saved_serial; }
};

}  // namespace wrinkle::editor
