// Requested actions that would close the current graph. They wait until the user has decided about
// unsaved work.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace wrinkle {
struct Document;
}

namespace wrinkle::editor {

struct Session;

struct PendingAction {
    enum class Kind : uint8_t { nothing, quit, new_graph, open, recover, leave, import };
    Kind kind = Kind::nothing;
    std::filesystem::path file;  // for open; for recover, the recovery file; for import, the folder
    size_t depth = 0;            // for leave: index in Session::parent_graphs of the target
    std::shared_ptr<const Document> document = {};  // for import
};

// Modal prompt that the user must answer first (panels/questions.cpp draws it).
struct Question {
    enum class Kind : uint8_t {
        none,
        unsaved,  // save changes?
        changed,  // the file on disk was changed by another program
        replace,  // save as would overwrite `file`
        outside,  // files that the graph names are not below the folder of `file`: copy them?
        recover,  // recover the edits in the recovery file `file`?
        running,  // stop the running task and quit?
        failed,   // the file could not be written (`error_text`): use another name?
        open,     // which file? The file browser (panels/browser.h) draws this and the next
        save_as,  // under which name?
        library,  // replace the entry in the library (document/library.h)?
    };
    Kind kind = Kind::none;
    PendingAction then = {};      // action after everything is saved
    bool saving = false;          // for changed: it blocks a save
    std::string text = {};        // for open and save_as: the path as typed
    std::string error_text = {};  // why the last answer failed
    std::filesystem::path file = {};

    bool open() const { return kind != Kind::none; }
    bool wants_path() const { return kind == Kind::open || kind == Kind::save_as; }
};

// Carries out the action, or prompts for unsaved work first.
void request_action(Session& session, const PendingAction& intent);
// Saves the unsaved graphs that the action closes, the innermost first, then carries it out.
void save_and_carry_out(Session& session, const PendingAction& intent);
// Carries out the action; before quitting, prompts if a background task is running.
void carry_out(Session& session, const PendingAction& intent);

// Answers to the question. If an answer fails, the question remains open with the reason in
// `error_text`.
void answer_save(Session& session);
void answer_path(Session& session);     // for open and save_as: `text`
void answer_save_as(Session& session);  // prompts for a path instead, after a failed write
void answer_replace(Session& session);  // overwrites `file`
void answer_copy(Session& session);     // for outside: saves, and copies the files
void answer_refer(Session& session);    // for outside: saves, and refers to the files
void answer_stop(Session& session);     // for running: cancels the task; quits when it ends
void answer_recover(Session& session);  // opens the recovered edits
void answer_forget(Session& session);   // discards the recovered edits

}  // namespace wrinkle::editor
