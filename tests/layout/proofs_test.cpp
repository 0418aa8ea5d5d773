// Tests that the pages which list the proofs name existing tests and graphs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "support/files.h"

namespace {

using wrinkle::test::bytes_of;

namespace fs = std::filesystem;
const fs::path root = WRINKLE_SOURCE_DIR;

bool is_name(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
        return std::isalnum(c) || c == '_';
    });
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
        text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
        text.remove_suffix(1);
    return text;
}

// "Suite.Name" of every TEST(Suite, Name), TEST_F and TEST_P.
std::set<std::string> tests_in(const std::string& source) {
    std::set<std::string> names;
    for (const std::string_view start : {"TEST(", "TEST_F(", "TEST_P("})
        for (size_t at = source.find(start); at != source.npos; at = source.find(start, at + 1)) {
            const size_t open = at + start.size(), end = source.find(')', open);
            const std::string_view inside = std::string_view(source).substr(open, end - open);
            const size_t comma = inside.find(',');
            if (comma == inside.npos) continue;
            const auto suite = trimmed(inside.substr(0, comma));
            const auto name = trimmed(inside.substr(comma + 1));
            if (is_name(suite) && is_name(name))
                names.insert(std::string(suite) + "." + std::string(name));
        }
    return names;
}

std::set<std::string> tests_in_the_sources() {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(root / "tests"))
        if (entry.path().extension() == ".cpp") names.merge(tests_in(bytes_of(entry.path())));
    return names;
}

// Returns the texts in backquotes.
std::vector<std::string> quoted(const std::string& page) {
    std::vector<std::string> found;
    for (size_t open = page.find('`'); open != page.npos;) {
        const size_t close = page.find('`', open + 1);
        if (close == page.npos) break;
        found.push_back(page.substr(open + 1, close - open - 1));
        open = page.find('`', close + 1);
    }
    return found;
}

// Returns true for "Suite.Name", as tests are written in prose.
bool is_test(const std::string& text) {
    const size_t dot = text.find('.');
    return dot != text.npos && std::isupper(static_cast<unsigned char>(text[0])) &&
           is_name(text.substr(0, dot)) && is_name(text.substr(dot + 1));
}

bool is_graph(const std::string& text) {
    return text.starts_with("graphs/") && text.ends_with(".json");
}

std::vector<std::string> missing_from(const std::string& page, const std::set<std::string>& tests) {
    std::vector<std::string> missing;
    for (const std::string& text : quoted(page))
        if ((is_test(text) && !tests.count(text)) || (is_graph(text) && !fs::exists(root / text)))
            missing.push_back(text);
    return missing;
}

TEST(Proofs, NameTestsAndGraphsThatExist) {
    const std::set<std::string> tests = tests_in_the_sources();
    for (const char* name : {"docs/pitfalls.md", "docs/checklists.md"}) {
        const std::string page = bytes_of(root / name);
        const std::vector<std::string> texts = quoted(page);
        EXPECT_GT(std::count_if(texts.begin(), texts.end(), is_test), 40) << name;
        for (const std::string& missing : missing_from(page, tests))
            ADD_FAILURE() << name << " names " << missing << ", which is not there";
    }
}

TEST(Proofs, AWrongNameIsNoticed) {
    const std::string page = "`Proofs.AWrongNameIsNoticed` `Proofs.IsNot` `graphs/none.json`";
    EXPECT_EQ(missing_from(page, tests_in_the_sources()),
              (std::vector<std::string>{"Proofs.IsNot", "graphs/none.json"}));
}

}  // namespace
