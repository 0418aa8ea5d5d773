// The vocabulary of comments, documents and printed strings: words that are forbidden, and words
// with a number that may only fall. A commit that lowers one writes the new number into the table.
#include "layout/vocabulary.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <map>

#include "support/files.h"

namespace wrinkle::layout {
namespace {

namespace fs = std::filesystem;

enum class Medium : uint8_t { comments, tests, documents, strings };
constexpr std::array<std::string_view, 4> medium_names{"comments", "comments of tests", "documents",
                                                       "strings"};
using Counts = std::array<size_t, 4>;  // by medium

// clang-format off
const std::vector<Term> forbidden = {
    {"stand", {"stand", "stands", "stood"}, {"stands out", "stand out"}},
    // Exceptions: conditions and names in scripts of the editor (editor/app/script.h).
    {"picture", {"picture", "pictures"}, {"stale picture other", "preview picture", "as picture"}},
    {"tell", {"told", "tell", "tells"}, {"told apart", "tell apart"}},
    {"hand", {"at hand", "the hand"}, {}},
    {"somebody", {"nobody", "somebody", "whoever", "everybody"}, {}},
    {"anew", {"anew"}, {}},
    {"written out", {"written out", "opened up"}, {}},
    {"is no", {"is no", "are no"}, {"there is no", "there are no", "is no longer", "are no longer", "is no more than", "are no more than"}},
    {"go on", {"go on", "goes on"}, {}},
    {"mend", {"dear", "dearer", "dearest", "mend", "mends", "heal", "heals"}, {}},
    {"surroundings", {"surroundings"}, {}},
    {"first word", {"^what", "^of", "^whether"}, {"of 255"}},
};

struct Row {
    Term term;
    Counts most;
};
const std::vector<Row> counted = {
    {{"what", {"what"}, {}}, {5, 1, 131, 40}},
    {{"place", {"place", "places"}, {}}, {11, 4, 34, 32}},
    {{"say", {"said", "say", "says"}, {}}, {3, 0, 45, 29}},
    {{"ask", {"ask*"}, {}}, {2, 0, 10, 5}},
    {{"keep", {"kept", "keep", "keeps"}, {}}, {18, 3, 38, 20}},
    {{"whole", {"whole"}, {"whole number", "whole numbers"}}, {3, 0, 27, 6}},
    {{"alone", {"alone"}, {}}, {0, 0, 21, 9}},
    {{"whose", {"whose"}, {}}, {3, 1, 13, 8}},
    {{"of its own", {"of its own"}, {}}, {4, 0, 11, 3}},
    {{"beside", {"beside"}, {}}, {1, 1, 29, 8}},
    {{"thing", {"thing", "things"}, {}}, {0, 0, 6, 1}},
    {{"met", {"met"}, {}}, {0, 0, 5, 0}},
};
// clang-format on

std::array<std::vector<std::string>, 4> prose_of_the_tree() {
    const fs::path root = WRINKLE_SOURCE_DIR;
    std::array<std::vector<std::string>, 4> prose;
    const auto append = [&](Medium medium, const std::vector<std::string>& blocks) {
        auto& all = prose[static_cast<size_t>(medium)];
        all.insert(all.end(), blocks.begin(), blocks.end());
    };
    for (const char* top : {"core", "editor", "nodes", "plugins", "tests"})
        for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
            const auto extension = entry.path().extension();
            if (extension != ".h" && extension != ".cpp" && extension != ".c") continue;
            const Prose found = prose_of_code(test::bytes_of(entry.path()));
            const bool tests = top == std::string_view("tests");
            append(tests ? Medium::tests : Medium::comments, found.comments);
            if (!tests) append(Medium::strings, found.strings);
        }
    for (const char* name : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"})
        append(Medium::documents, prose_of_document(test::bytes_of(root / name)));
    for (const auto& entry : fs::directory_iterator(root / "docs"))
        if (entry.path().extension() == ".md")
            append(Medium::documents, prose_of_document(test::bytes_of(entry.path())));
    return prose;
}

TEST(Vocabulary, OfTheTreeHasNoForbiddenWord) {
    const auto prose = prose_of_the_tree();
    for (const Term& term : forbidden)
        for (size_t medium = 0; medium < prose.size(); ++medium)
            for (const std::string& block : prose[medium])
                EXPECT_EQ(occurrences(term, block), 0U)
                    << "'" << term.name << "' in " << medium_names[medium] << ": " << block;
}

TEST(Vocabulary, OfTheTreeGetsNoWorse) {
    const auto prose = prose_of_the_tree();
    for (const Row& row : counted)
        for (size_t medium = 0; medium < prose.size(); ++medium) {
            size_t count = 0;
            for (const std::string& block : prose[medium])
                count += occurrences(row.term, block);
            EXPECT_EQ(count, row.most[medium])
                << "'" << row.term.name << "' in " << medium_names[medium]
                << (count > row.most[medium] ? ": use the field's term"
                                             : ": fewer than before; write the new number");
        }
}

size_t count(const Term& term, const std::vector<std::string>& blocks) {
    size_t sum = 0;
    for (const std::string& block : blocks)
        sum += occurrences(term, block);
    return sum;
}

TEST(Vocabulary, IsThatOfCommentsAndSentences) {
    const Term stand{"stand", {"stand*"}, {"stand-in"}};
    const Prose prose = prose_of_code(
        "// It stands\n// here, \"stands\".\nint stands = 1;  // stood\n"
        "call('\"', \"stands\", \"where it stands\", R\"(it stands)\");  // 1'000 stand-in\n");
    ASSERT_EQ(prose.comments.size(), 3U);
    EXPECT_EQ(count(stand, prose.comments), 2U);
    EXPECT_EQ(prose.strings.size(), 2U);
    EXPECT_EQ(count(stand, prose.strings), 2U);
    EXPECT_EQ(count({"hand", {"at hand"}, {}}, prose_of_code("// at\n// hand\n").comments), 1U);
}

TEST(Vocabulary, OfDocumentsLeavesOutCode) {
    const auto blocks = prose_of_document(
        "# What stands\n\nIt `stands` [here](stands.md),\nhttps://stands.org stands.\n"
        "```\nstands\n```\n* What it is\n");
    EXPECT_EQ(count({"stand", {"stands"}, {}}, blocks), 2U);
    EXPECT_EQ(count({"first", {"^what"}, {}}, blocks), 2U);
}

TEST(Vocabulary, AnExceptionIsNotCounted) {
    const Term none{"is no", {"is no"}, {"there is no", "is no longer"}};
    EXPECT_EQ(occurrences(none, "It is no file; there is no file; it is no longer one."), 1U);
}

}  // namespace
}  // namespace wrinkle::layout
