// Rows of the palette: matching node types, commands, nodes of the graph or undo steps.
#include <algorithm>
#include <tuple>

#include "editor/view/commands/commands.h"
#include "editor/view/edit/edits.h"
#include "editor/view/panels/palette.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

constexpr size_t max_recent = 8;

// Sort key for an empty query: families that create bumps, then those that use them, tools last.
size_t order_of_family(std::string_view family) {
    constexpr std::string_view first[] = {"image", "gradient", "noise",     "pattern", "height",
                                          "uv",    "decal",    "triplanar", "parallax"};
    const auto* const found = std::ranges::find(first, family);
    return static_cast<size_t>(found - std::begin(first));
}

size_t order_of_use(const std::vector<std::string>& recent, std::string_view id) {
    return static_cast<size_t>(std::ranges::find(recent, id) - recent.begin());
}

bool is_favorite(const State& state, std::string_view type) {
    const std::vector<std::string>& favorites = state.keeping.settings.favorites;
    return std::ranges::find(favorites, type) != favorites.end();
}

using NodeKey = std::tuple<int, bool, bool, size_t, size_t>;
using NodeRows = std::vector<std::pair<NodeKey, PaletteRow>>;

// Appends the graphs of the folder that match.
void add_subgraph_rows(const State& state, const std::string& wanted, NodeRows& found) {
    for (const std::string& file : state.palette.graphs) {
        const std::string title = fs::path(file).stem().string();
        auto matched = match(title, file, "", wanted);
        if (!matched) continue;
        const bool favorite = is_favorite(state, type_of_subgraph(file));
        const NodeKey key{matched->rank, true, !favorite, max_recent,
                          wanted.empty() ? SIZE_MAX : title.size()};
        found.emplace_back(key, PaletteRow{.title = title,
                                           .doc = "Graph in " + file,
                                           .target = "palette:" + file,
                                           .letters = std::move(matched->letters),
                                           .graph = file,
                                           .favorite = favorite});
    }
}

// Appends the graphs of the library that match.
void add_library_rows(const State& state, const std::string& wanted, NodeRows& found) {
    for (const LibraryEntry& entry : state.palette.library) {
        auto matched = match(entry.name, "", "", wanted);
        if (!matched) continue;
        const NodeKey key{matched->rank, true, true, max_recent + 1,
                          wanted.empty() ? SIZE_MAX : entry.name.size()};
        found.emplace_back(key, PaletteRow{.title = entry.name,
                                           .doc = "Graph in the library",
                                           .target = "palette:library:" + entry.name,
                                           .letters = std::move(matched->letters),
                                           .entry = &entry});
    }
}

// Matching node types and graphs, best first (palette.h).
std::vector<PaletteRow> node_rows(const State& state) {
    const std::string wanted = lower_case(state.palette.query);
    const Gesture wire = state.palette.all_types ? Gesture() : state.palette.wire;
    NodeRows found;
    for (const NodeType& type : state.registry->list()) {
        if (!type_fits(type, wire)) continue;
        auto matched = match(type.title, type.id, type.doc, wanted);
        const std::string_view other = other_name(type.id, wanted);
        const bool by_other = !other.empty() && (!matched || matched->rank > rank_of_other_name);
        if (by_other) matched = Match{rank_of_other_name, {}};
        if (!matched) continue;
        const size_t last = wanted.empty() ? order_of_family(type.family) : type.title.size();
        const bool favorite = is_favorite(state, type.id);
        const NodeKey key{matched->rank, !type_matches(type, wire), !favorite,
                          order_of_use(state.recent.nodes, type.id), last};
        found.emplace_back(
            key, PaletteRow{.title = type.title,
                            .doc = by_other ? std::string(other) + " elsewhere" : type.doc,
                            .target = "palette:" + type.id,
                            .letters = std::move(matched->letters),
                            .type = &type,
                            .favorite = favorite});
    }
    add_subgraph_rows(state, wanted, found);
    add_library_rows(state, wanted, found);
    return best_first(std::move(found));
}

std::vector<PaletteRow> command_rows(const State& state) {
    using Key = std::tuple<int, bool, size_t>;
    std::vector<std::pair<Key, PaletteRow>> found;
    const std::string query = lower_case(state.palette.query);
    for (const Command& command : commands()) {
        auto matched = match(command.title, command.id, command.menu, query);
        if (!matched) continue;
        const Key key{matched->rank, !command.enabled(state),
                      order_of_use(state.recent.commands, command.id)};
        found.emplace_back(key, PaletteRow{.title = std::string(command.title),
                                           .doc = std::string(command.menu),
                                           .key = std::string(command.keys),
                                           .off = std::string(command.why_not(state)),
                                           .target = "palette:" + std::string(command.id),
                                           .letters = std::move(matched->letters),
                                           .command = &command});
    }
    return best_first(std::move(found));
}

// Returns the nodes of the graph that match the query by id, type or title.
std::vector<PaletteRow> graph_rows(const State& state) {
    std::vector<std::pair<int, PaletteRow>> found;
    const std::string query = lower_case(state.palette.query);
    for (const NodePtr& node : state.document().nodes) {
        const NodeType* type = state.type_of(node->id);
        const std::string title = type ? type->title : "unknown type";
        auto matched = match(node->id, node->type, title, query);
        if (!matched) continue;
        found.emplace_back(matched->rank, PaletteRow{.title = node->id,
                                                     .doc = title,
                                                     .target = "palette:" + node->id,
                                                     .letters = std::move(matched->letters),
                                                     .type = type,
                                                     .node = node->id});
    }
    return best_first(std::move(found));
}

// Returns the steps of the undo history that match the query, the newest first.
std::vector<PaletteRow> step_rows(const State& state) {
    std::vector<PaletteRow> found;
    const std::string query = lower_case(state.palette.query);
    const History& history = state.history;
    for (size_t i = history.size(); i-- > 0;) {
        auto matched = match(history.name(i), "", "", query);
        if (!matched) continue;
        found.push_back({.title = history.name(i),
                         .doc = i > history.at() ? "undone" : "",
                         .key = i == history.at() ? "now" : "",
                         .target = "palette:step" + std::to_string(i),
                         .letters = std::move(matched->letters),
                         .step = i});
    }
    return found;
}

}  // namespace

std::vector<PaletteRow> palette_rows(const State& state) {
    switch (state.palette.list) {
        case Palette::List::nodes:
            return graph_rows(state);
        case Palette::List::commands:
            return command_rows(state);
        case Palette::List::steps:
            return step_rows(state);
        case Palette::List::types:
            break;
    }
    return node_rows(state);
}

std::string PaletteRow::added_type() const {
    if (!graph.empty()) return type_of_subgraph(graph);
    return type && node.empty() ? type->id : "";
}

void toggle_favorite(State& state, const PaletteRow& row) {
    std::vector<std::string>& favorites = state.keeping.settings.favorites;
    const std::string type = row.added_type();
    if (type.empty() || std::erase(favorites, type) > 0) return;
    if (favorites.size() < Settings::max_favorites) favorites.push_back(type);
}

void note_use(std::vector<std::string>& recent, std::string_view id) {
    std::erase(recent, id);
    recent.insert(recent.begin(), std::string(id));
    if (recent.size() > max_recent) recent.resize(max_recent);
}

}  // namespace wrinkle::editor
