// Tests that the README shows the program's actual output.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>

#include "support/files.h"

namespace {

using wrinkle::test::bytes_of;
const std::filesystem::path repository = WRINKLE_SOURCE_DIR;

TEST(Readme, ShowsTheGeneratedTextOfBaseAndDetail) {
    const std::string golden = bytes_of(repository / "graphs/golden/base_and_detail.glsl");
    ASSERT_FALSE(golden.empty());
    EXPECT_NE(bytes_of(repository / "README.md").find("```glsl\n" + golden + "```"),
              std::string::npos)
        << "put graphs/golden/base_and_detail.glsl into README.md";
}

// A block of C++ in the README must be part of the program of docs/embedding.md, which a test
// builds.
TEST(Readme, ShowsAProgramThatIsBuilt) {
    const std::string readme = bytes_of(repository / "README.md");
    const std::string open = "```cpp\n", page = bytes_of(repository / "docs/embedding.md");
    const size_t from = readme.find(open);
    ASSERT_NE(from, std::string::npos);
    const size_t begin = from + open.size(), end = readme.find("```", begin);
    const size_t program = page.find("```cpp materials.cpp\n");
    const size_t found = page.find("\n" + readme.substr(begin, end - begin), program);
    ASSERT_NE(program, std::string::npos);
    EXPECT_LT(found, page.find("\n```\n", program));
}

// Files read by the commands must be in the repository, or the page must mark them as the reader's.
TEST(Readme, FilesOfItsCommandsExistOrAreDeclared) {
    const std::string readme = bytes_of(repository / "README.md");
    const size_t declared = readme.find("Files of your own are ");
    ASSERT_NE(declared, std::string::npos);
    const std::string own = readme.substr(declared, readme.find(". ", declared) - declared);
    static const std::regex file(R"((-o )?([\w./*]+\.(?:json|glb|obj|hdr|exr|png|log|so))\b)");
    size_t files = 0;
    std::istringstream lines(readme);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("    wrinkle ") && !line.starts_with("    ./run ")) continue;
        for (std::sregex_iterator at(line.begin(), line.end(), file), end; at != end; ++at) {
            const std::string name = (*at)[2];
            if ((*at)[1].matched || name == "*.json") continue;
            ++files;
            EXPECT_TRUE(own.find("`" + name + "`") != own.npos ||
                        std::filesystem::exists(repository / name))
                << name << " in: " << line;
        }
    }
    EXPECT_GT(files, 15U);
}

// Links of the pages lead to files of the repository.
TEST(Documents, LinksLeadToFiles) {
    std::vector<std::filesystem::path> pages = {repository / "README.md",
                                                repository / "CONTRIBUTING.md"};
    for (const auto& entry : std::filesystem::directory_iterator(repository / "docs"))
        if (entry.path().extension() == ".md") pages.push_back(entry.path());
    static const std::regex link(R"(\]\(([^) #]+)(#[^)]*)?\))");
    size_t links = 0;
    for (const std::filesystem::path& page : pages) {
        const std::string text = bytes_of(page);
        for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
            const std::string to = (*at)[1];
            if (to.find_first_of("./") == to.npos || to.starts_with("http")) continue;
            ++links;
            EXPECT_TRUE(std::filesystem::exists(page.parent_path() / to)) << page << ": " << to;
        }
    }
    EXPECT_GT(links, 150U);
}

// Below its title, each page states its kind: that of its list in the README.
TEST(Documents, StateTheKindOfTheirList) {
    const std::string readme = bytes_of(repository / "README.md");
    static const std::regex link(R"(\]\(docs/([\w-]+\.md)\))");
    size_t listed = 0;
    for (const std::string kind : {"Tutorial", "How to", "Reference", "Explanation"}) {
        const size_t begin = readme.find("\n" + kind + (kind == "Tutorial" ? "s:\n" : ":\n"));
        ASSERT_NE(begin, readme.npos) << kind;
        const size_t list = readme.find("\n* ", begin), end = readme.find("\n\n", list);
        const std::string links = readme.substr(list, end - list);
        for (std::sregex_iterator at(links.begin(), links.end(), link), last; at != last; ++at) {
            const std::string text = bytes_of(repository / "docs" / (*at)[1].str());
            const size_t title = text.find('\n');
            EXPECT_EQ(text.substr(title, kind.size() + 6), "\n\n*" + kind + "*\n\n") << (*at)[1];
            ++listed;
        }
    }
    const auto pages = std::filesystem::directory_iterator(repository / "docs");
    EXPECT_EQ(listed, std::ranges::count_if(pages, [](const auto& entry) {
                  return entry.path().extension() == ".md";
              }));
}

// Base and detail in function form take at most 36 lines: 6 of them are the result's struct and its
// assignment, without which a further output would change the signature, 3 are named constants.
TEST(Readme, BaseAndDetailStayShort) {
    const std::string golden = bytes_of(repository / "graphs/golden/base_and_detail.glsl");
    EXPECT_LE(std::count(golden.begin(), golden.end(), '\n'), 36);
}

}  // namespace
