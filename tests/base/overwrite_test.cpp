// Tests for outputs that would overwrite an input or another output, under any path.
#include "base/file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "support/files.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<std::string>;

class Overwrite : public testing::Test {
protected:
    std::string at(const std::string& name) const { return (folder_.path() / name).string(); }

    test::TemporaryFolder folder_;
    std::string file_ = folder_.put("a/g.json", "x").string();
};

TEST_F(Overwrite, AnInputIsFoundUnderEveryNameOfIt) {
    fs::create_symlink(file_, at("link"));
    fs::create_symlink("a", at("folder"));
    fs::create_hard_link(file_, at("hard"));
    for (const std::string& name :
         {file_, at("a/../a/./g.json"), at("link"), at("folder/g.json"), at("hard")}) {
        const std::string why = overwrite_fault(Paths{name}, Paths{at("other"), file_});
        EXPECT_NE(why.find(name), why.npos) << name << ": " << why;
        EXPECT_NE(overwrite_fault(Paths{file_}, Paths{name}), "") << name;
    }
}

TEST_F(Overwrite, OtherFilesMayBeWritten) {
    folder_.put("b", "x");
    EXPECT_EQ(overwrite_fault(Paths{at("b"), at("new"), at("missing/new")}, Paths{file_}), "");
}

TEST_F(Overwrite, TwoOutputsOfOneFileAreFound) {
    fs::create_symlink("b", at("link"));  // the target does not exist yet
    EXPECT_NE(overwrite_fault(Paths{at("b"), at("link")}, {}), "");
    EXPECT_NE(overwrite_fault(Paths{at("new"), at("./new")}, {}), "");
    EXPECT_NE(overwrite_fault(Paths{at("missing/x"), at("missing/../missing/x")}, {}), "");
}

TEST_F(Overwrite, StreamsAndDevicesAreNotReplaced) {
    EXPECT_EQ(overwrite_fault(Paths{"-", "-", "/dev/null", "/dev/null"}, Paths{"-", "/dev/null"}),
              "");
}

}  // namespace
}  // namespace wrinkle
