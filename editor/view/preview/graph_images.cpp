#include "editor/view/preview/graph_images.h"

#include <algorithm>

#include "base/file.h"
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

std::vector<uint8_t> texels_of_values(const FlatValues& values) {
    std::vector<uint8_t> texels;
    const Range range = range_of_values(values.values);
    for (size_t i = 0; i + values.lanes <= values.values.size(); i += values.lanes)
        append_texel(texels, flat_color(values.type, values.values.data() + i, range));
    return texels;
}

}  // namespace

GraphImage draw_graph_image(GraphImageJob&& job) {
    GraphImage image{job.file, job.written, {}};
    std::string why;
    Diagnostics problems;
    const auto bytes = read_file(job.file, why);
    if (!bytes) return image;
    const Document document = read_document(*bytes, job.file.string(), problems);
    const Model model = make_model(document, job.file.parent_path(), *job.registry, job.root);
    constexpr FlatArea tile{0, 0, 1.0 / GraphImage::side, GraphImage::side, GraphImage::side};
    TextureStore textures;
    for (const std::string& node : shown_nodes(model, document))
        if (const auto values = evaluate_flat(model, document, node, "", tile, textures)) {
            image.texels = texels_of_values(*values);
            break;
        }
    return image;
}

uint32_t GraphImages::of(GraphImageJob wanted) {
    if (!maker || !gl) return 0;
    std::error_code ignored;
    wanted.written = std::filesystem::last_write_time(wanted.file, ignored);
    const auto found = drawn_.find(wanted.file);
    const uint32_t texture = found == drawn_.end() ? 0 : found->second.texture;
    const bool current = found != drawn_.end() && found->second.written == wanted.written;
    if (!current && maker->idle()) maker->post(std::move(wanted));
    return texture;
}

void GraphImages::take() {
    if (!maker) return;
    const auto image = maker->take();
    if (!image) return;
    Drawn& drawn = drawn_[image->file];
    drawn.written = image->written;
    if (gl && !image->texels.empty())
        allocate_texture(drawn.texture, GraphImage::side, GraphImage::side, image->texels.data());
}

}  // namespace wrinkle::editor
