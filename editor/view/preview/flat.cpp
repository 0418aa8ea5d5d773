#include "editor/view/preview/flat.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/model/document/change.h"
#include "editor/model/document/inputs.h"
#include "editor/model/document/request.h"
#include "editor/view/look/thumbnails.h"
#include "editor/view/state.h"

namespace wrinkle::editor {
namespace {

constexpr double max_points = 512 * 512;

// Returns the finite values of the shown lanes.
std::vector<double> shown_values(const FlatValues& values, int channel) {
    std::vector<double> shown;
    shown.reserve(values.values.size());
    for (size_t i = 0; i < values.values.size(); ++i) {
        const bool wanted = channel < 0 || i % values.lanes == static_cast<size_t>(channel);
        if (wanted && std::isfinite(values.values[i])) shown.push_back(values.values[i]);
    }
    return shown;
}

void count_values(FlatImage& image, const std::vector<double>& shown) {
    if (shown.empty()) return;
    image.range = {*std::ranges::min_element(shown), *std::ranges::max_element(shown)};
    const double wide = image.range.most - image.range.least;
    double sum = 0;
    for (const double value : shown) {
        sum += value;
        const double at = wide > 0 ? (value - image.range.least) / wide * FlatImage::bins : 0;
        ++image.histogram[std::min(static_cast<size_t>(at), FlatImage::bins - 1)];
    }
    image.mean = sum / static_cast<double>(shown.size());
}

void color_values(FlatImage& image, const FlatJob& job) {
    const FlatValues& flat = image.values;
    const bool constant = !(image.range.most > image.range.least);
    const Range range = job.fits_range && !constant ? image.range : Range{0, 1};
    const auto channel = static_cast<size_t>(std::max(job.channel, 0));
    image.texels.reserve(flat.values.size() / flat.lanes * 4);
    for (size_t i = 0; i + flat.lanes <= flat.values.size(); i += flat.lanes) {
        const double* lanes = flat.values.data() + i;
        append_texel(image.texels, job.channel < 0
                                       ? flat_color(flat.type, lanes, range)
                                       : flat_color(PortType::float_, lanes + channel, range));
    }
}

// Returns true if the values of nodes are equal in both documents.
bool has_same_values(const Document& before, const Document& after) {
    const Change difference = change(before, after);
    return difference.kind == Change::Kind::none || difference.kind == Change::Kind::cosmetic;
}

}  // namespace

FlatImage FlatPainter::operator()(const FlatJob& job) {
    FlatImage image;
    image.version = job.version;
    image.area = job.area;
    if (std::exchange(images_, job.images) != job.images) textures_.forget();
    const Document document = with_preset_as_defaults(job.model, job.document, job.preset);
    auto drawn = evaluate_flat(job.model, document, job.node, job.output, job.area, textures_);
    if (!drawn) return image;
    image.values = std::move(*drawn);
    FlatJob shown = job;
    if (job.channel >= static_cast<int>(image.values.lanes)) shown.channel = -1;
    count_values(image, shown_values(image.values, shown.channel));
    color_values(image, shown);
    return image;
}

void take_flat(FlatFeed& feed) {
    if (!feed.maker) return;
    auto newest = feed.maker->take();
    if (!newest || newest->version < feed.first) return;
    feed.shown = std::move(*newest);
    if (feed.gl && !feed.shown.texels.empty())
        allocate_texture(feed.texture, static_cast<int>(feed.shown.area.width),
                         static_cast<int>(feed.shown.area.height), feed.shown.texels.data());
}

std::string flat_node(const State& state) {
    const Document& document = state.document();
    if (state.view.selected.size() == 1 && document.find(*state.view.selected.begin()))
        return *state.view.selected.begin();
    const std::string& previewed = state.view.preview_request.node;
    if (document.find(previewed)) return previewed;
    for (const Output& output : document.outputs) {
        const std::string& node = output.from.link.node;
        if (document.find(node) && shown_port(state.type_of(node))) return node;
    }
    return {};
}

FlatArea area_of(const FlatView& view, float width, float height) {
    const double w = std::max(std::floor(static_cast<double>(width)), 1.0);
    const double h = std::max(std::floor(static_cast<double>(height)), 1.0);
    const double step = std::max(std::sqrt(w * h / max_points), 1.0);  // pixels of a texel
    FlatArea area;
    area.width = static_cast<uint32_t>(std::max(w / step, 1.0));
    area.height = static_cast<uint32_t>(std::max(h / step, 1.0));
    area.texel = view.span / std::min(area.width, area.height);
    area.u = view.u - area.texel * area.width / 2;
    area.v = view.v - area.texel * area.height / 2;
    return area;
}

void feed_flat(State& state, const FlatArea& area) {
    FlatFeed& feed = state.flat;
    const std::string node = flat_node(state);
    if (!feed.maker || node.empty() || state.building()) return;
    const FlatView& view = state.view.flat;
    const std::string& preset = state.view.preview_request.preset;
    FlatJob& last = feed.requested;
    const Document& now = state.document();
    const bool same = last.node == node && last.area == area && last.channel == view.channel &&
                      last.fits_range == view.fits_range && last.output == view.output &&
                      last.preset == preset && last.images == feed.images &&
                      last.model.registry == state.model.registry &&
                      has_same_values(last.document, now);
    if (same) {
        last.document = now;
        return;
    }
    last = {last.version + 1, state.model,     now,         node,   area,
            view.channel,     view.fits_range, view.output, preset, feed.images};
    feed.maker->post(last);
}

std::optional<std::vector<double>> values_at(const FlatImage& image, double u, double v) {
    const double x = std::floor((u - image.area.u) / image.area.texel);
    const double y = std::floor((v - image.area.v) / image.area.texel);
    if (image.values.node.empty() || !(x >= 0 && x < image.area.width) ||
        !(y >= 0 && y < image.area.height))
        return std::nullopt;
    const size_t at =
        (static_cast<size_t>(y) * image.area.width + static_cast<size_t>(x)) * image.values.lanes;
    const double* lanes = image.values.values.data() + at;
    return std::vector<double>(lanes, lanes + image.values.lanes);
}

}  // namespace wrinkle::editor
