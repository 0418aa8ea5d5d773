#include "editor/view/preview/node_previews.h"

#include "editor/view/preview/flat_values.h"

namespace wrinkle::editor {

NodePreviews NodePainter::operator()(const NodePreviewJob& job) {
    NodePreviews previews;
    previews.version = job.version;
    if (std::exchange(images_, job.images) != job.images) textures_.forget();
    std::vector<std::string> wanted;
    for (const NodePtr& node : job.document.nodes)
        if (job.nodes.contains(node->id)) wanted.push_back(node->id);
    // Compiles all nodes in one program. If that fails, compiles each half separately, so that one
    // broken node does not hide others.
    std::vector<std::vector<std::string>> groups{std::move(wanted)};
    while (!groups.empty()) {
        const std::vector<std::string> group = std::move(groups.back());
        groups.pop_back();
        if (draw_group(job, group, previews) || group.size() < 2) continue;
        const auto middle = group.begin() + static_cast<std::ptrdiff_t>(group.size() / 2);
        groups.emplace_back(middle, group.end());
        groups.emplace_back(group.begin(), middle);
    }
    return previews;
}

bool NodePainter::draw_group(const NodePreviewJob& job, const std::vector<std::string>& nodes,
                             NodePreviews& previews) {
    constexpr FlatArea patch{0, 0, 1.0 / NodePreviews::height, NodePreviews::width,
                             NodePreviews::height};
    std::vector<FlatValues> drawn;
    if (!evaluate_flat(job.model, job.document, nodes, patch, textures_, drawn)) return false;
    for (const FlatValues& each : drawn) {
        previews.places[each.node] = static_cast<uint32_t>(previews.places.size());
        const Range range = range_of_values(each.values);
        for (size_t i = 0; i < each.values.size(); i += each.lanes)
            append_texel(previews.texels, flat_color(each.type, each.values.data() + i, range));
    }
    return true;
}

}  // namespace wrinkle::editor
