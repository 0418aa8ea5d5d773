#include <algorithm>
#include <deque>
#include <set>

#include "editor/view/panels/popups.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;

// Breadth-first, so that the limits drop the files deepest below `folder`.
std::vector<std::string> image_files(const fs::path& folder, size_t limit, size_t max_entries) {
    constexpr std::string_view known[] = {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".hdr"};
    std::vector<std::string> files;
    std::deque<fs::path> folders{folder};
    size_t entries = 0;
    for (; !folders.empty() && files.size() < limit && entries < max_entries; folders.pop_front()) {
        std::set<fs::path> inner, images;
        std::error_code error, ignored;
        for (fs::directory_iterator at(folders.front(), error), end; !error && at != end;
             at.increment(error)) {
            if (++entries > max_entries) break;
            const std::string extension = at->path().extension().string();
            if (at->is_directory(ignored) && !at->is_symlink(ignored))
                inner.insert(at->path());
            else if (std::find(std::begin(known), std::end(known), extension) != std::end(known))
                images.insert(at->path());
        }
        folders.insert(folders.end(), inner.begin(), inner.end());
        for (const fs::path& image : images)
            if (files.size() < limit)
                files.push_back(image.lexically_relative(folder).generic_string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace wrinkle::editor
