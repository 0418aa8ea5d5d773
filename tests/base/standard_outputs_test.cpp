// Tests of the table of standard outputs: names are unique, and docs/outputs.md lists each row.
#include "base/standard_outputs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>
#include <string>

#include "base/text.h"
#include "support/files.h"

namespace wrinkle {
namespace {

std::string default_text(const StandardOutput& output) {
    if (output.type == "normal" || output.name.ends_with("tangent")) return "the surface's";
    const auto& [x, y, z] = output.value;
    if (output.type == "color" && (x != y || y != z))
        return shortest(x) + " " + shortest(y) + " " + shortest(z);
    return shortest(x);
}

std::string range_text(const StandardOutput& output) {
    if (output.type == "normal" || output.type == "vec3") return "unit";
    const auto end = [](double x) { return std::isinf(x) ? std::string() : shortest(x); };
    return end(output.low) + " .. " + end(output.high);
}

std::string row_of(const StandardOutput& output) {
    std::ostringstream row;
    row << "| `" << output.name << "` | ";
    if (!output.synonym.empty()) row << "`" << output.synonym << "`";
    row << " | " << output.type << " | " << default_text(output) << " | " << range_text(output)
        << " | " << output.doc << " |";
    return row.str();
}

TEST(StandardOutputs, HaveUniqueNames) {
    std::set<std::string_view> names;
    for (const StandardOutput& output : standard_output_table) {
        EXPECT_TRUE(names.insert(output.name).second) << output.name;
        EXPECT_TRUE(output.synonym.empty() || names.insert(output.synonym).second);
        EXPECT_LE(output.low, output.value[0]) << output.name;
        EXPECT_GE(output.high, output.value[0]) << output.name;
    }
}

TEST(StandardOutputs, AreFoundByBothNames) {
    EXPECT_EQ(find_standard_output("base_color"), find_standard_output("color"));
    EXPECT_EQ(output_name("geometry_opacity"), "opacity");
    EXPECT_EQ(output_name("mine"), "mine");
    EXPECT_EQ(find_standard_output(""), nullptr);
}

TEST(StandardOutputs, AreThoseOfThePage) {
    const std::string page = test::bytes_of(WRINKLE_SOURCE_DIR "/docs/outputs.md");
    size_t rows = 0;
    for (const StandardOutput& output : standard_output_table)
        EXPECT_NE(page.find(row_of(output) + "\n"), page.npos) << row_of(output);
    for (size_t at = page.find("\n| `"); at != page.npos; at = page.find("\n| `", at + 1))
        ++rows;
    EXPECT_EQ(rows, standard_output_table.size());
}

}  // namespace
}  // namespace wrinkle
