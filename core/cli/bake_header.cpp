#include "cli/bake_header.h"

#include <algorithm>
#include <tuple>

#include "base/checksum.h"
#include "base/text.h"
#include "cli/arguments.h"
#include "json/parse.h"
#include "json/write.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view before_sum = ",\n  \"sum\": \"", after_sum = "\"\n}\n";

bool has_right_sum(const std::string& text) {
    const size_t end = text.rfind(before_sum);
    return end != text.npos && with_sum(text.substr(0, end)) == text;
}

std::string map_json(const PartHeader::Map& map) {
    const WriterOptions& w = map.writer;
    std::string numbers = "{";
    for (const ImageNumber& number : w.numbers)
        numbers += (numbers.size() > 1 ? ", " : "") + json_quoted(number.name) + ": " +
                   shortest(number.value);
    return "{\"name\": " + json_quoted(map.name) +
           ", \"extension\": " + json_quoted(map.extension) +
           ", \"channels\": " + json::string_array(w.channels) +
           ", \"alpha\": " + (w.has_alpha ? "true" : "false") +
           ", \"type\": " + json_quoted(name_of(w.type)) +
           ", \"compression\": " + json_quoted(w.compression) +
           ", \"tile\": " + std::to_string(w.tile) + ", \"numbers\": " + numbers + "}}";
}

// Numbers are stored as strings, because some may be infinite.
std::string report_json(const BakeReport& found) {
    std::vector<std::string> words = {std::to_string(found.overlapped),
                                      shortest(found.overlap_uv.x), shortest(found.overlap_uv.y),
                                      std::to_string(found.overlap_triangle),
                                      std::to_string(found.not_finite)};
    for (const Clamped& lost : found.clamped)
        words.insert(words.end(),
                     {std::to_string(lost.numbers), shortest(lost.least), shortest(lost.greatest)});
    return json::string_array(words);
}

// Thrown and caught in this file.
struct InvalidHeader {};

void require(bool valid) {
    if (!valid) throw InvalidHeader();
}

// Reads the values of a header; throws InvalidHeader if a value is missing or invalid.
namespace read {

json::Value item(const json::Value& from, std::string_view key, json::Kind kind) {
    require(from.is(json::Kind::object));
    const json::Value value = from.find(key);
    require(value.is(kind));
    return value;
}

std::string text(const json::Value& from, std::string_view key) {
    return std::string(item(from, key, json::Kind::string).as_string());
}

uint64_t whole(const json::Value& value) {
    require(value.is(json::Kind::number) && value.as_number() >= 0 && value.as_number() < 1e15);
    return static_cast<uint64_t>(value.as_number());
}

std::vector<std::string> texts(const json::Value& from, std::string_view key) {
    std::vector<std::string> list;
    for (const json::Member& member : item(from, key, json::Kind::array).children()) {
        require(member.value.is(json::Kind::string));
        list.emplace_back(member.value.as_string());
    }
    return list;
}

std::pair<uint64_t, uint64_t> pair(const json::Value& from, std::string_view key) {
    const json::Value values = item(from, key, json::Kind::array);
    require(values.size() == 2);
    return {whole(values.at(0)), whole(values.at(1))};
}

BakeReport report(const json::Value& from) {
    const std::vector<std::string> words = texts(from, "found");
    require(words.size() >= 5 && words.size() % 3 == 2);
    BakeReport found;
    const auto number = [&](size_t i, auto& value) { require(parse_number(words[i], value)); };
    number(0, found.overlapped);
    number(1, found.overlap_uv.x);
    number(2, found.overlap_uv.y);
    number(3, found.overlap_triangle);
    number(4, found.not_finite);
    for (size_t i = 5; i < words.size(); i += 3) {
        Clamped& lost = found.clamped.emplace_back();
        number(i, lost.numbers);
        number(i + 1, lost.least);
        number(i + 2, lost.greatest);
    }
    return found;
}

PartHeader::Map map(const json::Value& from) {
    PartHeader::Map map{text(from, "name"), text(from, "extension"), {}};
    WriterOptions& w = map.writer;
    w.channels = texts(from, "channels");
    w.has_alpha = item(from, "alpha", json::Kind::boolean).as_boolean();
    w.compression = text(from, "compression");
    w.tile = static_cast<uint32_t>(whole(item(from, "tile", json::Kind::number)));
    const auto type = pixel_type_named(text(from, "type"));
    require(type && !w.channels.empty());
    w.type = *type;
    for (const json::Member& number : item(from, "numbers", json::Kind::object).children())
        if (number.value.is(json::Kind::number))
            w.numbers.push_back(
                {std::string(number.key), static_cast<float>(number.value.as_number())});
    return map;
}

PartHeader header(const json::Value& root) {
    PartHeader header;
    header.identity = text(root, "identity");
    std::tie(header.shard, header.shards) = pair(root, "shard");
    std::tie(header.first, header.last) = pair(root, "rows_of_tiles");
    header.sets = texts(root, "sets");
    header.done = whole(item(root, "done", json::Kind::number));
    header.found = report(root);
    header.sums = texts(root, "sums");
    const auto [width, height] = pair(root, "size");
    require(width > 0 && height > 0 && width <= 65536 && height <= 65536);
    // Names and suffixes become parts of paths and must not contain '/'.
    const auto is_name = [](const std::string& text) { return text.find('/') == text.npos; };
    require(std::ranges::all_of(header.sets, is_name));
    for (const json::Member& member : item(root, "maps", json::Kind::array).children()) {
        PartHeader::Map& map = header.maps.emplace_back(read::map(member.value));
        map.writer.width = static_cast<uint32_t>(width);
        map.writer.height = static_cast<uint32_t>(height);
        require(is_name(map.name) && is_name(map.extension));
    }
    require(!header.maps.empty() && header.first <= header.done && header.done <= header.last &&
            header.last <= header.sets.size() * uint64_t{header.bands()} &&
            header.sums.size() == header.files_with_rows());
    return header;
}

}  // namespace read
}  // namespace

size_t PartHeader::row_bytes(size_t map) const {
    const WriterOptions& w = maps[map].writer;
    return size_t{w.width} * w.channels.size() * bytes_of(w.type);
}

uint64_t PartHeader::bytes_of_rows(size_t set, size_t map) const {
    uint64_t rows = 0;
    const uint64_t end = std::min(done, (set + 1) * uint64_t{bands()});
    for (uint64_t band = std::max(first, set * uint64_t{bands()}); band < end; ++band)
        rows += rows_of(band);
    return rows * row_bytes(map);
}

uint32_t PartHeader::rows_of(uint64_t band) const {
    const auto in_set = static_cast<uint32_t>(band % bands());
    return std::min(bake_tile, height() - in_set * bake_tile);
}

std::vector<MapFile> PartHeader::files(const std::string& output, size_t set,
                                       uint32_t threads) const {
    std::vector<MapFile> files;
    for (const Map& map : maps) {
        const bool one_file = maps.size() == 1;
        const std::string extension =
            one_file ? fs::path(output).extension().string() : map.extension;
        files.push_back({map_path(output, one_file, map.name, sets[set], extension), map.writer});
        files.back().options.threads = threads;
    }
    return files;
}

std::string with_sum(std::string text) {
    const std::string sum = sha256(text);
    return std::move(text.append(before_sum).append(sum).append(after_sum));
}

std::string header_json(const PartHeader& header) {
    std::string maps;
    for (const PartHeader::Map& map : header.maps)
        maps += (maps.empty() ? "\n    " : ",\n    ") + map_json(map);
    std::string text =
        "{\n  \"wrinkle_bake\": 2,\n  \"identity\": " + json_quoted(header.identity) +
        ",\n  \"shard\": [" + std::to_string(header.shard) + ", " + std::to_string(header.shards) +
        "],\n  \"size\": [" + std::to_string(header.width()) + ", " +
        std::to_string(header.height()) + "],\n  \"maps\": [" + maps +
        "],\n  \"sets\": " + json::string_array(header.sets) + ",\n  \"rows_of_tiles\": [" +
        std::to_string(header.first) + ", " + std::to_string(header.last) +
        "],\n  \"done\": " + std::to_string(header.done) +
        ",\n  \"sums\": " + json::string_array(header.sums) +
        ",\n  \"found\": " + report_json(header.found);
    return with_sum(std::move(text));
}

std::optional<PartHeader> header_of_json(const std::string& text) {
    Diagnostics ignored;
    if (!has_right_sum(text)) return {};
    try {
        return read::header(json::parse(text, "bake.json", ignored).root);
    } catch (const InvalidHeader&) {
        return {};
    }
}

}  // namespace wrinkle::cli
