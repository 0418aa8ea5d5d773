// Tests that names from files are printed escaped: none moves the cursor or begins a line.
#include "cli/support.h"

namespace wrinkle::test {
namespace {

const std::string evil_json =
    R"(x\u001b[2J\nother.json:1:1: error: forged\u061c\u202e)";  // in JSON
const std::string evil = "x\x1B[2J\nother.json:1:1: error: forged\u061C\u202E";

class PrintedNamesTest : public CliTest {
protected:
    // Checks that no line begins as the forged one would and that there are no control characters.
    void expect_harmless(const Ran& ran, const std::string& what) {
        for (const std::string& text : {ran.out, ran.err}) {
            EXPECT_EQ(text.find("\nother.json"), text.npos) << what << ":\n" << text;
            for (const char* character : {"\x1B", "\u061C", "\u202E"})
                EXPECT_EQ(text.find(character), text.npos) << what << ":\n" << text;
        }
    }

    std::string graph(const std::string& type, const std::string& port) {
        return R"({"wrinkle": 1, "nodes": {
            "n": {"type": ")" +
               type + R"(", "in": {")" + port + R"(": 1}}},
            "outputs": {"value": {"from": "n.result"}}})";
    }
};

TEST_F(PrintedNamesTest, UnknownTypesAndPortsAreEscapedInEveryFormOfDiagnostics) {
    put("type.json", graph(evil_json, "a"));
    put("port.json", graph("add", evil_json));
    put("file.json", graph("graph:" + evil_json, "a"));
    for (const std::string file : {"type.json", "port.json", "file.json"})
        for (const std::string form : {"text", "json", "sarif", "github"}) {
            const Ran ran = run({"check", file, "--diagnostics", form});
            EXPECT_EQ(ran.code, 1);
            EXPECT_TRUE(says(ran.err, "forged"));
            expect_harmless(ran, file + " as " + form);
        }
}

TEST_F(PrintedNamesTest, NamesOfFilesAreEscaped) {
    const std::string missing = evil + "missing.json";
    put(evil + ".json", graph("add", "c"));
    put(evil + ".test.json", R"({"glsl": true})");
    put(evil + "unformatted.json", "{\"wrinkle\": 1}");
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"check", evil + ".json"},
             {"check", missing},
             {"compile", missing},
             {"compile", evil + "unformatted.json", "-o", evil + "/missing/x"},
             {"eval", missing, "--at", "{}"},
             {"test", evil + ".test.json"},
             {"format", "--check", evil + "unformatted.json"},
             {"lint", missing},
             {"compare", missing, missing},
             {"diff", missing, missing},
             {"merge", missing, missing, missing},
             {"settle", evil + "unformatted.json", "x", "--ours"},
             {"textconv", missing},
             {"import", missing, "-o", "out.json"},
             {"import", ".", "-o", evil + "/missing/x"},
             {"export", missing, "--to", "gltf", "-o", "out"},
             {"export", evil + ".json", "--to", "gltf", "-o", evil + "/missing/x", "--name", evil},
             {"inputs", evil + "unformatted.json"},
             {"inputs", "--json", evil + "unformatted.json"},
             {"check", "@" + missing},
             {evil},
             {"watch", evil},
             {"watch", "compile", "--" + evil},
             {"check", "a.json", "--" + evil}})
        expect_harmless(run(words), words[0] + " " + words.back());
}

TEST_F(PrintedNamesTest, CommentsOfEveryLanguageHoldNoControlCharacters) {
    put(evil + ".png", "P6\n1 1\n255\nabc");
    put("g.json",
        R"({"wrinkle": 1, "nodes": {"m\u061cn\u202e": {"type": "image", "in": {"image": ")" +
            evil_json + R"(.png"}}}, "outputs": {"color": {"from": "m\u061cn\u202e.color"}}})");
    for (const std::string target : {"glsl330", "essl300", "glsl450", "hlsl", "msl", "wgsl"}) {
        const Ran ran = run({"compile", "g.json", "--target", target, "--form", "shader"});
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_TRUE(says(ran.out, "// m n"));
        expect_harmless(ran, target);
    }
}

TEST_F(PrintedNamesTest, ALogIsPrintedEscaped) {
    put("g.json", graph("add", "a"));
    put("log.txt", "0:3(1): error: " + evil + "\nhello \x1B[2J\u202E\r\n");
    const Ran ran = run({"explain-log", "g.json", "log.txt"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out.find('\x1B'), ran.out.npos) << ran.out;
    EXPECT_TRUE(says(ran.out, "hello \\x1b[2J\\u202e\n"));
}

}  // namespace
}  // namespace wrinkle::test
