#include "registry/plugin_loader.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <set>

#include "base/file.h"
#include "base/file_log.h"
#include "base/folders.h"
#include "base/printable.h"
#include "base/text.h"
#include "registry/describe.h"
#include "registry/library.h"
#include "registry/plugin_code.h"

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

// Copy of a file without a directory entry; deleted with this object or at the end of the process.
class Copy {
public:
    explicit Copy(const std::string& path) {
        std::error_code error;
        std::string name = (fs::temp_directory_path(error) / "wrinkle-plugin-XXXXXX").string();
        file_ = mkostemp(name.data(), O_CLOEXEC);
        if (file_ < 0) return;
        fs::copy_file(path, name, fs::copy_options::overwrite_existing, error);
        unlink(name.c_str());
        if (!error) name_ = "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(file_);
    }
    Copy(const Copy&) = delete;
    Copy& operator=(const Copy&) = delete;
    ~Copy() {
        if (file_ >= 0) close(file_);
    }

    // Returns a path that is valid in every process of the user; "" on failure.
    const std::string& name() const { return name_; }

private:
    int file_ = -1;
    std::string name_;
};

class Loader {
public:
    Loader(Registry& registry, Diagnostics& diagnostics, const PluginOptions& options)
        : registry_(registry), diagnostics_(diagnostics), options_(options) {}

    void load(const std::string& name) {
        log_input(name);
        std::error_code error;
        const fs::file_status status = fs::status(name, error);
        if (!fs::exists(status)) {
            print_error(name, "there is no such plugin or folder");
        } else if (fs::is_directory(status)) {
            folder(name);
        } else {
            file(name, Severity::error);
        }
    }

    std::vector<PluginReport> take_reports() { return std::move(reports_); }

private:
    void folder(const std::string& name) {
        std::error_code error;
        std::vector<std::string> files;
        fs::directory_iterator entry(name, error);
        for (; !error && entry != fs::directory_iterator(); entry.increment(error))
            if (entry->path().extension() == ".so") files.push_back(entry->path().string());
        if (error) return print_error(name, "the folder cannot be read: " + error.message());
        std::ranges::sort(files);
        for (const std::string& path : files)
            file(path, Severity::warning);
    }

    void file(const std::string& path, Severity severity) {
        log_input(path);
        std::error_code error;
        const fs::path real = fs::canonical(path, error);
        if (!seen_.insert(error ? fs::path(path) : real).second) return;
        PluginReport report{.path = path};
        Diagnostics problems;
        if (!take(error ? path : real.string(), report, problems)) {
            report.state = PluginReport::State::refused;
            if (keep_former(path)) add_fault(problems, path, "its nodes loaded before remain");
        }
        for (Diagnostic problem : problems.list()) {
            if (problem.severity == Severity::error) {
                problem.severity = severity;
                report.why += (report.why.empty() ? "" : "; ") + without_location(problem);
            }
            diagnostics_.add(std::move(problem));
        }
        reports_.push_back(std::move(report));
    }

    static std::string without_location(Diagnostic problem) {
        problem.where = {};
        const std::string text = to_text(problem);
        return text.substr(text.find(": ") + 2);
    }

    bool take(const std::string& real, PluginReport& report, Diagnostics& problems) {
        std::string why;
        if (!open_to_read(real, why)) {
            add_fault(problems, report.path, std::string(cannot_be_loaded) + ": it " + why);
            return false;
        }
        if (!options_.copies) return take({real, real, report.path, {}}, report, problems);
        const auto copy = std::make_shared<const Copy>(real);
        if (copy->name().empty()) return take({real, real, report.path, {}}, report, problems);
        Diagnostics of_the_copy;
        if (take({copy->name(), real, report.path, copy}, report, of_the_copy)) {
            problems.append(of_the_copy);
            return true;
        }
        const bool only_there = of_the_copy.list().back().message.starts_with(cannot_be_loaded);
        if (only_there) return take({real, real, report.path, {}}, report, problems);
        problems.append(of_the_copy);
        return false;
    }

    bool take(const PluginFile& file, PluginReport& report, Diagnostics& problems) {
        const auto refuse = [&](std::string message, std::string expected) {
            add_fault(problems, report.path, std::move(message), std::move(expected));
            return false;
        };
        auto described = describe_plugin(file, {options_.cache, options_.limit}, problems);
        if (!described) return false;
        PluginListing& listing = described->listing;
        report.id = listing.id;
        report.version = listing.version;
        report.by_manifest = described->by == DescribedBy::manifest;
        report.nodes.clear();
        for (const NodeType& type : listing.types)
            report.nodes.push_back(type.id);
        const auto other = ids_.find(listing.id);
        if (other != ids_.end())
            return refuse(
                "the plugin id '" + listing.id + "' is taken: " + other->second + " has it",
                "remove one of them");
        // A cache entry was not made from this copy, so the copy is not known to load.
        const bool tried = described->by == DescribedBy::probe ||
                           (described->by == DescribedBy::cache && !options_.copies);
        const auto code = std::make_shared<PluginCode>(file, listing, tried, options_.limit);
        std::string why;
        if (options_.copies && !code->try_out(why)) return refuse(why, "");
        size_t index = 0;
        for (NodeType& type : listing.types) {
            type.code = code;
            type.code_index = index++;
        }
        if (!registry_.add(std::move(listing.types), report.path, problems)) return false;
        report.state = PluginReport::State::found;
        ids_.emplace(report.id, report.path);
        return true;
    }

    // Retains the nodes of a plugin that is now refused.
    bool keep_former(const std::string& origin) {
        std::vector<NodeType> types;
        if (options_.former)
            for (const NodeType& type : options_.former->list())
                if (type.origin == origin) types.push_back(type);
        Diagnostics ignored;
        return !types.empty() && registry_.add(std::move(types), origin, ignored);
    }

    void print_error(const std::string& path, std::string message) {
        reports_.push_back({.path = path, .why = message});
        add_fault(diagnostics_, path, std::move(message));
    }

    Registry& registry_;
    Diagnostics& diagnostics_;
    const PluginOptions& options_;
    std::set<fs::path> seen_;
    std::map<std::string, std::string> ids_;  // ids of the loaded plugins, to their paths
    std::vector<PluginReport> reports_;
};

std::string line(const PluginReport& report) {
    std::string text = printable(report.path) + "\n";
    if (!report.id.empty()) text += "    " + report.id + " " + report.version + "\n";
    if (report.state == PluginReport::State::refused)
        return text + "    refused: " + printable(report.why) + "\n";
    text += "    found";
    text += report.by_manifest ? " by its manifest:" : ":";
    for (const std::string& node : report.nodes)
        text += " " + node;
    return text + "\n";
}

}  // namespace

std::vector<std::string> plugin_places(std::span<const std::string> options,
                                       const char* environment) {
    std::vector<std::string> places(options.begin(), options.end());
    if (environment)
        for (const std::string_view entry : split(environment, ':'))
            if (!entry.empty()) places.emplace_back(entry);
    return places;
}

std::vector<std::string> default_plugin_folders() {
    const char* off = std::getenv("WRINKLE_NO_DEFAULT_PLUGINS");
    if (off && *off) return {};
    std::vector<std::string> folders;
    for (const fs::path& base :
         {user_folder("XDG_DATA_HOME", ".local/share"), installation_folder() / "lib/wrinkle"}) {
        const fs::path folder = base / "plugins";
        std::error_code error;
        if (folder.is_absolute() && fs::is_directory(folder, error) &&
            access(folder.c_str(), R_OK | X_OK) == 0)
            folders.push_back(folder.string());
    }
    return folders;
}

std::vector<std::string> plugin_places(std::span<const std::string> options) {
    std::vector<std::string> places = plugin_places(options, std::getenv("WRINKLE_PLUGIN_PATH"));
    for (std::string& folder : default_plugin_folders())
        places.push_back(std::move(folder));
    return places;
}

fs::path plugin_cache() {
    const fs::path folder = user_folder("XDG_CACHE_HOME", ".cache");
    return folder.empty() ? folder : folder / "plugins";
}

std::vector<PluginReport> load_plugins(Registry& registry, std::span<const std::string> places,
                                       Diagnostics& diagnostics, const PluginOptions& options) {
    Loader loader(registry, diagnostics, options);
    for (const std::string& name : places)
        loader.load(name);
    return loader.take_reports();
}

std::string to_text(std::span<const PluginReport> reports) {
    std::string text;
    for (const PluginReport& report : reports)
        text += line(report);
    return text;
}

}  // namespace wrinkle
