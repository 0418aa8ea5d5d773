// The table of rules, and its page docs/diagnostics.md.
#include "base/rules.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "base/text.h"
#include "support/files.h"

namespace wrinkle::test {
namespace {

const std::string page = WRINKLE_SOURCE_DIR "/docs/diagnostics.md";

// The rows of the page, one for each rule.
std::string rules_markdown() {
    return joined(rule_infos, "", [](const RuleInfo& rule) {
        return "| `" + std::string(rule.id) + "` | " + std::string(rule.title) + ". " +
               std::string(rule.description) + " | " + std::string(rule.help) + " |\n";
    });
}

TEST(Rules, AreInTheOrderOfTheirIds) {
    EXPECT_EQ(info(RuleId::file_unreadable).id, "file-unreadable");
    EXPECT_EQ(info(RuleId::unknown_node_type).id, "unknown-node-type");
    EXPECT_EQ(info(RuleId::cycle).id, "cycle");
    EXPECT_EQ(info(RuleId::input_type).id, "input-type");
    EXPECT_EQ(info(RuleId::over_limit).id, "over-limit");
    EXPECT_EQ(info(RuleId::image_missing).id, "image-missing");
    EXPECT_EQ(info(RuleId::not_finite).id, "not-finite");
    EXPECT_EQ(info(RuleId::option).id, "option");
    EXPECT_EQ(info(RuleId::cache).id, "cache");
}

// Lengths of GitHub's code scanning: names 255 characters, texts 1024.
TEST(Rules, AreShortSentencesWithKebabCaseIds) {
    std::set<std::string_view> ids;
    for (const RuleInfo& rule : rule_infos) {
        EXPECT_TRUE(ids.insert(rule.id).second) << rule.id;
        EXPECT_EQ(rule.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), rule.id.npos);
        EXPECT_LE(rule.title.size(), 60U) << rule.id;
        EXPECT_FALSE(rule.title.ends_with('.')) << rule.id;
        for (const std::string_view text : {rule.description, rule.help}) {
            EXPECT_TRUE(text.ends_with('.')) << rule.id;
            EXPECT_LE(text.size(), 255U) << rule.id;
            EXPECT_EQ(text.find('|'), text.npos) << rule.id;
        }
    }
}

// WRINKLE_UPDATE_GOLDEN=1 writes the rows of the page again.
TEST(Rules, AreListedInThePage) {
    const std::string text = bytes_of(page);
    const std::string head = "| --- | --- | --- |\n";
    const size_t begin = text.find(head);
    ASSERT_NE(begin, text.npos);
    const size_t first = begin + head.size();
    const size_t end = text.find("\n\n", first - 1);
    ASSERT_NE(end, text.npos) << "text follows the table";
    if (std::getenv("WRINKLE_UPDATE_GOLDEN"))
        std::ofstream(page) << text.substr(0, first) + rules_markdown() + text.substr(end + 1);
    EXPECT_EQ(text_difference(rules_markdown(), text.substr(first, end + 1 - first)), "");
}

}  // namespace
}  // namespace wrinkle::test
