#include "editor/view/panels/samples.h"

#include <algorithm>

#include "base/file.h"
#include "base/folders.h"
#include "editor/view/panels/listing.h"
#include "graph/read.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;

fs::path samples_folder() {
    std::error_code error;
    const fs::path program = program_folder();
    if (program.empty()) return {};
    for (const char* place : {"../share/wrinkle/graphs", "../../../graphs"}) {
        const fs::path folder = (program / place).lexically_normal();
        if (fs::exists(folder / "base_and_detail.json", error)) return folder;
    }
    return {};
}

std::vector<Sample> list_samples(const fs::path& folder) {
    std::vector<Sample> samples;
    const std::string extension = ".json";
    for (const Entry& entry : list_folder(folder, {&extension, 1}).entries) {
        const fs::path file = folder / entry.name, stem = file.stem();
        if (entry.folder || stem.extension() == ".test") continue;
        std::string why;
        const auto bytes = read_file(file, why);
        if (!bytes) continue;
        Diagnostics problems;
        const Document document = read_document(*bytes, file.string(), problems);
        if (problems.has_errors()) continue;
        samples.push_back({file, folder / "golden" / (stem.string() + ".png"),
                           document.name.empty() ? stem.string() : document.name,
                           document.nodes.size()});
    }
    std::sort(samples.begin(), samples.end(),
              [](const Sample& a, const Sample& b) { return name_before(a.name, b.name); });
    return samples;
}

}  // namespace wrinkle::editor
