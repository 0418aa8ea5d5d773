#include "api/parts.h"
#include "base/limits.h"
#include "emit/target.h"
#include "lower/override.h"
#include "lower/preset.h"
#include "nodes/all.h"
#include "registry/plugin_loader.h"

namespace wrinkle::api {
namespace fs = std::filesystem;

const char* version() noexcept {
    return WRINKLE_VERSION;
}

std::vector<std::string> targets() noexcept {
    try {
        std::vector<std::string> names;
        for (const Target& target : wrinkle::targets())
            names.emplace_back(target.name);
        return names;
    } catch (...) {
        return {};
    }
}

Library::Library(const LibraryOptions& options) noexcept {
    try {
        auto parts = std::make_shared<Parts>();
        report_limits(parts->problems);
        parts->registry.add_plugin(built_in_nodes(), Registry::built_in, parts->problems);
        const auto places =
            options.default_plugins ? plugin_places(options.plugin_paths) : options.plugin_paths;
        load_plugins(parts->registry, places, parts->problems, {.cache = plugin_cache()});
        parts_ = std::move(parts);
    } catch (...) {
        parts_ = nullptr;
    }
}

Library::Library(const Library&) noexcept = default;
Library::Library(Library&&) noexcept = default;
Library& Library::operator=(const Library&) noexcept = default;
Library& Library::operator=(Library&&) noexcept = default;
Library::~Library() = default;

Problems Library::problems() const noexcept {
    try {
        if (parts_) return problems_of(parts_->problems);
        Problems none = no_graph();
        none.front().message = "there is no library: it could not be made, or it was moved from";
        return none;
    } catch (...) {
        return caught();
    }
}

namespace {

// Reads a graph; an exception becomes the problem that makes its parts unusable.
template <class Read>
std::shared_ptr<const Graph::Parts> read_graph(std::shared_ptr<const Library::Parts> library,
                                               Read read) noexcept {
    std::shared_ptr<Graph::Parts> parts;
    try {
        parts = std::make_shared<Graph::Parts>();
        parts->library = std::move(library);
        read(*parts);
        parts->whole = true;
    } catch (...) {
        if (parts) parts->unusable = caught();
    }
    return parts;
}

std::string placed(const std::string& folder, const std::string& name) {
    const fs::path file = fs::path(name.empty() ? "text" : name).filename();
    return folder.empty() || folder == "." ? file.string() : (fs::path(folder) / file).string();
}

}  // namespace

Graph Library::load(const std::string& file, const std::string& root) const noexcept {
    if (!parts_) return {};
    return Graph(read_graph(parts_, [&](Graph::Parts& parts) {
        parts.project = load_project(file, {root, {}}, parts.problems);
    }));
}

Graph Library::load_text(const std::string& text, const std::string& folder,
                         const std::string& name, const std::string& root) const noexcept {
    if (!parts_) return {};
    return Graph(read_graph(parts_, [&](Graph::Parts& parts) {
        Document top = read_document(text, placed(folder, name), parts.problems);
        parts.project = load_project(std::move(top), folder, {root, {}}, parts.problems);
    }));
}

// The copy of the project shares its documents.
Graph Graph::with(const std::vector<std::string>& values) const noexcept {
    if (!parts_ || !parts_->whole) return *this;
    return Graph(read_graph(parts_->library, [&](Graph::Parts& parts) {
        parts.problems = parts_->problems;
        std::vector<Override> overrides;
        for (const std::string& text : values) {
            auto parsed = parse_override(text, parts.problems);
            if (parsed && parsed->is_sweep())
                parts.problems.error(RuleId::option, "'" + text + "' is a sweep", "one value");
            else if (parsed)
                overrides.push_back(std::move(*parsed));
        }
        parts.project = with_overrides(parts_->project, parts_->library->registry, overrides, 0,
                                       parts.problems);
    }));
}

Graph Graph::with_preset(const std::string& name) const noexcept {
    if (!parts_ || !parts_->whole) return *this;
    return Graph(read_graph(parts_->library, [&](Graph::Parts& parts) {
        parts.problems = parts_->problems;
        parts.project = wrinkle::with_preset(parts_->project, name, parts.problems);
    }));
}

}  // namespace wrinkle::api
