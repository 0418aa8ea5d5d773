#include "editor/model/document/compiler.h"

namespace wrinkle::editor {

Compilation compile(CompileJob job, const Registry& registry) {
    Compilation result;
    result.build = build(job.model, job.document, registry, job.name, job.request);
    result.version = job.version;
    result.document = std::move(job.document);
    return result;
}

}  // namespace wrinkle::editor
