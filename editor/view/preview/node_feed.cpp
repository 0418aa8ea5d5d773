#include "editor/view/preview/node_feed.h"

#include <algorithm>

#include "editor/model/document/change.h"
#include "editor/view/state.h"

namespace wrinkle::editor {
namespace {

// Returns true if the last request had the same images and node types.
bool has_same_inputs(const State& state) {
    const NodeFeed& feed = state.node_feed;
    return feed.has_asked() && feed.images == feed.requested.images &&
           state.model.registry == feed.requested.model.registry;
}

// Returns true if the current state is already requested. Runs each frame, so it counts the nodes
// instead of building their set: previews are only shown or only hidden at a time, so a different
// set has a different size.
bool is_asked(const State& state) {
    const auto shown = std::ranges::count_if(state.layout.cards,
                                             [](const Card& card) { return card.preview_y >= 0; });
    return has_same_inputs(state) &&
           static_cast<size_t>(shown) == state.node_feed.requested.nodes.size() &&
           same_document(state.node_feed.requested.document, state.document());
}

std::set<std::string> wanted_nodes(const State& state) {
    std::set<std::string> wanted;
    for (const Card& card : state.layout.cards)
        if (card.preview_y >= 0) wanted.insert(card.id);
    return wanted;
}

// Returns true if both documents have the same node previews.
bool looks_the_same(const Document& before, const Document& after) {
    const Change difference = change(before, after);
    return difference.kind == Change::Kind::none || difference.kind == Change::Kind::cosmetic;
}

}  // namespace

std::optional<PreviewAtlas::Place> preview_place(const NodeFeed& feed, std::string_view node) {
    const auto found = feed.previews.places.find(node);
    if (found == feed.previews.places.end() || found->second >= feed.atlas.count()) return {};
    return feed.atlas.place(found->second);
}

void feed_node_previews(State& state) {
    NodeFeed& feed = state.node_feed;
    if (!feed.maker) return;
    if (auto newest = feed.maker->take(); newest && newest->version >= feed.first) {
        feed.previews = std::move(*newest);
        feed.atlas.fill(feed.previews.texels, NodePreviews::width, NodePreviews::height);
    }
    const bool busy = state.building() || (state.preview && !state.preview->idle()) ||
                      state.gesture.kind != Gesture::Kind::none || state.value_held;
    if (busy || is_asked(state)) return;
    std::set<std::string> wanted = wanted_nodes(state);
    const Document& now = state.document();
    const bool same = has_same_inputs(state) && wanted == feed.requested.nodes &&
                      looks_the_same(feed.requested.document, now);
    if (same) {
        feed.requested.document = now;
        return;
    }
    const uint64_t version = feed.requested.version + (wanted.empty() ? 0 : 1);
    feed.requested = {version, state.model, now, std::move(wanted), feed.images};
    if (!feed.requested.nodes.empty()) feed.maker->post(feed.requested);
}

}  // namespace wrinkle::editor
