#include "cli/output.h"

#include <cstdio>
#include <filesystem>

#include "base/file.h"
#include "base/printable.h"
#include "report/annotations.h"
#include "report/repository.h"
#include "report/sarif.h"

namespace wrinkle::cli {
namespace {

bool print(std::string_view text) {
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    return written && std::fflush(stdout) == 0;
}

}  // namespace

int write_result(const std::string& path, std::string text) {
    return write_results({{path, std::move(text)}});
}

int write_results(const std::vector<Result>& results) {
    std::string why;
    return write_results(results, why) ? int{exit_success} : fail(exit_environment, why);
}

bool write_results(const std::vector<Result>& results, std::string& why) {
    std::vector<FileBytes> files;
    for (const Result& result : results)
        if (result.path != "-") files.push_back({result.path, result.text});
    if (!write_files(files, why)) return false;
    for (const Result& result : results)
        if (result.path == "-" && !print(result.text)) {
            why = "standard output cannot be written";
            return false;
        }
    return true;
}

std::string formatted(const Diagnostics& diagnostics, const std::string& format) {
    if (format == "text") return to_text(diagnostics);
    if (format == "json") return to_json(diagnostics);
    std::error_code ignored;
    const auto root = report::repository_root(std::filesystem::current_path(ignored));
    return format == "sarif" ? report::sarif(diagnostics, {WRINKLE_VERSION, root})
                             : report::github_annotations(diagnostics, root);
}

int report(const Diagnostics& diagnostics, const std::string& format) {
    const std::string text = formatted(diagnostics, format);
    std::fwrite(text.data(), 1, text.size(), stderr);
    return diagnostics.has_errors() ? exit_input : exit_success;
}

void print_error(std::string_view sentence) {
    std::fprintf(stderr, "wrinkle: error: %s\n", printable(sentence).c_str());
}

int fail(ExitCode code, std::string_view sentence) {
    print_error(sentence);
    return code;
}

}  // namespace wrinkle::cli
