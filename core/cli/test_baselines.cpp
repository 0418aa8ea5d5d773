#include "cli/test_baselines.h"

#include <algorithm>
#include <set>

#include "cli/session.h"
#include "cli/test_case.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

constexpr std::array golden_extensions = {".glsl", ".png"};

// Adds the golden files of all cases of a folder; returns false if a test file has errors.
bool add_read(const fs::path& folder, std::set<fs::path>& read) {
    std::error_code problem;
    for (fs::directory_iterator at(folder, problem), end; !problem && at != end;
         at.increment(problem)) {
        if (!at->path().filename().string().ends_with(test_suffix)) continue;
        Diagnostics diagnostics;
        for (const TestCase& test : read_test_cases(at->path(), diagnostics))
            for (const fs::path& golden : test.golden_files())
                read.insert(golden);
        if (diagnostics.has_errors()) return false;
    }
    return !problem;
}

}  // namespace

std::vector<fs::path> unread_baselines(const std::vector<fs::path>& folders) {
    std::vector<fs::path> unread;
    for (const fs::path& folder : folders) {
        std::set<fs::path> read;
        if (!add_read(folder, read)) continue;
        std::error_code problem;
        for (fs::directory_iterator at(folder / "golden", problem), end; !problem && at != end;
             at.increment(problem))
            if (std::ranges::count(golden_extensions, at->path().extension()) &&
                !read.contains(at->path()))
                unread.push_back(at->path());
    }
    std::ranges::sort(unread);
    return unread;
}

std::vector<report::Check> deleted_checks(const std::vector<fs::path>& files) {
    std::vector<report::Check> checks;
    for (const fs::path& file : files) {
        report::Check& check = checks.emplace_back();
        const fs::path near = near_path(file);
        check.test = near.parent_path().generic_string();
        check.name = near.filename().string();
        check.file = check.baseline = near.string();
        check.kind =
            near.extension() == ".png" ? report::CheckKind::image : report::CheckKind::text;
        check.status = report::Status::deleted;
        check.message = "no case reads this golden file";
        check.expected =
            "--accept deleted removes it; or its case was renamed or removed by mistake";
    }
    return checks;
}

}  // namespace wrinkle::cli
