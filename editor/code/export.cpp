#include "editor/code/export.h"

#include "base/file.h"
#include "base/text.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;

bool export_code(State& state, const fs::path& file) {
    const CodeText text = make_code(
        {state.model, state.document(), identifier(state.path.stem().string()), state.code.options},
        *state.registry);
    const std::string name = file.filename().string();
    if (!text.problem.empty()) {
        state.status = name + " was not written, because the graph has errors. " + text.problem;
        return false;
    }
    std::vector<FileBytes> files{{file, text.source}};
    if (state.code.options.form == Form::shader)
        files = {{file.string() + ".vert", text.vertex}, {file.string() + ".frag", text.fragment}};
    std::string why;
    if (!write_files(files, why)) {
        state.status = name + " was not written: " + why;
        return false;
    }
    state.status =
        files.size() == 1 ? "Wrote " + file.string() : "Wrote " + file.string() + ".vert and .frag";
    return true;
}

fs::path usual_export(const State& state) {
    const std::string stem = state.path.stem().string();
    return state.folder() / (state.code.options.form == Form::shader ? stem : stem + ".glsl");
}

}  // namespace wrinkle::editor
