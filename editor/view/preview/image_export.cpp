#include "editor/view/preview/image_export.h"

#include <algorithm>

#include "editor/model/words.h"
#include "editor/view/preview/image_request.h"
#include "image/load.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

float shown_split(const State& state) {
    const CompareView& compare = state.view.compare;
    if (!state.preview || state.preview->shown().other == 0) return 1;
    if (compare.mode == CompareView::Mode::split) return compare.split;
    return compare.mode == CompareView::Mode::flip && compare.flipped ? 0.0F : 1.0F;
}

TaskOutcome draw_and_write(ImageRequest& request, const fs::path& file, TaskProgress& progress) {
    const std::string name = file.filename().string();
    progress.total = 2;
    Diagnostics problems;
    const auto image = request.wait(progress.cancelled, problems);
    if (progress.cancelled) return {};
    if (!image) return {false, name + " was not drawn: " + sentence(first_error(problems))};
    progress.done = 1;
    Diagnostics written;
    if (!save_image(*image, file, {}, written))
        return {false, name + " was not written: " + disk_words(first_error(written)) + "."};
    progress.done = 2;
    return {true, "Wrote " + name + ", " + std::to_string(image->width) + " \u00D7 " +
                      std::to_string(image->height) + " px."};
}

}  // namespace

std::vector<ImageSize> image_sizes(const PreviewState& state) {
    std::vector<ImageSize> sizes{{1024, 1024}, {2048, 2048}, {4096, 4096}};
    if (!state.preview) return sizes;
    const PreviewImage& shown = state.preview->shown();
    sizes.insert(sizes.begin(), {std::max(shown.width, 1), std::max(shown.height, 1)});
    return sizes;
}

void start_image_export(State& state, const fs::path& file, ImageSize size) {
    if (!state.preview) return;
    const auto request =
        std::make_shared<ImageRequest>(size.width, size.height, shown_split(state));
    const auto work = [request, file](TaskProgress& progress) {
        return draw_and_write(*request, file, progress);
    };
    if (start_task(state, {"Drawing " + file.filename().string(), work,
                           [&state, file, size] { start_image_export(state, file, size); }}))
        state.preview->draw_image_request(request);
}

fs::path usual_image_path(const State& state) {
    return state.folder() / (fs::path(state.file_name()).stem().string() + ".png");
}

std::string_view why_no_image(const State& state) {
    return state.preview && state.preview->shown().texture ? "" : "There is no image yet.";
}

}  // namespace wrinkle::editor
