// The text that `wrinkle compile` writes for the document, for every target in every form, byte for
// byte, and the node that each line came from; SPIR-V, which is no text, is shown disassembled.
// Made on a thread of its own where there is one.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/document/model.h"
#include "editor/worker.h"
#include "glsl/emit.h"

namespace wrinkle::editor {

struct State;

struct CodeOptions {
    std::string target = std::string(targets().front().name);
    Form form = Form::function;
    bool vertex = false;  // of the shader form that stage, else the fragment stage
    bool uniforms = false;
    bool operator==(const CodeOptions&) const = default;
};

struct CodeText {
    CodeOptions options;
    std::string source;              // function form, or the stage that is shown
    std::string vertex, fragment;    // shader form, as files hold them
    std::vector<size_t> starts;      // of each line in `source`
    std::vector<std::string> nodes;  // by line the node of the top graph, "" for none
    size_t longest = 0;              // bytes of the longest line
    std::string problem;             // why there is no text; then `source` is empty

    std::string_view line(size_t index) const;
    const std::string& node(size_t line) const;  // "" past the end
};

struct CodeJob {
    Model model;
    Document document;
    std::string name;  // of the material
    CodeOptions options;
};

CodeText make_code(const CodeJob& job, const Registry& registry);

// The shader form where the target has no other.
Form form_of(const CodeOptions& options);

// Why no line of the text is the selected node's, in one sentence; "" when one is, or when it is
// not just one node that is selected.
std::string why_no_line(const State& state);

// The lines of any text, without nodes.
CodeText lines_of(std::string text);

class CodeMaker {
public:
    // The registry must stay as it is while the maker lives. wake is called on its thread.
    explicit CodeMaker(const Registry& registry, std::function<void()> wake = {})
        : registry_(&registry),
          worker_([this](CodeJob&& job) { return make_code(job, *registry_); }, std::move(wake)) {}
    void use(const Registry& registry) { registry_ = &registry; }  // as of Compiler
    void ask(CodeJob job) { worker_.post(std::move(job)); }
    std::optional<CodeText> take() { return worker_.take(); }

private:
    std::atomic<const Registry*> registry_;
    Worker<CodeJob, CodeText> worker_;
};

// What the code panel knows.
struct Code {
    CodeOptions options;
    CodeMaker* maker = nullptr;  // nullptr: texts are made at once
    CodeText text;               // the newest that could be made
    std::string problem;         // why the newest document has none
    std::string hovered;         // the node of the line under the pointer

    // Of the newest text that was asked for.
    bool asked = false;
    uint64_t asked_file = 0;
    Document asked_of;
    CodeOptions asked_options;
    std::string scrolled_to;  // the node whose lines were brought into view
};

}  // namespace wrinkle::editor
