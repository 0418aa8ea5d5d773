#include "editor/model/code/code.h"

#include <algorithm>
#include <set>

#include "base/file.h"
#include "compile/inputs.h"
#include "editor/model/document/wiring.h"
#include "editor/model/session.h"
#include "editor/model/words.h"
#include "graph/edit.h"
#include "lower/material.h"
#include "spirv/spirv.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

void cut_lines(CodeText& text) {
    for (size_t at = 0; at < text.source.size();) {
        const size_t end = std::min(text.source.find('\n', at), text.source.size());
        text.starts.push_back(at);
        text.longest = std::max(text.longest, end - at);
        at = end + 1;
    }
}

// Returns the node of the top graph for a path "outer/inner".
std::string top_of(const std::string& path) {
    return path.substr(0, path.find('/'));
}

const Target& target_of(const CodeOptions& options) {
    const Target* target = find_target(options.target);
    return target ? *target : targets().front();
}

Shader shader_of(const CodeJob& job, Diagnostics& problems) {
    const Project project = project_to_compile(job.model, job.document, problems);
    if (problems.has_errors()) return {};
    MaterialOptions options;
    options.uniform_parameters = job.options.uniforms;
    const Compiled compiled = compile_material(project, *job.model.registry, options, problems);
    if (!compiled.ok) return {};
    EmitOptions emit_options;
    emit_options.name = job.name;
    emit_options.form = form_of(job.options);
    emit_options.target = &target_of(job.options);
    Shader shader = write_shader(compiled.module, emit_options);
    report_problems(shader.problems, compiled.module, project, compiled.places, problems);
    return shader;
}

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
    for (const InputFile& input : inputs_of(project, Types(project, *job.model.registry)))
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

std::string_view CodeText::line(size_t index) const {
    const size_t end = index + 1 < starts.size() ? starts[index + 1] : source.size();
    std::string_view text = std::string_view(source).substr(starts[index], end - starts[index]);
    if (text.ends_with('\n')) text.remove_suffix(1);
    return text;
}

const std::string& CodeText::node(size_t line) const {
    static const std::string none;
    return line < nodes.size() ? nodes[line] : none;
}

Form form_of(const CodeOptions& options) {
    const Target& target = target_of(options);
    return supports(target, options.form) ? options.form : default_form(target);
}

std::string why_no_line(const Session& session, const std::set<std::string>& selected) {
    const CodeText& text = session.code.text;
    if (selected.size() != 1 || text.nodes.empty()) return {};
    const std::string& id = *selected.begin();
    const Node* node = session.document().find(id);
    if (!node || std::ranges::find(text.nodes, id) != text.nodes.end()) return {};
    std::set<std::string> read;
    for (const Output& output : session.document().outputs)
        if (output.from.kind == Input::Kind::link) read.insert(output.from.link.node);
    if (!reachable(session.document(), read, Direction::upstream).contains(id))
        return id + " has no line: no output of the graph reads it.";
    if (node->muted) return id + " has no line: it is muted, and passes on what it is given.";
    if (node->type == reroute_type) return id + " has no line: a reroute passes on its input.";
    return id + " has no line: its values are constants, or in lines of other nodes.";
}

CodeText lines_of(std::string text) {
    CodeText result;
    result.source = std::move(text);
    cut_lines(result);
    return result;
}

CodeJob job_of(const Session& session) {
    return {session.model, session.document(), material_name(session.file_name()),
            session.code.options};
}

CodeText make_code(const CodeJob& job) {
    CodeText text;
    text.options = job.options;
    Diagnostics problems;
    Shader shader = shader_of(job, problems);
    if (problems.has_errors()) {
        text.problem = first_error(problems);
        return text;
    }
    const bool whole = form_of(job.options) == Form::shader;
    text.vertex = std::move(shader.vertex);
    text.fragment = std::move(shader.fragment);
    text.source = !whole               ? std::move(shader.source)
                  : job.options.vertex ? text.vertex
                                       : text.fragment;
    if (target_of(job.options).name == "spirv") text.source = disassembly(text.source);
    cut_lines(text);
    if (whole && job.options.vertex) return text;
    for (const uint32_t index : shader.reflection.lines)
        text.nodes.push_back(index < shader.reflection.node_paths.size()
                                 ? top_of(shader.reflection.node_paths[index])
                                 : "");
    return text;
}

void start_code_export(Session& session, const fs::path& file) {
    const auto work = [job = job_of(session), file](TaskProgress&) {
        return export_code(job, file);
    };
    start_task(session, {"Exporting " + file.filename().string(), work,
                         [&session, file] { start_code_export(session, file); }});
}

std::string export_suffix(const CodeOptions& options) {
    return has_stages(options) ? "" : std::string(function_suffix(target_of(options)));
}

fs::path usual_export(const Session& session) {
    const std::string stem = fs::path(session.file_name()).stem().string();
    return session.folder() / (stem + export_suffix(session.code.options));
}

}  // namespace wrinkle::editor
