// The pages that say which test proves what name tests and graphs that are there.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
const fs::path root = WRINKLE_SOURCE_DIR;

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// The first group of every match; of two groups, joined by a dot.
std::vector<std::string> all_matches(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at)
        found.push_back(at->size() > 2 ? at->str(1) + "." + at->str(2) : at->str(1));
    return found;
}

std::set<std::string> tests_in_the_sources() {
    const std::regex declaration(R"(\bTEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\s*\))");
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(root / "tests"))
        if (entry.path().extension() == ".cpp")
            for (const std::string& name : all_matches(text_of(entry.path()), declaration))
                names.insert(name);
    return names;
}

std::vector<std::string> missing_from(const std::string& page, const std::set<std::string>& tests) {
    std::vector<std::string> missing;
    for (const std::string& name : all_matches(page, std::regex(R"(`([A-Z]\w*)\.(\w+)`)")))
        if (!tests.count(name)) missing.push_back(name);
    for (const std::string& graph : all_matches(page, std::regex(R"(`(graphs/[\w/]+\.json)`)")))
        if (!fs::exists(root / graph)) missing.push_back(graph);
    return missing;
}

TEST(Proofs, NameTestsAndGraphsThatExist) {
    const std::set<std::string> tests = tests_in_the_sources();
    for (const char* name : {"docs/pitfalls.md", "docs/checklists.md"}) {
        const std::string page = text_of(root / name);
        EXPECT_GT(all_matches(page, std::regex(R"(`([A-Z]\w*)\.(\w+)`)")).size(), 40U) << name;
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
