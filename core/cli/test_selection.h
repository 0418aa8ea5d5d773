// Selection of regression cases: by name, and by their files that changed since a Git revision.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/session.h"
#include "cli/test_case.h"

namespace wrinkle::cli {

// Returns true if a filter selects the name of a case: a pattern of the shell (*, ?, [...]) that
// matches the entire name, where * matches '/' too, or another text that is a part of it. Without
// filters, all names are selected.
bool has_selected_name(const std::vector<std::string>& filters, const std::string& name);

// Files of the working tree that differ from a revision, are missing, or are new.
class ChangedFiles {
public:
    // Reports an error and returns std::nullopt if Git does not know the revision.
    static std::optional<ChangedFiles> since(const std::string& revision, Diagnostics& diagnostics);
    bool contains(const std::filesystem::path& file) const;

private:
    std::filesystem::path top_;    // the working tree, canonical
    std::set<std::string> paths_;  // relative to it
};

// Returns the files that the result of a case depends on: graph, sub-graphs, images, plugins,
// preset and mesh. They may be missing.
std::vector<std::string> case_inputs(const TestCase& test, const Registry& registry,
                                     const CommonOptions& common);

// Returns true if an input of the case, its test file or a golden file is among the changed.
bool has_changed(const TestCase& test, const ChangedFiles& changed, const Registry& registry,
                 const CommonOptions& common);

}  // namespace wrinkle::cli
