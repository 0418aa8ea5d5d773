// Tests that version 1 of the contract is unchanged: the current header begins with the
// declarations of the frozen one.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "sdk/v1/layout.h"
#include "support/files.h"

namespace wrinkle::testing {
namespace {

const std::filesystem::path frozen_header = WRINKLE_SOURCE_DIR "/tests/sdk/v1/wrinkle/plugin.h";

std::map<std::string, Member> by_name(const Layout& layout) {
    std::map<std::string, Member> found;
    for (const Member& member : layout.members)
        found.emplace(member.of + "." + member.name, member);
    return found;
}

TEST(Frozen, EveryMemberStaysWhereItWas) {
    const auto present = by_name(present_layout());
    for (const auto& [name, was] : by_name(frozen_layout())) {
        ASSERT_TRUE(present.contains(name)) << name;
        const Member& is = present.at(name);
        EXPECT_EQ(is.offset, was.offset) << name;
        EXPECT_EQ(is.size, was.size) << name;
        EXPECT_EQ(is.type, was.type) << name;
    }
}

TEST(Frozen, StructsOnlyGrow) {
    const Layout frozen = frozen_layout(), present = present_layout();
    ASSERT_EQ(frozen.sizes.size(), present.sizes.size());
    for (size_t i = 0; i < frozen.sizes.size(); ++i)
        EXPECT_GE(present.sizes[i].value, frozen.sizes[i].value) << frozen.sizes[i].name;
}

// Detects moved members: each begins at the end of the previous one, and the last ends the struct,
// so that a new member cannot hide in padding.
TEST(Frozen, NoMemberIsLeftOut) {
    const Layout frozen = frozen_layout();
    std::map<std::string, size_t> end;
    for (const Member& member : frozen.members) {
        const size_t from = end[member.of];
        EXPECT_EQ(member.offset,
                  (from + member.alignment - 1) / member.alignment * member.alignment)
            << member.of << "." << member.name;
        end[member.of] = member.offset + member.size;
    }
    for (const Constant& size : frozen.sizes)
        EXPECT_EQ(end[size.name], size.value) << size.name;
}

TEST(Frozen, RowsOfTablesStay) {
    const std::vector<std::string> present = present_layout().rows;
    for (const std::string& row : frozen_layout().rows)
        EXPECT_NE(std::find(present.begin(), present.end(), row), present.end()) << row;
}

TEST(Frozen, NoNumberIsGivenTwice) {
    std::set<std::string> numbers;
    for (const std::string& row : present_layout().rows) {
        std::istringstream words(row);  // "WR_OPS: add, 21, ..."
        std::string table, name, number;
        words >> table >> name >> number;
        EXPECT_TRUE(numbers.insert(table + number).second) << row;
    }
}

TEST(Frozen, ConstantsStay) {
    const std::vector<Constant> frozen = frozen_layout().constants;
    const std::vector<Constant> present = present_layout().constants;
    ASSERT_EQ(frozen.size(), present.size());
    for (size_t i = 0; i < frozen.size(); ++i)
        EXPECT_EQ(present[i].value, frozen[i].value) << frozen[i].name;
}

TEST(Frozen, NoConstantIsLeftOut) {
    std::set<std::string> known = {
        "WR_TYPES",  "WR_PORT_TYPES",    "WR_SURFACE_INPUTS", "WR_OPS",
        "WR_SCALES", "WR_FRAME_METHODS", "WR_EXPORT"};  // the tables, and macros without a value
    for (const Constant& constant : frozen_layout().constants)
        known.insert(constant.name);
    std::istringstream text(test::bytes_of(frozen_header));
    for (std::string line; std::getline(text, line);) {
        if (!line.starts_with("#define WR_")) continue;
        const size_t end = line.find_first_of(" (", 8);
        EXPECT_TRUE(known.contains(line.substr(8, end - 8))) << line;
    }
}

TEST(Frozen, TheCopyIsNotEdited) {
    uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
    for (const char byte : test::bytes_of(frozen_header))
        hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    EXPECT_EQ(hash, 0x1b1fa85b2376202bu)
        << "tests/sdk/v1/wrinkle/plugin.h is frozen: take it back to what it was";
}

}  // namespace
}  // namespace wrinkle::testing
