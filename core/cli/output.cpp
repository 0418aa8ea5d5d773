#include "cli/output.h"

#include <cstdio>

#include "base/file.h"
#include "base/printable.h"

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

int report(const Diagnostics& diagnostics, const std::string& format) {
    if (!diagnostics.list().empty() || format == "json") {
        const std::string text = format == "json" ? to_json(diagnostics) : to_text(diagnostics);
        std::fwrite(text.data(), 1, text.size(), stderr);
    }
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
