#include "editor/view/refresh.h"

#include <imgui.h>

#include "editor/model/document/change.h"
#include "editor/model/document/renamed.h"
#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/edit/edits.h"
#include "editor/view/preview/feed.h"

namespace wrinkle::editor {
namespace {

// Requests a count only if the source differs; a changed value does not change it.
void request_costs(State& state) {
    CompileState& follow = state.follow;
    if (!follow.counter || !state.built.uniform) return;
    const std::string& text = state.built.uniform->source;
    if (follow.counting_of >= follow.first && follow.counting == text) return;
    follow.counting = text;
    follow.counting_of = state.built.version;
    follow.counter->post({state.built.version, state.built.module, state.built.document});
}

void poll_costs(CompileState& follow) {
    if (!follow.counter) return;
    if (auto counted = follow.counter->take()) follow.counted = std::move(*counted);
}

void take(State& state, Build newest) {
    if (newest.version < state.follow.first || newest.version <= state.built.version) return;
    ++state.counters.builds;
    state.built = std::move(newest);
    request_costs(state);
    apply_latest_build(state);
}

void request_build(State& state) {
    CompileState& follow = state.follow;
    follow.requested_snapshot = state.document();
    follow.requested = wanted_request(state);
    CompileJob job{++follow.requested_version, state.model, state.document(),
                   material_name(state.file_name()), follow.requested};
    if (follow.compiler)
        follow.compiler->post(std::move(job));
    else
        take(state, build(job));
}

// For a changed structure; measures the time until its pixels.
void request_build_of_structure(State& state) {
    request_build(state);
    if (state.timings) state.timings->structure(state.follow.requested_version);
}

void rebuild_model(State& state) {
    state.model = make_model(state.document(), state.folder(), *state.registry, state.root());
    use_current_names(state);
}

void begin(State& state) {
    state.is_synced = true;
    state.layout_stale = true;
    state.follow.first = state.follow.requested_version + 1;
    state.follow.drawn.uniform = state.follow.drawn.shown = std::nullopt;
    rebuild_model(state);
    request_build_of_structure(state);
}

void follow_document(State& state) {
    CompileState& follow = state.follow;
    const Change difference = change(follow.requested_snapshot, state.document());
    if (difference.renamed) rename_in_request(state, follow.requested_snapshot);
    if (difference.renamed || difference.kind == Change::Kind::structure) rebuild_model(state);
    switch (difference.kind) {
        case Change::Kind::none:
        case Change::Kind::cosmetic:
            follow.requested_snapshot = state.document();
            break;
        case Change::Kind::names:
            follow.requested_snapshot = state.document();
            follow.requested = wanted_request(state);
            if (!state.built.problems.list().empty()) request_build(state);  // problems name nodes
            break;
        case Change::Kind::values: {
            const bool sent = send_values(state);
            // While a value is dragged only the uniform changes; the build follows at the end of
            // the drag.
            if (!sent || !is_holding_value(state)) request_build(state);
            break;
        }
        case Change::Kind::structure:
            request_build_of_structure(state);
            break;
    }
}

// Another preset changes uniforms only, unless it sets an option or an image.
bool shows_other_preset(State& state) {
    CompileState& follow = state.follow;
    const PreviewRequest wanted = wanted_request(state);
    if (state.building() || follow.drawn.displacement ||
        !differ_in_preset_only(follow.requested, wanted) || !send_values(state))
        return false;
    follow.requested = wanted;
    return true;
}

// Deselects nodes, boxes and wires that no longer exist after undo, a reload or a cancelled
// gesture.
void forget_what_is_gone(State& state) {
    const Document& now = state.document();
    View& view = state.view;
    std::erase_if(view.selected, [&](const std::string& id) {
        return !now.find(id) && id != Link::surface && id != Link::input && id != Card::outputs_id;
    });
    std::erase_if(view.boxes, [&](const BoxId& id) { return !find_box(now, id); });
    std::string& preset = view.preview_request.preset;
    if (!preset.empty() && !now.presets.find(preset)) preset.clear();
    if (!view.selected_wire) return;
    const auto& [node, port] = *view.selected_wire;
    if (!link_at(now, node, port)) view.selected_wire.reset();
}

}  // namespace

void refresh(State& state) {
    CompileState& follow = state.follow;
    forget_what_is_gone(state);
    if (!state.is_synced)
        begin(state);
    else if (!same_document(follow.requested_snapshot, state.document()))
        follow_document(state);
    if (follow.requested != wanted_request(state) && !shows_other_preset(state))
        request_build_of_structure(state);
    if (follow.compiler)
        if (auto result = follow.compiler->take()) take(state, std::move(*result));
    poll_costs(follow);
    poll_preview_diagnostics(state);
    send_time(state);
    update_layout(state);
    feed_node_previews(state);
    take_flat(state.flat);
    state.graph_images.take();
}

bool is_holding_value(const State& state) {
    return state.gesture.kind == Gesture::Kind::value || state.value_held;
}

bool is_settled(const State& state) {
    const bool held = is_holding_value(state);
    return state.is_synced && state.dropped.waiting.empty() && !state.building() &&
           (!state.preview || state.preview->idle() || state.play.moves()) && state.flat.idle() &&
           state.graph_images.idle() &&
           (held || same_document(state.follow.requested_snapshot, state.document()));
}

}  // namespace wrinkle::editor
