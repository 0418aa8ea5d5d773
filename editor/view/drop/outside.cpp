// Prompt for images outside the graph's folder, and its answers.
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "base/file.h"
#include "editor/model/document/folders.h"
#include "editor/model/words.h"
#include "editor/view/drop/drop.h"
#include "editor/view/panels/prompt.h"
#include "lower/named_images.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;

fs::path image_folder(const Session& session) {
    std::error_code ignored;
    const fs::path textures = session.folder() / "textures";
    return fs::is_directory(textures, ignored) ? textures : session.folder();
}

namespace {

// Copies the file under a name that no other file has; returns "" on failure.
std::string copied(Session& session, const fs::path& file) {
    const fs::path folder = image_folder(session);
    fs::path to = folder / file.filename();
    std::error_code error, ignored;
    for (int i = 2; fs::exists(to, ignored); ++i)
        to = folder / (file.stem().string() + std::to_string(i) + file.extension().string());
    if (fs::copy_file(file, to, error)) return to.string();
    session.status = file.filename().string() + " was not copied: " + disk_words(error) + ".";
    return {};
}

// Adds the files after the answer; files that are still outside could not be copied.
void add_answered(State& state, const FileDrop& drop, const std::vector<std::string>& files) {
    if (!state.dropped.by_name) return add_images(state, drop, files);
    const DropState to = state.dropped;
    for (const std::string& file : files)
        use_image(state, to.node, to.port, file);
}

void copy_outside(State& state) {
    const FileDrop drop = std::exchange(state.dropped.outside, {});
    std::vector<std::string> files;
    for (const std::string& file : drop.files) {
        const std::string place = path_in_graph(state, file).empty() ? copied(state, file) : file;
        if (!place.empty()) files.push_back(place);
    }
    add_answered(state, drop, files);
}

bool names_files(const Session& session) {
    const Project project = project_with(session.model, session.document());
    const Document& top = project.top();
    return !named_images(project, *session.model.types, 0).empty() ||
           std::ranges::any_of(top.nodes,
                               [](const NodePtr& node) { return node->subgraph().has_value(); });
}

// Returns the nearest folder that contains all of the files if the graph may adopt it and it is not
// the root folder; otherwise "".
fs::path folder_to_have(const Session& session, const std::vector<std::string>& files) {
    if (!session.path.empty() || files.empty() || names_files(session)) return {};
    fs::path folder = real_path(files.front()).parent_path();
    for (const std::string& file : files)
        while (folder.has_relative_path() && !inside(folder, file))
            folder = folder.parent_path();
    return folder.has_relative_path() ? folder : fs::path();
}

void have_folder(Session& session, const fs::path& folder) {
    session.unsaved_folder = folder;
    session.recovery_file.remove();  // it refers to the other folder
    session.is_synced = false;
}

void link_outside(State& state, const fs::path& folder) {
    const FileDrop drop = std::exchange(state.dropped.outside, {});
    have_folder(state, folder);
    add_answered(state, drop, drop.files);
}

bool may_write(const fs::path& folder) {
    return access(folder.c_str(), W_OK) == 0;
}

Prompt outside_prompt(const State& state, const fs::path& copies, const fs::path& theirs) {
    std::vector<std::string> names;
    for (const std::string& file : state.dropped.outside.files)
        if (path_in_graph(state, file).empty()) names.push_back(fs::path(file).filename().string());
    const bool many = names.size() > 1, copyable = may_write(copies);
    Prompt prompt;
    prompt.title = copyable         ? "Copy " + listed_or_counted(names) + "?"
                   : theirs.empty() ? listed_or_counted(names) + " cannot be used."
                                    : "Link " + listed_or_counted(names) + "?";
    prompt.text = "A graph reads files below its own folder only, and " +
                  std::string(many ? "these are" : "this one is") + " not below " +
                  state.folder().string() + ". ";
    prompt.text += copyable
                       ? "A copy goes into " + copies.string() + "."
                       : "Nothing can be copied into " + copies.string() + ", which is read-only.";
    if (!theirs.empty())
        prompt.text += " To link " + std::string(many ? "them" : "it") +
                       ", this unsaved graph gets " + theirs.string() +
                       " as its folder: it is proposed when you save.";
    if (copyable) prompt.buttons.push_back({"Copy", "copy:yes", copy_outside});
    if (!theirs.empty())
        prompt.buttons.push_back(
            {"Link", "copy:refer", [theirs](State& s) { link_outside(s, theirs); }});
    prompt.buttons.push_back({"Cancel", "copy:no", [](State& s) { s.dropped.outside = {}; }});
    return prompt;
}

}  // namespace

// Draws the prompt that offers to copy outside files into the graph's folder, or to make their
// folder the graph's.
void draw_copy_question(State& state) {
    const FileDrop& outside = state.dropped.outside;
    if (outside.files.empty()) return;
    const fs::path theirs = folder_to_have(state, outside.files);
    draw_prompt(state, "##copy", outside_prompt(state, image_folder(state), theirs));
}

}  // namespace wrinkle::editor
