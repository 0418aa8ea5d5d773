#include "editor/model/document/intent.h"

#include "editor/model/document/files.h"
#include "editor/model/document/levels.h"
#include "editor/model/document/recovery.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

// Resolves a relative path against the graph's folder.
fs::path typed_path(const State& state) {
    const fs::path typed = state.question.text;
    return typed.is_absolute() ? typed : state.folder() / typed;
}

void done(State& state) {
    const PendingAction then = state.question.then;
    state.question = {};
    save_and_carry_out(state, then);
}

// Prompts again after a failed save, unless another question is open.
void ask_again(State& state, const PendingAction& then) {
    if (!state.question.open())
        state.question = {.kind = Question::Kind::unsaved, .trouble = state.status};
    state.question.then = then;
}

void answer_open(State& state) {
    const fs::path path = typed_path(state);
    std::error_code error;
    if (!fs::exists(path, error)) {
        state.question.trouble = "There is no file " + path.string() + ".";
    } else if (fs::is_directory(path, error)) {
        state.question.trouble = path.string() + " is a folder.";
    } else {
        state.question = {};
        request_action(state, {PendingAction::Kind::open, path});
    }
}

void write_as(State& state, const fs::path& path, OutsideFiles files) {
    if (save_file_as(state, path, files)) return done(state);
    state.question.kind = Question::Kind::save_as;
    state.question.trouble = state.status;
}

// Prompts first for files that the graph could no longer read.
void begin_write_as(State& state, const fs::path& path) {
    if (files_outside(state, path).empty()) return write_as(state, path, OutsideFiles::referred);
    state.question.kind = Question::Kind::outside;
    state.question.file = path;
}

void answer_name(State& state) {
    fs::path path = typed_path(state);
    if (path.extension().empty()) path += ".json";
    std::error_code error;
    const bool there = fs::exists(path, error), itself = there && is_same_file(path, state.path);
    if (fs::is_directory(path, error)) {
        state.question.trouble = path.string() + " is a folder.";
    } else if (itself && !state.save_refused.empty()) {
        state.question.trouble =
            state.file_name() + " could not be read whole and is kept. Choose another name.";
    } else if (there && !itself) {
        state.question.kind = Question::Kind::replace;
        state.question.file = path;
    } else {
        begin_write_as(state, path);
    }
}

}  // namespace

void carry_out(State& state, const PendingAction& intent) {
    switch (intent.kind) {
        case PendingAction::Kind::nothing:
            return;
        case PendingAction::Kind::quit:
            state.quit = !state.tasks.running;
            if (!state.quit) state.question = {.kind = Question::Kind::running, .then = intent};
            return;
        case PendingAction::Kind::new_graph:
            return new_file(state);
        case PendingAction::Kind::open:
            open_file(state, intent.file);
            look_for_recoverable(state);
            return offer_recovery(state);
        case PendingAction::Kind::recover:
            state.question = {.kind = Question::Kind::recover, .file = intent.file};
            return;
        case PendingAction::Kind::leave:
            return leave_subgraphs(state, intent.depth);
    }
}

void request_action(State& state, const PendingAction& intent) {
    if (unsaved(state, intent).empty()) return carry_out(state, intent);
    state.question = {.kind = Question::Kind::unsaved, .then = intent};
}

void answer_save(State& state) {
    const PendingAction then = state.question.then;
    state.question = {};
    if (state.dirty() && !save_file(state)) return ask_again(state, then);
    save_and_carry_out(state, then);
}

void save_and_carry_out(State& state, const PendingAction& intent) {
    while (!unsaved(state, intent).empty()) {
        if (!state.dirty())
            leave_subgraphs(state, state.outer.size() - 1);
        else if (!save_file(state))
            return ask_again(state, intent);
    }
    carry_out(state, intent);
}

void answer_save_as(State& state) {
    state.question.kind = Question::Kind::save_as;
    state.question.trouble.clear();
}

void answer_path(State& state) {
    state.question.trouble.clear();
    state.question.opening = true;
    if (state.question.text.empty())
        state.question.trouble = "Type the name of a file.";
    else if (state.question.kind == Question::Kind::open)
        answer_open(state);
    else
        answer_name(state);
}

void answer_recover(State& state) {
    const fs::path journal = state.question.file;
    state.question = {};
    for (const Recoverable& found : state.keeping.recoverable)
        if (found.journal == journal) return recover(state, found);
}

void answer_forget(State& state) {
    const fs::path journal = state.question.file;
    state.question = {};
    for (const Recoverable& found : state.keeping.recoverable)
        if (found.journal == journal) return forget(state, found);
}

void answer_stop(State& state) {
    state.question = {};
    cancel_task(state);
    state.quit = true;  // takes effect when the task has ended
}

void answer_replace(State& state) {
    begin_write_as(state, fs::path(state.question.file));
}

void answer_copy(State& state) {
    write_as(state, fs::path(state.question.file), OutsideFiles::copied);
}

void answer_refer(State& state) {
    write_as(state, fs::path(state.question.file), OutsideFiles::referred);
}

}  // namespace wrinkle::editor
