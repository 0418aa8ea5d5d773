// What the preview runs of a snapshot, and its problems: a pure function of the document and of the
// files that it names, so it may run on any thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/document/cost.h"
#include "editor/document/model.h"
#include "editor/preview/displacement.h"
#include "editor/preview/request.h"
#include "glsl/emit.h"

namespace wrinkle::editor {

// One compilation. The texts that `wrinkle compile` writes are made in editor/code.
struct Build {
    Diagnostics problems;  // of the whole document, also of what no output needs
    Diagnostics live;      // why `uniform` is empty: of what the outputs need
    std::optional<Shader> uniform;
    std::shared_ptr<const Module> module;  // that `uniform` was made from
    std::optional<Costs> costs;            // of `uniform`, estimated
    double milliseconds = 0;

    // What the preview runs in place of `uniform` when it was asked for something else.
    PreviewRequest request;
    std::optional<Shader> shown;
    std::map<std::string, std::string> copied;  // from nodes that were made for it to those copied
    size_t replaced = 0;                        // sums
    std::string why_not_shown;                  // one sentence
    std::shared_ptr<const Displacement> displacement;

    const std::optional<Shader>& running() const { return shown ? shown : uniform; }
};

// Neither a node nor an output: there is nothing to compile, and nothing wrong with it.
bool holds_nothing(const Document& document);

Build build(const Model& model, const Document& document, const Registry& registry,
            const std::string& name, const PreviewRequest& request = {});

}  // namespace wrinkle::editor
