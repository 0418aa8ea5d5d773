// Compiles a snapshot for the preview and collects its problems: a pure function of the document
// and of the files that it names, so it may run on any thread.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "editor/model/document/cost.h"
#include "editor/model/document/displacement.h"
#include "editor/model/document/model.h"
#include "editor/model/document/request.h"
#include "emit/emit.h"

namespace wrinkle::editor {

struct CompileJob {
    uint64_t version = 0;  // increases with every job
    Model model;
    Document document;
    std::string name;  // material name
    PreviewRequest request = {};
};

// Result of one compilation. editor/model/code generates the sources that `wrinkle compile` writes.
struct Build {
    uint64_t version = 0;  // version of the job
    Document document;
    Diagnostics problems;  // all of the document, including parts that no output needs
    Diagnostics live;      // why `uniform` is empty: problems of the parts that the outputs need
    std::optional<Shader> uniform;
    std::shared_ptr<const Module> module;  // source of `uniform`
    std::optional<Costs> costs;            // estimated costs of `uniform`
    double milliseconds = 0;

    // Shader that the preview runs instead of `uniform` if the request asks for another one.
    PreviewRequest request;
    std::optional<Shader> shown;
    std::map<std::string, std::string> copied;  // node created for the request -> copied node
    size_t replaced = 0;                        // number of replaced sums
    std::string why_not_shown;                  // one sentence
    std::shared_ptr<const Displacement> displacement;

    const std::optional<Shader>& running() const { return shown ? shown : uniform; }
};

// Returns true if the document has neither nodes nor outputs: there is nothing to compile or
// report.
bool holds_nothing(const Document& document);

Build build(const CompileJob& job);

}  // namespace wrinkle::editor
