#include "editor/view/preview/graph_images.h"

#include "base/file.h"
#include "editor/model/document/inputs.h"
#include "editor/model/document/request.h"
#include "editor/view/look/thumbnails.h"
#include "editor/view/preview/flat_values.h"
#include "graph/read.h"

namespace wrinkle::editor {
namespace {

// Returns the nodes of the outputs that can be shown, the preferred first.
std::vector<std::string> shown_nodes(const Model& model, const Document& document) {
    std::vector<std::string> nodes;
    for (const std::string_view preferred : {"color", "material", ""})
        for (const Output& output : document.outputs) {
            const std::string& node = output.from.link.node;
            if ((output.name == preferred || preferred.empty()) && document.find(node) &&
                shown_port(model.type_of(node)))
                nodes.push_back(node);
        }
    return nodes;
}

std::vector<uint8_t> draw(const Model& model, const Document& document) {
    constexpr FlatArea tile{0, 0, 1.0 / GraphImage::side, GraphImage::side, GraphImage::side};
    TextureStore textures;
    for (const std::string& node : shown_nodes(model, document))
        if (const auto values = evaluate_flat(model, document, node, "", tile, textures))
            return texels_of(*values);
    return {};
}

std::vector<uint8_t> texels_of_graph(const GraphFile& graph) {
    std::string why;
    Diagnostics problems;
    const auto bytes = read_file(graph.file, why);
    if (!bytes) return {};
    const Document document = read_document(*bytes, graph.file.string(), problems);
    return draw(make_model(document, graph.file.parent_path(), *graph.registry, graph.root),
                document);
}

std::vector<uint8_t> texels_of_graph(const GraphPreset& graph) {
    return draw(graph.model, with_preset_as_defaults(graph.model, graph.document, graph.preset));
}

}  // namespace

GraphImage draw_graph_image(GraphImageJob&& job) {
    return {job.key, job.stamp,
            std::visit([](const auto& graph) { return texels_of_graph(graph); }, job.graph)};
}

uint32_t GraphImages::of(const GraphFile& file) {
    std::error_code ignored;
    const auto time = std::filesystem::last_write_time(file.file, ignored).time_since_epoch();
    return find_or_draw({file.file.string(), static_cast<uint64_t>(time.count()), file});
}

uint32_t GraphImages::of(const GraphPreset& preset, uint64_t version) {
    return find_or_draw({"preset " + preset.preset, version, preset});
}

uint32_t GraphImages::find_or_draw(GraphImageJob job) {
    if (!maker || !gl) return 0;
    const auto found = drawn_.find(job.key);
    const uint32_t texture = found == drawn_.end() ? 0 : found->second.texture;
    const bool current = found != drawn_.end() && found->second.stamp == job.stamp;
    if (!current && maker->idle()) maker->post(std::move(job));
    return texture;
}

void GraphImages::take() {
    if (!maker) return;
    const auto image = maker->take();
    if (!image) return;
    Drawn& drawn = drawn_[image->key];
    drawn.stamp = image->stamp;
    if (gl && !image->texels.empty())
        allocate_texture(drawn.texture, GraphImage::side, GraphImage::side, image->texels.data());
}

}  // namespace wrinkle::editor
