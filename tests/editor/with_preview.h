// A state with a preview that renders on its own thread. Skipped only if GL is not available.
#pragma once

#include <epoxy/gl.h>

#include <memory>
#include <optional>
#include <vector>

#include "editor/model/document/files.h"
#include "editor/view/preview/feed.h"
#include "editor/view/refresh.h"
#include "gpu/context.h"
#include "headless.h"

namespace wrinkle::editor {

class WithPreview : public Headless {
protected:
    static constexpr int side = 200;

    void SetUp() override {
        Diagnostics why;
        context_ = gpu::Context::offscreen(why);
        if (!context_ || !context_->make_current()) GTEST_SKIP() << to_text(why);
        preview_ = std::make_unique<Preview>();
        ASSERT_TRUE(preview_->has_thread());
        state.preview = preview_.get();
    }
    void TearDown() override {
        state.preview = nullptr;
        preview_.reset();
        if (context_) context_->release_current();
    }

    // Returns the rendering of the newest document, `side` x `side` pixels, as it is when nothing
    // moves.
    const PreviewImage& see() {
        refresh(state);
        do {
            preview_->show(state.view.preview_view, other_normal(state), state.view.compare, side,
                           side);
            preview_->wait_idle();
            refresh(state);
        } while (!preview_->idle());
        return preview_->shown();
    }
    void begin(const char* graph) {
        file = folder.write("graph.json", graph);
        open_file(state, file);
        state.view.preview_view.mesh = "plane";
        state.view.preview_view.yaw = state.view.preview_view.pitch = 0;
    }
    void compare(Against against, const char* name) {
        state.view.preview_request.against = against;
        state.view.preview_request.name = name;
        state.view.compare.mode = CompareView::Mode::split;
        state.view.compare.difference = true;
    }
    static std::vector<uint8_t> pixels_of(uint32_t texture) {
        std::vector<uint8_t> pixels(4 * side * side);
        glBindTexture(GL_TEXTURE_2D, texture);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    }
    void edit(Document document) { state.commit("edit", std::move(document)); }

    std::optional<gpu::Context> context_;
    std::unique_ptr<Preview> preview_;
};

}  // namespace wrinkle::editor
