#include "base/limits.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "support/files.h"

namespace wrinkle {
namespace {

struct Variable {
    Variable(std::string_view name, const char* value) : name(name) {
        setenv(this->name.c_str(), value, 1);
    }
    ~Variable() { unsetenv(name.c_str()); }
    std::string name;
};

TEST(Limits, AVariableReplacesTheDefault) {
    EXPECT_EQ(limit_of(Limit::graph_values), 1'000'000U);
    const Variable set("WRINKLE_GRAPH_MAX_VALUES", "70");
    EXPECT_EQ(limit_of(Limit::graph_values), 70U);
    EXPECT_EQ(limit_of(Limit::graph_calls), 100'000U);
    Diagnostics diagnostics;
    EXPECT_TRUE(report_limits(diagnostics));
    EXPECT_EQ(to_text(diagnostics), "");
}

TEST(Limits, AVariableThatIsNotAWholeNumberIsAnErrorAndTheDefaultHolds) {
    for (const char* wrong : {"", "0", "-1", "2e6", "1 ", "99999999999999999999"}) {
        const Variable set("WRINKLE_TEXT_MAX_BYTES", wrong);
        EXPECT_EQ(limit_of(Limit::text_bytes), uint64_t{16} << 20) << wrong;
        Diagnostics diagnostics;
        EXPECT_FALSE(report_limits(diagnostics)) << wrong;
        EXPECT_EQ(to_text(diagnostics), "error: environment variable WRINKLE_TEXT_MAX_BYTES is '" +
                                            std::string(wrong) +
                                            "' (a whole number from 1 to 18446744073709551615)\n");
    }
}

TEST(Limits, EveryLimitIsARowOfThePageWithItsDefaultAndUnit) {
    const std::string page =
        test::bytes_of(std::filesystem::path(WRINKLE_SOURCE_DIR) / "docs/limits.md");
    for (const LimitRow& row : limit_rows)
        EXPECT_NE(page.find("| `" + std::string(row.variable) + "` | " +
                            std::to_string(row.default_value) + " | " + std::string(row.unit) +
                            " | " + std::string(row.doc) + " |\n"),
                  std::string::npos)
            << row.variable;
}

}  // namespace
}  // namespace wrinkle
