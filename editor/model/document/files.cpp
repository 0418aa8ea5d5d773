#include "editor/model/document/files.h"

#include <unistd.h>

#include <algorithm>

#include "base/file.h"
#include "editor/model/document/levels.h"
#include "editor/model/document/recovery.h"
#include "editor/model/words.h"
#include "graph/read.h"
#include "graph/write.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

std::string name_of(const fs::path& path) {
    return path.filename().string();
}

void begin(Session& session, const fs::path& path, Document document) {
    session.recovery_file.remove();  // saved or discarded
    if (session.path != path) session.repeated_exports = {};
    session.path = path;
    session.save_refused.clear();
    session.history = History(std::move(document));
    session.saved_serial = session.history.serial();
    session.disk = {};
}

Document read_text(const Session& session, std::string text) {
    Diagnostics shown_by_the_build;
    return read_document(std::move(text), session.path.string(), shown_by_the_build);
}

// Renaming a temporary file over a read-only one would succeed, since only the folder's permissions
// apply; this check respects the file's own.
bool is_read_only(const fs::path& path) {
    std::error_code error;
    const fs::path target = link_target(path);
    return fs::is_regular_file(target, error) && access(target.c_str(), W_OK) != 0;
}

// Writes without a prompt. The document is the current one, or becomes it.
bool write_to(Session& session, const fs::path& path, const Document& document) {
    const bool kept = session.dirty() && keep_edits_now(session);
    const std::string text = write_document(document);
    std::string why;
    if (is_read_only(path))
        why = "it is read-only";
    else if (const std::error_code error = write_file_synced(path, text))
        why = disk_words(error);
    if (!why.empty()) {
        session.status = name_of(path) + " was not saved: " + why +
                         (kept ? ". Your edits are kept in the recovery file."
                               : ". Your edits are still here, in memory alone.");
        return false;
    }
    session.disk = DiskCopy::of(path, text);
    session.repeated_exports.start_again(session.tasks.running != nullptr);
    session.status = "Saved " + name_of(path);
    return true;
}

std::string words_on_outside(const std::vector<std::string>& names) {
    if (names.empty()) return {};
    constexpr size_t most = 3;
    std::string text = ". Not below its folder, so not read there: ";
    for (size_t i = 0; i < std::min(names.size(), most); ++i)
        text += (i ? ", " : "") + names[i];
    return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more"
                               : text;
}

}  // namespace

void reset_derived(Session& session, GraphSwitch how) {
    session.images.paths.clear();
    ++session.images.changes;
    session.built = Build();
    session.is_synced = false;
    if (session.on_switch) session.on_switch(how);
}

void new_file(Session& session, const fs::path& folder) {
    close_outer(session);
    begin(session, {}, {});
    reset_derived(session, GraphSwitch::opened);
    std::error_code ignored;
    session.unsaved_folder = real_path(fs::is_directory(folder, ignored) ? folder : fs::path());
    session.status = "New graph";
}

void open_file(Session& session, const fs::path& path) {
    close_outer(session);
    load_file(session, path);
    reset_derived(session, GraphSwitch::opened);
    if (session.disk.stamp.there)
        remember_recent(session.keeping.folders, session.keeping.settings, path);
}

void load_file(Session& session, const fs::path& path) {
    std::string why;
    const Stamp stamp = stamp_of(path);
    const auto bytes = read_file(path, why);
    begin(session, path, {});
    std::error_code ignored;
    if (bytes) {
        session.history = History(read_text(session, *bytes));
        session.save_refused = session.document().lost;
        session.disk = DiskCopy::of(stamp, *bytes);
    } else {
        Document empty;
        empty.file = path.string();
        session.history = History(std::move(empty));
        if (fs::exists(path, ignored)) session.save_refused = path.string() + " " + why;
    }
    session.status = bytes ? "Opened " + path.string() : "New graph " + path.string();
}

bool save_file(Session& session) {
    if (session.path.empty()) {
        session.question = {.kind = Question::Kind::save_as};
        return false;
    }
    if (!session.save_refused.empty()) {
        session.status =
            "Not saved, because the file could not be read whole: " + session.save_refused;
        return false;
    }
    if (compare(session.disk, session.path) == OnDisk::changed) {
        session.question = {.kind = Question::Kind::changed, .saving = true};
        return false;
    }
    if (!write_to(session, session.path, session.document())) {
        session.question = {.kind = Question::Kind::failed, .error_text = session.status};
        return false;
    }
    session.saved_serial = session.history.serial();
    return true;
}

MovedPaths moved_to(const Session& session, const fs::path& path, OutsideFiles files) {
    const Model model =
        make_model(session.document(), session.folder(), *session.registry, session.root());
    return move_paths(session.document(), model, session.folder(), path.parent_path(), files);
}

std::vector<std::string> files_outside(const Session& session, const fs::path& path) {
    return moved_to(session, path, OutsideFiles::referred).outside;
}

bool save_file_as(Session& session, const fs::path& path, OutsideFiles files) {
    MovedPaths moved = moved_to(session, path, files);
    std::string why;
    NewPaths made;
    if (!copy_files(moved.copies, made, why)) {
        session.status = name_of(path) + " was not saved: " + why + ".";
        return false;
    }
    if (!write_to(session, path, moved.document)) return false;
    made.keep();
    const std::string saved =
        session.status + (moved.copies.empty() ? words_on_outside(moved.outside)
                                               : " and copied " + listed(moved.outside));
    session.commit("Name files from " + path.parent_path().string(), std::move(moved.document));
    session.status = saved;
    session.saved_serial = session.history.serial();
    session.recovery_file.remove();  // it refers to the other file
    session.path = path;
    session.save_refused.clear();
    session.is_synced = false;
    remember_recent(session.keeping.folders, session.keeping.settings, path);
    return true;
}

void reload_from_disk(Session& session) {
    std::string why;
    const Stamp stamp = stamp_of(session.path);
    const auto bytes = read_file(session.path, why);
    if (!bytes) {
        session.status = name_of(session.path) + " " + why;
        return;
    }
    session.disk = DiskCopy::of(stamp, *bytes);
    session.commit("Load " + name_of(session.path) + " again", read_text(session, *bytes));
    session.saved_serial = session.history.serial();
    session.save_refused = session.document().lost;
    session.is_synced = false;
    session.status = name_of(session.path) + " was changed by another program and is read again.";
}

void keep_local_version(Session& session) {
    std::string why;
    const Stamp stamp = stamp_of(session.path);
    const auto bytes = read_file(session.path, why);
    session.disk = DiskCopy::of(stamp, bytes.value_or(""));
    session.saved_serial = Session::never_saved;
}

void decide_later(Session& session) {
    session.postponed = stamp_of(session.path);
    session.question = {};
    session.status =
        name_of(session.path) + " was changed by another program; saving prompts again.";
}

void check_disk_changes(Session& session) {
    switch (compare(session.disk, session.path)) {
        case OnDisk::same:
            return;
        case OnDisk::gone:
            session.disk = {};
            session.saved_serial = Session::never_saved;
            session.status = name_of(session.path) + " is no longer there. Save writes it again.";
            return;
        case OnDisk::changed:
            if (!session.dirty()) return reload_from_disk(session);
            if (stamp_of(session.path) == session.postponed) return;
            session.question = {.kind = Question::Kind::changed};
    }
}

}  // namespace wrinkle::editor
