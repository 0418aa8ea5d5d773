#include "editor/model/document/library.h"

#include <algorithm>

#include "base/file.h"
#include "editor/model/document/files.h"
#include "graph/write.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

constexpr int most_copies = 99;

fs::path folder_of_entry(const Session& session) {
    return session.keeping.folders.library / session.path.stem();
}

// Writes the graph and copies of its files into an empty folder. Returns the reason on failure.
std::string write_entry(const Session& session, const fs::path& folder) {
    const MovedPaths moved = moved_to(session, folder / "x", OutsideFiles::copied);
    const fs::path file = folder / session.path.filename().replace_extension(".json");
    std::string why;
    NewPaths made;
    if (!copy_files(moved.copies, made, why)) return why;
    if (const std::error_code error = write_file_synced(file, canonical_text(moved.document)))
        return disk_words(error);
    made.keep();
    return {};
}

// Replaces `folder` by `written`, or leaves both as they are.
std::error_code exchange_folders(const fs::path& written, const fs::path& folder) {
    std::error_code error, ignored;
    const fs::path former = fs::path(written) += ".former";
    if (fs::exists(folder, ignored)) fs::rename(folder, former, error);
    if (error) return error;
    fs::rename(written, folder, error);
    if (error) fs::rename(former, folder, ignored);
    fs::remove_all(former, ignored);
    return error;
}

std::map<fs::path, fs::path> files_of_entry(const fs::path& from, const fs::path& to) {
    std::map<fs::path, fs::path> copies;
    std::error_code error;
    for (fs::recursive_directory_iterator at(from, error), end; !error && at != end;
         at.increment(error))
        if (at->is_regular_file(error))
            copies[to / at->path().lexically_relative(from)] = at->path();
    return copies;
}

}  // namespace

std::vector<LibraryEntry> library_entries(const Folders& folders) {
    std::vector<LibraryEntry> entries;
    std::error_code error, ignored;
    if (folders.library.empty()) return entries;
    for (fs::directory_iterator at(folders.library, error), end; !error && at != end;
         at.increment(error)) {
        const std::string name = at->path().filename().string();
        const fs::path file = at->path() / (name + ".json");
        if (!name.starts_with('.') && fs::is_regular_file(file, ignored))
            entries.push_back({name, file});
    }
    std::ranges::sort(entries, {}, &LibraryEntry::name);
    return entries;
}

std::string_view why_not_in_library(const Session& session) {
    if (session.keeping.folders.library.empty()) return "There is no folder for a library.";
    if (session.document().nodes.empty()) return "The graph has no nodes.";
    return session.path.empty() ? "Save the graph first: the entry is named after its file." : "";
}

void add_to_library(Session& session) {
    std::error_code ignored;
    if (!fs::exists(folder_of_entry(session), ignored)) return replace_in_library(session);
    session.question = {.kind = Question::Kind::library, .file = folder_of_entry(session)};
}

void replace_in_library(Session& session) {
    session.question = {};
    const fs::path folder = folder_of_entry(session), library = folder.parent_path();
    const fs::path written = library / ("." + folder.filename().string());
    const std::string name = folder.filename().string();
    std::error_code error, ignored;
    fs::remove_all(written, ignored);  // of an editor that ended meanwhile
    fs::create_directories(written, error);
    std::string why = error ? disk_words(error) : write_entry(session, written);
    if (why.empty() && (error = exchange_folders(written, folder))) why = disk_words(error);
    fs::remove_all(written, ignored);
    session.status = why.empty() ? "Added " + name + " to the library: " + folder.string()
                                 : name + " was not added to the library: " + why + ".";
}

std::string copy_from_library(Session& session, const LibraryEntry& entry) {
    std::string why;
    for (int i = 1; i <= most_copies; ++i) {
        const std::string name = entry.name + (i == 1 ? "" : std::to_string(i));
        NewPaths made;
        const auto copies = files_of_entry(entry.file.parent_path(), session.folder() / name);
        if (copy_files(copies, made, why)) {
            made.keep();
            return name + "/" + entry.file.filename().string();
        }
        if (!why.starts_with("there is another")) break;
    }
    session.status = entry.name + " was not copied from the library: " + why + ".";
    return {};
}

}  // namespace wrinkle::editor
