// Tests that docs/reflection.md names every key that --reflect writes, and no other.
#include <set>

#include "base/text.h"
#include "cli/support.h"

namespace wrinkle::test {
namespace {

using Keys = std::set<std::string>;

void add_keys(const json::Value& value, Keys& keys) {
    for (const json::Member& member : value.children()) {
        if (!member.key.empty()) keys.emplace(member.key);
        add_keys(member.value, keys);
    }
}

class ReflectionTest : public CliTest {
protected:
    // Keys of the reflections of every target in its forms.
    Keys written_keys() {
        put("map.png", "");
        put("g.json", R"({"wrinkle": 1, "inputs": {
                "deep": {"type": "float", "default": 1, "slider": [0, 2], "limits": [0, 3],
                         "step": 0.1, "unit": "x", "label": "Deep", "group": "Relief",
                         "widget": "slider", "when": "input.mode == a", "doc": "How deep",
                         "renamed": ["depth"]},
                "mode": {"type": "choice", "default": "a", "choices": ["a", "b"]}},
            "nodes": {
                "map": {"type": "tangent_normal_map",
                        "in": {"image": "map.png", "uv": {"from": "surface.uv1"}}},
                "softer": {"type": "gradient_scale", "in": {"gradient": {"from": "map.gradient"},
                           "amount": {"from": "input.deep"}}}},
            "outputs": {"normal": {"from": "softer.gradient"}}})");
        Keys keys;
        size_t written = 0;
        for (const char* target :
             {"glsl330", "glsl450", "essl300", "spirv", "hlsl", "msl", "wgsl", "godot3", "godot4"})
            for (const char* form : {"function", "shader"}) {
                const Ran ran = run({"compile", "g.json", "--target", target, "--form", form,
                                     "--params", "uniform", "--reflect", "r.json", "-o", "out"});
                if (ran.code == 2) continue;  // the target lacks the form
                EXPECT_EQ(ran.code, 0) << ran.err;
                add_keys(parsed(get("r.json")), keys);
                ++written;
            }
        EXPECT_EQ(written, 15U);
        return keys;
    }
};

TEST_F(ReflectionTest, IsDocumentedKeyByKey) {
    const std::string page = bytes_of(WRINKLE_SOURCE_DIR "/docs/reflection.md");
    const Keys keys = written_keys();
    EXPECT_GE(keys.size(), 50U);
    for (const std::string& key : keys)
        EXPECT_TRUE(says(page, "`" + key + "`")) << key;
    for (const std::string_view line : split(page, '\n')) {
        if (!line.starts_with("| `")) continue;
        const auto parts = split(line.substr(0, line.find(" |")), '`');
        for (size_t i = 1; i < parts.size(); i += 2)  // the words in backquotes
            EXPECT_TRUE(keys.contains(std::string(parts[i]))) << parts[i];
    }
}

}  // namespace
}  // namespace wrinkle::test
