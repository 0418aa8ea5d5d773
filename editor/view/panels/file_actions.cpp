#include "editor/view/panels/file_actions.h"

#include "editor/model/document/files.h"
#include "editor/model/document/intent.h"

namespace wrinkle::editor {

void open_chosen(State& state, const std::filesystem::path& file) {
    state.question = {.kind = Question::Kind::open, .text = file.string()};
    answer_path(state);
}

void save_chosen(State& state, const std::filesystem::path& file) {
    state.question = {
        .kind = Question::Kind::save_as, .then = state.browser.then, .text = file.string()};
    answer_path(state);
}

}  // namespace wrinkle::editor
