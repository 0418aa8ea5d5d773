#include "cli/test_formats.h"

#include <array>
#include <cstdio>

#include "cli/cli.h"
#include "cli/output.h"
#include "report/ci_formats.h"
#include "report/repository.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

constexpr std::array attachment_bases = {"project", "xml", "absolute", "none"};

std::string attachment_path(const fs::path& image, const CiFormats& formats) {
    const fs::path absolute = fs::absolute(image).lexically_normal();
    if (formats.attachments == "absolute") return absolute.string();
    const fs::path base = formats.attachments == "xml" ? fs::absolute(formats.junit).parent_path()
                                                       : fs::current_path();
    return absolute.lexically_proximate(base).generic_string();
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
                   std::string& why) {
    report::CiOptions options;
    if (formats.attachments != "none")
        options.attachment = [&](const std::string& image) {
            return attachment_path(folder / image, formats);
        };
    std::vector<Result> files;
    if (!formats.junit.empty()) files.push_back({formats.junit, report::junit(results, options)});
    if (!formats.tap.empty()) files.push_back({formats.tap, report::tap(results)});
    std::error_code ignored;
    if (formats.github)
        files.push_back({"-", report::github_annotations(
                                  results, report::repository_root(fs::current_path(ignored)))});
    return files.empty() || write_results(files, why);
}

}  // namespace wrinkle::cli
