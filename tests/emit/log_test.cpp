// Tests of source locations in the formats of drivers and compilers.
#include "emit/log.h"

#include <gtest/gtest.h>

namespace wrinkle::test {
namespace {

struct Spelling {
    const char* text;
    size_t line;
    bool warning;
    const char* message;
};

TEST(Log, ReadsThePlacesOfEveryDriver) {
    const Spelling spellings[] = {
        {"0:38(12): error: `x' undeclared", 38, false, "`x' undeclared"},  // Mesa
        {"0:38(12): warning: `x' used uninitialized", 38, true, "`x' used uninitialized"},
        {"0(38) : error C1008: undefined variable \"x\"", 38, false,
         "error C1008: undefined variable \"x\""},  // NVIDIA
        {"0(7) : warning C7050: \"y\" might be used", 7, true,
         "warning C7050: \"y\" might be used"},
        {"ERROR: 0:38: 'x' : undeclared identifier", 38, false,
         "'x' : undeclared identifier"},  // ANGLE, Intel
        {"WARNING: 0:38: 'x' : unused", 38, true, "'x' : unused"},
        {"ERROR: out/my.frag:38: 'x' : undeclared", 38, false, "'x' : undeclared"},  // glslang
        {"my.frag:38: error: 'x' : undeclared", 38, false, "'x' : undeclared"},      // glslc
        {"a.frag.hlsl:38:5: error: no x", 38, false, "no x"},                        // dxc
        {"C:\\my x\\a.hlsl(38,5-9): error X3004: no x", 38, false, "error X3004: no x"},
        {"program_source:38:5: warning: unused x", 38, true, "unused x"},  // Metal
        {"the driver refuses it: 0:38(12): error: no x", 38, false, "no x"},
    };
    for (const Spelling& each : spellings) {
        const LogLine read = read_log_line(each.text);
        EXPECT_EQ(read.line, each.line) << each.text;
        EXPECT_EQ(read.warning, each.warning) << each.text;
        EXPECT_EQ(read.message, each.message) << each.text;
    }
}

TEST(Log, TakesNothingElseForAPlace) {
    for (const char* text :
         {"", ":", "(", "0", "0:", "0(", "0:x", "0:38", "12:30:55 compiling",
          "at 12:30:55.120: begun", "ERROR: 2 compilation errors.  No code generated.",
          "vec3(1.0) : bad", "x:38: no file", "0:99999999999999999999999: too large",
          "(38) : error", "version 3.30:1: "}) {
        EXPECT_EQ(read_log_line(text).line, 0u) << text;
        EXPECT_EQ(read_log_line(text).message, text);
    }
}

TEST(Log, TheFirstPlaceOfSeveralLines) {
    EXPECT_EQ(line_in("compilation failed\nERROR: 0:12: 'x'\nERROR: 0:3: 'y'\n"), 12u);
    EXPECT_EQ(line_in("compilation failed\n"), 0u);
}

// Any log is parsed without reads out of bounds.
TEST(Log, TakesAnyBytes) {
    const std::string bytes = "0:3(8): a\n0(4,5-6)x : ERROR:WARNING:\xff.f";
    for (size_t from = 0; from < bytes.size(); ++from)
        for (size_t size = 0; size <= bytes.size() - from; ++size)
            line_in(std::string(bytes, from, size));
}

}  // namespace
}  // namespace wrinkle::test
