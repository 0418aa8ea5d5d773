#include "image/oiio/exr_file.h"

#include <libdeflate.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <utility>

#include "image/codec_support.h"

namespace wrinkle::oiio {

using codec::Failure;

namespace {

constexpr int part = 0;
constexpr size_t short_name = 31;  // longer names need a flag in the header

constexpr std::array<std::pair<std::string_view, exr_compression_t>, 5> compressions = {{
    {"none", EXR_COMPRESSION_NONE},
    {"rle", EXR_COMPRESSION_RLE},
    {"zips", EXR_COMPRESSION_ZIPS},
    {"zip", EXR_COMPRESSION_ZIP},
    {"piz", EXR_COMPRESSION_PIZ},
}};

exr_compression_t compression_named(std::string_view name) {
    for (const auto& each : compressions)
        if (each.first == name) return each.second;
    throw Failure("OpenEXR has no compression '" + std::string(name) + "'");
}

void check(exr_result_t result) {
    if (result != EXR_ERR_SUCCESS) throw Failure(exr_get_default_error_message(result));
}

void say_nothing(exr_const_context_t, exr_result_t, const char*) {}

int64_t write_to_file(exr_const_context_t, void* file, const void* bytes, uint64_t size,
                      uint64_t offset, exr_stream_error_func_ptr_t) {
    const size_t written =
        static_cast<OutputFile*>(file)->pwrite(bytes, size, static_cast<int64_t>(offset));
    return written == size ? static_cast<int64_t>(size) : -1;
}

bool any_long_name(const WriterOptions& options) {
    const auto is_long = [](const std::string& name) { return name.size() > short_name; };
    return std::ranges::any_of(options.channels, is_long) ||
           std::ranges::any_of(options.numbers, is_long, &ImageNumber::name);
}

// On slope maps within 4 % of the size of zlib level 4, OpenEXR's default, and three times as fast.
constexpr int zip_level = 1;

struct FreeCompressor {
    void operator()(libdeflate_compressor* compressor) const {
        libdeflate_free_compressor(compressor);
    }
};

libdeflate_compressor* compressor_of_thread() {
    thread_local const std::unique_ptr<libdeflate_compressor, FreeCompressor> the(
        libdeflate_alloc_compressor(zip_level));
    if (!the) throw std::bad_alloc();
    return the.get();
}

uint8_t difference(uint8_t value, uint8_t before) {
    return static_cast<uint8_t>(value - before + 128);
}

// Precondition: the size is even and not 0, as for all chunks of OpenEXR.
void split_and_differ(std::span<const std::byte> packed, std::vector<uint8_t>& out) {
    const auto* in = reinterpret_cast<const uint8_t*>(packed.data());
    const size_t half = packed.size() / 2;
    out.resize(packed.size());
    uint8_t *even = out.data(), *odd = even + half;
    even[0] = in[0];
    odd[0] = difference(in[1], in[packed.size() - 2]);
    for (size_t i = 1; i < half; ++i) {
        even[i] = difference(in[2 * i], in[2 * i - 2]);
        odd[i] = difference(in[2 * i + 1], in[2 * i - 1]);
    }
}

// OpenEXR's zip compression: bytes with even indices before those with odd ones, each replaced by
// its difference from the previous one (+ 128), as a zlib stream. Returns false if the stream would
// not be shorter; the file then stores `packed`.
bool zip(std::span<const std::byte> packed, std::vector<std::byte>& compressed) {
    thread_local std::vector<uint8_t> differences;
    split_and_differ(packed, differences);
    compressed.resize(packed.size() - 1);
    const size_t size =
        libdeflate_zlib_compress(compressor_of_thread(), differences.data(), differences.size(),
                                 compressed.data(), compressed.size());
    compressed.resize(size);
    return size > 0;
}

}  // namespace

// Ignores errors: a file without its last chunks is discarded, and errors were reported before.
void ExrFile::FinishContext::operator()(exr_context_t context) const {
    exr_finish(&context);
}

ExrFile::ExrFile(OutputFile& file, const char* path, const WriterOptions& options, bool mips)
    : compression_(compression_named(options.compression)),
      width_(options.width),
      height_(options.height),
      tile_(options.tile),
      threads_(static_cast<int>(options.threads)) {
    exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
    start.error_handler_fn = say_nothing;
    start.write_fn = write_to_file;
    start.user_data = &file;
    exr_context_t context = nullptr;
    check(exr_start_write(&context, path, EXR_WRITE_FILE_DIRECTLY, &start));
    context_.reset(context);
    declare(options, mips);
    check(exr_write_header(context));
    sort_channels(options);
    int32_t rows = static_cast<int32_t>(tile_);
    if (tile_ == 0) check(exr_get_scanlines_per_chunk(context, part, &rows));
    rows_per_chunk_ = static_cast<uint32_t>(rows);
}

void ExrFile::declare(const WriterOptions& options, bool mips) {
    const exr_context_t context = context_.get();
    int index = part;
    if (any_long_name(options)) check(exr_set_longname_support(context, 1));
    check(exr_add_part(context, nullptr, tile_ > 0 ? EXR_STORAGE_TILED : EXR_STORAGE_SCANLINE,
                       &index));
    check(exr_initialize_required_attr_simple(context, part, static_cast<int32_t>(width_),
                                              static_cast<int32_t>(height_), compression_));
    declare_channels(options);
    for (const ImageNumber& number : options.numbers)
        check(exr_attr_set_float(context, part, number.name.c_str(), number.value));
    if (tile_ == 0) return;
    check(exr_set_tile_descriptor(context, part, tile_, tile_,
                                  mips ? EXR_TILE_MIPMAP_LEVELS : EXR_TILE_ONE_LEVEL,
                                  EXR_TILE_ROUND_DOWN));
    if (!mips) return;
    check(exr_set_lineorder(context, part, EXR_LINEORDER_RANDOM_Y));
    check(exr_attr_set_string(context, part, "textureformat", "Plain Texture"));
}

void ExrFile::declare_channels(const WriterOptions& options) {
    const bool half = options.type == PixelType::half;
    value_bytes_ = half ? 2 : 4;
    for (const std::string& name : options.channels)
        check(exr_add_channel(context_.get(), part, name.c_str(),
                              half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT, EXR_PERCEPTUALLY_LOGARITHMIC,
                              1, 1));
}

void ExrFile::sort_channels(const WriterOptions& options) {
    const exr_attr_chlist_t* sorted = nullptr;
    check(exr_get_channels(context_.get(), part, &sorted));
    const std::vector<std::string>& names = options.channels;
    for (int c = 0; c < sorted->num_channels; ++c) {
        const auto found = std::ranges::find(names, sorted->entries[c].name.str);
        order_.push_back(static_cast<uint32_t>(found - names.begin()));
    }
}

// Sets the range of `slot` to chunk `index` of the rows, counted from left to right and from
// the top down.
void ExrFile::locate(const Rows& rows, uint32_t index, Slot& slot) const {
    const uint32_t step = tile_ > 0 ? tile_ : rows.width;
    const uint32_t y = index / rows.across * rows_per_chunk_;
    slot.x = index % rows.across * step;
    slot.y = rows.first + y;
    slot.width = std::min(step, rows.width - slot.x);
    slot.height = std::min(rows_per_chunk_, rows.count - y);
    slot.texels = rows.texels + y * rows.bytes + slot.x * texel_bytes();
}

// Encodes with OpenEXR's library, but compresses by zip(). The library's sizes of border tiles are
// wrong for all levels but the first, so the sizes are set here.
void ExrFile::encode(const Rows& rows, Slot& slot) const {
    const exr_context_t context = context_.get();
    exr_chunk_info_t info = {};
    check(tile_ > 0 ? exr_write_tile_chunk_info(context, part, slot.x / tile_, slot.y / tile_,
                                                rows.level, rows.level, &info)
                    : exr_write_scanline_chunk_info(context, part, slot.y, &info));
    info.width = slot.width;
    info.height = slot.height;
    info.unpacked_size = size_t{slot.width} * slot.height * texel_bytes();
    exr_encode_pipeline_t pipeline = {};
    check(exr_encoding_initialize(context, part, &info, &pipeline));
    for (int c = 0; c < pipeline.channel_count; ++c) {
        exr_coding_channel_info_t& channel = pipeline.channels[c];
        channel.user_pixel_stride = static_cast<int32_t>(texel_bytes());
        channel.user_line_stride = static_cast<int32_t>(rows.bytes);
        channel.encode_from_ptr =
            reinterpret_cast<const uint8_t*>(slot.texels) + order_[c] * value_bytes_;
    }
    exr_result_t result = exr_encoding_choose_default_routines(context, part, &pipeline);
    const bool zips = compression_ == EXR_COMPRESSION_ZIP || compression_ == EXR_COMPRESSION_ZIPS;
    if (zips) pipeline.compress_fn = nullptr;
    pipeline.yield_until_ready_fn = nullptr;
    pipeline.write_fn = nullptr;  // put() writes the chunk, in order
    if (result == EXR_ERR_SUCCESS) result = exr_encoding_run(context, part, &pipeline);
    if (result == EXR_ERR_SUCCESS) {
        const std::span encoded(static_cast<const std::byte*>(pipeline.compressed_buffer),
                                pipeline.compressed_bytes);
        if (!zips || !zip(encoded, slot.stored)) slot.stored.assign(encoded.begin(), encoded.end());
    }
    exr_encoding_destroy(context, &pipeline);
    check(result);
}

void ExrFile::put(const Rows& rows, const Slot& slot) {
    const exr_context_t context = context_.get();
    check(tile_ > 0
              ? exr_write_tile_chunk(context, part, slot.x / tile_, slot.y / tile_, rows.level,
                                     rows.level, slot.stored.data(), slot.stored.size())
              : exr_write_scanline_chunk(context, part, slot.y, slot.stored.data(),
                                         slot.stored.size()));
}

// A slot is reused after its chunk is written: at most slots_.size() chunks are in flight.
void ExrFile::put_all(const Rows& rows) {
    const uint32_t chunks = (rows.count + rows_per_chunk_ - 1) / rows_per_chunk_ * rows.across;
    slots_.resize(2 * static_cast<size_t>(tbb::this_task_arena::max_concurrency()));
    uint32_t next = 0;
    const auto take = [&](tbb::flow_control& control) -> Slot* {
        if (next == chunks) {
            control.stop();
            return nullptr;
        }
        Slot& slot = slots_[next % slots_.size()];
        locate(rows, next++, slot);
        return &slot;
    };
    const auto encode_one = [&](Slot* slot) {
        encode(rows, *slot);
        return slot;
    };
    const auto put_one = [&](Slot* slot) { put(rows, *slot); };
    using tbb::filter_mode;
    tbb::parallel_pipeline(
        slots_.size(), tbb::make_filter<void, Slot*>(filter_mode::serial_in_order, take) &
                           tbb::make_filter<Slot*, Slot*>(filter_mode::parallel, encode_one) &
                           tbb::make_filter<Slot*, void>(filter_mode::serial_in_order, put_one));
}

void ExrFile::write(uint32_t level, const std::byte* texels, uint32_t first, uint32_t count) {
    Rows rows{level, first, count, texels, std::max(1u, width_ >> level), 1, 0};
    if (tile_ > 0) rows.across = (rows.width + tile_ - 1) / tile_;
    rows.bytes = rows.width * texel_bytes();
    if (threads_ == 0) return put_all(rows);
    tbb::task_arena(threads_).execute([&] { put_all(rows); });
}

void ExrFile::close() {
    exr_context_t context = context_.release();
    check(exr_finish(&context));
}

}  // namespace wrinkle::oiio
