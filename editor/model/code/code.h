// Source text of the document for each target and form, byte for byte as `wrinkle compile` writes
// it, and the node of each line. SPIR-V is binary and is shown disassembled. CodeMaker compiles on
// a worker thread.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "editor/model/document/model.h"
#include "editor/model/worker.h"
#include "emit/emit.h"

namespace wrinkle::editor {

struct Session;

struct CodeOptions {
    std::string target = std::string(targets().front().name);
    Form form = Form::function;
    bool vertex = false;  // shader form: show the vertex stage, else the fragment stage
    bool uniforms = false;
    bool operator==(const CodeOptions&) const = default;
};

struct CodeText {
    CodeOptions options;
    std::string source;              // function form, or the stage shown
    std::string vertex, fragment;    // shader form, as written to files
    std::vector<size_t> starts;      // byte offset of each line in `source`
    std::vector<std::string> nodes;  // by line: node of the top graph, "" for none
    size_t longest = 0;              // bytes of the longest line
    std::string problem;             // the error if there is no text; then `source` is empty

    std::string_view line(size_t index) const;
    const std::string& node(size_t line) const;  // "" past the end
};

struct CodeJob {
    Model model;
    Document document;
    std::string name;  // name of the material
    CodeOptions options;
};

CodeJob job_of(const Session& session);  // for the current document
CodeText make_code(const CodeJob& job);

// Returns Form::shader if the target has only that form, else options.form.
Form form_of(const CodeOptions& options);

// Returns one sentence why the text has no line of the selected node; "" if it has one, or if not
// exactly one node is selected.
std::string why_no_line(const Session& session, const std::set<std::string>& selected);

// Exports the current document as a background task, in the form of the code panel: one file, or
// for the shader form FILE.vert and FILE.frag (FILE.frag.spv, FILE.frag.hlsl, ...). Writes all
// files or none.
void start_code_export(Session& session, const std::filesystem::path& file);

// Returns ".glsl", ".hlsl", ...; "" for the shader form, which adds one per stage.
std::string export_suffix(const CodeOptions& options);

// Default path: next to the graph, "graph.glsl", or "graph" for the shader form.
std::filesystem::path usual_export(const Session& session);

// Splits any text into lines, without nodes.
CodeText lines_of(std::string text);

using CodeMaker = Worker<CodeJob, CodeText>;

// State of the code panel.
struct Code {
    CodeOptions options;
    CodeMaker* maker = nullptr;  // nullptr: texts are made synchronously
    CodeText text;               // the newest valid text
    std::string problem;         // error of the newest document, "" if none
    std::string hovered;         // node of the line under the pointer

    // The latest request.
    bool requested = false;
    uint64_t requested_file = 0;
    Document requested_snapshot;
    CodeOptions requested_options;
    std::string scrolled_to;  // node that was last scrolled into view
};

}  // namespace wrinkle::editor
