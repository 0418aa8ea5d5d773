#include "editor/model/document/plugins.h"

#include <algorithm>

#include "editor/model/session.h"
#include "editor/model/words.h"
#include "nodes/all.h"
#include "registry/plugin_loader.h"

namespace wrinkle::editor {
namespace {

// Returns the most important problem: a refused plugin, else the first in the list.
std::string first_trouble(const Plugins& plugins) {
    for (const PluginReport& report : plugins.reports) {
        if (report.state != PluginReport::State::refused) continue;
        const std::string name = std::filesystem::path(report.path).filename().string();
        return (name.empty() ? report.path : name) + " was refused: see the problems.";
    }
    return sentence(plugins.problems.list().front().message);
}

size_t from_plugins(const Registry& registry) {
    return static_cast<size_t>(std::ranges::count_if(
        registry.list(), [](const NodeType& type) { return type.origin != Registry::built_in; }));
}

}  // namespace

void load_plugins(Session& session) {
    Plugins& plugins = session.plugins;
    plugins.problems = Diagnostics();
    auto registry = std::make_shared<Registry>();
    registry->add_plugin(built_in_nodes(), Registry::built_in, plugins.problems);
    PluginOptions options{.copies = true, .cache = plugins.cache};
    if (!plugins.registries.empty()) options.former = plugins.registries.back().get();
    plugins.reports = wrinkle::load_plugins(*registry, plugins.places, plugins.problems, options);
    session.registry = registry.get();
    plugins.registries.push_back(std::move(registry));
}

void reload_plugins(Session& session) {
    load_plugins(session);
    session.is_synced = false;
    session.status =
        session.plugins.problems.list().empty()
            ? "Plugins are reloaded: " + counted(from_plugins(*session.registry), "node") +
                  " from them."
            : first_trouble(session.plugins);
}

}  // namespace wrinkle::editor
