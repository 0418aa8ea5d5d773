// Modal prompts for pending decisions (document/intent.h), and the list of recent files.
#include <imgui.h>

#include <ctime>
#include <vector>

#include "base/file.h"
#include "editor/model/document/files.h"
#include "editor/model/document/levels.h"
#include "editor/model/document/library.h"
#include "editor/model/words.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/panels.h"
#include "editor/view/panels/prompt.h"

namespace wrinkle::editor {
namespace {

void cancel(Session& session) {
    session.question = {};
}

void discard(Session& session) {
    carry_out(session, std::exchange(session.question, {}).then);
}

void take_theirs(Session& session) {
    const PendingAction then = std::exchange(session.question, {}).then;
    reload_from_disk(session);
    save_and_carry_out(session, then);
}

// If the question blocked a save, saves now.
void take_mine(Session& session) {
    keep_local_version(session);
    if (session.question.saving) return answer_save(session);
    session.question = {};
}

const PromptButton cancelled{"Cancel", "answer:cancel", cancel};

// Prompt for the unsaved edits of an editor that ended unexpectedly.
Prompt recovery_prompt(const Session& session) {
    Prompt prompt;
    for (const Recoverable& found : session.keeping.recoverable) {
        if (found.file != session.question.file) continue;
        const std::string file =
            found.graph.empty() ? "a graph without a file" : found.graph.filename().string();
        char when[64] = "";
        const time_t seconds = found.when;
        if (const tm* local = std::localtime(&seconds))
            std::strftime(when, sizeof when, "%H:%M on %d %B", local);
        prompt.title = "Recover unsaved edits of " + file + "?";
        prompt.text = "The editor ended before they were saved. The last one was made at " +
                      std::string(when) + ".";
    }
    prompt.buttons = {{"Recover", "answer:recover", answer_recover},
                      {"Discard", "answer:forget", answer_forget},
                      {"Later", "answer:later", cancel}};
    return prompt;
}

Prompt running_prompt(const Session& session) {
    const Task* task = session.tasks.running.get();
    return {task ? task->order().name + " is not done yet." : "All is done.",
            task ? "To quit stops it. Nothing of it is written." : "",
            {{"Quit", "answer:stop", answer_stop}, {"Continue", "answer:cancel", cancel}}};
}

// Prompt for a graph that is saved to a folder that its files are not below.
Prompt saved_elsewhere_prompt(const Session& session) {
    const std::filesystem::path& file = session.question.file;
    const std::vector<std::string> names = files_outside(session, file);
    const std::string folder = real_path(file.parent_path()).string();
    return {"Copy " + listed_or_counted(names) + " too?",
            "A graph reads files below its own folder only, and these are not below " + folder +
                ". Without a copy there, " + file.filename().string() + " does not find them.",
            {{"Copy and save", "answer:copy", answer_copy},
             {"Save without", "answer:refer", answer_refer},
             cancelled}};
}

Prompt prompt_of(const Session& session) {
    const Question& question = session.question;
    switch (question.kind) {
        case Question::Kind::unsaved:
            return {"Save changes to " + listed(unsaved(session, question.then)) + "?",
                    question.then.kind == PendingAction::Kind::leave
                        ? "The graph around it shows what is saved."
                        : "",
                    {{"Save", "answer:save", answer_save},
                     {"Discard", "answer:discard", discard},
                     cancelled}};
        case Question::Kind::changed:
            return {session.file_name() + " was changed by another program.",
                    "Mine keeps the graph in this window, and saving overwrites the file. Theirs "
                    "loads the file; undo brings yours back. Later prompts again when you save.",
                    {{"Keep mine", "answer:mine", take_mine},
                     {"Load theirs", "answer:theirs", take_theirs},
                     {"Later", "answer:later", decide_later}}};
        case Question::Kind::replace:
            return {question.file.filename().string() + " is there already.",
                    "Its present contents would be lost.",
                    {{"Replace", "answer:replace", answer_replace}, cancelled}};
        case Question::Kind::library:
            return {question.file.filename().string() + " is in the library already.",
                    "The graph there would be lost.",
                    {{"Replace", "answer:library", replace_in_library}, cancelled}};
        case Question::Kind::outside:
            return saved_elsewhere_prompt(session);
        case Question::Kind::recover:
            return recovery_prompt(session);
        case Question::Kind::running:
            return running_prompt(session);
        case Question::Kind::failed:
            return {session.file_name() + " could not be saved.",
                    "",
                    {{"Save as...", "answer:save-as", answer_save_as},
                     {"Try again", "answer:save", answer_save},
                     cancelled}};
        case Question::Kind::none:
        case Question::Kind::open:
        case Question::Kind::save_as:
            break;  // the file browser handles the last two
    }
    return {};
}

}  // namespace

void draw_question(State& state) {
    if (!state.question.open() || state.question.wants_path()) return;
    Prompt prompt = prompt_of(state);
    prompt.error = state.question.error_text;
    draw_prompt(state, "##question", prompt);
}

void draw_recent_files(State& state) {
    const auto recent = state.keeping.settings.recent;
    if (recent.empty()) return;
    ImGui::Separator();
    for (size_t i = 0; i < recent.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const bool chosen = ImGui::MenuItem(recent[i].filename().string().c_str());
        if (ImGui::IsItemHovered()) show_tooltip(beside_window(), recent[i].string());
        name_item(state, "recent:" + std::to_string(i + 1));
        ImGui::PopID();
        if (chosen) request_action(state, {PendingAction::Kind::open, recent[i]});
    }
}

}  // namespace wrinkle::editor
