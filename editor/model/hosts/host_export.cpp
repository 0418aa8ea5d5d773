#include "editor/model/hosts/host_export.h"

#include "base/text.h"
#include "compile/inputs.h"
#include "compile/shader.h"
#include "editor/model/document/folders.h"
#include "editor/model/document/inputs.h"
#include "editor/model/words.h"
#include "editor/model/worker.h"
#include "emit/emit.h"
#include "mesh/load.h"
#include "mesh/shapes.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
TaskOutcome export_to_host(const HostJob& job, const Registry& registry, TaskProgress& progress) {
    yield_to_interface();
    const HostChoices& choices = job.choices;
    const std::string failed = "No file was exported. ";
    try {
        Diagnostics problems;
        bool double_sided = false;
        auto mesh = make_shape(choices.mesh);
        if (!mesh) mesh = load_mesh(choices.mesh, {{}, {}, nullptr, &double_sided}, problems);
        Document document = job.document;
        if (double_sided) follow_double_sided(document, choices.mesh, problems);
        Project project = project_to_compile(job.model, document, problems);
        if (problems.has_errors()) return {false, failed + first_error(problems)};
        std::vector<std::string> inputs = {choices.mesh};
        for (InputFile& input : inputs_of(project, Types(project, registry)))
            inputs.push_back(std::move(input.path));
        const ExportRequest request{
            std::move(project), job.graph,    registry,    material_name(job.graph), *mesh,
            choices.mesh,       double_sided, choices.size};
        if (progress.cancelled) return {};
        const auto files = export_material(*choices.host, request, choices.into, inputs, problems);
        if (problems.has_errors()) return {false, failed + first_error(problems)};
        return {true,
                "Wrote " + counted(files.size(), "file") + " for " +
                    std::string(choices.host->label) + " into " + choices.into.filename().string() +
                    ".",
                problems};
    } catch (...) {
        return {false, failed + sentence(exception_text())};
    }
}

void start_host_export(Session& session, const HostChoices& choices,
                       const std::function<void(Session&)>& then) {
    HostJob job{session.model,
                with_preset_as_defaults(session.model, session.document(), choices.preset),
                session.path.empty() ? session.file_name() : session.path.string(), choices};
    job.choices.into = output_folder(session, choices);
    const auto work = [job = std::move(job), registry = session.registry](TaskProgress& progress) {
        return export_to_host(job, *registry, progress);
    };
    start_task(session, {"Exporting to " + std::string(choices.host->label),
                         work,
                         [&session, choices, then] { start_host_export(session, choices, then); },
                         {},
                         then});
}

fs::path usual_folder(const Session& session, const Host& host) {
    return fs::path(session.file_name()).stem().string() + "_" + std::string(host.name);
}

fs::path output_folder(const Session& session, const HostChoices& choices) {
    return session.folder() / with_home(choices.into);
}

}  // namespace wrinkle::editor
