#include "cli/test_formats.h"

#include <array>
#include <cstdio>

#include "cli/output.h"
#include "report/ci_formats.h"
#include "report/repository.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

constexpr std::array attachment_bases = {"project", "xml", "absolute"};

std::string attachment_folder(const fs::path& folder, const CiFormats& formats) {
    const fs::path absolute = fs::absolute(folder).lexically_normal();
    if (formats.attachments == "absolute") return absolute.string();
    const fs::path base = formats.attachments == "xml" ? fs::absolute(formats.junit).parent_path()
                                                       : fs::current_path();
    return absolute.lexically_proximate(base.lexically_normal()).generic_string();
}

}  // namespace

void declare_formats(CLI::App& command, CiFormats& formats) {
    command.add_option("--junit", formats.junit, "Gets the results as JUnit XML")
        ->type_name("FILE");
    command.add_option("--tap", formats.tap, "Gets the results as TAP 14")->type_name("FILE");
    add_choice(command, "--attachments", formats.attachments, attachment_bases,
               "Paths of images in JUnit: relative to the working folder, to the XML file, or "
               "absolute");
    command.add_flag("--github", formats.github, "Prints annotations for GitHub Actions");
}

bool write_formats(const CiFormats& formats, const report::Results& results, const fs::path& folder,
                   bool added_fails, std::string& why) {
    report::CiOptions options;
    options.root = report::repository_root(fs::current_path());
    options.attachments = attachment_folder(folder, formats);
    options.added_fails = added_fails;
    std::vector<Result> files;
    if (!formats.junit.empty()) files.push_back({formats.junit, report::junit(results, options)});
    if (!formats.tap.empty()) files.push_back({formats.tap, report::tap(results, options)});
    if (formats.github) files.push_back({"-", report::github_annotations(results, options)});
    return files.empty() || write_results(files, why);
}

}  // namespace wrinkle::cli
