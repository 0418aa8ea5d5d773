// GitHub's workflow commands: each adds a problem to its line in the view of a commit or a pull
// request. Source: GitHub Docs, "Workflow commands for GitHub Actions", and the command parser of
// actions/runner.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/diagnostics.h"

namespace wrinkle::report {

struct Annotation {
    enum class Level : uint8_t { error, warning, notice } level = Level::error;
    std::string file;  // relative to the repository; "" without a file
    uint32_t line = 0, column = 0;
    std::string title, text;
};

// GitHub shows ten errors and ten warnings of a step.
inline constexpr size_t max_annotations = 10;

// Returns a line for each annotation: errors, warnings, notices, each in the given order, at most
// max_annotations; if there are more, the last one gives their count and `rest`.
std::string github_commands(std::vector<Annotation> annotations, const std::string& rest);

// Paths are written relative to `root` (repository.h). The title is the rule's id.
std::string github_annotations(const Diagnostics& diagnostics, const std::filesystem::path& root);

}  // namespace wrinkle::report
