#include "editor/view/preview/node_previews.h"

#include <algorithm>
#include <cstdlib>

#include "editor/view/preview/flat_values.h"

namespace wrinkle::editor {
namespace {

FlatArea patch(uint32_t magnification) {
    return {0, 0, 1.0 / (NodePreviews::height * magnification), NodePreviews::width,
            NodePreviews::height};
}

// Differences below 4 of 255 count as none: they are hardly visible.
bool has_one_color(const std::vector<uint8_t>& texels) {
    for (size_t i = 4; i < texels.size(); ++i)
        if (std::abs(texels[i] - texels[i % 4]) >= 4) return false;
    return true;
}

}  // namespace

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
    std::vector<FlatValues> drawn;
    if (!evaluate_flat(job.model, job.document, nodes, patch(1), textures_, drawn)) return false;
    std::vector<std::string> uniform;
    for (const FlatValues& each : drawn) {
        previews.places[each.node] = static_cast<uint32_t>(previews.places.size());
        const std::vector<uint8_t> texels = texels_of(each);
        if (has_one_color(texels)) uniform.push_back(each.node);
        previews.texels.insert(previews.texels.end(), texels.begin(), texels.end());
    }
    magnify(job, uniform, previews);
    return true;
}

void NodePainter::magnify(const NodePreviewJob& job, const std::vector<std::string>& nodes,
                          NodePreviews& previews) {
    std::vector<FlatValues> drawn;
    evaluate_flat(job.model, job.document, nodes, patch(NodePreviews::magnification), textures_,
                  drawn);
    for (const FlatValues& each : drawn) {
        const std::vector<uint8_t> texels = texels_of(each);
        if (has_one_color(texels)) continue;
        previews.magnified.insert(each.node);
        std::ranges::copy(
            texels, previews.texels.begin() +
                        static_cast<std::ptrdiff_t>(previews.places[each.node] * texels.size()));
    }
}

}  // namespace wrinkle::editor
