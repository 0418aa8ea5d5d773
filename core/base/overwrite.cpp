#include <sys/stat.h>

#include <map>
#include <optional>
#include <tuple>

#include "base/file.h"

namespace wrinkle {
namespace {

// Device and inode of a file; for a file that does not exist yet, its resolved path.
using FileId = std::tuple<dev_t, ino_t, std::string>;

std::optional<FileId> id_of(const std::string& path) {
    if (path == "-") return {};
    struct stat found {};
    if (stat(path.c_str(), &found) != 0) return FileId{0, 0, real_path(link_target(path)).string()};
    if (!S_ISREG(found.st_mode)) return {};
    return FileId{found.st_dev, found.st_ino, ""};
}

}  // namespace

std::string overwrite_fault(std::span<const std::string> outputs,
                            std::span<const std::string> inputs) {
    std::map<FileId, const std::string*> written;
    for (const std::string& output : outputs) {
        const auto id = id_of(output);
        if (!id) continue;
        const auto [other, fresh] = written.emplace(*id, &output);
        if (!fresh)
            return "two outputs would be written to one file: " + *other->second + " and " + output;
    }
    for (const std::string& input : inputs) {
        const auto id = id_of(input);
        const auto output = id ? written.find(*id) : written.end();
        if (output == written.end()) continue;
        const std::string& name = *output->second;
        return "the output " + name + " would replace the input " +
               (name == input ? "with its name" : input) + "; choose another name";
    }
    return {};
}

}  // namespace wrinkle
