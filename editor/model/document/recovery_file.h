// Recovery file: the unsaved state of an open document on disk, to recover it after a crash.
//
// There is one file per document and process in STATE/journal, locked (flock) while its program
// runs. It is created with the first unsaved edit, replaced at once by every further one (a
// temporary file is renamed over it), and removed when all edits are saved or discarded.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "graph/document.h"

namespace wrinkle::editor {

// Contents of a recovery file that is not locked by a running program.
struct Recoverable {
    std::filesystem::path file;
    std::filesystem::path graph;   // absolute; empty if the graph had no file yet
    std::filesystem::path folder;  // absolute, if the graph had no file yet; empty: unknown
    std::string refused;           // why the file must not be overwritten, "" if it may be
    std::string text;              // the document after the last edit
    size_t edits = 0;
    int64_t when = 0;  // last edit, seconds since 1970
};

// Contents: "SUM\n", the checksum of the rest in hexadecimal; the number of edits, the path, the
// reason why the file must not be overwritten, and the text, separated by zero bytes. A path that
// ends with "/" is the folder of a graph without a file.
class RecoveryFile {
public:
    RecoveryFile() = default;
    ~RecoveryFile() { close(); }
    RecoveryFile(RecoveryFile&& other) noexcept { swap(other); }
    RecoveryFile& operator=(RecoveryFile&& other) noexcept {
        swap(other);
        return *this;
    }
    void swap(RecoveryFile& other) noexcept;

    // Replaces the contents; on an error the previous ones remain. `graph` is the document's file,
    // or its folder and "/" if there is none.
    std::error_code write(const std::filesystem::path& state_folder,
                          const std::filesystem::path& graph, const std::string& refused,
                          const Document& document);
    // Removes the file, after all edits are saved or discarded.
    void remove();
    bool exists() const { return handle_ >= 0; }
    // Flushes the contents to disk without waiting, to survive a crash of the machine.
    void sync();

private:
    std::error_code replace(const std::string& contents);
    void close();

    int handle_ = -1;  // holds the lock
    std::filesystem::path file_;
    size_t edits_ = 0, synced_ = 0;  // `synced_`: edits at the last sync()
    std::shared_ptr<std::atomic<bool>> syncing_ = std::make_shared<std::atomic<bool>>(false);
};

// Returns std::nullopt if the file is not intact.
std::optional<Recoverable> read_recovery_file(const std::filesystem::path& file);

// Returns all recoverable graphs, the latest first. Removes a recovery file with the same text as
// its graph's file: it has no unsaved edits.
std::vector<Recoverable> list_recoverable(const std::filesystem::path& state_folder);

}  // namespace wrinkle::editor
