#include "editor/view/preview/node_feed.h"

#include <algorithm>

#include "editor/model/document/change.h"
#include "editor/model/document/delta.h"
#include "editor/view/state.h"

namespace wrinkle::editor {
namespace {

// Returns true if the current state is already requested. Runs each frame, so it counts the nodes
// instead of building their set: previews are only shown or only hidden at a time, so a different
// set has a different size.
bool is_asked(const State& state) {
    const NodeFeed& feed = state.node_feed;
    const auto shown = std::count_if(state.layout.cards.begin(), state.layout.cards.end(),
                                     [](const Card& card) { return card.preview_y >= 0; });
    return feed.has_asked() && static_cast<size_t>(shown) == feed.requested_nodes.size() &&
           feed.images == feed.requested_images && state.registry == feed.requested_registry &&
           same_document(feed.requested_snapshot, state.document());
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

void feed_node_previews(State& state) {
    NodeFeed& feed = state.node_feed;
    if (!feed.maker) return;
    if (auto newest = feed.maker->take(); newest && newest->version >= feed.first) {
        feed.previews = std::move(*newest);
        feed.atlas.fill(feed.previews.texels, NodePreviews::width, NodePreviews::height);
    }
    const bool busy = state.follow.building() || (state.preview && !state.preview->idle()) ||
                      state.gesture.kind != Gesture::Kind::none;
    if (busy || is_asked(state)) return;
    std::set<std::string> wanted = wanted_nodes(state);
    const Document& now = state.document();
    const bool same = feed.has_asked() && wanted == feed.requested_nodes &&
                      feed.images == feed.requested_images &&
                      state.registry == feed.requested_registry &&
                      looks_the_same(feed.requested_snapshot, now);
    feed.requested_snapshot = now;
    if (same) return;
    feed.requested_nodes = wanted;
    feed.requested_images = feed.images;
    feed.requested_registry = state.registry;
    if (!wanted.empty())
        feed.maker->submit({++feed.requested_version, state.registry, state.model, now,
                            std::move(wanted), feed.images});
}

}  // namespace wrinkle::editor
