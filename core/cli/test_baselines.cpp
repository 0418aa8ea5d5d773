#include "cli/test_baselines.h"

#include <algorithm>

#include "cli/session.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

constexpr std::array golden_extensions = {".glsl", ".png"};

}  // namespace

std::vector<fs::path> unread_baselines(const std::set<fs::path>& folders,
                                       const std::vector<TestFile>& files) {
    std::set<fs::path> read, broken;
    for (const TestFile& file : files) {
        if (file.problems.has_errors()) broken.insert(file.path.parent_path());
        for (const TestCase& test : file.cases)
            for (const fs::path& golden : test.golden_files())
                read.insert(golden);
    }
    std::vector<fs::path> unread;
    for (const fs::path& folder : folders) {
        if (broken.contains(folder)) continue;
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

std::vector<fs::path> unread_baselines(const fs::path& folder) {
    std::vector<TestFile> files;
    std::error_code problem;
    for (fs::directory_iterator at(folder, problem), end; !problem && at != end;
         at.increment(problem))
        if (at->path().filename().string().ends_with(test_suffix))
            files.push_back(read_test_file(at->path()));
    return problem ? std::vector<fs::path>() : unread_baselines({folder}, files);
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
