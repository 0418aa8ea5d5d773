#include "image/writer.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/file.h"
#include "image/formats.h"
#include "image/mips.h"
#include "image/module.h"
#include "image/stored.h"

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

constexpr uint32_t scan_lines_at_once = 64;  // complete chunks of OpenEXR, complete strips of TIFF

std::string named(const fs::path& path) {
    return "image '" + path.string() + "' ";
}

}  // namespace

struct ImageWriter::State {
    struct Level {
        uint32_t width = 0, height = 0, written = 0;  // rows
        size_t row_bytes = 0;
        std::vector<std::byte> waiting = {};  // rows of an incomplete granule

        uint32_t waiting_rows() const { return static_cast<uint32_t>(waiting.size() / row_bytes); }
        uint32_t rows_left() const { return height - written - waiting_rows(); }
    };

    fs::path path;
    std::optional<Temporary> temporary;
    PixelType type = PixelType::u8;
    uint32_t granule = 0;  // rows per write to the file
    std::vector<Level> levels;
    std::vector<std::byte> converted;  // values of one write() call
    const WrinkleImageModule* module = nullptr;
    WrinkleImageWriter* file = nullptr;
    bool failed = false;

    ~State() {
        if (file) module->drop(file);
    }

    bool fail(const std::string& why, Diagnostics& diagnostics) {
        failed = true;
        diagnostics.error(named(path) + "cannot be written: " + why,
                          module ? "a folder that can be written to and has room" : library_remedy);
        return false;
    }

    bool begin(const Writable& format, const WriterOptions& options, Diagnostics& diagnostics);
    void plan(const WriterOptions& options);
    bool add(uint32_t level, std::span<const std::byte> rows, Diagnostics& diagnostics);
};

void ImageWriter::State::plan(const WriterOptions& options) {
    type = options.type;
    granule = options.tile > 0 ? options.tile : scan_lines_at_once;
    const size_t texel_bytes = options.channels.size() * bytes_of(type);
    uint32_t width = options.width, height = options.height;
    const uint32_t count = options.mips ? mip_count(width, height) : 1;
    for (uint32_t level = 0; level < count; ++level) {
        levels.push_back({width, height, 0, width * texel_bytes});
        width = next_mip_size(width);
        height = next_mip_size(height);
    }
}

bool ImageWriter::State::begin(const Writable& format, const WriterOptions& options,
                               Diagnostics& diagnostics) {
    WriterOptions written = options;
    if (written.compression.empty()) written.compression = format.compression;
    char text[512] = "";
    file = module->begin(temporary->path().c_str(), format.plugin, written,
                         static_cast<uint32_t>(levels.size()), {text, sizeof text});
    return file || fail(text, diagnostics);
}

// Writes complete granules, and all rows after the last one of the level; the others wait.
bool ImageWriter::State::add(uint32_t index, std::span<const std::byte> rows,
                             Diagnostics& diagnostics) {
    Level& level = levels[index];
    level.waiting.insert(level.waiting.end(), rows.begin(), rows.end());
    uint32_t count = level.waiting_rows();
    if (level.rows_left() > 0) count -= count % granule;
    if (count == 0) return true;
    char text[512] = "";
    if (!module->rows(file, index, level.waiting.data(), level.written, count, {text, sizeof text}))
        return fail(text, diagnostics);
    level.written += count;
    const auto sent = static_cast<ptrdiff_t>(count * level.row_bytes);
    level.waiting.erase(level.waiting.begin(), level.waiting.begin() + sent);
    return true;
}

std::vector<std::string> channel_names(uint32_t channels, bool has_alpha) {
    if (channels == 1) return {"Y"};
    if (channels == 2 && has_alpha) return {"Y", "A"};
    const std::vector<std::string> all = {"R", "G", "B", "A"};
    return {all.begin(), all.begin() + std::min(channels, 4u)};
}

std::optional<ImageWriter> ImageWriter::open(const fs::path& path, const WriterOptions& options,
                                             Diagnostics& diagnostics) {
    const Writable* format = format_to_write(path);
    const WriteProblem problem = find_write_problem(format, options);
    if (!problem.message.empty()) {
        diagnostics.error(named(path) + problem.message, problem.expected);
        return {};
    }
    auto state = std::make_unique<State>();
    state->path = path;
    state->plan(options);
    std::string why;
    state->module = image_module(why);
    std::error_code error;
    if (auto made = Temporary::beside(link_target(path), error))
        state->temporary.emplace(std::move(*made));
    if (!state->module || error) {
        state->fail(state->module ? error.message() : why, diagnostics);
        return {};
    }
    if (!state->begin(*format, options, diagnostics)) return {};
    return ImageWriter(std::move(state));
}

ImageWriter::ImageWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
ImageWriter::ImageWriter(ImageWriter&&) noexcept = default;
ImageWriter& ImageWriter::operator=(ImageWriter&&) noexcept = default;
ImageWriter::~ImageWriter() = default;

uint32_t ImageWriter::levels() const {
    return static_cast<uint32_t>(state_->levels.size());
}

uint32_t ImageWriter::width(uint32_t level) const {
    return state_->levels[level].width;
}

uint32_t ImageWriter::rows_left(uint32_t level) const {
    return state_->levels[level].rows_left();
}

bool ImageWriter::write(std::span<const float> rows, Diagnostics& diagnostics, uint32_t level) {
    State& state = *state_;
    state.converted.resize(rows.size() * bytes_of(state.type));
    store_values(state.type, rows, state.converted.data());
    return write_stored(state.converted, diagnostics, level);
}

bool ImageWriter::write_stored(std::span<const std::byte> rows, Diagnostics& diagnostics,
                               uint32_t level) {
    if (state_->failed) return false;
    assert(rows.size() % state_->levels[level].row_bytes == 0);
    assert(rows.size() / state_->levels[level].row_bytes <= rows_left(level));
    return state_->add(level, rows, diagnostics);
}

bool ImageWriter::close(Diagnostics& diagnostics) {
    State& state = *state_;
    if (state.failed) return false;
    if (!state.file) return true;
    assert(std::all_of(state.levels.begin(), state.levels.end(),
                       [](const State::Level& level) { return level.rows_left() == 0; }));
    char text[512] = "";
    const bool ended = state.module->end(std::exchange(state.file, nullptr), {text, sizeof text});
    return ended || state.fail(text, diagnostics);
}

bool ImageWriter::finish(Diagnostics& diagnostics) {
    if (!close(diagnostics)) return false;
    State& state = *state_;
    std::string why;
    return replace_file(*state.temporary, state.path, why) || state.fail(why, diagnostics);
}

}  // namespace wrinkle
