#include "editor/view/panels/listing.h"

#include <algorithm>
#include <cstring>
#include <deque>
#include <fstream>
#include <set>
#include "editor/view/panels/search.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

bool has_extension(const std::string& name, std::span<const std::string> extensions) {
    const std::string own = lower_case(fs::path(name).extension().string());
    return extensions.empty() || std::ranges::find(extensions, own) != extensions.end();
}

bool is_image(const fs::path& file) {
    constexpr std::string_view known[] = {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".hdr"};
    return std::ranges::find(known, file.extension().string()) != std::end(known);
}

bool is_graph(const fs::path& file) {
    std::error_code ignored;
    if (file.extension() != ".json" || file.stem().has_extension()) return false;
    if (!fs::is_regular_file(file, ignored)) return false;  // reading a pipe would wait
    char start[512] = "";
    std::ifstream(file, std::ios::binary).read(start, sizeof start - 1);
    return std::string_view(start).find("\"wrinkle\"") != std::string_view::npos;
}

// Breadth-first, so that the limits drop the files deepest below `folder`.
std::vector<std::string> files_below(const fs::path& folder, bool (*wanted)(const fs::path&),
                                     size_t limit, size_t max_entries) {
    std::vector<std::string> files;
    std::deque<fs::path> folders{folder};
    size_t entries = 0;
    for (; !folders.empty() && files.size() < limit && entries < max_entries; folders.pop_front()) {
        std::set<fs::path> inner, found;
        std::error_code error, ignored;
        for (fs::directory_iterator at(folders.front(), error), end; !error && at != end;
             at.increment(error)) {
            if (++entries > max_entries) break;
            if (at->path().filename().native().starts_with('.')) continue;
            if (at->is_directory(ignored) && !at->is_symlink(ignored))
                inner.insert(at->path());
            else if (wanted(at->path()))
                found.insert(at->path());
        }
        folders.insert(folders.end(), inner.begin(), inner.end());
        for (const fs::path& file : found)
            if (files.size() < limit)
                files.push_back(file.lexically_relative(folder).generic_string());
    }
    std::ranges::sort(files);
    return files;
}

}  // namespace

bool name_before(std::string_view a, std::string_view b) {
    const int order = strverscmp(lower_case(a).c_str(), lower_case(b).c_str());
    return order == 0 ? a < b : order < 0;
}

Listing list_folder(const fs::path& folder, std::span<const std::string> extensions) {
    Listing listing;
    std::error_code error, ignored;
    fs::directory_iterator at(folder, error);
    for (; !error && at != fs::directory_iterator(); at.increment(error)) {
        Entry entry{at->path().filename().string(), at->is_directory(ignored)};
        if (entry.name.starts_with('.')) continue;
        if (!entry.folder && !has_extension(entry.name, extensions)) continue;
        listing.entries.push_back(std::move(entry));
        if (listing.entries.size() < Listing::max_entries) continue;
        listing.error_text = "Only the first " + std::to_string(Listing::max_entries) +
                             " entries are listed. Type a name to go to the others.";
        break;
    }
    if (error) listing.error_text = folder.string() + " cannot be read: " + error.message() + ".";
    std::ranges::sort(listing.entries, [](const Entry& a, const Entry& b) {
        return a.folder != b.folder ? a.folder : name_before(a.name, b.name);
    });
    return listing;
}

std::vector<size_t> filtered(const Listing& listing, std::string_view query) {
    return find_matches(listing.entries, &Entry::name, query);
}

std::vector<std::string> image_files(const fs::path& folder, size_t limit, size_t max_entries) {
    return files_below(folder, is_image, limit, max_entries);
}

std::vector<std::string> graph_files(const fs::path& folder, size_t limit, size_t max_entries) {
    return files_below(folder, is_graph, limit, max_entries);
}

}  // namespace wrinkle::editor
