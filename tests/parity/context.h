// One offscreen context for all tests of a program: creating one takes longer than most tests.
#pragma once

#include <gtest/gtest.h>

#include "gpu/context.h"

namespace wrinkle::test {

class WithGpu : public testing::Test {
protected:
    static void SetUpTestSuite() {
        Diagnostics diagnostics;
        context() = gpu::Context::offscreen(diagnostics);
        ASSERT_TRUE(context()) << to_text(diagnostics);
        ASSERT_TRUE(context()->make_current());
    }
    static void TearDownTestSuite() { context().reset(); }

private:
    static std::optional<gpu::Context>& context() {
        static std::optional<gpu::Context> the_context;
        return the_context;
    }
};

}  // namespace wrinkle::test
