#include "registry/plugin_loader.h"

#include <dlfcn.h>
#include <elf.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <set>

#include "base/file.h"
#include "base/text.h"
#include "registry/descriptor.h"

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

constexpr const char* entry_symbol = "wrinkle_plugin";

// Loading less than a whole file may end the program.
bool is_cut_short(const std::string& path) {
    std::string why;
    const auto bytes = read_file(path, why);
    Elf64_Ehdr head;
    if (!bytes || bytes->size() < sizeof head) return false;  // dlopen() says what it is
    std::memcpy(&head, bytes->data(), sizeof head);
    if (std::memcmp(head.e_ident, ELFMAG, SELFMAG) != 0 || head.e_ident[EI_CLASS] != ELFCLASS64)
        return false;
    const auto ends_after = [&](uint64_t at, uint64_t size) {
        return at > bytes->size() || size > bytes->size() - at;
    };
    if (ends_after(head.e_shoff, uint64_t{head.e_shentsize} * head.e_shnum) ||
        ends_after(head.e_phoff, sizeof(Elf64_Phdr) * head.e_phnum))
        return true;
    for (size_t i = 0; i < head.e_phnum; ++i) {
        Elf64_Phdr part;
        std::memcpy(&part, bytes->data() + head.e_phoff + i * sizeof part, sizeof part);
        if (ends_after(part.p_offset, part.p_filesz)) return true;
    }
    return false;
}

// A temporary file with the same bytes; "" when there can be none.
std::string copy_of(const std::string& path) {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "wrinkle-plugin-XXXXXX.so").string();
    const int file = mkostemps(name.data(), 3, O_CLOEXEC);
    if (file < 0) return {};
    close(file);
    fs::copy_file(path, name, fs::copy_options::overwrite_existing, error);
    if (!error) return name;
    unlink(name.c_str());
    return {};
}

class Loader {
public:
    Loader(Registry& registry, Diagnostics& diagnostics, const PluginOptions& options)
        : registry_(registry), diagnostics_(diagnostics), options_(options) {}

    void place(const std::string& name) {
        std::error_code error;
        const fs::file_status status = fs::status(name, error);
        if (!fs::exists(status)) {
            complain(name, "there is no such plugin or folder", Severity::error);
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
        if (error)
            return complain(name, "the folder cannot be read: " + error.message(), Severity::error);
        std::sort(files.begin(), files.end());
        for (const std::string& path : files)
            file(path, Severity::warning);
    }

    void file(const std::string& path, Severity severity) {
        std::error_code error;
        const fs::path real = fs::canonical(path, error);
        if (!seen_.insert(error ? fs::path(path) : real).second) return;
        PluginReport report;
        report.path = path;
        Diagnostics problems;
        if (load(error ? path : real.string(), report, problems)) {
            report.state = PluginReport::State::loaded;
        } else {
            for (Diagnostic problem : problems.list()) {
                problem.severity = severity;
                diagnostics_.add(problem);
                problem.where = {};
                const std::string text = to_text(problem);
                report.why += report.why.empty() ? "" : "; ";
                report.why += text.substr(text.find(": ") + 2);
            }
        }
        reports_.push_back(std::move(report));
    }

    bool load(const std::string& path, PluginReport& report, Diagnostics& problems) {
        const auto refuse = [&](std::string message, std::string expected = {}) {
            Diagnostic diagnostic;
            diagnostic.where.file = report.path;
            diagnostic.message = std::move(message);
            diagnostic.expected = std::move(expected);
            problems.add(std::move(diagnostic));
            return false;
        };
        if (is_cut_short(path)) return refuse("it cannot be loaded: the file is cut short");
        void* library = open(path);
        if (!library) return refuse("it cannot be loaded: " + last_error(path));
        const auto entry = reinterpret_cast<wr_plugin_entry>(dlsym(library, entry_symbol));
        if (!entry) {
            dlclose(library);
            return refuse("it is no plugin of Wrinkle: it does not export wrinkle_plugin",
                          "declare it extern \"C\" with WR_EXPORT");
        }
        const wr_plugin* plugin = entry();
        bool fine = plugin != nullptr;
        if (!fine) refuse("its wrinkle_plugin() returned null");
        if (fine) fine = registry_.add_plugin(plugin, report.path, problems);
        describe(plugin, report);
        if (!fine) dlclose(library);
        return fine;
    }

    // dlerror() begins with the path, which the report names already.
    static std::string last_error(const std::string& path) {
        const char* text = dlerror();
        const std::string reason = text ? text : "unknown reason";
        const std::string prefix = path + ": ";
        return reason.compare(0, prefix.size(), prefix) == 0 ? reason.substr(prefix.size())
                                                             : reason;
    }

    static void describe(const wr_plugin* plugin, PluginReport& report) {
        wr_plugin copy;
        if (!plugin || !read_plugin(plugin, copy) || copy.abi != WR_ABI) return;
        if (copy.id && is_utf8(copy.id)) report.id = copy.id;
        if (copy.version && is_utf8(copy.version)) report.version = copy.version;
        Diagnostics ignored;
        std::vector<NodeType> types;
        read_descriptors(plugin, report.path, types, ignored);
        for (const NodeType& type : types)
            if (!type.id.empty()) report.nodes.push_back(type.id);
    }

    void complain(const std::string& path, std::string message, Severity severity) {
        PluginReport report;
        report.path = path;
        report.why = message;
        reports_.push_back(std::move(report));
        Diagnostic diagnostic;
        diagnostic.severity = severity;
        diagnostic.where.file = path;
        diagnostic.message = std::move(message);
        diagnostics_.add(std::move(diagnostic));
    }

    void* open(const std::string& path) const {
        constexpr int mode = RTLD_NOW | RTLD_LOCAL;
        void* library = nullptr;
        if (const std::string copy = options_.copies ? copy_of(path) : ""; !copy.empty()) {
            library = dlopen(copy.c_str(), mode);
            unlink(copy.c_str());
        }
        return library ? library : dlopen(path.c_str(), mode);
    }

    Registry& registry_;
    Diagnostics& diagnostics_;
    const PluginOptions& options_;
    std::set<fs::path> seen_;
    std::vector<PluginReport> reports_;
};

std::string line(const PluginReport& report) {
    std::string text = report.path + "\n";
    if (!report.id.empty()) text += "    " + report.id + " " + report.version + "\n";
    if (report.state == PluginReport::State::refused)
        return text + "    refused: " + report.why + "\n";
    text += "    loaded:";
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

std::vector<PluginReport> load_plugins(Registry& registry, std::span<const std::string> places,
                                       Diagnostics& diagnostics, const PluginOptions& options) {
    Loader loader(registry, diagnostics, options);
    for (const std::string& name : places)
        loader.place(name);
    return loader.take_reports();
}

std::string to_text(std::span<const PluginReport> reports) {
    std::string text;
    for (const PluginReport& report : reports)
        text += line(report);
    return text;
}

}  // namespace wrinkle
