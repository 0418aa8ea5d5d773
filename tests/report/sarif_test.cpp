// SARIF: structure, locations, fingerprints and limits. Its schema is checked by tests/ci.
#include "report/sarif.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "json/parse.h"
#include "report/hostile_results.h"
#include "report/repository.h"
#include "support/files.h"

namespace wrinkle::test {
namespace {

namespace fs = std::filesystem;
using namespace report;

Diagnostic problem_at(const std::string& file, uint32_t line) {
    return {RuleId::unknown_port,    Severity::error, {file, line, 7},
            "/nodes/weave/in/amout", "weave",         "unknown port 'amout'",
            "did you mean 'amount'?"};
}

json::Value parsed_sarif(const Diagnostics& diagnostics,
                         const fs::path& root = fs::current_path()) {
    Diagnostics problems;
    const json::Parsed parsed = json::parse(sarif(diagnostics, {"1.2.3", root}), "sarif", problems);
    EXPECT_TRUE(parsed.complete) << to_text(problems);
    EXPECT_FALSE(problems.has_errors()) << to_text(problems);
    return parsed.root.find("runs").at(0);
}

json::Value result_of(const Diagnostic& diagnostic, const fs::path& root = fs::current_path()) {
    Diagnostics list;
    list.add(diagnostic);
    return parsed_sarif(list, root).find("results").at(0);
}

json::Value physical(const json::Value& result) {
    return result.find("locations").at(0).find("physicalLocation");
}

std::string fingerprint_of(const json::Value& result) {
    return std::string(
        result.find("partialFingerprints").find("primaryLocationLineHash").as_string());
}

TEST(Sarif, AResultHasRuleLevelMessageAndPlace) {
    const json::Value result = result_of(problem_at("graphs/a b.json", 12));
    EXPECT_EQ(result.find("ruleId").as_string(), "unknown-port");
    EXPECT_EQ(result.find("level").as_string(), "error");
    EXPECT_EQ(result.find("message").find("text").as_string(),
              "node 'weave': unknown port 'amout' (did you mean 'amount'?)");
    EXPECT_EQ(physical(result).find("artifactLocation").find("uri").as_string(),
              "graphs/a%20b.json");
    EXPECT_EQ(physical(result).find("region").find("startLine").as_number(), 12);
    EXPECT_EQ(physical(result).find("region").find("startColumn").as_number(), 7);
}

TEST(Sarif, RulesAreListedAtTheirIndex) {
    Diagnostics list;
    list.add(problem_at("a.json", 1));
    const json::Value run = parsed_sarif(list);
    const json::Value driver = run.find("tool").find("driver");
    EXPECT_EQ(driver.find("semanticVersion").as_string(), "1.2.3");
    ASSERT_EQ(driver.find("rules").size(), rule_infos.size());
    const json::Value result = run.find("results").at(0);
    const auto index = static_cast<size_t>(result.find("ruleIndex").as_number());
    const json::Value rule = driver.find("rules").at(index);
    EXPECT_EQ(rule.find("id").as_string(), "unknown-port");
    for (const char* key : {"shortDescription", "fullDescription", "help"})
        EXPECT_FALSE(rule.find(key).find("text").as_string().empty());
}

TEST(Sarif, AProblemWithoutALineIsAtTheFirst) {
    const json::Value region = physical(result_of(file_problem(Severity::warning, RuleId::mesh_uvs,
                                                               "m.obj", "no uvs", "")))
                                   .find("region");
    EXPECT_EQ(region.find("startLine").as_number(), 1);
    EXPECT_FALSE(region.has("startColumn"));
}

TEST(Sarif, AProblemWithoutAFileIsANotification) {
    Diagnostics list;
    list.add(file_problem(Severity::warning, RuleId::cache, "", "hm", ""));
    json::Value run = parsed_sarif(list);
    EXPECT_EQ(run.find("results").size(), 0U);
    const auto invocation = [&] { return run.find("invocations").at(0); };
    EXPECT_TRUE(invocation().find("executionSuccessful").as_boolean());
    list.error(RuleId::opengl, "no OpenGL");
    run = parsed_sarif(list);
    EXPECT_FALSE(invocation().find("executionSuccessful").as_boolean());
    const json::Value said = invocation().find("toolExecutionNotifications").at(1);
    EXPECT_EQ(said.find("descriptor").find("id").as_string(), "opengl");
    EXPECT_EQ(said.find("message").find("text").as_string(), "no OpenGL");
}

TEST(Sarif, FingerprintsStayWhenLinesMoveAndDifferByPlace) {
    const std::string one = fingerprint_of(result_of(problem_at("a.json", 12)));
    EXPECT_EQ(fingerprint_of(result_of(problem_at("a.json", 99))), one);
    Diagnostic other = problem_at("a.json", 12);
    other.message = "unknown port 'amount2'";
    EXPECT_EQ(fingerprint_of(result_of(other)), one);
    other.rule = RuleId::type_mismatch;
    EXPECT_NE(fingerprint_of(result_of(other)), one);
    other = problem_at("a.json", 12);
    other.node = "weave2";
    EXPECT_NE(fingerprint_of(result_of(other)), one);
    other = problem_at("a.json", 12);
    other.pointer += "x";
    EXPECT_NE(fingerprint_of(result_of(other)), one);
    EXPECT_NE(fingerprint_of(result_of(problem_at("b.json", 12))), one);
    Diagnostics twice;
    twice.add(problem_at("a.json", 1));
    twice.add(problem_at("a.json", 2));
    const json::Value results = parsed_sarif(twice).find("results");
    EXPECT_EQ(fingerprint_of(results.at(0)), one);
    EXPECT_EQ(fingerprint_of(results.at(1)), one.substr(0, 16) + ":2");
}

TEST(Sarif, MessagesAreCutAtGitHubsLimitAndHoldNoLinks) {
    const auto text_of = [](std::string message) {
        const json::Value result =
            result_of(file_problem(Severity::error, RuleId::option, "a.json", message, ""));
        return std::string(result.find("message").find("text").as_string());
    };
    const std::string umlaut = "\xC3\xA4";
    std::string fits, longer;
    for (int i = 0; i < 1024; ++i)
        fits += umlaut;
    EXPECT_EQ(text_of(fits), fits);
    longer = fits + "b";
    EXPECT_EQ(text_of(longer), fits.substr(0, 2 * 1021) + "...");
    EXPECT_EQ(text_of("[click](http://example.org)"), "[click] (http://example.org)");
}

TEST(Sarif, HostileTextsAreStrings) {
    Diagnostic diagnostic = problem_at(hostile_text(), 3);
    diagnostic.node = diagnostic.message = diagnostic.pointer = hostile_text();
    const json::Value result = result_of(diagnostic);
    const std::string uri(physical(result).find("artifactLocation").find("uri").as_string());
    EXPECT_EQ(uri.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                    "0123456789-._~/%:"),
              uri.npos);
}

TEST(Sarif, DroppedProblemsAreCounted) {
    Diagnostics list(1);
    list.add(problem_at("a.json", 1));
    list.add(problem_at("a.json", 2));
    const json::Value invocation = parsed_sarif(list).find("invocations").at(0);
    EXPECT_EQ(invocation.find("toolExecutionNotifications")
                  .at(0)
                  .find("message")
                  .find("text")
                  .as_string(),
              "and 1 more problems");
}

TEST(Repository, IsTheNearestFolderWithGit) {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "a/.git");
    fs::create_directories(folder.path() / "a/b/c");
    EXPECT_EQ(repository_root(folder.path() / "a/b/c"), folder.path() / "a");
    EXPECT_EQ(repository_root(folder.path() / "a"), folder.path() / "a");
}

TEST(Repository, PathsAreRelativeToItOrAbsolute) {
    const fs::path here = fs::current_path();
    EXPECT_EQ(path_in_repository("x/./y.json", here), "x/y.json");
    EXPECT_EQ(path_in_repository("y.json", here.parent_path()),
              (here.filename() / "y.json").string());
    EXPECT_EQ(path_in_repository("../z.json", here), (here.parent_path() / "z.json").string());
    EXPECT_EQ(path_in_repository((here / "q").string(), here), "q");
    EXPECT_EQ(uri_of("/a b/\xC3\xA4.json"), "file:///a%20b/%C3%A4.json");
    EXPECT_EQ(uri_of("a:b?c#d.json"), "a%3Ab%3Fc%23d.json");
}

}  // namespace
}  // namespace wrinkle::test
