// What the README shows is what the program writes.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/files.h"

namespace {

using wrinkle::test::bytes_of;
const std::filesystem::path repository = WRINKLE_SOURCE_DIR;

TEST(Readme, ShowsTheGeneratedTextOfBaseAndDetail) {
    const std::string golden = bytes_of(repository / "graphs/golden/base_and_detail.glsl");
    ASSERT_FALSE(golden.empty());
    EXPECT_NE(bytes_of(repository / "README.md").find("```glsl\n" + golden + "```"),
              std::string::npos)
        << "put graphs/golden/base_and_detail.glsl into README.md";
}

// Base and detail in function form are at most 26 lines.
TEST(Readme, BaseAndDetailStayShort) {
    const std::string golden = bytes_of(repository / "graphs/golden/base_and_detail.glsl");
    EXPECT_LE(std::count(golden.begin(), golden.end(), '\n'), 26);
}

}  // namespace
