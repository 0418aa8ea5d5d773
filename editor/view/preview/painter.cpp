#include "editor/view/preview/painter.h"
#include "editor/view/preview/image_request.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

#include "gpu/context.h"
#include "image/load.h"
#include "mesh/load.h"
#include "mesh/shapes.h"

namespace wrinkle::editor {
namespace {

// Frames of the interface may wait in the same driver: a rendering that takes longer than this is
// drawn in strips, with frames between them, and with one sample per pixel until it is still.
constexpr double slow_milliseconds = 15, strip_milliseconds = 8;

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

std::optional<Mesh> open_mesh(const std::string& name, bool& double_sided, Diagnostics& problems) {
    if (auto shape = make_shape(name)) return shape;
    MeshFileOptions options;
    options.double_sided = &double_sided;
    return load_mesh(name, options, problems);
}

void resize(Mesh& mesh, float factor) {
    for (auto* list : {&mesh.positions, &mesh.displaced})
        for (glm::vec3& position : *list)
            position *= factor;
}

bool fit(std::optional<gpu::Target>& target, const gpu::TargetOptions& options,
         Diagnostics& problems) {
    if (target && target->width() == options.width && target->height() == options.height)
        return true;
    target = gpu::Target::make(options, problems);
    return target.has_value();
}

// Returns the smallest end of the scale that covers 99 % of the angles.
float end_of_scale(std::vector<float> angles) {
    if (angles.empty()) return 3;
    const size_t at = (angles.size() - 1) * 99 / 100;
    std::nth_element(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(at),
                     angles.end());
    for (const float end : {3.0F, 12.0F, 45.0F})
        if (angles[at] <= end) return end;
    return 180;
}

AngleFigures figures_of(const std::vector<float>& pixels, float end) {
    AngleFigures figures;
    std::vector<float> degrees(pixels.size() / 4, -1), seen;
    double sum = 0;
    for (size_t i = 0; i < degrees.size(); ++i) {
        if (pixels[4 * i + 3] == 0 || !std::isfinite(pixels[4 * i])) continue;
        degrees[i] = pixels[4 * i];
        seen.push_back(degrees[i]);
        sum += static_cast<double>(degrees[i]);
        figures.max = std::max(figures.max, degrees[i]);
    }
    if (!seen.empty()) figures.mean = static_cast<float>(sum / static_cast<double>(seen.size()));
    figures.end = end > 0 ? end : end_of_scale(std::move(seen));
    figures.degrees = std::make_shared<const std::vector<float>>(std::move(degrees));
    return figures;
}

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

// Sets the options of side B.
void view_other(gpu::ViewOptions& view, const PreviewJob& job, float heat_degrees) {
    if (!job.difference) {
        view.normal = job.against;
        return;
    }
    view.view = gpu::View::difference;
    view.against = job.against;
    view.heat_degrees = heat_degrees;
}

// Draws the image that `job` requests from the renderer's state; std::nullopt with the reason in
// `problems` on failure.
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
    view_other(view, job, heat_degrees);
    if (!renderer.draw(scene, view, *target, problems)) return std::nullopt;
    const auto from = static_cast<uint32_t>(request.split * static_cast<float>(request.width));
    put_beside(image, target->read_image(), from);
    return image;
}

}  // namespace

bool PreviewPainter::use_mesh(const PreviewJob& job, Diagnostics& problems) {
    const auto wanted = job.view.displaced ? job.displacement : nullptr;
    MeshKey key{job.view.mesh, job.view.scale, wanted, job.meshes, wanted ? job.images : 0};
    if (key.images != mesh_.images) textures_.forget();
    if (key == mesh_) return true;
    bool double_sided = false;
    auto mesh = open_mesh(job.view.mesh, double_sided, problems);
    if (!mesh || !(job.view.scale > 0)) return !mesh_.mesh.empty();
    resize(*mesh, job.view.scale);
    framing_ = gpu::default_camera(*mesh, job.view.mesh);
    if (wanted) {
        auto moved = displaced(*mesh, *wanted, textures_, problems);
        if (moved) mesh = std::move(moved);
    }
    renderer_.set_mesh(*mesh);
    mesh_ = std::move(key);
    double_sided_ = double_sided;
    return true;
}

void PreviewPainter::use_light(const PreviewJob& job) {
    const PreviewView& view = job.view;
    const bool reread = std::exchange(light_read_, job.lights) != job.lights;
    const bool same = view.environment == environment_ && view.mood == mood_;
    if (same && !(reread && !environment_.empty())) return;
    environment_ = view.environment;
    mood_ = view.mood;
    dark_ = Diagnostics();
    const auto image = environment_.empty() ? std::nullopt : load_image(environment_, dark_);
    if (image)
        renderer_.set_environment(*image);
    else
        renderer_.set_mood(mood_);
}

void PreviewPainter::begin_graph(uint64_t graph) {
    if (std::exchange(graph_, graph) == graph) return;
    const int slot = last_.slot;
    last_ = PreviewImage();
    last_.slot = slot;
    has_material_ = false;
    tried_ = nullptr;
    refusal_ = Diagnostics();
}

// A rejected material is not tried again until it or the images change.
bool PreviewPainter::use_material(const PreviewJob& job) {
    const bool reread = std::exchange(images_, job.images) != job.images;
    if (reread) renderer_.forget_images();
    if (job.material && (job.material != tried_ || reread)) {
        tried_ = job.material;
        sample_took_.reset();
        refusal_ = Diagnostics();
        if (renderer_.set_material(*job.material, refusal_)) has_material_ = true;
    }
    if (!has_material_) return false;
    if (!refusal_.has_errors())
        for (const auto& [name, value] : job.values)
            renderer_.set_uniform(name, value);
    return true;
}

gpu::Scene PreviewPainter::scene_of(const PreviewView& view) const {
    gpu::Scene scene;
    scene.camera = framing_;
    scene.camera.yaw = view.yaw;
    scene.camera.pitch = view.pitch;
    scene.camera.distance = framing_.distance * view.distance;
    const glm::mat3 to_world(glm::transpose(glm::mat3(gpu::view_matrix(scene.camera))));
    scene.camera.target += to_world * glm::vec3(view.pan_x, view.pan_y, 0) * framing_.distance;
    const bool from_file = !view.environment.empty();
    scene.lighting = view.lighting;
    scene.environment_turn = view.turn + (from_file ? 0 : framing_.yaw);
    scene.to_light = gpu::light_direction(framing_.yaw + view.turn, view.light_pitch);
    scene.light = from_file ? 0 : gpu::directional_light_of(view.mood);
    scene.behind = from_file ? gpu::Behind::environment : gpu::Behind::studio;
    scene.background = {0.157F, 0.165F, 0.176F, 0};
    return scene;
}

gpu::ViewOptions PreviewPainter::options_of(const PreviewJob& job) const {
    gpu::ViewOptions options;
    options.view = job.view.view;
    const bool quick = sample_took_ && *sample_took_ * options.samples <= slow_milliseconds;
    if (!quick && !job.smooth) options.samples = 1;
    const bool slow = !sample_took_ || *sample_took_ * options.samples > slow_milliseconds;
    options.strip_milliseconds = slow ? strip_milliseconds : 0;
    options.before_strip = before_strip_;
    return options;
}

bool PreviewPainter::measure(const PreviewJob& job, const gpu::Scene& scene, PreviewImage& image) {
    const gpu::TargetOptions options{
        .width = job.width, .height = job.height, .format = gpu::PixelFormat::rgba32f};
    if (!fit(numbers_, options, image.problems)) return false;
    gpu::ViewOptions raw = options_of(job);
    raw.view = gpu::View::difference;
    raw.against = job.against;
    raw.raw = true;
    if (!renderer_.draw(scene, raw, *numbers_, image.problems)) return false;
    image.angles = figures_of(numbers_->read(), job.degrees);
    return true;
}

bool PreviewPainter::draw_sides(const PreviewJob& job, gpu::ViewOptions view, PreviewImage& image) {
    const auto start = std::chrono::steady_clock::now();
    Slot& slot = slots_[static_cast<size_t>(image.slot)];
    const gpu::TargetOptions options{.width = job.width, .height = job.height, .samples = 4};
    if (!fit(slot.a, options, image.problems)) return false;
    const gpu::Scene scene = scene_of(job.view);
    image.smooth = view.samples > 1 || view.view != gpu::View::shaded;
    if (!renderer_.draw(scene, view, *slot.a, image.problems)) return false;
    gpu::Context::finish();
    const bool in_strips = view.strip_milliseconds > 0;  // the rest is compiling and waiting
    sample_took_ = (in_strips ? renderer_.strips_took() : milliseconds_since(start)) / view.samples;
    image.texture = slot.a->texture();
    image.other = 0;
    image.angles = {};
    if (job.against.empty()) return true;
    if (!fit(slot.b, options, image.problems)) return false;
    if (job.difference && !measure(job, scene, image)) return false;
    view_other(view, job, image.angles.end);
    if (!renderer_.draw(scene, view, *slot.b, image.problems)) return false;
    image.other = slot.b->texture();
    return true;
}

PreviewImage PreviewPainter::draw(const PreviewJob& job, int held) {
    const auto start = std::chrono::steady_clock::now();
    begin_graph(job.graph);
    PreviewImage image = last_;
    image.version = job.version;
    image.graph = job.graph;
    image.problems = Diagnostics();
    const auto before = std::tuple(renderer_.programs_linked(), images_, mesh_.mesh, mesh_.scale);
    use_light(job);
    if (use_material(job) && use_mesh(job, image.problems) && job.width > 0 && job.height > 0) {
        PreviewImage next = image;
        next.slot = 0;
        while (next.slot == held || next.slot == last_.slot)
            ++next.slot;
        next.width = job.width;
        next.height = job.height;
        if (draw_sides(job, options_of(job), next))
            image = std::move(next);
        else
            image.problems = std::move(next.problems);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    gpu::Context::finish();
    image.refused = refusal_.has_errors();
    image.lost = gpu::Context::was_lost();
    image.double_sided = double_sided_ ? mesh_.mesh : "";
    Diagnostics problems = refusal_;
    problems.append(dark_);
    problems.append(image.problems);
    image.problems = std::move(problems);
    image.programs = renderer_.programs_linked();
    image.first =
        before != std::tuple(renderer_.programs_linked(), images_, mesh_.mesh, mesh_.scale);
    image.milliseconds = milliseconds_since(start);
    last_ = image;
    if (job.image_request && !job.image_request->answered()) draw_image_request(job);
    return image;
}

// Uses the state of the last rendering, with an opaque background.
void PreviewPainter::draw_image_request(const PreviewJob& job) {
    ImageRequest& request = *job.image_request;
    Diagnostics problems = last_.problems;
    std::optional<Image> image;
    if (!request.cancelled && last_.texture && !last_.refused)
        image =
            draw_requested_image(renderer_, scene_of(job.view), job, last_.angles.end, problems);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    request.answer(std::move(image), std::move(problems));
}

}  // namespace wrinkle::editor
