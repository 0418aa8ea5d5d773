// Tests of the reference of .test.json files: the schema of `wrinkle test --schema`, the reader and
// docs/test-cases.md agree on every key.
#include "cli/support.h"
#include "json/write.h"

namespace wrinkle::test {
namespace {

class TestSchemaTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        const Ran ran = run({"test", "--schema"});
        EXPECT_EQ(ran.code, 0) << ran.err;
        schema = parsed(ran.out);
        put("a.json", tilt_graph());
    }
    // Returns the errors of `wrinkle test` for a file with this key.
    std::string problems(const std::string& group, std::string_view key,
                         const std::string& value) const {
        const std::string member = "{\"" + std::string(key) + "\": " + value + "}";
        put("a.test.json", group.empty() ? member : "{\"" + group + "\": " + member + "}");
        return run({"test", "a.test.json"}, "", without_gl()).err;
    }
    // Calls use(group, key, schema of its value); "render" is one of the groups.
    template <class Use>
    void each_key(Use use) const {
        const json::Value top = schema.find("properties");
        ASSERT_EQ(top.size(), 10U);
        for (const json::Member& member : top.children())
            use("", member.key, member.value);
        const json::Value render = top.find("render").find("properties");
        ASSERT_EQ(render.size(), 10U);
        for (const json::Member& member : render.children())
            use("render", member.key, member.value);
    }

    json::Value schema;
};

TEST_F(TestSchemaTest, EveryKeyIsTakenByTheReader) {
    each_key([&](const std::string& group, std::string_view key, const json::Value& value) {
        const json::Value example = value.find("examples").at(0);
        const std::string said = problems(group, key, json::one_line(example));
        EXPECT_EQ(said.find("unknown key"), said.npos) << key << said;
        EXPECT_EQ(said.find("expected "), said.npos) << key << said;
    });
}

TEST_F(TestSchemaTest, AValueOfAnotherTypeIsRefusedAtItsKey) {
    each_key([&](const std::string& group, std::string_view key, const json::Value&) {
        const std::string said = problems(group, key, "null");
        EXPECT_TRUE(says(said, "a.test.json:1:")) << key;
        EXPECT_EQ(said.find("unknown key"), said.npos) << key << said;
    });
}

TEST_F(TestSchemaTest, AnUnknownKeyIsRefusedByBoth) {
    EXPECT_FALSE(schema.find("additionalProperties").as_boolean());
    EXPECT_TRUE(
        says(problems("", "pionts", "[]"), "unknown key 'pionts' (did you mean 'points'?)"));
    const json::Value render = schema.find("properties").find("render");
    EXPECT_FALSE(render.find("additionalProperties").as_boolean());
    EXPECT_TRUE(says(problems("render", "vew", "\"normal\""), "(did you mean 'view'?)"));
    EXPECT_FALSE(schema.find("$defs").find("point").find("additionalProperties").as_boolean());
    EXPECT_TRUE(says(problems("", "points", R"([{"uv": [0, 0]}])"), "there is no 'uv'"));
}

TEST_F(TestSchemaTest, PointsHaveTheInputsThatTheReaderTakes) {
    const json::Value point = schema.find("$defs").find("point").find("properties");
    for (const json::Member& member : point.children()) {
        if (member.key == "dx" || member.key == "dy") continue;
        std::string value = "0.5";
        if (member.value.find("type").as_string() == "array") {
            value = "[0.5";
            for (double i = 1; i < member.value.find("minItems").as_number(); ++i)
                value += ", 0.5";
            value += "]";
        }
        const std::string key(member.key), input = "{\"" + key + "\": " + value + "}";
        EXPECT_EQ(problems("", "points", "[" + input + "]").find("does not fit"), std::string::npos)
            << key;
        const bool changes = schema.find("$defs").find("changes").find("properties").has(key);
        const std::string said = problems("", "points", "[{\"dx\": " + input + "}]");
        EXPECT_EQ(changes, said.find("has no meaning") == said.npos) << key << said;
    }
}

TEST_F(TestSchemaTest, EveryCaseOfTheSamplesHasKeysOfTheSchema) {
    const json::Value top = schema.find("properties");
    size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(WRINKLE_SOURCE_DIR "/graphs")) {
        if (!entry.path().string().ends_with(".test.json")) continue;
        ++files;
        const json::Value sample = parsed(bytes_of(entry.path()));
        for (const json::Member& member : sample.children()) {
            ASSERT_TRUE(top.has(member.key)) << entry.path() << member.key;
            if (member.key != "render") continue;
            for (const json::Member& inner : member.value.children())
                EXPECT_TRUE(top.find("render").find("properties").has(inner.key)) << inner.key;
        }
    }
    EXPECT_GT(files, 30U);
}

TEST_F(TestSchemaTest, ThePageHasALineForEveryKeyWithItsDefault) {
    const std::string page = bytes_of(WRINKLE_SOURCE_DIR "/docs/test-cases.md");
    each_key([&](const std::string& group, std::string_view key, const json::Value& value) {
        const std::string name = (group.empty() ? "" : group + ".") + std::string(key);
        const size_t line = page.find("\n| `" + name + "` |");
        ASSERT_NE(line, page.npos) << name;
        if (!value.has("default")) return;
        const std::string fallback = "| `" + json::one_line(value.find("default")) + "` |";
        EXPECT_TRUE(says(page.substr(line, page.find('\n', line + 1) - line), fallback)) << name;
    });
}

TEST_F(TestSchemaTest, TheExampleOfThePageRuns) {
    const std::string page = bytes_of(WRINKLE_SOURCE_DIR "/docs/test-cases.md");
    const std::string open = "```json\n";
    const size_t begin = page.find(open) + open.size();
    put("tilt.json", tilt_graph());
    put("tilt.test.json", page.substr(begin, page.find("```", begin) - begin));
    const Ran ran = run({"test", "tilt.test.json"});
    EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
    EXPECT_EQ(ran.out, "2 passed, 0 failed\n");
}

TEST_F(TestSchemaTest, APathIsNeededWithoutIt) {
    const Ran ran = run({"test"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_TRUE(says(ran.err, "test needs NAME.test.json"));
}

}  // namespace
}  // namespace wrinkle::test
