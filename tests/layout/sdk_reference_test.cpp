// Tests that docs/sdk.md has a line for every public name of core/sdk/wrinkle, and for no other.
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/files.h"

namespace {

using wrinkle::test::bytes_of;
using Names = std::set<std::string>;
namespace fs = std::filesystem;

const fs::path headers = WRINKLE_SOURCE_DIR "/core/sdk/wrinkle";

std::vector<std::string> lines_of(const fs::path& file) {
    std::istringstream text(bytes_of(file));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);)
        lines.push_back(line);
    return lines;
}

// The headers are formatted: the first columns of a line identify the declared name.
void add_declared(const std::string& line, bool member, Names& names) {
    static const std::regex outside[] = {
        std::regex(R"(^(?:class|struct|enum class|concept) (\w+))"),
        std::regex(R"(^(?! |return |static_assert|extern )[\w:<>&*,. ]+ [&*]?(\w+)\()"),
        std::regex(R"(^WRINKLE_(?:UNARY|BINARY)\((\w+)\))"),
        std::regex(R"(^inline constexpr [\w<>:]+ (\w+)[ {=])"),
        std::regex(R"(^#define (WRINKLE_PLUGIN)\()")};
    static const std::regex inside(R"(^    (?! |return |explicit )[\w:<>&*,. ]+ [&*]?(\w+)\()");
    std::smatch match;
    for (const std::regex& form : outside)
        if (std::regex_search(line, match, form)) names.insert(match[1]);
    if (member && std::regex_search(line, match, inside)) names.insert(match[1]);
}

Names names_of_cpp(const fs::path& file) {
    Names names;
    bool hidden = false, member = false;
    for (std::string line : lines_of(file)) {
        if (line == "namespace detail {" || line.starts_with("}  // namespace detail"))
            hidden = line.front() == 'n';
        if (line.ends_with('{') && (line.starts_with("class ") || line.starts_with("struct ")))
            member = true;
        if (line == "private:" || line == "};") member = false;
        if (line == "public:") member = true;
        line = line.substr(0, line.find("//"));
        if (!hidden && line.find("operator") == line.npos) add_declared(line, member, names);
    }
    return names;
}

Names names_of_c(const fs::path& file) {
    static const std::regex forms[] = {std::regex(R"(^typedef (?:struct|uint32_t) (\w+))"),
                                       std::regex(R"(^(?:typedef|    [\w]).*\(\*(\w+)\)\()"),
                                       std::regex(R"(^WR_EXPORT .*[ *](\w+)\()"),
                                       std::regex(R"(^#define (WR_\w+))")};
    Names names;
    std::smatch match;
    for (const std::string& line : lines_of(file))
        for (const std::regex& form : forms)
            if (std::regex_search(line, match, form)) names.insert(match[1]);
    names.erase("build");  // a member of wr_node, written by the node author
    return names;
}

Names declared() {
    Names names;
    for (const auto& entry : fs::directory_iterator(headers)) {
        const std::string name = entry.path().filename();
        if (name == "body.h") continue;  // everything in it is in `detail`
        names.merge(name == "plugin.h" ? names_of_c(entry.path()) : names_of_cpp(entry.path()));
    }
    return names;
}

// Words of the first cells; those of arguments do not count.
Names documented() {
    static const std::regex word(R"(\w+)"), arguments(R"(\([^`]*\))");
    Names names;
    for (const std::string& line : lines_of(WRINKLE_SOURCE_DIR "/docs/sdk.md")) {
        if (!line.starts_with("| `")) continue;
        const std::string cell =
            std::regex_replace(line.substr(2, line.find(" | ", 2) - 2), arguments, "");
        for (std::sregex_iterator at(cell.begin(), cell.end(), word), end; at != end; ++at)
            names.insert(at->str());
    }
    return names;
}

TEST(SdkReference, EveryPublicNameHasALine) {
    const Names names = declared(), page = documented();
    EXPECT_GT(names.size(), 150U);
    for (const char* each : {"fwidth", "detach", "hash", "resolve", "loop", "sample_grad", "Choice",
                             "front_normal", "wr_builder", "in", "fail"})
        EXPECT_TRUE(names.contains(each)) << each;
    for (const std::string& name : names)
        EXPECT_TRUE(page.contains(name)) << name << " is not in docs/sdk.md";
}

// The name before each parenthesis must be declared.
TEST(SdkReference, EveryLineIsOfAPublicName) {
    static const std::regex called(R"((\w+)(?:<[^>]*>)?\()");
    const Names names = declared();
    for (const std::string& line : lines_of(WRINKLE_SOURCE_DIR "/docs/sdk.md")) {
        if (!line.starts_with("| `")) continue;
        const std::string cell = line.substr(2, line.find(" | ", 2) - 2);
        for (std::sregex_iterator at(cell.begin(), cell.end(), called), end; at != end; ++at)
            EXPECT_TRUE(names.contains((*at)[1])) << (*at)[1] << " is not in core/sdk/wrinkle";
    }
}

}  // namespace
