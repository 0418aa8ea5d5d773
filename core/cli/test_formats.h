// Options of `wrinkle test` for CI systems (report/ci_formats.h).
#pragma once

#include <filesystem>
#include <string>

#include "report/results.h"

namespace CLI {
class App;
}

namespace wrinkle::cli {

struct CiFormats {
    std::string junit, tap;               // files; "": none
    std::string attachments = "project";  // attachment_bases
    bool github = false;                  // annotations on standard output
};

void declare_formats(CLI::App& command, CiFormats& formats);

// Writes the files, and prints the annotations. `folder` is that of the report. Returns false and
// the reason in `why` on failure.
bool write_formats(const CiFormats& formats, const report::Results& results,
                   const std::filesystem::path& folder, std::string& why);

}  // namespace wrinkle::cli
