#include "editor/model/document/used_files.h"

#include <utility>

#include "editor/model/document/plugins.h"
#include "editor/model/images/images.h"
#include "editor/model/session.h"
#include "lower/named_images.h"

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

void read_again(Session& session, const UsedFile& file, bool came_or_went) {
    // The problem of an image appears or disappears with it.
    if (file.use == Use::subgraph || (file.use == Use::image && came_or_went))
        session.is_synced = false;
    const std::string name = file.path.filename().string();
    if (file.use != Use::plugin)  // plugins are reloaded together
        session.status = file.stamp.there ? name + " was changed and is read again."
                                          : name + " is no longer there.";
}

std::vector<UsedFile> take(Session& session, const std::vector<UsedFile>& files,
                           const WindowFiles& window) {
    UsedFiles& used = session.used;
    std::map<fs::path, UsedFiles::Known> known;
    std::vector<UsedFile> changed;
    bool plugins = false;
    for (const UsedFile& file : files) {
        const auto former = used.known.find(file.path);
        if (former == used.known.end() || known.contains(file.path)) {
            known.try_emplace(file.path, UsedFiles::Known{file.stamp, file.stamp});
            continue;
        }
        UsedFiles::Known& now = known[file.path] = former->second;
        const bool was_there = now.read.there;
        if (!has_changed(now, file)) continue;
        ++used.changes;
        changed.push_back(file);
        plugins |= file.use == Use::plugin;
        read_again(session, file, was_there != file.stamp.there);
    }
    used.known = std::move(known);
    follow_images(session, files, window.dropped);
    if (plugins) reload_plugins(session);
    return changed;
}

FileQuestion question_of(const Session& session, const WindowFiles& window) {
    return {session.model, session.document(), window.mesh, window.light, session.plugins.places};
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

std::vector<UsedFile> follow_files(Session& session, const WindowFiles& window) {
    UsedFiles& used = session.used;
    std::vector<UsedFile> changed;
    if (used.looker)
        if (const auto files = used.looker->take()) changed = take(session, *files, window);
    const double now = seconds_now();
    const bool other = used.checked_project != session.model.project;
    if (!session.is_synced || (now - used.checked_at < 1 && !other)) return changed;
    if (used.looker && !used.looker->idle()) return changed;
    used.checked_at = now;
    used.checked_project = session.model.project;
    if (!used.looker) return take(session, look_at_files(question_of(session, window)), window);
    used.looker->post(question_of(session, window));
    return changed;
}

}  // namespace wrinkle::editor
