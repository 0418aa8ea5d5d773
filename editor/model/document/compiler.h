// Compiles documents on a worker thread. The newest document wins: a new job replaces a waiting
// one, and results are returned in the order of their versions.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "editor/model/document/build.h"
#include "editor/model/worker.h"

namespace wrinkle::editor {

struct CompileJob {
    uint64_t version = 0;  // increases with every job
    Model model;
    Document document;
    std::string name;  // material name
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
    // Precondition: the registry does not change while the compiler is busy. `wake` is called on
    // the worker thread.
    explicit Compiler(const Registry& registry, std::function<void()> wake = {})
        : registry_(&registry),
          worker_([this](CompileJob&& job) { return compile(std::move(job), *registry_); },
                  std::move(wake)) {}

    // Takes effect with the next job; the previous registry must not change until the running job
    // ends.
    void use(const Registry& registry) { registry_ = &registry; }

    void submit(CompileJob job) { worker_.post(std::move(job)); }
    std::optional<Compilation> take() { return worker_.take(); }
    bool idle() const { return worker_.idle(); }
    void wait_idle() { worker_.wait_idle(); }

private:
    std::atomic<const Registry*> registry_;
    Worker<CompileJob, Compilation> worker_;
};

}  // namespace wrinkle::editor
