// Tests of exporting the preview as an image file of any size. Skipped only if GL is not available.
#include "editor/view/preview/image_export.h"

#include <epoxy/gl.h>

#include "editor/model/document/files.h"
#include "editor/view/refresh.h"
#include "gpu/context.h"
#include "headless.h"
#include "image/load.h"

namespace wrinkle::editor {
namespace {
namespace fs = std::filesystem;

class PictureExport : public Headless {
protected:
    void SetUp() override {
        Diagnostics why;
        context_ = gpu::Context::offscreen(why);
        if (!context_ || !context_->make_current()) GTEST_SKIP() << to_text(why);
        preview_ = std::make_unique<Preview>();
        state.preview = preview_.get();
        open(small_graph);
        play("wait\nassert picture");
    }
    void TearDown() override {
        state.tasks = {};
        state.preview = nullptr;
        preview_.reset();
        if (context_) context_->release_current();
    }
    std::optional<Image> written(const std::string& name) const {
        Diagnostics problems;
        return load_image(folder.path() / name, problems);
    }

    std::optional<gpu::Context> context_;
    std::unique_ptr<Preview> preview_;
};

TEST_F(PictureExport, TheTimeShownIsThatOfAPictureAndNotOfItsProgram) {
    play("drag preview preview+60,30");
    EXPECT_FALSE(state.preview->shown().first);
    EXPECT_GT(state.preview->shown().milliseconds, 0);
}

TEST_F(PictureExport, WritesWhatIsShown) {
    play(
        "click preview:picture\nkey Ctrl+A\ntype shown\nkey Enter\nfinish\n"
        "assert status Wrote shown.png");
    const PreviewImage& shown = state.preview->shown();
    const auto image = written("shown.png");
    ASSERT_TRUE(image);
    ASSERT_EQ(image->width, static_cast<uint32_t>(shown.width));
    ASSERT_EQ(image->height, static_cast<uint32_t>(shown.height));
    std::vector<uint8_t> pixels(4 * size_t{image->width} * image->height);
    glBindTexture(GL_TEXTURE_2D, shown.texture);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    size_t seen = 0, same = 0;
    for (uint32_t y = 0; y < image->height; ++y)
        for (uint32_t x = 0; x < image->width; ++x) {
            const uint8_t* pixel = &pixels[4 * (size_t{y} * image->width + x)];
            if (pixel[3] != 255) continue;
            ++seen;
            const float* other = image->texel(x, y);
            same += std::abs(other[0] * 255 - static_cast<float>(pixel[0])) < 1.5F &&
                    std::abs(other[1] * 255 - static_cast<float>(pixel[1])) < 1.5F;
        }
    EXPECT_GT(seen, 1000U);
    EXPECT_EQ(same, seen);
}

TEST_F(PictureExport, TakesTheSizeThatIsChosen) {
    start_image_export(state, folder.path() / "wide.png", {600, 200});
    play("finish\nassert status Wrote wide.png");
    const auto image = written("wide.png");
    ASSERT_TRUE(image);
    EXPECT_EQ(image->width, 600U);
    EXPECT_EQ(image->height, 200U);
    const float* corner = image->texel(2, 2);
    const float* middle = image->texel(300, 100);
    EXPECT_NE(corner[0], middle[0]) << "the object stands in the middle";
}

TEST_F(PictureExport, SaysWhenItCannotBeWrittenAndLeavesNothing) {
    start_image_export(state, folder.path() / "nowhere" / "a.png", {64, 64});
    play("finish\nassert status a.png was not written");
    EXPECT_FALSE(fs::exists(folder.path() / "nowhere"));
    start_image_export(state, folder.path() / "a.png", {1 << 20, 1 << 20});
    play("finish\nassert status a.png was not drawn");
    EXPECT_FALSE(fs::exists(folder.path() / "a.png"));
}

TEST_F(PictureExport, IsCancelledBeforeItIsDrawn) {
    start_image_export(state, folder.path() / "a.png", {2048, 2048});
    cancel_task(state);
    play("finish");
    EXPECT_EQ(state.status, "Drawing a.png was cancelled. Nothing was written.");
    EXPECT_FALSE(fs::exists(folder.path() / "a.png"));
}

}  // namespace
}  // namespace wrinkle::editor
