// Recovery journal: stores the unsaved edits of an open document on disk, to recover them after a
// crash.
//
// There is one file per document and process in STATE/journal, locked (flock) while its program
// runs. It is created with the first unsaved edit and removed when all edits are saved or
// discarded. It is append-only: first the complete text, then one text delta per step, with a size
// proportional to the change. A partial record at the end is ignored.
//
// A record is `KIND LENGTH SUM\n`, LENGTH bytes and "\n"; SUM is the checksum of these bytes and
// the previous sum, so a record is valid only after its predecessors. KIND is `graph` (path, reason
// why the file must not be overwritten, text, separated by zero bytes; a path that ends with "/" is
// the folder of a graph without a file) or `edit` (text_delta.h).
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "editor/model/document/journaled_text.h"

namespace wrinkle::editor {

// Contents of a journal that is not locked by a running program.
struct Recoverable {
    std::filesystem::path journal;
    std::filesystem::path graph;   // absolute; empty if the graph had no file yet
    std::filesystem::path folder;  // absolute, if the graph had no file yet; empty: unknown
    std::string refused;           // why the file must not be overwritten, "" if it may be
    std::string text;              // the document after the last edit
    size_t edits = 0;
    int64_t when = 0;  // last edit, seconds since 1970
};

class Journal {
public:
    Journal() = default;
    ~Journal() { close(); }
    Journal(Journal&& other) noexcept { swap(other); }
    Journal& operator=(Journal&& other) noexcept {
        swap(other);
        return *this;
    }
    void swap(Journal& other) noexcept;

    // Creates the file if necessary and appends the difference to the text of `document`. On an
    // error nothing of it is stored and earlier records remain valid. `graph` is the file, or the
    // folder and "/" if there is none.
    std::error_code keep(const std::filesystem::path& state_folder,
                         const std::filesystem::path& graph, const std::string& refused,
                         const Document& document);
    // Removes the file, after all edits are saved or discarded.
    void drop();
    bool exists() const { return handle_ >= 0; }
    // Flushes the records to disk without waiting, to survive a crash of the machine.
    void sync();

private:
    std::error_code create(const std::filesystem::path& state_folder);
    std::error_code append(std::string_view kind, std::string_view payload);
    void close();

    int handle_ = -1;
    std::filesystem::path file_;
    JournaledText text_;  // after the last record
    uint64_t sum_ = 0;    // chained checksum of the last record
    uint64_t size_ = 0, synced_ = 0;
    std::shared_ptr<std::atomic<bool>> syncing_ = std::make_shared<std::atomic<bool>>(false);
};

// Returns the intact part of a journal; std::nullopt if not even its first record is intact.
std::optional<Recoverable> read_journal(const std::filesystem::path& file);

// Returns all recoverable journals, the latest first. Removes a journal with the same text as its
// graph's file: it has no unsaved edits.
std::vector<Recoverable> list_recoverable(const std::filesystem::path& state_folder);

}  // namespace wrinkle::editor
