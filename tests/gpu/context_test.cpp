#include "gpu/context.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <thread>

#include "fixture.h"
#include "gpu/texture.h"

namespace wrinkle::gpu {
namespace {

using ContextTest = WithContext;

bool context_works() {
    Diagnostics diagnostics;
    return Target::make({4, 4}, diagnostics).has_value();
}

TEST_F(ContextTest, IsOpenGlThreeThreeCoreOrLater) {
    GLint major = 0;
    GLint minor = 0;
    GLint profile = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_GE(10 * major + minor, 33);
    EXPECT_TRUE(profile & GL_CONTEXT_CORE_PROFILE_BIT);
    EXPECT_FALSE(Context::renderer_name().empty());
}

TEST_F(ContextTest, SurvivesTheEndOfAnother) {
    {
        std::optional<Context> other = Context::offscreen(diagnostics);
        ASSERT_TRUE(other) << errors();
        EXPECT_TRUE(context_works()) << "a new context must not become current by itself";
        ASSERT_TRUE(other->make_current());
        EXPECT_TRUE(context_works());
    }
    ASSERT_TRUE(context->make_current());
    EXPECT_TRUE(context_works());
}

TEST_F(ContextTest, CanBeMoved) {
    Context moved = std::move(*context);
    context.reset();
    EXPECT_TRUE(context_works());
    moved.release_current();
    ASSERT_TRUE(moved.make_current());
    EXPECT_TRUE(context_works());
}

TEST_F(ContextTest, SharesTexturesWithAnotherThread) {
    std::optional<Context> worker = Context::sharing_current(diagnostics);
    ASSERT_TRUE(worker) << errors();
    std::optional<Texture> texture;
    std::thread([&] {
        ASSERT_TRUE(worker->make_current());
        texture = Texture::of_floats(1, 1, std::array<float, 4>{0.25F, -3, 1e20F, 7});
        Context::finish();
        worker->release_current();
    }).join();
    texture->bind(0);
    std::array<float, 4> texel{};
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, texel.data());
    EXPECT_EQ(texel, (std::array<float, 4>{0.25F, -3, 1e20F, 7}));
}

TEST_F(ContextTest, RefusesToShareWithNothing) {
    context->release_current();
    EXPECT_FALSE(Context::sharing_current(diagnostics));
    EXPECT_EQ(diagnostics.error_count(), 1U);
}

void try_without_a_driver() {
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere/at_all.json", 1);
    Diagnostics diagnostics;
    const bool made = Context::offscreen(diagnostics).has_value();
    std::cerr << to_text(diagnostics);
    std::exit(made ? 0 : 3);
}

TEST(ContextDeathTest, SaysInOneSentenceThatThereIsNoDriver) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(try_without_a_driver(), testing::ExitedWithCode(3), "OpenGL is not available");
}

void say_wish(const char* of_the_user) {
    of_the_user ? setenv("GALLIVM_PERF", of_the_user, 1) : unsetenv("GALLIVM_PERF");
    Context::prefer_quick_programs();
    std::cerr << std::getenv("GALLIVM_PERF");
    std::exit(0);
}

TEST(ContextDeathTest, PrefersQuickProgramsUnlessTheUserSaidOtherwise) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(say_wish(nullptr), testing::ExitedWithCode(0), "nopt");
    EXPECT_EXIT(say_wish("no_brilinear"), testing::ExitedWithCode(0), "no_brilinear");
}

}  // namespace
}  // namespace wrinkle::gpu
