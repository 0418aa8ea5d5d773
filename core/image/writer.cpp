#include "image/writer.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/file.h"
#include "image/find_codec.h"
#include "image/formats.h"
#include "image/mips.h"
#include "image/stored.h"

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

constexpr uint32_t scan_lines_at_once = 64;  // complete chunks of OpenEXR, complete strips of TIFF

void report(const fs::path& path, const std::string& why, const char* remedy,
            Diagnostics& diagnostics) {
    diagnostics.error(RuleId::file_unwritable, quoted(path) + "cannot be written: " + why, remedy);
}

constexpr const char* folder_remedy = "a folder that can be written to and has room";

}  // namespace

std::vector<std::string> channel_names(uint32_t channels, bool has_alpha) {
    if (channels == 1) return {"Y"};
    if (channels == 2 && has_alpha) return {"Y", "A"};
    const std::vector<std::string> all = {"R", "G", "B", "A"};
    return {all.begin(), all.begin() + std::min(channels, 4u)};
}

void ImageWriter::Drop::operator()(WrinkleImageWriter* file) const {
    codec->drop(file);
}

ImageWriter::ImageWriter(fs::path path, Temporary temporary, const WriterOptions& options,
                         const WrinkleImageCodec* codec)
    : path_(std::move(path)),
      temporary_(std::move(temporary)),
      type_(options.type),
      granule_(options.tile > 0 ? options.tile : scan_lines_at_once),
      file_(nullptr, Drop{codec}) {
    const size_t texel_bytes = options.channels.size() * bytes_of(type_);
    uint32_t width = options.width, height = options.height;
    const uint32_t count = options.mips ? mip_count(width, height) : 1;
    for (uint32_t level = 0; level < count; ++level) {
        levels_.push_back({width, height, 0, width * texel_bytes});
        width = next_mip_size(width);
        height = next_mip_size(height);
    }
}

std::optional<ImageWriter> ImageWriter::open(const fs::path& path, const WriterOptions& options,
                                             Diagnostics& diagnostics) {
    const Writable* format = format_to_write(path);
    const WriteProblem problem = find_write_problem(format, options);
    if (!problem.message.empty()) {
        diagnostics.error(RuleId::option, quoted(path) + problem.message, problem.expected);
        return {};
    }
    std::string why;
    const WrinkleImageCodec* codec = find_codec(format->plugin, why);
    std::error_code error;
    auto temporary = Temporary::beside(link_target(path), error);
    if (!codec || error) {
        report(path, codec ? error.message() : why, codec ? folder_remedy : library_remedy,
               diagnostics);
        return {};
    }
    WriterOptions written = options;
    if (written.compression.empty()) written.compression = format->compression;
    ImageWriter writer(path, std::move(*temporary), options, codec);
    char text[512] = "";
    writer.file_.reset(codec->begin(writer.temporary_.path().c_str(), format->plugin, written,
                                    writer.levels(), {text, sizeof text}));
    if (writer.file_) return writer;
    report(path, text, folder_remedy, diagnostics);
    return {};
}

bool ImageWriter::fail(const std::string& why, Diagnostics& diagnostics) {
    failed_ = true;
    report(path_, why, folder_remedy, diagnostics);
    return false;
}

uint32_t ImageWriter::rows_left(uint32_t index) const {
    const Level& level = levels_[index];
    return level.height - level.written -
           static_cast<uint32_t>(level.waiting.size() / level.row_bytes);
}

bool ImageWriter::write(std::span<const float> rows, Diagnostics& diagnostics, uint32_t level) {
    converted_.resize(rows.size() * bytes_of(type_));
    store_values(type_, rows, converted_.data());
    return write_stored(converted_, diagnostics, level);
}

// Writes complete granules, and all rows after the last one of the level; the others wait.
bool ImageWriter::write_stored(std::span<const std::byte> rows, Diagnostics& diagnostics,
                               uint32_t index) {
    if (failed_) return false;
    Level& level = levels_[index];
    assert(rows.size() % level.row_bytes == 0);
    assert(rows.size() / level.row_bytes <= rows_left(index));
    level.waiting.insert(level.waiting.end(), rows.begin(), rows.end());
    auto count = static_cast<uint32_t>(level.waiting.size() / level.row_bytes);
    if (rows_left(index) > 0) count -= count % granule_;
    if (count == 0) return true;
    char text[512] = "";
    if (!file_.get_deleter().codec->rows(file_.get(), index, level.waiting.data(), level.written,
                                         count, {text, sizeof text}))
        return fail(text, diagnostics);
    level.written += count;
    const auto sent = static_cast<ptrdiff_t>(count * level.row_bytes);
    level.waiting.erase(level.waiting.begin(), level.waiting.begin() + sent);
    return true;
}

bool ImageWriter::close(Diagnostics& diagnostics) {
    if (failed_) return false;
    if (!file_) return true;
    for (uint32_t level = 0; level < levels(); ++level)
        assert(rows_left(level) == 0);
    char text[512] = "";
    const WrinkleImageCodec* codec = file_.get_deleter().codec;
    return codec->end(file_.release(), {text, sizeof text}) || fail(text, diagnostics);
}

bool ImageWriter::finish(Diagnostics& diagnostics) {
    if (!close(diagnostics)) return false;
    std::string why;
    return replace_file(temporary_, path_, why) || fail(why, diagnostics);
}

}  // namespace wrinkle
