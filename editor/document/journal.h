// The unsaved edits of an open document on disk, so that they outlive the program.
//
// One file per document and process in STATE/journal, locked while its program runs. It comes into
// being with the first unsaved edit and goes when all is saved or given up. It is only appended to:
// the whole text first, then one delta of the text for each step, which costs what it changed. What
// a dying program wrote half is not read.
//
// A record is `KIND LENGTH SUM\n`, LENGTH bytes and "\n"; SUM is the checksum of these bytes and of
// the sum before it, so a record holds only after those that it follows. KIND is `graph` (path,
// reason why its file must not be written over, text, with zero bytes between; a path that ends
// with "/" is the folder of a graph without a file) or `edit` (text_delta.h).
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "editor/document/kept_text.h"

namespace wrinkle::editor {

// What a journal says that is no program's any more.
struct Recoverable {
    std::filesystem::path journal;
    std::filesystem::path graph;   // absolute; empty of one that had no file yet
    std::filesystem::path folder;  // absolute, of one that had no file yet; empty: not known
    std::string refused;           // why that file must not be written over, "" when it may
    std::string text;              // the document after its last edit
    size_t edits = 0;
    int64_t when = 0;  // of the last edit, seconds since 1970
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

    // Brings the file up to the text of `document`. After an error nothing of it is kept, and what
    // was kept before still is. `graph` is the file, or a folder and "/" where there is none.
    std::error_code keep(const std::filesystem::path& state_folder,
                         const std::filesystem::path& graph, const std::string& refused,
                         const Document& document);
    // All is saved or given up: removes the file.
    void drop();
    bool exists() const { return handle_ >= 0; }
    // Against the death of the machine: has what is kept brought to the disk, without waiting.
    void sync();

private:
    std::error_code create(const std::filesystem::path& state_folder);
    std::error_code append(std::string_view kind, std::string_view payload);
    void close();

    int handle_ = -1;
    std::filesystem::path file_;
    KeptText text_;     // as of the last record
    uint64_t sum_ = 0;  // of the last record
    uint64_t size_ = 0, synced_ = 0;
    std::shared_ptr<std::atomic<bool>> syncing_ = std::make_shared<std::atomic<bool>>(false);
};

// What a journal file holds as far as it is whole; nothing when not even its first record is.
std::optional<Recoverable> read_journal(const std::filesystem::path& file);

// All that can be recovered, the latest first. A journal whose text is what its graph's file holds
// is removed: nothing of it is unsaved.
std::vector<Recoverable> list_recoverable(const std::filesystem::path& state_folder);

}  // namespace wrinkle::editor
