#include "editor/model/document/texture_import.h"

#include "base/file.h"
#include "editor/model/document/files.h"
#include "import/material_graph.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

// Shared by the thread of the task and that of the interface, one after the other.
struct ReadFolder {
    fs::path folder;
    Document document;
    Diagnostics problems;
};

std::string first_error(const Diagnostics& problems) {
    for (const Diagnostic& each : problems.list())
        if (each.severity == Severity::error)
            return (each.where.file.empty()
                        ? ""
                        : fs::path(each.where.file).filename().string() + ": ") +
                   each.message + (each.expected.empty() ? "" : " (" + each.expected + ")");
    return "it was cancelled";
}

TaskOutcome read_folder(ReadFolder& read, TaskProgress& progress) {
    const std::string name = read.folder.filename().string();
    auto set = textures::find_textures({read.folder}, read.problems);
    textures::ExamineOptions options;
    options.stopped = [&progress] { return progress.cancelled.load(); };
    if (!set || !examine_textures(*set, options, read.problems))
        return {false, "No graph was made of " + name + ". " + first_error(read.problems) + "."};
    textures::GraphOptions graph;
    graph.folder = read.folder;
    for (const auto& texture : set->channels)
        if (texture && !inside(read.folder, texture->file))
            return {false, "No graph was made of " + name + ". " +
                               texture->file.filename().string() + " leads out of the folder."};
    read.document = material_graph(*set, graph);
    return {true, "Read " + name + ".", read.problems};
}

TaskOutcome read_guarded(ReadFolder& read, TaskProgress& progress) {
    try {
        return read_folder(read, progress);
    } catch (...) {  // most likely out of memory
        return {false, "No graph was made: " + exception_text() + "."};
    }
}

}  // namespace

bool import_folder(Session& session, const fs::path& folder) {
    const auto read = std::make_shared<ReadFolder>();
    read->folder = real_path(folder);
    TaskSpec spec;
    spec.name = "Importing " + read->folder.filename().string();
    spec.work = [read](TaskProgress& progress) { return read_guarded(*read, progress); };
    spec.again = [&session, folder] { import_folder(session, folder); };
    spec.then = [read](Session& done) {
        PendingAction action{PendingAction::Kind::import, read->folder};
        action.document = std::make_shared<const Document>(std::move(read->document));
        request_action(done, action);
    };
    return start_task(session, std::move(spec));
}

void open_imported(Session& session, const PendingAction& import) {
    new_file(session, import.file);
    const std::string name = import.file.filename().string();
    session.commit("Import " + name, *import.document);
    session.status = "Made a graph of " + name + ".";
    session.tasks.warnings_of = session.path;
}

}  // namespace wrinkle::editor
