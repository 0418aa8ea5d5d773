#include "editor/view/preview/preview.h"

#include "editor/view/preview/painter.h"

namespace wrinkle::editor {

Preview::Preview(std::function<void()> wake) : wake_(std::move(wake)) {
    begin();
}

void Preview::begin() {
    Diagnostics why;  // ignored: the fallback gives the same result
    context_ = gpu::Context::sharing_current(why);
    if (!context_) return;
    const auto work = [this](PreviewJob&& job) {
        if (!painter_) {
            context_->make_current();
            painter_ = std::make_unique<PreviewPainter>([this] { gate_.wait_for_frame(); });
        }
        return painter_->draw(job, held_);
    };
    const auto finish = [this] {
        painter_.reset();
        context_->release_current();
    };
    worker_ = std::make_unique<Worker<PreviewJob, PreviewImage>>(work, wake_, finish);
}

Preview::~Preview() {
    worker_.reset();
    if (job_.image_request) job_.image_request->answer(std::nullopt, Diagnostics());
}

void Preview::leave_context() {
    worker_.reset();
    painter_.reset();
    context_.reset();
    held_ = -1;
    image_ = PreviewImage();
}

void Preview::recreate_context() {
    begin();
    changed_ = true;
}

void Preview::set_material(std::shared_ptr<const Shader> material,
                           std::shared_ptr<const Displacement> displacement) {
    job_.material = std::move(material);
    job_.displacement = std::move(displacement);
    job_.values.clear();
    changed_ = true;
}

void Preview::forget_material() {
    ++job_.graph;
    set_material(nullptr, nullptr);
    image_ = PreviewImage();
}

void Preview::set_uniform(const std::string& name, std::span<const float> value) {
    job_.values[name].assign(value.begin(), value.end());
    changed_ = true;
}

void Preview::forget(Use use) {
    ++(use == Use::mesh ? job_.meshes : use == Use::light ? job_.lights : job_.images);
    changed_ = true;
}

void Preview::draw_image_request(std::shared_ptr<ImageRequest> image_request) {
    // Cancels the previous request.
    if (job_.image_request) job_.image_request->answer(std::nullopt, Diagnostics());
    job_.image_request = std::move(image_request);
    submit();
}

void Preview::show(const PreviewView& view, const std::string& against, const CompareView& compare,
                   int width, int height) {
    const bool difference = !against.empty() && compare.difference;
    const float degrees = difference ? compare.degrees : 0;
    const PreviewFrame frame{view, against, difference, degrees, width, height};
    const bool same = !changed_ && frame == job_;
    if (same && !can_smooth()) return;
    static_cast<PreviewFrame&>(job_) = frame;
    job_.smooth = same;
    changed_ = false;
    submit();
}

void Preview::submit() {
    ++job_.version;
    if (worker_) return worker_->post(job_);
    if (!painter_) painter_ = std::make_unique<PreviewPainter>();
    image_ = painter_->draw(job_, -1);
}

const PreviewImage& Preview::newest() {
    if (worker_)
        if (auto newer = worker_->take(); newer && newer->graph == job_.graph) {
            held_ = newer->slot;
            image_ = std::move(*newer);
        }
    return image_;
}

// The last job is on screen with one sample per pixel.
bool Preview::can_smooth() const {
    return image_.version == job_.version && image_.texture && !image_.smooth && !job_.smooth;
}

bool Preview::idle() const {
    return (!worker_ || worker_->idle()) && !can_smooth();
}

void Preview::wait_idle() {
    if (worker_) worker_->wait_idle();
}

}  // namespace wrinkle::editor
