#include "editor/model/document/used_files.h"

#include <algorithm>
#include <utility>

#include "editor/model/document/plugins.h"
#include "editor/model/images/images.h"
#include "editor/view/preview/feed.h"
#include "editor/view/state.h"
#include "lower/named_images.h"
#include "mesh/shapes.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

void add(std::vector<UsedFile>& files, Use use, const fs::path& path,
         const std::string& name = {}) {
    files.push_back({use, path, stamp_of(path), name});
}

// The modification date of a folder changes when a file is added or removed.
void add_plugins(const fs::path& place, std::vector<UsedFile>& files) {
    std::error_code error;
    add(files, Use::plugin, place);
    for (fs::directory_iterator entry(place, error); !error && entry != fs::directory_iterator();
         entry.increment(error))
        if (entry->path().extension() == ".so") add(files, Use::plugin, entry->path());
}

// Returns true if the file must be read again.
bool has_changed(UsedFiles::Known& known, const UsedFile& file) {
    const Stamp before = std::exchange(known.last, file.stamp);
    if (file.stamp == known.read) return false;
    const bool waits = !file.stamp.there || file.use == Use::plugin;
    if (waits ? before != file.stamp : file.stamp.size == 0) return false;
    known.read = file.stamp;
    return true;
}

void read_again(State& state, const UsedFile& file, bool came_or_went) {
    switch (file.use) {
        case Use::image:
            state.thumbnails.forget(file.path);
            forget_images(state);
            if (came_or_went) state.fresh = false;  // its problem appears or disappears
            break;
        case Use::subgraph:
            state.fresh = false;
            break;
        case Use::mesh:
            if (state.preview) state.preview->forget_mesh();
            break;
        case Use::light:
            if (state.preview) state.preview->forget_light();
            break;
        case Use::plugin:
            break;  // reloaded together
    }
    const std::string name = file.path.filename().string();
    if (file.use != Use::plugin)
        state.status = file.stamp.there ? name + " was changed and is read again."
                                        : name + " is no longer there.";
}

bool take(State& state, const std::vector<UsedFile>& files) {
    UsedFiles& used = state.used;
    std::map<fs::path, UsedFiles::Known> known;
    bool plugins = false, any = false;
    for (const UsedFile& file : files) {
        const auto former = used.known.find(file.path);
        if (former == used.known.end() || known.contains(file.path)) {
            known.try_emplace(file.path, UsedFiles::Known{file.stamp, file.stamp});
            continue;
        }
        UsedFiles::Known& now = known[file.path] = former->second;
        const bool was_there = now.read.there;
        if (!has_changed(now, file)) continue;
        any = true;
        ++used.changes;
        plugins |= file.use == Use::plugin;
        read_again(state, file, was_there != file.stamp.there);
    }
    used.known = std::move(known);
    follow_images(state, files);
    if (plugins) reload_plugins(state);
    return any;
}

FileQuestion question_of(const State& state) {
    const PreviewView& view = state.view.preview_view;
    const bool shape = std::any_of(shapes().begin(), shapes().end(),
                                   [&](const Shape& each) { return each.name == view.mesh; });
    return {state.model, state.document(), shape ? "" : view.mesh, view.environment,
            state.plugins.places};
}

}  // namespace

std::vector<UsedFile> look_at_files(const FileQuestion& question) {
    std::vector<UsedFile> files;
    const Project project = project_with(question.model, question.document);
    const bool same = project.files[0].document.nodes.size() ==
                      question.model.project->files[0].document.nodes.size();
    for (size_t i = 0; i < project.files.size(); ++i) {
        if (i > 0) add(files, Use::subgraph, project.files[i].path);
        if (i == 0 && !same) continue;
        for (const NamedImage& image : named_images(project, *question.model.types, i))
            if (image.path) add(files, Use::image, *image.path, i == 0 ? image.name : "");
    }
    if (!question.mesh.empty()) add(files, Use::mesh, question.mesh);
    if (!question.light.empty()) add(files, Use::light, question.light);
    for (const std::string& place : question.plugins)
        add_plugins(place, files);
    return files;
}

bool follow_files(State& state) {
    UsedFiles& used = state.used;
    bool any = false;
    if (used.looker)
        if (const auto files = used.looker->take()) any = take(state, *files);
    const double now = seconds_now();
    const bool other = used.looked_of != state.model.project;
    if (!state.fresh || (now - used.looked < 1 && !other)) return any;
    if (used.looker && used.looker->busy()) return any;
    used.looked = now;
    used.looked_of = state.model.project;
    if (!used.looker) return take(state, look_at_files(question_of(state))) || any;
    used.looker->post(question_of(state));
    return any;
}

}  // namespace wrinkle::editor
