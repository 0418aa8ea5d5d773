#include "cli/test_selection.h"

#include <fnmatch.h>

#include <algorithm>

#include "base/file.h"
#include "base/text.h"
#include "cli/git.h"
#include "cli/meshes.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

bool matches(const std::string& filter, const std::string& name) {
    const bool is_pattern = filter.find_first_of("*?[") != filter.npos;
    return is_pattern ? fnmatch(filter.c_str(), name.c_str(), 0) == 0
                      : name.find(filter) != name.npos;
}

// Returns the lines of the output of Git, without the line end; std::nullopt if it failed.
std::optional<std::string> line_of_git(const std::vector<std::string>& words) {
    GitResult result = run_git(words);
    if (result.code != 0) return {};
    while (result.output.ends_with('\n'))
        result.output.pop_back();
    return std::move(result.output);
}

}  // namespace

bool has_selected_name(const std::vector<std::string>& filters, const std::string& name) {
    return filters.empty() || std::ranges::any_of(filters, [&](const std::string& filter) {
               return matches(filter, name);
           });
}

std::optional<ChangedFiles> ChangedFiles::since(const std::string& revision,
                                                Diagnostics& diagnostics) {
    const auto top = line_of_git({"rev-parse", "--show-toplevel"});
    const auto commit =
        line_of_git({"rev-parse", "--verify", "--end-of-options", revision + "^{commit}"});
    if (!top || !commit) {
        diagnostics.error(RuleId::option,
                          "--changed-since " + revision +
                              (top ? ": Git knows no such revision"
                                   : ": the working folder is not in a Git work tree"),
                          "a commit, tag or branch");
        return {};
    }
    ChangedFiles changed;
    changed.top_ = real_path(*top);
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"diff", "--name-only", "--no-relative", "--no-renames", "-z",
                                   *commit, "--"},
          {"ls-files", "--others", "--exclude-standard", "--full-name", "-z", "--", ":/"}}) {
        const GitResult listed = run_git(words);
        if (listed.code != 0) {
            diagnostics.error(RuleId::environment, "git " + words.front() + " failed");
            return {};
        }
        for (const std::string_view path : split(listed.output, '\0'))
            if (!path.empty()) changed.paths_.emplace(path);
    }
    return changed;
}

bool ChangedFiles::contains(const fs::path& file) const {
    std::error_code ignored;
    const fs::path folder = real_path(fs::absolute(file, ignored).parent_path());
    // A changed link, or a changed file that a link leads to.
    return paths_.contains(path_from(top_, folder / file.filename()).generic_string()) ||
           paths_.contains(path_from(top_, real_path(file)).generic_string());
}

std::vector<std::string> case_inputs(const TestCase& test, const Registry& registry,
                                     const CommonOptions& common) {
    Diagnostics ignored;
    const Project project = open_project(test.graph.string(), common, ignored);
    std::vector<std::string> paths = input_paths(project, registry);
    if (test.preset.ends_with(".json"))
        paths.push_back((test.file.parent_path() / test.preset).string());
    if (test.render && is_mesh_path(test.render->options.mesh))
        if (const auto mesh = resolve_file(project, 0, test.render->options.mesh))
            paths.push_back(mesh->string());
    return paths;
}

bool has_changed(const TestCase& test, const ChangedFiles& changed, const Registry& registry,
                 const CommonOptions& common) {
    const auto is_changed = [&](const fs::path& file) { return changed.contains(file); };
    return is_changed(test.file) || is_changed(test.graph) ||
           std::ranges::any_of(test.golden_files(), is_changed) ||
           std::ranges::any_of(case_inputs(test, registry, common), is_changed);
}

}  // namespace wrinkle::cli
