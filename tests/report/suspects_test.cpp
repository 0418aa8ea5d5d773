// Tests of likely causes: the uses that failed cases share.
#include "report/suspects.h"

#include <gtest/gtest.h>

namespace wrinkle::report {
namespace {

TEST(Suspects, TheCommonThingOfFailedCasesIsFirst) {
    const std::vector<CaseUses> cases = {{true, {"node a", "node b"}},
                                         {true, {"node a", "node c", "node c"}},
                                         {true, {"node a", "node b"}},
                                         {false, {"node b", "node c"}},
                                         {false, {"node c"}}};
    const auto found = suspects(cases);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].name, "node a");
    EXPECT_EQ(found[0].failed, 3U);
    EXPECT_EQ(found[0].passed, 0U);
    EXPECT_DOUBLE_EQ(found[0].score, 1);
    EXPECT_EQ(found[1].name, "node b");
    EXPECT_NEAR(found[1].score, 2.0 / 3, 1e-12);  // 2 / sqrt(3 * 3)
    EXPECT_EQ(likely_causes(cases)[0], "node a: in 3 of 3 failed and 0 of 2 passed cases");
}

TEST(Suspects, OneFailedCaseHasNone) {
    EXPECT_TRUE(suspects({{true, {"node a"}}, {false, {"node b"}}}).empty());
    EXPECT_TRUE(suspects({}).empty());
}

TEST(Suspects, ThereAreAtMostThree) {
    EXPECT_EQ(
        suspects({{true, {"a", "b", "c", "d"}}, {true, {"a", "b", "c", "d"}}, {false, {}}}).size(),
        3U);
}

TEST(Suspects, ThereAreNoneWithoutAPassedCase) {
    EXPECT_TRUE(suspects({{true, {"a"}}, {true, {"a"}}}).empty());
}

}  // namespace
}  // namespace wrinkle::report
