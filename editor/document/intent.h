// What is asked for and would put the present graph away. It waits until unsaved work has been
// decided about.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace wrinkle::editor {

struct State;

struct Intent {
    enum class Kind : uint8_t { nothing, quit, new_graph, open, recover, leave };
    Kind kind = Kind::nothing;
    std::filesystem::path file;  // of open; of recover the journal
    size_t depth = 0;            // of leave: which of State::outer shall be on the canvas
};

// Something that the user must decide before anything else is done (panels/questions.h draws it).
struct Question {
    enum class Kind : uint8_t {
        none,
        unsaved,  // save changes?
        changed,  // the file on the disk is another one
        replace,  // save as would write over `file`
        outside,  // files that the graph names are not below the folder of `file`: copy them?
        recover,  // the edits in the journal `file`?
        running,  // stop what runs in the background, to quit?
        failed,   // the file could not be written (`trouble`): another name?
        open,     // which file? This and the next are asked by the file browser (panels/browser.h)
        save_as,  // under which name?
    };
    Kind kind = Kind::none;
    Intent then = {};          // what follows once all is saved
    bool saving = false;       // of changed: it is in the way of saving
    std::string text = {};     // of open and save_as: the path as typed
    std::string trouble = {};  // why the last answer could not be followed
    std::filesystem::path file = {};
    bool opening = true;  // drawn for the first time, or again after an answer in vain

    bool open() const { return kind != Kind::none; }
    bool wants_path() const { return kind == Kind::open || kind == Kind::save_as; }
};

// Does it, or asks about unsaved work first.
void intend(State& state, const Intent& intent);
// Saves what is unsaved of what it puts away, from the innermost graph on, and does it.
void save_and_carry_out(State& state, const Intent& intent);
// Does it; quitting asks before it stops what runs in the background.
void carry_out(State& state, const Intent& intent);

// The answers. One that fails leaves the question open and says why in it.
void answer_save(State& state);
void answer_path(State& state);     // of open and save_as: `text`
void answer_save_as(State& state);  // under another name than the one that failed
void answer_replace(State& state);
void answer_copy(State& state);   // of outside: the files go along
void answer_refer(State& state);  // of outside: they stay
void answer_stop(State& state);
void answer_recover(State& state);
void answer_forget(State& state);

}  // namespace wrinkle::editor
