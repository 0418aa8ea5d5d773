// Fuzz target: the bytes are a bake.json without its checksum. With a valid checksum, the header is
// rejected, or it is a part with files and rows that are counted without overflow and names that
// stay in its folder.
#include "cli/bake_header.h"
#include "fuzz/fuzz.h"

namespace wrinkle::fuzz {
namespace {

std::string wrong_with(const cli::PartHeader& header) {
    if (header.files_with_rows() != header.sums.size()) return "another number of sums than files";
    for (size_t i = 0; i < header.sums.size(); ++i) {
        const size_t set = header.set_of(header.first) + i / header.maps.size();
        const size_t map = i % header.maps.size();
        if (set >= header.sets.size()) return "rows of no picture";
        const uint64_t bytes = header.bytes_of_rows(set, map);
        if (bytes == 0 || bytes > header.height() * uint64_t{header.row_bytes(map)})
            return "more rows than a picture has, or none";
        for (const MapFile& file : header.files("out/maps", set, 1)) {
            const auto folder = file.path.lexically_normal().parent_path();
            if (folder != "out" && folder != "out/maps") return "outside: " + file.path.string();
        }
    }
    return "";
}

}  // namespace

std::string bake_part(std::string_view bytes) {
    const auto header = cli::header_of_json(cli::with_sum(std::string(bytes)));
    if (!header) return "";
    const std::string written = header_json(*header);
    const auto again = cli::header_of_json(written);
    if (!again || header_json(*again) != written) return "its own text reads back as another";
    return wrong_with(*header);
}

}  // namespace wrinkle::fuzz
