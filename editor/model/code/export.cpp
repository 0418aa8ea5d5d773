#include "editor/model/code/export.h"

#include "base/file.h"
#include "compile/inputs.h"
#include "editor/model/words.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

bool has_stages(const CodeOptions& options) {
    return form_of(options) == Form::shader;
}

// Returns the suffix of a stage's file: ".frag", ".frag.spv".
std::string end_of(const char* stage, const CodeOptions& options) {
    const Target* target = find_target(options.target);
    return stage + std::string(target ? target->suffix : "");
}

TaskOutcome export_code(const CodeJob& job, const fs::path& file) {
    const CodeText text = make_code(job);
    const std::string name = file.filename().string();
    if (!text.problem.empty())
        return {false,
                name + " was not written, because the graph has errors. " + sentence(text.problem)};
    std::vector<FileBytes> files{{file, text.source}};
    const std::string vertex = end_of(".vert", job.options);
    const std::string fragment = end_of(".frag", job.options);
    if (has_stages(job.options))
        files = {{file.string() + vertex, text.vertex}, {file.string() + fragment, text.fragment}};
    std::vector<std::string> read, made;
    Diagnostics ignored;
    const Project project = project_to_compile(job.model, job.document, ignored);
    for (const InputFile& input : inputs_of(project, Types(project, *job.registry)))
        read.push_back(input.path);
    for (const FileBytes& each : files)
        made.push_back(each.path.string());
    std::string why = overwrite_fault(made, read);
    if (!why.empty()) return {false, name + " was not written: " + why + "."};
    if (!write_files(files, why))
        return {false, name + " was not written: " + disk_words(why) + "."};
    const std::string stages = vertex + " and " + fragment;
    return {true, "Wrote " + name + (has_stages(job.options) ? stages : "") + "."};
}

}  // namespace

void start_code_export(Session& session, const fs::path& file) {
    const auto work = [job = job_of(session), file](TaskProgress&) {
        return export_code(job, file);
    };
    start_task(session, {"Exporting " + file.filename().string(), work,
                         [&session, file] { start_code_export(session, file); }});
}

fs::path usual_export(const Session& session) {
    const std::string stem = session.path.stem().string();
    return session.folder() / (has_stages(session.code.options) ? stem : stem + ".glsl");
}

}  // namespace wrinkle::editor
