// Tests that replace every file that the program reads by special files and links that lead out of
// the root, and by empty, huge or damaged files.
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>

#include "hostile/support.h"

namespace wrinkle::hostile {
namespace {

using Names = std::vector<std::string>;

// A file that a command reads, relative to the project's folder.
struct Position {
    std::string file;
    Names args;
    std::set<std::string> outputs = {};

    // Returns true if the user names the file, or its plugin: it may then be outside of the root.
    bool is_named() const {
        return file.ends_with(".so.json") ||
               std::any_of(args.begin(), args.end(), [&](const std::string& arg) {
                   return arg == file || arg == "@" + file;
               });
    }
};

enum class Kind {
    missing,
    directory,
    pipe,
    device,
    socket,
    link_out,
    dangling_link,
    link_to_itself,
    link_to_pipe,
    unreadable,
    empty,
    huge,
    damaged,
};
constexpr const char* kind_names[] = {
    "missing",        "directory",    "pipe",       "device", "socket", "link out", "dangling link",
    "link to itself", "link to pipe", "unreadable", "empty",  "huge",   "damaged"};

void make_socket(const fs::path& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string text = path;
    ASSERT_LT(text.size(), sizeof address.sun_path);
    text.copy(address.sun_path, text.size());
    const int handle = socket(AF_UNIX, SOCK_STREAM, 0);
    EXPECT_EQ(bind(handle, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    close(handle);
}

void make_pipe(const fs::path& path) {
    EXPECT_EQ(mkfifo(path.c_str(), 0666), 0);
}

class HostileFiles : public HostileTest {
protected:
    void SetUp() override {
        HostileTest::SetUp();
        fs::permissions(folder, fs::perms::all);
        put("graph.json", R"({"wrinkle": 1,
 "nodes": {
  "base": {"type": "tangent_normal_map", "in": {"image": "base.png"}},
  "inner": {"type": "graph:inner.json"},
  "sum": {"type": "gradient_add", "in": {"a": {"from": "base.gradient"}, "b": {"from": "inner.bump"}}},
  "normal": {"type": "resolve", "in": {"gradient": {"from": "sum.gradient"}}}
 },
 "outputs": {"normal": {"from": "normal.normal"}}
}
)");
        put("inner.json", R"({"wrinkle": 1, "nodes": {"dots": {"type": "domes"}},
 "outputs": {"bump": {"from": "dots.height"}}}
)");
        put("plain.json", test::tilt_graph());
        put("plain.test.json",
            R"({"points": [{"normal": [0, 0, 1]}], "expect": [{"normal": [-0.6, 0, 0.8]}],
 "glsl": true, "render": {"size": "8x8"}})");
        put("points.json", R"([{"normal": [0, 0, 1]}])");
        put("options", "check\nplain.json\n");
        put("driver.log", "0:3(1): error: bad\n");
        put("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
        fs::copy_file(WRINKLE_SOURCE_DIR "/graphs/textures/weave_normal.png", folder / "base.png");
        put("wall/a_normal.png", get("base.png"));
        put("wall/a_height.png", get("base.png"));
        fs::copy_file(WRINKLE_SOURCE_DIR "/graphs/compare/meshes/bent_cylinder.glb",
                      folder / "mesh.glb");
        put_gltf();
        fs::copy_file(WRINKLE_RIPPLES, folder / "nodes.so");
        temporary.put("outside/other.txt", "no secret");
        make_pipe(folder.parent_path() / "outside/pipe");
        run({"test", ".", "--update"});
        run({"plugins", "--manifest", "nodes.so"});
        ASSERT_TRUE(exists("golden/plain.glsl") && exists("golden/plain.png"));
        ASSERT_TRUE(exists("nodes.so.json"));
        make_caches();
        baseline();
    }

    void attack(const Position& position) {
        const fs::path path = folder / position.file;
        const std::string original = test::bytes_of(path);
        // Only contents reach the parsers that sanitizers check; the other kinds fail to open.
        constexpr Kind first = WRINKLE_SANITIZED ? Kind::empty : Kind::missing;
        for (auto kind = static_cast<size_t>(first); kind < std::size(kind_names); ++kind) {
            fs::remove_all(path);
            place(static_cast<Kind>(kind), path, original, position.is_named());
            unprivileged = static_cast<Kind>(kind) == Kind::unreadable;
            HostileTest::attack(position.file + " is " + kind_names[kind], position.args,
                                position.outputs);
            unprivileged = false;
            clean();
            fs::remove_all(path);
            put(position.file, original);
        }
    }

private:
    void put_gltf() {
        const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        put("mesh.bin", {reinterpret_cast<const char*>(corners), sizeof corners});
        put("mesh.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
 "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "buffers": [{"uri": "mesh.bin", "byteLength": 36}]})");
    }

    // Creates a cache with one entry and the two parts of a bake.
    void make_caches() {
        EXPECT_EQ(run({"compile", "plain.json", "-o", "x.glsl", "--cache", "kept"}).code, 0);
        EXPECT_EQ(run({"compile", "plain.json", "-o", "y.glsl", "--cache", "kept"}).code, 0);
        for (const std::string shard : {"1", "2"}) {
            const Ran ran = run({"bake", "plain.json", "--mesh", "plane", "--size", "100",
                                 "--shard", shard + "/2", "-o", "part" + shard});
            EXPECT_EQ(ran.code, 0) << ran.err;
        }
        fs::remove(folder / "x.glsl");
        fs::remove(folder / "y.glsl");
    }

    void place(Kind kind, const fs::path& path, const std::string& original, bool is_named) {
        switch (kind) {
            case Kind::missing:
                return;
            case Kind::directory:
                fs::create_directory(path);
                return;
            case Kind::pipe:
                make_pipe(path);
                return;
            case Kind::device:
                fs::create_symlink("/dev/zero", path);
                return;
            case Kind::socket:
                make_socket(path);
                return;
            case Kind::link_out:
                fs::create_symlink(
                    folder.parent_path() / (is_named ? "outside/other.txt" : "outside/secret.txt"),
                    path);
                return;
            case Kind::dangling_link:
                fs::create_symlink("nowhere", path);
                return;
            case Kind::link_to_itself:
                fs::create_symlink(path.filename(), path);
                return;
            case Kind::link_to_pipe:
                fs::create_symlink(folder.parent_path() / "outside/pipe", path);
                return;
            case Kind::unreadable:
                put(fs::relative(path, folder), original);
                fs::permissions(path, fs::perms::none);
                return;
            case Kind::empty:
                put(fs::relative(path, folder), "");
                return;
            case Kind::huge:
                put(fs::relative(path, folder), original);
                fs::resize_file(path, uint64_t{1} << 40);
                return;
            case Kind::damaged: {
                std::string bytes = original;
                for (size_t i = 0; i < bytes.size(); i += 7)
                    bytes[i] = static_cast<char>(bytes[i] ^ (i % 251 + 1));
                put(fs::relative(path, folder), bytes);
            }
        }
    }
};

TEST_F(HostileFiles, AsGraphsKeepTheContract) {
    const std::vector<Position> positions = {
        {"graph.json", {"check", "graph.json"}},
        {"graph.json", {"check", "graph.json", "plain.json", "--diagnostics", "json"}},
        {"graph.json", {"compile", "graph.json", "-o", "out.glsl"}, {"out.glsl"}},
        {"graph.json", {"compile", "graph.json", "plain.json", "-o", "out"}, {"out"}},
        {"graph.json", {"eval", "graph.json", "--mesh", "plane", "--uv", "0.5,0.5"}},
        {"graph.json", {"render", "graph.json", "-o", "out.png", "--size", "8x8"}, {"out.png"}},
        {"graph.json",
         {"bake", "graph.json", "--mesh", "plane", "--size", "8", "-o", "out.png"},
         {"out.png"}},
        {"graph.json", {"inputs", "graph.json", "--json"}},
        {"graph.json", {"format", "graph.json"}},
        {"graph.json", {"diff", "graph.json", "plain.json", "--exit-zero"}},
        {"graph.json",
         {"merge", "plain.json", "graph.json", "plain.json", "-o", "out.json"},
         {"out.json", "out.json.conflicts"}},
        {"graph.json", {"upgrade", "graph.json"}},
        {"graph.json", {"explain-log", "graph.json", "driver.log"}},
        {"inner.json", {"check", "graph.json"}},
        {"inner.json", {"compile", "graph.json", "-o", "out.glsl"}, {"out.glsl"}},
        {"inner.json", {"eval", "graph.json", "--mesh", "plane", "--uv", "0.5,0.5"}},
        {"inner.json", {"inputs", "graph.json"}},
        {"inner.json", {"render", "graph.json", "-o", "out.png", "--size", "8x8"}, {"out.png"}},
        {"plain.test.json", {"test", "."}, {".wrinkle"}},
        {"plain.test.json", {"test", "plain.test.json", "--diagnostics", "json"}, {".wrinkle"}},
        {"plain.json", {"test", "."}, {".wrinkle"}},
    };
    for (const Position& position : positions)
        attack(position);
}

TEST_F(HostileFiles, AsImagesAndMeshesKeepTheContract) {
    const std::vector<Position> positions = {
        {"base.png", {"check", "graph.json"}},
        {"base.png", {"compile", "graph.json", "-o", "out.glsl"}, {"out.glsl"}},
        {"base.png", {"compile", "graph.json", "--cost"}},
        {"base.png", {"eval", "graph.json", "--mesh", "plane", "--uv", "0.5,0.5"}},
        {"base.png", {"render", "graph.json", "-o", "out.png", "--size", "8x8"}, {"out.png"}},
        {"base.png",
         {"bake", "graph.json", "--mesh", "plane", "--size", "8", "-o", "out.png"},
         {"out.png"}},
        {"base.png", {"convert", "base.png", "-o", "out.exr", "--to", "derivative"}, {"out.exr"}},
        {"base.png", {"lint", "base.png", "--json"}},
        {"base.png", {"compare", "base.png", "base.png", "-o", "out.png"}, {"out.png"}},
        {"base.png", {"export", "graph.json", "--to", "gltf", "--size", "8", "-o", "out"}, {"out"}},
        {"mesh.glb", {"export", "plain.json", "--mesh", "mesh.glb", "--to", "gltf", "-o", "out"}},
        {"wall/a_normal.png", {"import", "wall", "-o", "out.json"}, {"out.json"}},
        {"wall/a_height.png",
         {"import", "wall/a_normal.png", "wall/a_height.png", "-o", "out.json"},
         {"out.json"}},
        {"base.png",
         {"render", "plain.json", "-o", "out.png", "--size", "8x8", "--environment", "base.png"},
         {"out.png"}},
        {"mesh.obj", {"eval", "plain.json", "--mesh", "mesh.obj", "--uv", "0.2,0.2"}},
        {"mesh.obj",
         {"render", "plain.json", "--mesh", "mesh.obj", "-o", "out.png", "--size", "8x8"},
         {"out.png"}},
        {"mesh.obj",
         {"bake", "plain.json", "--mesh", "mesh.obj", "--size", "8", "-o", "out.png", "-MD"},
         {"out.png", "out.png.d", "out.d"}},
        {"mesh.glb", {"eval", "plain.json", "--mesh", "mesh.glb", "--uv", "0.2,0.2"}},
        {"mesh.gltf", {"eval", "plain.json", "--mesh", "mesh.gltf", "--uv", "0.2,0.2"}},
        {"mesh.bin", {"eval", "plain.json", "--mesh", "mesh.gltf", "--uv", "0.2,0.2"}},
        {"mesh.bin",
         {"bake", "plain.json", "--mesh", "mesh.gltf", "--size", "8", "-o", "out.png"},
         {"out.png"}},
    };
    for (const Position& position : positions)
        attack(position);
}

TEST_F(HostileFiles, AsOptionsLogsGoldensAndPluginsKeepTheContract) {
    const std::vector<Position> positions = {
        {"points.json", {"eval", "plain.json", "--at", "@points.json"}},
        {"options", {"@options"}},
        {"driver.log", {"explain-log", "plain.json", "driver.log"}},
        {"golden/plain.glsl", {"test", "."}, {".wrinkle"}},
        {"golden/plain.glsl", {"test", ".", "--report", "out"}, {"out"}},
        {"golden/plain.png", {"test", "."}, {".wrinkle"}},
        {"golden/plain.png", {"test", ".", "--report", "out"}, {"out"}},
        {"nodes.so", {"check", "plain.json", "--plugin-path", "nodes.so"}},
        {"nodes.so", {"plugins", "--plugin-path", "."}},
        {"nodes.so", {"plugins", "--manifest", "nodes.so"}, {"nodes.so.json"}},
        {"nodes.so", {"plugins", "--test", "nodes.so", "--no-gpu"}},
        {"nodes.so.json", {"nodes", "--plugin-path", "nodes.so"}},
        {"nodes.so.json", {"check", "plain.json", "--plugin-path", "."}},
    };
    for (const Position& position : positions)
        attack(position);
}

TEST_F(HostileFiles, AsGoldensAreNotWrittenOutsideOfTheRoot) {
    for (const std::string golden : {"golden/plain.glsl", "golden/plain.png"}) {
        const std::string before = get("../outside/secret.txt");
        attack({golden, {"test", ".", "--update"}, {"golden", ".wrinkle"}});
        EXPECT_EQ(get("../outside/secret.txt"), before) << golden;
    }
}

TEST_F(HostileFiles, InACacheOrAPartOfABakeKeepTheContract) {
    Names kept, parts;
    for (const std::string& name : files()) {
        if (!fs::is_regular_file(folder / name)) continue;
        if (name.starts_with("kept/")) kept.push_back(name);
        if (name.starts_with("part")) parts.push_back(name);
    }
    ASSERT_FALSE(kept.empty());
    ASSERT_GE(parts.size(), 4u);
    for (const std::string& name : kept)
        attack(
            {name, {"compile", "plain.json", "-o", "out.glsl", "--cache", "kept"}, {"out.glsl"}});
    for (const std::string& name : parts) {
        attack({name, {"bake", "--merge", "part1", "part2", "-o", "out.png"}, {"out.png"}});
        attack({name,
                {"bake", "plain.json", "--mesh", "plane", "--size", "100", "--shard", "1/2", "-o",
                 "part1", "--resume"},
                {"part1"}});
    }
}

}  // namespace
}  // namespace wrinkle::hostile
