#include "editor/view/preview/image_request.h"

#include "editor/view/preview/painter.h"

namespace wrinkle::editor {
namespace {

// Copies the columns from `from` on from the other image.
void put_beside(Image& image, const Image& other, uint32_t from) {
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = from; x < image.width; ++x)
            for (uint32_t c = 0; c < 3; ++c)
                image.texel(x, y)[c] = other.texel(x, y)[c];
}

Image opaque(const Image& source) {
    Image image = make_image(source.width, source.height, 3, PixelType::u8);
    put_beside(image, source, 0);
    return image;
}

}  // namespace

std::optional<Image> draw_requested_image(gpu::Renderer& renderer, gpu::Scene scene,
                                          const PreviewJob& job, float heat_degrees,
                                          Diagnostics& problems) {
    const ImageRequest& request = *job.image_request;
    const auto target = gpu::Target::make(
        {.width = request.width, .height = request.height, .samples = 4}, problems);
    if (!target) return std::nullopt;
    scene.background.a = 1;
    gpu::ViewOptions view;
    view.view = job.view.view;
    if (!renderer.draw(scene, view, *target, problems)) return std::nullopt;
    Image image = opaque(target->read_image());
    if (job.against.empty() || request.split >= 1 || request.cancelled) return image;
    if (job.difference) {
        view.view = gpu::View::difference;
        view.against = job.against;
        view.heat_degrees = heat_degrees;
    } else {
        view.normal = job.against;
    }
    if (!renderer.draw(scene, view, *target, problems)) return std::nullopt;
    const auto from = static_cast<uint32_t>(request.split * static_cast<float>(request.width));
    put_beside(image, target->read_image(), from);
    return image;
}

}  // namespace wrinkle::editor
