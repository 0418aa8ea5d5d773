// Fuzz target: an accepted listing reads back as it is written; a rejected one has an error.
#include "fuzz/fuzz.h"
#include "registry/listing.h"

namespace wrinkle::fuzz {

std::string listing(std::string_view bytes) {
    const auto read = [](std::string text, Diagnostics& problems) {
        return read_listing(std::move(text), "fuzz.so.json", "fuzz.so", problems);
    };
    Diagnostics problems;
    const auto taken = read(std::string(bytes), problems);
    if (taken.has_value() == problems.has_errors()) return "a listing and an error, or neither";
    for (const Diagnostic& problem : problems.list())
        if (to_text(problem).find('\n') != std::string::npos) return "an error of several lines";
    if (!taken) return "";
    const std::string written = to_json(*taken);
    const auto again = read(written, problems);
    if (!again) return "its own text is refused: " + to_text(problems) + written;
    return to_json(*again) == written ? "" : "its own text reads back as " + to_json(*again);
}

}  // namespace wrinkle::fuzz
