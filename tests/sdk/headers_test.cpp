// Tests that the headers compile with every available compiler, with the warnings that users may
// enable, as older C and as newer C++.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace wrinkle::testing {
namespace {

constexpr const char* warnings =
    " -fsyntax-only -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror";
const std::string sdk = " -I" WRINKLE_SOURCE_DIR "/core/sdk ";

bool is_there(const std::string& compiler) {
    return std::system(("command -v " + compiler + " >/dev/null").c_str()) == 0;
}

// Returns 0 if `compiler` accepts a file with this one line.
int compile(const std::string& compiler, const std::string& options, const std::string& line) {
    const std::string command = compiler + " " + options + warnings + sdk + "-";
    return std::system(("echo '" + line + "' | " + command).c_str());
}

TEST(Headers, TheContractIsC) {
    for (const std::string compiler : {"gcc", "clang"}) {
        if (!is_there(compiler)) continue;
        for (const char* standard : {"-x c -std=c99", "-x c -std=c11", "-x c++ -std=c++11"})
            EXPECT_EQ(compile(compiler, standard, "#include <wrinkle/plugin.h>"), 0)
                << compiler << " " << standard;
        EXPECT_NE(compile(compiler, "-x c -std=c11 2>/dev/null", "wr_bulder b;"), 0)
            << "a mistake is not seen";
    }
}

TEST(Headers, TheFaceIsCpp20) {
    for (const std::string compiler : {"g++", "clang++"}) {
        if (!is_there(compiler)) continue;
        for (const char* standard : {"-x c++ -std=c++20", "-x c++ -std=c++2b"})
            EXPECT_EQ(compile(compiler, standard, "#include <wrinkle/node.h>"), 0)
                << compiler << " " << standard;
    }
}

}  // namespace
}  // namespace wrinkle::testing
