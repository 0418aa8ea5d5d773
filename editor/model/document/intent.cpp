#include "editor/model/document/intent.h"

#include "editor/model/document/files.h"
#include "editor/model/document/levels.h"
#include "editor/model/document/recovery.h"
#include "editor/model/document/texture_import.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

// Resolves a relative path against the graph's folder.
fs::path typed_path(const Session& session) {
    const fs::path typed = session.question.text;
    return typed.is_absolute() ? typed : session.folder() / typed;
}

void done(Session& session) {
    const PendingAction then = session.question.then;
    session.question = {};
    save_and_carry_out(session, then);
}

// Prompts again after a failed save, unless another question is open.
void ask_again(Session& session, const PendingAction& then) {
    if (!session.question.open())
        session.question = {.kind = Question::Kind::unsaved, .error_text = session.status};
    session.question.then = then;
}

void answer_open(Session& session) {
    const fs::path path = typed_path(session);
    std::error_code error;
    if (!fs::exists(path, error)) {
        session.question.error_text = "There is no file " + path.string() + ".";
    } else if (fs::is_directory(path, error)) {
        session.question.error_text = path.string() + " is a folder.";
    } else {
        session.question = {};
        request_action(session, {PendingAction::Kind::open, path});
    }
}

void write_as(Session& session, const fs::path& path, OutsideFiles files) {
    if (save_file_as(session, path, files)) return done(session);
    session.question.kind = Question::Kind::save_as;
    session.question.error_text = session.status;
}

// Prompts first for files that the graph could no longer read.
void begin_write_as(Session& session, const fs::path& path) {
    if (files_outside(session, path).empty())
        return write_as(session, path, OutsideFiles::referred);
    session.question.kind = Question::Kind::outside;
    session.question.file = path;
}

void answer_name(Session& session) {
    fs::path path = typed_path(session);
    if (path.extension().empty()) path += ".json";
    std::error_code error;
    const bool there = fs::exists(path, error), itself = there && is_same_file(path, session.path);
    if (fs::is_directory(path, error)) {
        session.question.error_text = path.string() + " is a folder.";
    } else if (itself && !session.save_refused.empty()) {
        session.question.error_text =
            session.file_name() + " could not be read whole and is kept. Choose another name.";
    } else if (there && !itself) {
        session.question.kind = Question::Kind::replace;
        session.question.file = path;
    } else {
        begin_write_as(session, path);
    }
}

void answer_with(Session& session, void (*act)(Session&, const Recoverable&)) {
    const fs::path file = session.question.file;
    session.question = {};
    for (const Recoverable& found : session.keeping.recoverable)
        if (found.file == file) return act(session, found);
}

}  // namespace

void carry_out(Session& session, const PendingAction& intent) {
    switch (intent.kind) {
        case PendingAction::Kind::nothing:
            return;
        case PendingAction::Kind::quit:
            session.quit = !session.tasks.running;
            if (!session.quit) session.question = {.kind = Question::Kind::running, .then = intent};
            return;
        case PendingAction::Kind::new_graph:
            return new_file(session);
        case PendingAction::Kind::open:
            open_file(session, intent.file);
            look_for_recoverable(session);
            return offer_recovery(session);
        case PendingAction::Kind::recover:
            session.question = {.kind = Question::Kind::recover, .file = intent.file};
            return;
        case PendingAction::Kind::leave:
            return leave_subgraphs(session, intent.depth);
        case PendingAction::Kind::import:
            return open_imported(session, intent);
    }
}

void request_action(Session& session, const PendingAction& intent) {
    if (unsaved(session, intent).empty()) return carry_out(session, intent);
    session.question = {.kind = Question::Kind::unsaved, .then = intent};
}

void answer_save(Session& session) {
    const PendingAction then = session.question.then;
    session.question = {};
    if (session.dirty() && !save_file(session)) return ask_again(session, then);
    save_and_carry_out(session, then);
}

void save_and_carry_out(Session& session, const PendingAction& intent) {
    while (!unsaved(session, intent).empty()) {
        if (!session.dirty())
            leave_subgraphs(session, session.parent_graphs.size() - 1);
        else if (!save_file(session))
            return ask_again(session, intent);
    }
    carry_out(session, intent);
}

void answer_save_as(Session& session) {
    session.question.kind = Question::Kind::save_as;
    session.question.error_text.clear();
}

void answer_path(Session& session) {
    session.question.error_text.clear();
    if (session.question.text.empty())
        session.question.error_text = "Type the name of a file.";
    else if (session.question.kind == Question::Kind::open)
        answer_open(session);
    else
        answer_name(session);
}

void answer_recover(Session& session) {
    answer_with(session, recover);
}

void answer_forget(Session& session) {
    answer_with(session, forget);
}

void answer_stop(Session& session) {
    session.question = {};
    cancel_task(session);
    session.quit = true;  // takes effect when the task has ended
}

void answer_replace(Session& session) {
    begin_write_as(session, fs::path(session.question.file));
}

void answer_copy(Session& session) {
    write_as(session, fs::path(session.question.file), OutsideFiles::copied);
}

void answer_refer(Session& session) {
    write_as(session, fs::path(session.question.file), OutsideFiles::referred);
}

}  // namespace wrinkle::editor
