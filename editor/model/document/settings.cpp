#include "editor/model/document/settings.h"

#include <algorithm>

#include "bake/bake.h"
#include "base/file.h"
#include "base/text.h"
#include "json/parse.h"
#include "json/write.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

using json::Kind;
using json::Value;

fs::path settings_file(const Folders& folders) {
    return folders.config / "settings.json";
}

// Visits every field with its name and valid range.
template <class S, class Visitor>
void each_setting(S& settings, Visitor&& visit) {
    visit("width", settings.width, 320, 16384);
    visit("height", settings.height, 240, 16384);
    visit("side", settings.side, 0.0F, 0.9F);
    visit("preview", settings.preview, 0.0F, 0.9F);
    visit("problems", settings.problems, 0.0F, 0.9F);
    visit("scale", settings.scale, 1.0F, 3.0F);
    visit("theme", settings.theme, 0, 32);
    visit("recent", settings.recent, Settings::max_recent);
    visit("dismissed", settings.dismissed, Settings::max_dismissed);
    visit("favorites", settings.favorites, Settings::max_favorites);
    visit("host", settings.host, 0, 32);
    visit("bake_maps", settings.bake.maps, 0, 4096);
    visit("bake_size", settings.bake.width, uint32_t{1}, max_baked_side);
    visit("bake_height", settings.bake.square_or_height, uint32_t{0}, max_baked_side);
    visit("bake_space", settings.bake.space, 0, 32);
    visit("bake_green", settings.bake.green, 0, 32);
    visit("bake_stored", settings.bake.stored, 0, 32);
    visit("bake_udim", settings.bake.udim, false, true);
    visit("bake_packs", settings.bake.packs, 0, 4096);
    auto& tuning = settings.bake.tuning;
    visit("bake_scale", tuning.scale, 1e-30, 1e30);
    visit("bake_samples", tuning.samples, uint32_t{1}, bake_sample_counts.back());
    visit("bake_dilate", tuning.dilate, uint32_t{0}, max_dilation);
    visit("bake_compression", tuning.compression, 0, 32);
    visit("bake_tile", tuning.tile, uint32_t{0}, max_bake_tile);
}

// Return true if the value is valid; then `field` receives it.
template <class Number>
bool read_field(const Value& value, Number& field, Number low, Number high) {
    const bool fits = value.is(Kind::number) && value.as_number() >= double(low) &&
                      value.as_number() <= double(high);
    if (fits) field = static_cast<Number>(value.as_number());
    return fits;
}
bool read_field(const Value& value, std::string& field, int, int longest) {
    const bool fits =
        value.is(Kind::string) && value.as_string().size() <= static_cast<size_t>(longest);
    if (fits) field = value.as_string();
    return fits;
}
template <class Text>
bool read_field(const Value& value, std::vector<Text>& field, size_t most) {
    for (const json::Member& item : value.children())
        if (item.value.is(Kind::string) && field.size() < most)
            field.emplace_back(item.value.as_string());
    return value.is(Kind::array);
}

template <class Number>
Value json_of(const Number& field) {
    return Value::number(field);
}
Value json_of(float field) {
    return Value::single(field);
}
Value json_of(const std::string& field) {
    return Value::string(field);
}
template <class Text>
Value json_of(const std::vector<Text>& field) {
    std::vector<Value> items;
    for (const Text& each : field) {  // JSON can store only UTF-8 names
        const std::string text(each);
        if (is_utf8(text)) items.push_back(Value::string(text));
    }
    return Value::array(items);
}

}  // namespace

Settings read_settings(const Folders& folders, std::string& error_text) {
    Settings settings;
    std::string why;
    std::error_code error;
    const fs::path file = settings_file(folders);
    if (folders.config.empty() || !fs::exists(file, error)) return settings;
    const auto text = read_file(file, why);
    if (!text) {
        error_text = file.string() + " " + why + ". The editor begins with its own settings.";
        return settings;
    }
    Diagnostics problems;
    const json::Parsed parsed = json::parse(*text, file.string(), problems);
    if (!parsed.complete || !parsed.root.is(Kind::object)) {
        fs::path kept = file;
        kept += ".bak";
        fs::rename(file, kept, error);
        error_text = file.string() + " is damaged. It is kept as " + kept.filename().string() +
                     ", and the editor begins with its own settings.";
        return settings;
    }
    std::string unusable;
    each_setting(settings, [&](const char* name, auto& field, auto... range) {
        if (!read_field(parsed.root.find(name), field, range...) && parsed.root.has(name))
            unusable += (unusable.empty() ? "" : ", ") + std::string(name);
    });
    if (!unusable.empty())
        error_text = file.string() + ": " + unusable + " cannot be used as written there.";
    return settings;
}

std::string write_settings(const Folders& folders, const Settings& settings) {
    if (folders.config.empty()) return {};
    std::vector<std::pair<std::string, Value>> members;
    each_setting(settings, [&](const char* name, const auto& field, auto...) {
        members.emplace_back(name, json_of(field));
    });
    std::error_code error;
    fs::create_directories(folders.config, error);
    if (!error)
        error =
            write_file_synced(settings_file(folders), json::pretty(Value::object(members)) + "\n");
    return error ? disk_words(error) : "";
}

void remember_recent(const Folders& folders, Settings& settings, const fs::path& file) {
    std::string ignored;
    if (!folders.config.empty()) {
        std::vector<fs::path> all = read_settings(folders, ignored).recent;
        for (const fs::path& known :
             settings.recent)  // the list on disk is empty if the file cannot be written
            if (std::ranges::find(all, known) == all.end()) all.push_back(known);
        settings.recent = std::move(all);
    }
    std::error_code error;
    fs::path absolute = real_path(file, error);
    if (error) absolute = file;
    std::erase(settings.recent, absolute);
    settings.recent.insert(settings.recent.begin(), absolute);
    if (settings.recent.size() > Settings::max_recent) settings.recent.resize(Settings::max_recent);
    write_settings(folders, settings);
}

}  // namespace wrinkle::editor
