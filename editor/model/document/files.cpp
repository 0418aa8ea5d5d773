#include "editor/model/document/files.h"

#include <imgui.h>
#include <unistd.h>

#include <algorithm>

#include "base/file.h"
#include "editor/model/document/levels.h"
#include "editor/model/document/recovery.h"
#include "editor/model/document/words.h"
#include "graph/read.h"
#include "graph/write.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

std::string name_of(const fs::path& path) {
    return path.filename().string();
}

void begin(State& state, const fs::path& path, Document document) {
    state.keeping.journal.drop();  // saved or discarded
    state.path = path;
    state.save_refused.clear();
    state.history = History(std::move(document));
    state.saved_serial = state.history.serial();
    state.view = {};
    state.keeping.disk = {};
    reset_interaction(state);
}

Document read_text(const State& state, std::string text) {
    Diagnostics shown_by_the_build;
    return read_document(std::move(text), state.path.string(), shown_by_the_build);
}

// Renaming a temporary file over a read-only one would succeed, since only the folder's permissions
// apply; this check respects the file's own.
bool is_read_only(const fs::path& path) {
    std::error_code error;
    const fs::path target = link_target(path);
    return fs::is_regular_file(target, error) && access(target.c_str(), W_OK) != 0;
}

// Writes without a prompt. The document is the current one, or becomes it.
bool write_to(State& state, const fs::path& path, const Document& document) {
    const bool kept = state.dirty() && keep_edits_now(state);
    const std::string text = write_document(document);
    std::string why;
    if (is_read_only(path))
        why = "it is read-only";
    else if (const std::error_code error = write_file_synced(path, text))
        why = disk_words(error);
    if (!why.empty()) {
        state.status = name_of(path) + " was not saved: " + why +
                       (kept ? ". Your edits are kept in the recovery file."
                             : ". Your edits are still here, in memory alone.");
        return false;
    }
    state.keeping.disk = DiskCopy::of(path, text);
    state.status = "Saved " + name_of(path);
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

MovedPaths moved_to(const State& state, const fs::path& path, OutsideFiles files) {
    const Model model = make_model(state.document(), state.folder(), *state.registry, state.root());
    return move_paths(state.document(), model, state.folder(), path.parent_path(), files);
}

void keep_settings(State& state) {
    Persistence& keeping = state.keeping;
    keeping.settings.side = state.panes.side;
    keeping.settings.preview = state.panes.preview;
    keeping.settings.problems = state.panes.problems;
    keeping.settings.theme = state.look.theme == Theme::light ? "light" : "dark";
    keeping.settings.scale = state.look.scale;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    if (size.x >= 1 && size.y >= 1) {
        keeping.settings.width = static_cast<int>(size.x * state.look.scale);
        keeping.settings.height = static_cast<int>(size.y * state.look.scale);
    }
    if (keeping.settings == keeping.written || ImGui::IsAnyMouseDown()) return;
    const std::string why = write_settings(keeping.folders, keeping.settings);
    if (!why.empty() && why != keeping.unsettled)
        state.status = "The settings were not saved: " + why + ".";
    keeping.unsettled = why;
    keeping.written = keeping.settings;
}

}  // namespace

void reset_interaction(State& state) {
    state.gesture = {};
    state.palette = {};
    state.popup = {};
    state.offer = {};
    state.box_text = {};
    state.dropped.waiting.clear();
    state.images.paths.clear();
    ++state.images.changes;
    if (state.preview) state.preview->forget_material();
    state.node_feed.forget();
    state.built = Build();
    state.preview_problems = Diagnostics();
    state.fresh = false;
}

void new_file(State& state, const fs::path& folder) {
    close_outer(state);
    begin(state, {}, {});
    std::error_code ignored;
    state.unsaved_folder = real_path(fs::is_directory(folder, ignored) ? folder : fs::path());
    state.status = "New graph";
}

void open_file(State& state, const fs::path& path) {
    close_outer(state);
    load_file(state, path);
    if (state.keeping.disk.stamp.there)
        remember_recent(state.keeping.folders, state.keeping.settings, path);
}

void load_file(State& state, const fs::path& path) {
    std::string why;
    const auto bytes = read_file(path, why);
    begin(state, path, {});
    std::error_code ignored;
    if (bytes) {
        state.history = History(read_text(state, *bytes));
        state.save_refused = state.document().lost;
        state.keeping.disk = DiskCopy::of(path, *bytes);
    } else {
        Document empty;
        empty.file = path.string();
        state.history = History(std::move(empty));
        if (fs::exists(path, ignored)) state.save_refused = path.string() + " " + why;
    }
    state.status = bytes ? "Opened " + path.string() : "New graph " + path.string();
}

bool save_file(State& state) {
    if (state.path.empty()) {
        state.question = {.kind = Question::Kind::save_as};
        return false;
    }
    if (!state.save_refused.empty()) {
        state.status = "Not saved, because the file could not be read whole: " + state.save_refused;
        return false;
    }
    if (compare(state.keeping.disk, state.path) == OnDisk::changed) {
        state.question = {.kind = Question::Kind::changed, .saving = true};
        return false;
    }
    if (!write_to(state, state.path, state.document())) {
        state.question = {.kind = Question::Kind::failed, .trouble = state.status};
        return false;
    }
    state.saved_serial = state.history.serial();
    return true;
}

std::vector<std::string> files_outside(const State& state, const fs::path& path) {
    return moved_to(state, path, OutsideFiles::referred).outside;
}

bool save_file_as(State& state, const fs::path& path, OutsideFiles files) {
    MovedPaths moved = moved_to(state, path, files);
    std::string why;
    NewCopies copies;
    if (!copies.make(moved.copies, why)) {
        state.status = name_of(path) + " was not saved: " + why + ".";
        return false;
    }
    if (!write_to(state, path, moved.document)) return false;
    copies.keep();
    const std::string saved =
        state.status + (moved.copies.empty() ? words_on_outside(moved.outside)
                                             : " and copied " + listed(moved.outside));
    state.commit("Name files from " + path.parent_path().string(), std::move(moved.document));
    state.status = saved;
    state.saved_serial = state.history.serial();
    state.keeping.journal.drop();  // it refers to the other file
    state.path = path;
    state.save_refused.clear();
    state.fresh = false;
    remember_recent(state.keeping.folders, state.keeping.settings, path);
    return true;
}

void reload_from_disk(State& state) {
    std::string why;
    const auto bytes = read_file(state.path, why);
    if (!bytes) {
        state.status = name_of(state.path) + " " + why;
        return;
    }
    state.keeping.disk = DiskCopy::of(state.path, *bytes);
    state.commit("Load " + name_of(state.path) + " again", read_text(state, *bytes));
    state.saved_serial = state.history.serial();
    state.save_refused = state.document().lost;
    state.fresh = false;
    state.status = name_of(state.path) + " was changed by another program and is read again.";
}

void keep_local_version(State& state) {
    std::string why;
    const auto bytes = read_file(state.path, why);
    state.keeping.disk = DiskCopy::of(state.path, bytes.value_or(""));
    state.saved_serial = State::never_saved;
}

void check_disk_changes(State& state) {
    switch (compare(state.keeping.disk, state.path)) {
        case OnDisk::same:
            return;
        case OnDisk::gone:
            state.keeping.disk = {};
            state.saved_serial = State::never_saved;
            state.status = name_of(state.path) + " is no longer there. Save writes it again.";
            return;
        case OnDisk::changed:
            if (!state.dirty()) return reload_from_disk(state);
            state.question = {.kind = Question::Kind::changed};
    }
}

bool tend(State& state) {
    keep_edits(state);
    const bool read = follow_files(state);
    const double now = seconds_now();
    if (now - state.keeping.looked < 1) return read;
    state.keeping.looked = now;
    state.keeping.try_again = true;
    state.keeping.journal.sync();
    for (Level& level : state.outer)
        level.journal.sync();
    keep_settings(state);
    const bool busy = state.gesture.kind != Gesture::Kind::none || state.question.open() ||
                      state.popup.kind != Popup::Kind::none;
    const std::string status = state.status;
    if (!busy && !state.path.empty()) check_disk_changes(state);
    return read || state.question.open() || state.status != status;
}

void use_settings(State& state, const Settings& settings) {
    state.keeping.settings = state.keeping.written = settings;
    state.panes.side = settings.side;
    state.panes.preview = settings.preview;
    state.panes.problems = settings.problems;
    state.look.theme = settings.theme == "light" ? Theme::light : Theme::dark;
    for (const float scale : interface_scales)
        if (scale <= settings.scale) state.look.scale = scale;
}

void finish(State& state) {
    state.keeping.journal.drop();
    close_outer(state);
    keep_settings(state);
}

}  // namespace wrinkle::editor
