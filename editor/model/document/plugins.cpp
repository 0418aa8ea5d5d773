#include "editor/model/document/plugins.h"

#include <algorithm>

#include "editor/model/words.h"
#include "editor/view/state.h"
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
    return static_cast<size_t>(
        std::count_if(registry.list().begin(), registry.list().end(),
                      [](const NodeType& type) { return type.origin != Registry::built_in; }));
}

}  // namespace

void load_plugins(State& state) {
    Plugins& plugins = state.plugins;
    plugins.problems = Diagnostics();
    auto registry = std::make_shared<Registry>();
    registry->add_plugin(built_in_nodes(), Registry::built_in, plugins.problems);
    PluginOptions options{.copies = true, .cache = plugins.cache};
    if (!plugins.registries.empty()) options.former = plugins.registries.back().get();
    plugins.reports = wrinkle::load_plugins(*registry, plugins.places, plugins.problems, options);
    state.registry = registry.get();
    plugins.registries.push_back(std::move(registry));
}

void reload_plugins(State& state) {
    load_plugins(state);
    if (state.follow.compiler) state.follow.compiler->use(*state.registry);
    if (state.code.maker) state.code.maker->use(*state.registry);
    state.offer = {};
    state.fresh = false;
    state.status =
        state.plugins.problems.list().empty()
            ? "Plugins are loaded anew: " + counted(from_plugins(*state.registry), "node") +
                  " from them."
            : first_trouble(state.plugins);
}

}  // namespace wrinkle::editor
