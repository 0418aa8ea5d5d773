#include "cli/bake_parts.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>

#include "bake/file_problem.h"
#include "base/file.h"
#include "base/text.h"
#include "json/parse.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

std::string quoted_list(const std::vector<std::string>& words) {
    std::string text = "[";
    for (const std::string& word : words)
        text += (text.size() > 1 ? ", " : "") + json_quoted(word);
    return text + "]";
}

std::string map_json(const PartHeader::Map& map) {
    const WriterOptions& w = map.writer;
    std::string numbers = "{";
    for (const ImageNumber& number : w.numbers)
        numbers += (numbers.size() > 1 ? ", " : "") + json_quoted(number.name) + ": " +
                   shortest(number.value);
    return "{\"name\": " + json_quoted(map.name) +
           ", \"extension\": " + json_quoted(map.extension) +
           ", \"channels\": " + quoted_list(w.channels) +
           ", \"alpha\": " + (w.has_alpha ? "true" : "false") +
           ", \"type\": " + json_quoted(name_of(w.type)) +
           ", \"compression\": " + json_quoted(w.compression) +
           ", \"tile\": " + std::to_string(w.tile) + ", \"numbers\": " + numbers + "}}";
}

// Texts, as some of the numbers may be infinite.
std::string report_json(const BakeReport& found) {
    std::vector<std::string> words = {std::to_string(found.overlapped),
                                      shortest(found.overlap_uv.x), shortest(found.overlap_uv.y),
                                      std::to_string(found.overlap_triangle),
                                      std::to_string(found.not_finite)};
    for (const Clamped& lost : found.clamped)
        words.insert(words.end(),
                     {std::to_string(lost.numbers), shortest(lost.least), shortest(lost.greatest)});
    return quoted_list(words);
}

std::string header_json(const PartHeader& header) {
    std::string maps;
    for (const PartHeader::Map& map : header.maps)
        maps += (maps.empty() ? "\n    " : ",\n    ") + map_json(map);
    return "{\n  \"wrinkle_bake\": 1,\n  \"identity\": " + json_quoted(header.identity) +
           ",\n  \"shard\": [" + std::to_string(header.shard) + ", " +
           std::to_string(header.shards) + "],\n  \"size\": [" + std::to_string(header.width()) +
           ", " + std::to_string(header.height()) + "],\n  \"maps\": [" + maps +
           "],\n  \"pictures\": " + quoted_list(header.pictures) + ",\n  \"rows_of_tiles\": [" +
           std::to_string(header.first) + ", " + std::to_string(header.last) +
           "],\n  \"done\": " + std::to_string(header.done) +
           ",\n  \"found\": " + report_json(header.found) + "\n}\n";
}

// Values of a header; whatever does not fit leaves `fine` false.
struct HeaderReader {
    bool fine = true;

    json::Value item(const json::Value& from, std::string_view key, json::Kind kind) {
        const json::Value value = from.is(json::Kind::object) ? from.find(key) : json::Value();
        fine = fine && value.is(kind);
        return value;
    }
    std::string text(const json::Value& from, std::string_view key) {
        const json::Value value = item(from, key, json::Kind::string);
        return fine ? std::string(value.as_string()) : "";
    }
    bool flag(const json::Value& from, std::string_view key) {
        const json::Value value = item(from, key, json::Kind::boolean);
        return fine && value.as_boolean();
    }
    uint64_t whole(const json::Value& value) {
        fine = fine && value.is(json::Kind::number) && value.as_number() >= 0 &&
               value.as_number() < 1e15;
        return fine ? static_cast<uint64_t>(value.as_number()) : 0;
    }
    std::vector<std::string> texts(const json::Value& from, std::string_view key) {
        std::vector<std::string> list;
        const json::Value values = item(from, key, json::Kind::array);
        for (const json::Member& member : values.children()) {
            fine = fine && member.value.is(json::Kind::string);
            if (fine) list.emplace_back(member.value.as_string());
        }
        return list;
    }
    std::pair<uint64_t, uint64_t> pair(const json::Value& from, std::string_view key) {
        const json::Value values = item(from, key, json::Kind::array);
        fine = fine && values.size() == 2;
        return fine ? std::pair(whole(values.at(0)), whole(values.at(1)))
                    : std::pair<uint64_t, uint64_t>(0, 0);
    }
    BakeReport report(const json::Value& from) {
        const std::vector<std::string> words = texts(from, "found");
        fine = fine && words.size() >= 5 && words.size() % 3 == 2;
        BakeReport found;
        if (!fine) return found;
        const auto read = [&](size_t i, auto& number) {
            const char* end = words[i].data() + words[i].size();
            const auto [stop, problem] = std::from_chars(words[i].data(), end, number);
            fine = fine && problem == std::errc() && stop == end;
        };
        read(0, found.overlapped);
        read(1, found.overlap_uv.x);
        read(2, found.overlap_uv.y);
        read(3, found.overlap_triangle);
        read(4, found.not_finite);
        for (size_t i = 5; i < words.size(); i += 3) {
            Clamped& lost = found.clamped.emplace_back();
            read(i, lost.numbers);
            read(i + 1, lost.least);
            read(i + 2, lost.greatest);
        }
        return found;
    }
    PartHeader::Map map(const json::Value& from) {
        PartHeader::Map map{text(from, "name"), text(from, "extension"), {}};
        WriterOptions& w = map.writer;
        w.channels = texts(from, "channels");
        w.has_alpha = flag(from, "alpha");
        w.compression = text(from, "compression");
        w.tile = static_cast<uint32_t>(whole(item(from, "tile", json::Kind::number)));
        const std::string type = text(from, "type");
        bool known = false;
        for (const PixelType each :
             {PixelType::u8, PixelType::u16, PixelType::half, PixelType::float32})
            if (name_of(each) == type) {
                w.type = each;
                known = true;
            }
        for (const json::Member& number : item(from, "numbers", json::Kind::object).children())
            if (number.value.is(json::Kind::number))
                w.numbers.push_back(
                    {std::string(number.key), static_cast<float>(number.value.as_number())});
        fine = fine && known && !w.channels.empty();
        return map;
    }
};

std::optional<PartHeader> parse_header(const json::Value& root) {
    HeaderReader reader;
    PartHeader header;
    header.identity = reader.text(root, "identity");
    const auto shard = reader.pair(root, "shard");
    const auto size = reader.pair(root, "size");
    const auto bands = reader.pair(root, "rows_of_tiles");
    header.shard = static_cast<uint32_t>(shard.first);
    header.shards = static_cast<uint32_t>(shard.second);
    header.pictures = reader.texts(root, "pictures");
    header.first = bands.first;
    header.last = bands.second;
    header.done = reader.whole(reader.item(root, "done", json::Kind::number));
    header.found = reader.report(root);
    for (const json::Member& map : reader.item(root, "maps", json::Kind::array).children()) {
        header.maps.push_back(reader.map(map.value));
        header.maps.back().writer.width = static_cast<uint32_t>(size.first);
        header.maps.back().writer.height = static_cast<uint32_t>(size.second);
    }
    // They become parts of paths.
    const auto is_name = [](const std::string& text) { return text.find('/') == text.npos; };
    for (const PartHeader::Map& map : header.maps)
        reader.fine = reader.fine && is_name(map.name) && is_name(map.extension);
    reader.fine =
        reader.fine && std::all_of(header.pictures.begin(), header.pictures.end(), is_name);
    const bool sane = reader.fine && !header.maps.empty() && size.first > 0 && size.second > 0 &&
                      size.first <= 65536 && size.second <= 65536 && header.first <= header.done &&
                      header.done <= header.last &&
                      header.last <= header.pictures.size() * uint64_t{header.bands()};
    if (!sane) return {};
    return header;
}

}  // namespace

size_t PartHeader::row_bytes(size_t map) const {
    const WriterOptions& w = maps[map].writer;
    return size_t{w.width} * w.channels.size() * bytes_of(w.type);
}

uint32_t PartHeader::rows_of(uint64_t band) const {
    const auto in_picture = static_cast<uint32_t>(band % bands());
    return std::min(bake_tile, height() - in_picture * bake_tile);
}

std::vector<MapFile> PartHeader::files(const std::string& output, size_t picture,
                                       uint32_t threads) const {
    std::vector<MapFile> files;
    for (const Map& map : maps) {
        const bool one_file = maps.size() == 1;
        const std::string extension =
            one_file ? fs::path(output).extension().string() : map.extension;
        files.push_back(
            {map_path(output, one_file, map.name, pictures[picture], extension), map.writer});
        files.back().options.threads = threads;
    }
    return files;
}

PartHeader header_of(const BakeJob& job) {
    PartHeader header;
    header.identity = job.identity;
    header.shard = job.wishes.shard;
    header.shards = job.wishes.shards;
    for (size_t i = 0; i < job.wishes.maps.size(); ++i) {
        const WantedMap& wanted = job.wishes.maps[i];
        WriterOptions writer = writer_options(job.plans[0].maps[i], wanted.type, job.wishes.width,
                                              job.wishes.height, job.options.scale);
        writer.compression = job.options.compression;
        writer.tile = job.options.tile;
        header.maps.push_back({wanted.request.name, wanted.extension, std::move(writer)});
    }
    for (const BakePicture& picture : job.pictures)
        header.pictures.push_back(picture.suffix);
    const uint64_t all = header.pictures.size() * uint64_t{header.bands()};
    header.first = header.done = all * (header.shard - 1) / header.shards;
    header.last = all * header.shard / header.shards;
    return header;
}

std::optional<PartHeader> read_header(const fs::path& folder, Diagnostics& diagnostics) {
    const fs::path file = header_file(folder);
    std::string why;
    const auto text = read_file(file, why);
    if (!text) {
        diagnostics.add(
            file_problem(Severity::error, file.string(), why, "a folder that bake --shard wrote"));
        return {};
    }
    Diagnostics own;
    auto header = parse_header(json::parse(*text, file.string(), own).root);
    if (!header || own.has_errors()) {
        diagnostics.add(file_problem(Severity::error, file.string(),
                                     "does not tell of a part of a bake", "bake that shard again"));
        return {};
    }
    return header;
}

fs::path header_file(const fs::path& folder) {
    return folder / "bake.json";
}

fs::path rows_file(const fs::path& folder, size_t picture, size_t map) {
    return folder / (std::to_string(picture) + "-" + std::to_string(map) + ".rows");
}

std::optional<PartWriter> PartWriter::open(const fs::path& folder, PartHeader header, bool resume,
                                           Diagnostics& diagnostics) {
    std::error_code error;
    fs::create_directories(folder, error);
    Diagnostics ignored;
    const auto before = resume ? read_header(folder, ignored) : std::nullopt;
    if (before && before->identity == header.identity && before->shard == header.shard &&
        before->shards == header.shards) {
        header.done = before->done;
        header.found = before->found;
    }
    PartWriter writer;
    writer.folder_ = folder;
    writer.header_ = std::move(header);
    if (!writer.write_header(diagnostics)) return {};
    return writer;
}

bool PartWriter::fail(size_t map, Diagnostics& diagnostics) const {
    diagnostics.add(file_problem(Severity::error, rows_file(folder_, picture_, map).string(),
                                 "rows of the map '" + header_.maps[map].name +
                                     "' cannot be written: " + std::strerror(errno),
                                 "a folder that can be written to and has room"));
    return false;
}

bool PartWriter::write_header(Diagnostics& diagnostics) const {
    std::string why;
    if (write_file(header_file(folder_), header_json(header_), why)) return true;
    diagnostics.add(file_problem(Severity::error, header_file(folder_).string(), why, ""));
    return false;
}

bool PartWriter::begin(size_t picture, Diagnostics& diagnostics) {
    picture_ = picture;
    files_.clear();
    const uint64_t start = std::max(header_.first, picture * uint64_t{header_.bands()});
    uint64_t rows = 0;  // that are done of it
    for (uint64_t band = start; band < header_.done; ++band)
        rows += header_.rows_of(band);
    for (size_t map = 0; map < header_.maps.size(); ++map) {
        const fs::path path = rows_file(folder_, picture, map);
        const uint64_t kept = rows * header_.row_bytes(map);
        std::FILE* file = std::fopen(path.c_str(), kept > 0 ? "r+b" : "wb");
        if (!file) return fail(map, diagnostics);
        files_.emplace_back(file);
        // Rows that bake.json does not tell of are written again.
        if (std::fseek(file, static_cast<long>(kept), SEEK_SET) != 0) return fail(map, diagnostics);
    }
    return true;
}

bool PartWriter::rows(size_t map, std::span<const std::byte> bytes, Diagnostics& diagnostics) {
    std::FILE* file = files_[map].get();
    if (std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0)
        return true;
    return fail(map, diagnostics);
}

bool PartWriter::done(uint64_t bands, const BakeReport& found, Diagnostics& diagnostics) {
    header_.done = bands;
    header_.found = found;
    return write_header(diagnostics);
}

}  // namespace wrinkle::cli
