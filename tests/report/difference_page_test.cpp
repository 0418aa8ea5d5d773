// Tests of the report of two graphs: changes, sides, costs, and no command that accepts.
#include <gtest/gtest.h>

#include "report/page.h"

namespace wrinkle::report {
namespace {

Results two_graphs() {
    Results results;
    results.before = "HEAD:a.json";
    results.after = "a.json";
    results.changes = {"  node weave.scale: 2 -> 3", "- node <old>: \"add\"",
                       "layout: 1 note added"};
    Check cost;
    cost.test = "a";
    cost.name = "cost";
    cost.kind = CheckKind::cost;
    cost.status = Status::changed;
    cost.message = "alu 80 -> 68";
    cost.measured = {{"alu", "", "80", "68", -12, 0, ""}};
    Check point = cost;
    point.name = "points/0";
    point.kind = CheckKind::point;
    point.measured = {{"normal", "end.normal", "[0, 0, 1]", "[1, 0, 0]", 90, 0, "degrees"}};
    results.checks = {cost, point};
    return results;
}

TEST(DifferencePage, HasTheChangesOfTheGraph) {
    const std::string text = page(two_graphs(), ".");
    EXPECT_NE(text.find("<title>Wrinkle diff: 2 changed</title>"), text.npos);
    EXPECT_NE(text.find("<h1>Different</h1>"), text.npos);
    EXPECT_NE(text.find("<li><code>node weave.scale: 2 -&gt; 3</code></li>"), text.npos);
    EXPECT_NE(text.find("<li class=\"removed\"><code>- node &lt;old&gt;: &quot;add&quot;</code>"),
              text.npos);
    Results same = two_graphs();
    same.changes.clear();
    EXPECT_NE(page(same, ".").find("<h1>Different</h1>"), text.npos);
    for (Check& check : same.checks)
        check.status = Status::passed;
    EXPECT_NE(page(same, ".").find("<h1>Same</h1>"), text.npos);
}

TEST(DifferencePage, ChecksHaveTwoSidesAndNoLimit) {
    const std::string text = page(two_graphs(), ".");
    EXPECT_NE(text.find("<th scope=\"col\">Measure</th><th scope=\"col\">Before</th><th scope=\"col"
                        "\">After</th><th scope=\"col\">Difference</th></tr>"),
              text.npos);
    EXPECT_NE(text.find("<tr><th scope=\"row\">alu</th><td>80</td><td>68</td><td class=\"number\">"
                        "-12 </td></tr>"),
              text.npos);
    EXPECT_NE(text.find("<tr class=\"over\"><th scope=\"row\">normal</th><td>end.normal</td>"),
              text.npos);
    EXPECT_EQ(text.find(">Limit<"), text.npos);
    EXPECT_NE(text.find("<span class=\"worst\">normal 90 degrees</span>"), text.npos);
}

TEST(DifferencePage, AcceptsNothing) {
    const std::string text = page(two_graphs(), ".");
    EXPECT_EQ(text.find("id=\"accept\""), text.npos);
    EXPECT_EQ(text.find("data-acceptable"), text.find("data-acceptable", text.find("<script>")));
}

}  // namespace
}  // namespace wrinkle::report
