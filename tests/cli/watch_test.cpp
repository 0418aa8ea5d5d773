// Tests of wrinkle watch: every editor's way to save a file, errors and their end, other inputs
// than the graph, and outputs that are complete at every moment.
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <thread>
#include <utility>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

using namespace std::chrono_literals;
using Names = std::vector<std::string>;

class WatchTest : public CliTest {
protected:
    ~WatchTest() override {
        if (child_ > 0) {
            kill(child_, SIGKILL);
            waitpid(child_, nullptr, 0);
        }
    }

    // Starts `wrinkle watch ARGS` and waits until it has made the first outputs.
    void watch(Names args) {
        args.insert(args.begin(), "watch");
        const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
        const int text =
            open(printed_file().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0600);
        child_ = start(args, nothing, nothing, text, {});
        close(nothing);
        close(text);
        ASSERT_TRUE(becomes([&] { return says(printed(), "watches "); })) << printed();
    }
    fs::path printed_file() const { return folder.parent_path() / "printed"; }
    std::string printed() const { return bytes_of(printed_file()); }

    // Waits for a condition. The limit is long because other tests run at the same time.
    template <class Condition>
    static bool becomes(Condition condition) {
        for (int i = 0; i < 6000; ++i) {
            if (condition()) return true;
            std::this_thread::sleep_for(5ms);
        }
        return false;
    }

    // Waits until out.glsl has the number; it is part of the generated text of scaled_graph().
    testing::AssertionResult shows(const std::string& number) const {
        if (becomes([&] {
                return exists("out.glsl") && get("out.glsl").find(number) != std::string::npos;
            }))
            return testing::AssertionSuccess();
        return testing::AssertionFailure()
               << number << " is not in " << get("out.glsl") << printed();
    }

    size_t count(const std::string& words) const {
        const std::string text = printed();
        size_t found = 0;
        for (size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1))
            ++found;
        return found;
    }

    // Ends the watch and returns its exit code; 128 + the signal if that killed it.
    int stop(int signal) {
        kill(child_, signal);
        int status = 0;
        waitpid(std::exchange(child_, -1), &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

    void move(const std::string& from, const std::string& to) const {
        fs::rename(folder / from, folder / to);
    }

private:
    pid_t child_ = -1;
};

// Ways to save `text` as g.json, in the steps of the programs; docs/watch.md lists them.
struct Way {
    const char* name;
    std::function<void(const fs::path& folder, const std::string& text)> save;
};

void write_text(const fs::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

void save_like_vim(const fs::path& f, const std::string& text) {
    write_text(f / "4913", "");
    fs::remove(f / "4913");
    fs::rename(f / "g.json", f / "g.json~");
    write_text(f / "g.json", text);
    fs::remove(f / "g.json~");
}

void save_like_sed(const fs::path& f, const std::string& text) {
    write_text(f / "sedAbCdEf", text);
    fs::rename(f / "sedAbCdEf", f / "g.json");
}

void save_like_vs_code(const fs::path& f, const std::string& text) {
    std::ofstream file(f / "g.json");
    std::this_thread::sleep_for(30ms);
    file << text.substr(0, text.size() / 2) << std::flush;
    std::this_thread::sleep_for(30ms);
    file << text.substr(text.size() / 2);
}

void save_like_jetbrains(const fs::path& f, const std::string& text) {
    write_text(f / "g.json___jb_tmp___", text);
    fs::rename(f / "g.json", f / "g.json___jb_old___");
    std::this_thread::sleep_for(40ms);
    fs::rename(f / "g.json___jb_tmp___", f / "g.json");
    fs::remove(f / "g.json___jb_old___");
}

void delete_and_write(const fs::path& f, const std::string& text) {
    fs::remove(f / "g.json");
    std::this_thread::sleep_for(40ms);
    write_text(f / "g.json", text);
}

void replace_folder(const fs::path& f, const std::string& text) {
    const fs::path other = f.parent_path() / "other", old = f.parent_path() / "old";
    fs::create_directory(other);
    write_text(other / "g.json", text);
    fs::rename(f, old);
    fs::rename(other, f);
    fs::remove_all(old);
}

const std::vector<Way>& ways() {
    static const std::vector<Way> list = {
        {"in place",
         [](const fs::path& f, const std::string& text) { write_text(f / "g.json", text); }},
        {"vim", save_like_vim},
        {"sed -i, mv", save_like_sed},
        {"VS Code", save_like_vs_code},
        {"JetBrains", save_like_jetbrains},
        {"deleted, then written", delete_and_write},
        {"folder replaced", replace_folder},
    };
    return list;
}

TEST_F(WatchTest, EveryWayToSaveGivesTheNewText) {
    put("src/g.json", ramp_graph("1.5"));
    watch({"compile", "src/g.json", "-o", "out.glsl"});
    int number = 10;
    for (const Way& way : ways())
        for (int i = 0; i < 3; ++i) {
            const std::string amount = std::to_string(++number) + ".25";
            way.save(folder / "src", ramp_graph(amount));
            ASSERT_TRUE(shows(amount)) << way.name;
        }
    EXPECT_EQ(count("error"), 0u) << printed();
    EXPECT_EQ(stop(SIGTERM), 0);
}

TEST_F(WatchTest, FollowsLinks) {
    put("a/g.json", ramp_graph("1.5"));
    put("b/g.json", ramp_graph("2.25"));
    fs::create_directory_symlink("a", folder / "now");
    fs::create_symlink("now/g.json", folder / "link.json");
    watch({"compile", "link.json", "-o", "out.glsl"});
    ASSERT_TRUE(shows("1.5"));
    fs::create_directory_symlink("b", folder / "next");
    move("next", "now");
    ASSERT_TRUE(shows("2.25"));
    put("b/g.json", ramp_graph("3.25"));
    ASSERT_TRUE(shows("3.25"));
    put("c.json", ramp_graph("4.25"));
    fs::remove(folder / "link.json");
    fs::create_symlink("c.json", folder / "link.json");
    ASSERT_TRUE(shows("4.25"));
}

TEST_F(WatchTest, PollsTheFilesToo) {
    put("g.json", ramp_graph("1.5"));
    watch({"--poll", "compile", "g.json", "-o", "out.glsl"});
    int number = 10;
    for (const Way& way : ways()) {
        if (way.name == std::string("folder replaced")) continue;  // it holds the output
        const std::string amount = std::to_string(++number) + ".25";
        way.save(folder, ramp_graph(amount));
        ASSERT_TRUE(shows(amount)) << way.name;
    }
    EXPECT_EQ(count("error"), 0u) << printed();
    EXPECT_EQ(stop(SIGINT), 0);
}

TEST_F(WatchTest, ReportsAnErrorOnceAndItsEnd) {
    put("g.json", ramp_graph("1.5"));
    watch({"compile", "g.json", "-o", "out.glsl"});
    const std::string good = get("out.glsl");
    put("g.json", "{");
    ASSERT_TRUE(becomes([&] { return count("wrinkle: failed (") == 1; })) << printed();
    EXPECT_TRUE(says(printed(), "g.json:1:2: error: "));
    put("h.json", "{ ");
    move("h.json", "g.json");
    put("g.json", "{ \n");
    ASSERT_TRUE(becomes([&] { return count("wrinkle: failed") >= 2; })) << printed();
    EXPECT_EQ(get("out.glsl"), good);
    put("g.json", ramp_graph("2.25"));
    ASSERT_TRUE(becomes([&] { return count("wrinkle: fixed; wrote out.glsl (") == 1; }))
        << printed();
    EXPECT_TRUE(shows("2.25"));
}

TEST_F(WatchTest, SameErrorIsNotRepeated) {
    put("g.json", ramp_graph("1.5"));
    watch({"compile", "g.json", "-o", "out.glsl"});
    put("g.json", "[]");
    ASSERT_TRUE(becomes([&] { return count("wrinkle: failed (") == 1; })) << printed();
    put("g.json", "[ ]");
    ASSERT_TRUE(becomes([&] { return count("wrinkle: failed as before (") == 1; })) << printed();
    EXPECT_EQ(count("error"), 1u) << printed();
}

TEST_F(WatchTest, AGraphMayGoAndReturnOrComeLater) {
    put("g.json", ramp_graph("1.5"));
    watch({"compile", "g.json", "-o", "out.glsl"});
    fs::remove(folder / "g.json");
    ASSERT_TRUE(becomes([&] { return says(printed(), "No such file"); })) << printed();
    put("g.json", ramp_graph("2.25"));
    EXPECT_TRUE(shows("2.25"));
    stop(SIGTERM);
    watch({"compile", "later/g.json", "-o", "out.glsl"});
    put("later/g.json", ramp_graph("3.25"));
    EXPECT_TRUE(shows("3.25"));
}

TEST_F(WatchTest, EqualContentsStartNoBuildAndEqualOutputsAreNotWritten) {
    put("g.json", ramp_graph("1.5"));
    watch({"compile", "g.json", "-o", "out.glsl"});
    const auto before = fs::last_write_time(folder / "out.glsl");
    put("g.json", ramp_graph("1.5"));
    std::this_thread::sleep_for(200ms);
    EXPECT_EQ(count("\n"), 2u) << printed();
    put("g.json", ramp_graph("1.5") + "\n");
    ASSERT_TRUE(becomes([&] { return count("the output is the same (") == 1; })) << printed();
    EXPECT_EQ(fs::last_write_time(folder / "out.glsl"), before);
}

TEST_F(WatchTest, SubGraphsAndFilesThatWereLookedForAreInputs) {
    put("g.json", R"({"wrinkle": 1, "nodes": {
        "inner": {"type": "graph:sub.json"}},
        "outputs": {"value": {"from": "inner.value"}}})");
    watch({"compile", "g.json", "-o", "out.glsl"});
    EXPECT_TRUE(says(printed(), "sub.json"));
    put("sub.json", ramp_graph("1.5"));
    ASSERT_TRUE(shows("1.5"));
    put("sub.json", ramp_graph("2.25"));
    ASSERT_TRUE(shows("2.25"));
}

std::string pixels(const std::string& values) {
    return "P5\n4 1\n255\n" + values;
}

TEST_F(WatchTest, ImagesAreInputs) {
    put("a.pgm", pixels("abcd"));
    watch({"convert", "a.pgm", "--from", "height", "--to", "normal", "-o", "out.png"});
    const std::string first = get("out.png");
    put("b.pgm", pixels("dabc"));
    move("b.pgm", "a.pgm");
    ASSERT_TRUE(becomes([&] { return count("wrote out.png") == 2; })) << printed();
    EXPECT_NE(get("out.png"), first);
    std::this_thread::sleep_for(200ms);
    EXPECT_EQ(count("\n"), 3u) << "its own output started a build:\n" << printed();
}

TEST_F(WatchTest, ANewInputStopsABake) {
    const Names bake = {"bake",      "g.json", "--mesh", "plane", "--size", "16384",
                        "--samples", "16",     "--map",  "value", "-o",     "out.exr"};
    put("g.json", "[]");
    watch(bake);
    put("g.json", ramp_graph("1.5"));
    std::this_thread::sleep_for(300ms);
    put("g.json", "[]");
    EXPECT_TRUE(becomes([&] { return count("wrinkle: failed as before (") == 1; })) << printed();
    put("g.json", ramp_graph("1.5"));
    std::this_thread::sleep_for(300ms);
    EXPECT_EQ(stop(SIGTERM), 0);
    EXPECT_EQ(files(), Names{"g.json"});
}

// Some 10,000 saves of this kind were timed: docs/watch.md.
TEST_F(WatchTest, AReaderSeesCompleteTextsOnly) {
    put("g.json", ramp_graph("0.5"));
    watch({"compile", "g.json", "-o", "out.glsl"});
    const std::string first = get("out.glsl");
    const size_t at = first.find("0.5");
    ASSERT_NE(at, first.npos);
    for (int i = 1; i <= 60; ++i) {
        const std::string number = std::to_string(i) + ".5";
        const std::string whole = first.substr(0, at) + number + first.substr(at + 3);
        const std::string before = get("out.glsl");
        const Way& way = ways()[static_cast<size_t>(i) % 3];
        way.save(folder, ramp_graph(number));
        std::string text;
        ASSERT_TRUE(becomes([&] {
            text = get("out.glsl");
            return text != before;
        })) << printed();
        ASSERT_EQ(text, whole);
    }
    EXPECT_EQ(stop(SIGTERM), 0);
    EXPECT_EQ(files(), (Names{"g.json", "out.glsl"}));
}

TEST_F(WatchTest, RefusesWrongUsage) {
    put("g.json", ramp_graph());
    EXPECT_TRUE(says(run({"watch"}).err, "COMMAND"));
    EXPECT_EQ(run({"watch", "format", "g.json"}).code, 2);
    EXPECT_TRUE(says(run({"watch", "compile", "-"}).err, "standard input"));
    const Ran ran = run({"watch", "compile", "g.json", "--form", "square"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_TRUE(says(ran.err, "square"));
}

}  // namespace
}  // namespace wrinkle::test
