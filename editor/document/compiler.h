// Documents to texts on a thread of its own. The newest document wins: one that waits is replaced,
// and what comes out is never older than what came out before.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "editor/document/build.h"
#include "editor/worker.h"

namespace wrinkle::editor {

struct CompileJob {
    uint64_t version = 0;  // grows with every job
    Model model;
    Document document;
    std::string name;  // of the material
    PreviewRequest request;
};

struct Compilation {
    uint64_t version = 0;
    Document document;
    Build build;
};

Compilation compile(CompileJob job, const Registry& registry);

class Compiler {
public:
    // The registry must stay as it is while the compiler is busy. wake is called on its thread.
    explicit Compiler(const Registry& registry, std::function<void()> wake = {})
        : registry_(&registry),
          worker_([this](CompileJob&& job) { return compile(std::move(job), *registry_); },
                  std::move(wake)) {}

    // From the next job on; the former one must stay as it is as long.
    void use(const Registry& registry) { registry_ = &registry; }

    void ask(CompileJob job) { worker_.post(std::move(job)); }
    std::optional<Compilation> take() { return worker_.take(); }
    bool idle() const { return worker_.idle(); }
    void settle() { worker_.settle(); }

private:
    std::atomic<const Registry*> registry_;
    Worker<CompileJob, Compilation> worker_;
};

}  // namespace wrinkle::editor
