// Tests that every command reads only regular files: pipes, devices and links to them are errors
// with a message. Streams are read only if the command line names them.
#include <sys/stat.h>
#include <unistd.h>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

class SpecialFilesTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        alarm(300);  // a command that blocks ends the test program
        put("g.json", tilt_graph());
        mkfifo((folder / "pipe").c_str(), 0600);
        for (const char* extension :
             {".json", ".test.json", ".png", "_color.png", ".obj", ".hdr", ".so"}) {
            fs::create_symlink("pipe", folder / ("pipe" + std::string(extension)));
            fs::create_symlink("/dev/zero", folder / ("zero" + std::string(extension)));
        }
    }
    void TearDown() override { alarm(0); }

    // Runs `words` with '*' replaced by the stem of a pipe, and by that of a device.
    void expect_refused(const std::vector<std::string>& words, int code = 1) {
        for (const auto& [stem, kind] :
             {std::pair{"pipe", "is a pipe, not a file"}, {"zero", "is a device, not a file"}}) {
            std::vector<std::string> args = words;
            std::string line;
            for (std::string& word : args) {
                if (const size_t star = word.find('*'); star != word.npos)
                    word.replace(star, 1, stem);
                line += word + " ";
            }
            const Ran ran = run(args);
            EXPECT_EQ(ran.code, code) << line << ran.err;
            EXPECT_TRUE(says(ran.err + ran.out, kind)) << line;
        }
    }

    // Runs a line in bash, which replaces <(COMMAND).
    Ran shell(const std::string& line) {
        const std::string wrinkle = std::exchange(program, "/bin/bash");
        const Ran ran = run({"-c", "wrinkle() { " + wrinkle + " \"$@\"; }; " + line});
        program = wrinkle;
        return ran;
    }
};

TEST_F(SpecialFilesTest, AreRefusedByEveryCommand) {
    put("log.txt", "0:1(1): error: x\n");
    put("plane.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"check", "*.json"},
             {"compile", "*.json"},
             {"eval", "*.json", "--at", "{}"},
             {"eval", "g.json", "--at", "@*.json"},
             {"eval", "g.json", "--mesh", "./*.obj", "--uv", "0.5,0.5"},
             {"render", "*.json", "-o", "out.png"},
             {"render", "g.json", "-o", "out.png", "--environment", "*.hdr"},
             {"bake", "*.json", "--mesh", "plane.obj", "-o", "out.png"},
             {"bake", "g.json", "--mesh", "./*.obj", "-o", "out.png"},
             {"inputs", "*.json"},
             {"format", "*.json"},
             {"upgrade", "*.json"},
             {"explain-log", "*.json", "log.txt"},
             {"explain-log", "g.json", "*.json"},
             {"convert", "*.png", "--to", "height", "-o", "out.png"},
             {"lint", "*.png"},
             {"compare", "*.png", "*.png"},
             {"merge", "g.json", "*.json", "g.json"},
             {"textconv", "*.json"},
             {"import", "*_color.png", "-o", "out.json", "--root", "/"},
             {"export", "*.json", "--to", "gltf", "-o", "out.png"},
             {"export", "g.json", "--mesh", "./*.obj", "--to", "gltf", "-o", "out.png"},
             {"test", "*.test.json"}})
        expect_refused(words);
    expect_refused({"diff", "*.json", "g.json"}, 2);
    expect_refused({"check", "@*.json"}, 2);
    EXPECT_FALSE(exists("out.png"));
}

TEST_F(SpecialFilesTest, AreRefusedWhereTestsNameThem) {
    put("g.test.json", R"({"glsl": true})");
    fs::create_directory(folder / "golden");
    fs::create_symlink("../pipe", folder / "golden/g.glsl");
    const Ran ran = run({"test", "g.test.json"});
    EXPECT_EQ(ran.code, 1) << ran.err;
    EXPECT_TRUE(says(ran.out, "is a pipe, not a file"));
}

TEST_F(SpecialFilesTest, AreRefusedAsPluginsAndTheirManifests) {
    expect_refused({"check", "g.json", "--plugin-path", "./*.so"});
    fs::copy_file(WRINKLE_RIPPLES, folder / "ripples.so");
    fs::create_symlink("pipe", folder / "ripples.so.json");
    const Ran ran = run({"check", "g.json", "--plugin-path", "./ripples.so"});
    EXPECT_TRUE(says(ran.err, "the manifest is ignored: it is a pipe, not a file"));
}

TEST_F(SpecialFilesTest, AStreamThatIsNamedIsRead) {
    const Ran plain = run({"compile", "g.json", "--name", "g"});
    for (const char* line : {"wrinkle compile <(cat g.json) --name g",
                             "cat g.json | wrinkle compile /dev/stdin --name g",
                             "cat g.json | wrinkle compile - --name g",
                             "wrinkle compile /dev/fd/7 --name g 7<g.json"}) {
        const Ran ran = shell(line);
        EXPECT_EQ(ran.code, 0) << line << ran.err;
        EXPECT_EQ(ran.out, plain.out) << line;
    }
}

TEST_F(SpecialFilesTest, AStreamLargerThanTheLimitIsRefused) {
    const Ran ran = shell("WRINKLE_FILE_MAX_BYTES=100000 wrinkle check - </dev/zero");
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "<stdin>: error: is larger than 100000 bytes"));
}

TEST_F(SpecialFilesTest, AStreamIsNotRewritten) {
    const Ran ran = shell("cat g.json | wrinkle format /dev/stdin");
    EXPECT_EQ(ran.code, 2) << ran.err;
    EXPECT_TRUE(says(ran.err, "/dev/stdin is a stream, which cannot be rewritten"));
}

}  // namespace
}  // namespace wrinkle::test
