#include "editor/view/drop/drop.h"

#include <algorithm>
#include <cctype>

#include "base/file.h"
#include "editor/model/document/field.h"
#include "editor/model/document/inputs.h"
#include "editor/model/document/texture_import.h"
#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/canvas/new_cards.h"
#include "editor/view/drop/image_kind.h"
#include "editor/view/edit/edits.h"
#include "editor/view/edit/layer.h"
#include "editor/view/look/draw.h"
#include "editor/view/panels/panels.h"
#include "editor/view/panels/search.h"
#include "editor/view/refresh.h"
#include "lower/preset.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
std::string path_in_graph(const Session& session, const fs::path& file) {
    const auto place = inside(session.folder(), file);
    std::error_code error;
    const fs::path root = fs::canonical(session.folder(), error);
    return place && !error ? place->lexically_relative(root).generic_string() : "";
}

namespace {

enum class Kind : uint8_t { image, environment, mesh, graph };

Kind kind_of_name(const fs::path& file) {
    const std::string extension = lower_case(file.extension().string());
    if (extension == ".obj" || extension == ".gltf" || extension == ".glb") return Kind::mesh;
    if (extension == ".json") return Kind::graph;
    if (extension == ".hdr" || extension == ".exr") return Kind::environment;
    return Kind::image;
}

bool on_preview(const Interface& interface, const FileDrop& drop) {
    const auto rect = interface.targets.find("preview");
    return rect && drop.x >= rect->x0 && drop.x < rect->x1 && drop.y >= rect->y0 &&
           drop.y < rect->y1;
}

// An image that was added to the graph.
struct NewImage {
    std::string file;  // as written in the graph
    ImageKind kind;
    const NodeType* type = nullptr;
    ImVec2 at{0, 0};  // canvas units
    std::string merge;
};

bool set_on_card(State& state, const NewImage& image, const Hit& hit) {
    const Card card = state.layout.cards[hit.card];
    if (card.kind != Card::Kind::node || !card.type) return false;
    const std::string field = hit.kind == Hit::Kind::field ? card.fields[hit.part].port : "";
    const Port* port = image_port(*card.type, field);
    if (!port) port = image_port(*card.type);
    if (!port) return false;
    state.commit(card.id + ": " + port->name,
                 with_file(state.document(), card.id, *port, image.file), image.merge);
    state.view.selected = {card.id};
    return true;
}

// Adds a source node that reads the image according to its kind.
NewNode with_source(const State& state, const NewImage& image, ImVec2 at) {
    NewNode made = with_image_node(state, *image.type, image.file, at);
    const Port* port = image_port(*image.type);
    if (port && image.kind.encoding)
        made.document = with_image_word(made.document, made.id, *port, "encoding",
                                        name_of(*image.kind.encoding));
    return made;
}

void add_on_wire(State& state, const NewImage& image, const Wire& wire) {
    const NewNode made = with_source(state, image, image.at + ImVec2(-336, 96));
    const Port* bump = bump_of(*image.type);
    std::string why = image.file + " is an image of colors, so there is no bump to add";
    std::optional<Document> document;
    if (bump)
        document = with_bump_on_wire(state, made.document, wire, {made.id, bump->name},
                                     image.at + ImVec2(-88, -60), why);
    state.commit("Add " + made.id, document ? std::move(*document) : made.document, image.merge);
    show_new(state, {made.id});
    if (!document) state.status = why;
}

// Returns true if the graph now shows it.
bool add_on_ground(State& state, const NewImage& image) {
    if (state.document().nodes.empty()) leave_empty_graph(state);
    const NewNode made = with_source(state, image, image.at);
    Document document = made.document;
    const Port* bump = bump_of(*image.type);
    const bool shown = bump && !document.find_output("normal");
    if (shown)
        document =
            with_bump_shown(state, document, {made.id, bump->name}, image.at + ImVec2(512, 0));
    state.commit("Add " + made.id, std::move(document), image.merge);
    show_new(state, {made.id});
    state.status = bump && !shown
                       ? "To layer " + made.id + ", drop its card on a wire."
                       : made.id + " is a " + image.type->title + ": " + image.kind.why + ".";
    return shown;
}

const Wire* wire_of_normal(const CanvasState& canvas) {
    for (const Wire& wire : canvas.layout.wires)
        if (wire.ends_at({"", "normal"})) return &wire;
    return nullptr;
}

// If `layered`, earlier images are shown and this one is layered over them.
bool place_image(State& state, const NewImage& image, bool layered) {
    if (layered)
        if (const Wire* found = wire_of_normal(state)) {
            const Wire wire = before_resolve(state, state.document(), *found);
            NewImage placed = image;
            placed.at = wire.middle();
            add_on_wire(state, placed, wire);
            return true;
        }
    const Hit hit = pick(state, to_screen(state.view, image.at));
    if (hit.kind == Hit::Kind::wire) {
        const Wire wire = state.layout.wires[hit.part];
        add_on_wire(state, image, wire);
        return false;
    }
    if (hit.kind != Hit::Kind::nothing && set_on_card(state, image, hit)) return false;
    return add_on_ground(state, image);
}

// Layers it over the selected wire or over the bump that the output `normal` shows, else adds it on
// empty canvas.
void place_chosen(State& state, NewImage image) {
    image.at =
        to_canvas(state.view, state.view.corner + state.view.extent * 0.5F) - ImVec2(120, 120);
    const auto selected = state.view.selected_wire;
    for (const Wire& each : state.layout.wires)
        if (selected && each.ends_at(*selected)) {
            const Wire wire = each;
            image.at = wire.middle();
            return add_on_wire(state, image, wire);
        }
    if (wire_of_normal(state))
        place_image(state, image, true);
    else
        add_on_ground(state, image);
}

void place(State& state, DropEvent& event, const fs::path& file, const Examined& examined) {
    NewImage image;
    image.file = path_in_graph(state, file);
    if (!examined.problem.empty() || image.file.empty()) {
        state.status = examined.problem;
        return;
    }
    image.kind = kind_of(examined, file.filename().string());
    image.type = state.registry->find(image.kind.node_type);
    if (!image.type) return;
    image.at = event.at;
    image.merge = event.merge;
    if (event.chosen)
        place_chosen(state, image);
    else
        event.layered = place_image(state, image, event.layered);
    state.images.paths[image.file] = file;
    ++state.images.changes;
    refresh(state);
}

// Places files in order until one is not examined yet. All files of one drop are one undo step.
void place_dropped(State& state) {
    std::vector<DropEvent>& waiting = state.dropped.waiting;
    while (!waiting.empty()) {
        DropEvent& next = waiting.front();
        while (!next.files.empty()) {
            const fs::path file = next.files.front();
            const Examined* found = examined(state, file);
            if (!found) return;
            place(state, next, file, Examined(*found));
            next.files.erase(next.files.begin());
        }
        waiting.erase(waiting.begin());
    }
}

void await(State& state, DropEvent event) {
    for (auto file = event.files.rbegin(); file != event.files.rend(); ++file)
        want_image(state, *file, stamp_of(*file), true);  // reversed: the first ends up in front
    if (state.images.busy() && !event.files.empty())
        state.status = "Looking at " + event.files.front().filename().string() + ".";
    state.dropped.waiting.push_back(std::move(event));
    place_dropped(state);
}

fs::path canonical_or_same(const fs::path& file) {
    std::error_code error;
    const fs::path found = fs::canonical(file, error);
    return error ? file : found;
}

void load_preset(State& state, const fs::path& file) {
    PresetOfFile loaded = with_preset_file(state.model, state.document(), file);
    if (!loaded.problem.empty()) {
        state.status = loaded.problem;
        return;
    }
    state.commit("Load preset " + loaded.name, std::move(loaded.document));
    state.view.preview_request.preset = loaded.name;
    state.inputs_panel.shown = true;
}

void handle(State& state, const FileDrop& drop) {
    std::vector<std::string> images;
    std::error_code ignored;
    for (const std::string& file : drop.files) {
        if (fs::is_directory(file, ignored)) {
            import_folder(state, file);
            return;
        }
        if (file.ends_with(preset_suffix)) return load_preset(state, file);
        const Kind kind = kind_of_name(file);
        if (kind == Kind::graph) return take_graph(state, {drop.x, drop.y, {file}});
        PreviewView& preview = state.view.preview_view;
        if (kind == Kind::mesh) {
            preview.mesh = file;
        } else if (kind == Kind::environment && on_preview(state, drop)) {
            preview.environment = file;
            preview.lighting = gpu::Lighting::ggx;
        } else {
            images.push_back(file);
        }
    }
    const bool all_inside = std::ranges::all_of(
        images, [&](const auto& file) { return !path_in_graph(state, file).empty(); });
    if (all_inside) return add_images(state, drop, images);
    state.dropped.outside = {drop.x, drop.y, images};
    state.dropped.by_name = false;
}

void set_image(Session& session, const std::string& id, const std::string& name,
               const std::string& file) {
    const NodeType* type = session.type_of(id);
    const Port* port = type ? image_port(*type, name) : nullptr;
    if (port) session.commit(id + ": " + name, with_file(session.document(), id, *port, file));
}

}  // namespace

void add_images(State& state, const FileDrop& drop, const std::vector<std::string>& files) {
    DropEvent event;
    event.at = to_canvas(state.view, {drop.x, drop.y});
    event.merge = "drop " + std::to_string(state.history.serial());
    for (const std::string& file : files)
        event.files.push_back(canonical_or_same(file));
    await(state, std::move(event));
}

void add_image(State& state, const std::string& file) {
    DropEvent event;
    event.chosen = true;
    event.files = {canonical_or_same(state.folder() / file)};
    await(state, std::move(event));
}

void use_image(State& state, const std::string& node, const std::string& port,
               const std::string& file) {
    const std::string place = path_in_graph(state, file);
    if (!place.empty())
        return node.empty() ? add_image(state, place) : set_image(state, node, port, place);
    state.dropped.outside = {0, 0, {file}};
    state.dropped.by_name = true;
    state.dropped.node = node;
    state.dropped.port = port;
}

void handle_drops(State& state) {
    const std::vector<FileDrop> arrived = std::move(state.dropped.arrived);
    state.dropped.arrived.clear();
    for (const FileDrop& drop : arrived)
        handle(state, drop);
    place_dropped(state);
}

}  // namespace wrinkle::editor
