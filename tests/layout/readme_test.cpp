// What the README shows is what the program writes.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

namespace {

std::string text_of(const std::string& name) {
    std::ifstream file(std::string(WRINKLE_SOURCE_DIR) + "/" + name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(Readme, ShowsTheGeneratedTextOfBaseAndDetail) {
    const std::string golden = text_of("graphs/golden/base_and_detail.glsl");
    ASSERT_FALSE(golden.empty());
    EXPECT_NE(text_of("README.md").find("```glsl\n" + golden + "```"), std::string::npos)
        << "put graphs/golden/base_and_detail.glsl into README.md";
}

// Base and detail in function form are at most 26 lines.
TEST(Readme, BaseAndDetailStayShort) {
    const std::string golden = text_of("graphs/golden/base_and_detail.glsl");
    EXPECT_LE(std::count(golden.begin(), golden.end(), '\n'), 26);
}

}  // namespace
