// Tests of the frame of exports: files are complete or absent, and every host takes every material.
#include "export/export.h"

#include <map>

#include "base/temporary.h"
#include "base/text.h"
#include "export/support.h"
#include "registry/port_type.h"
#include "support/samples.h"

namespace wrinkle::test {
namespace {
namespace fs = std::filesystem;
using Names = std::vector<std::string>;

const std::string red = R"("color": [0.5, 0, 0])";

TEST_F(ExportTest, EveryHostTakesEveryMaterial) {
    for (const Host& host : hosts())
        for (const fs::path& graph : sample_graphs()) {
            if (graph.parent_path().filename() != "materials") continue;
            const Names files = export_graph(std::string(host.name), graph);
            EXPECT_FALSE(diagnostics.has_errors()) << host.name << to_text(diagnostics);
            EXPECT_TRUE(std::ranges::count(files, "README.txt")) << host.name << graph;
            EXPECT_GE(files.size(), 2U);
        }
}

TEST_F(ExportTest, EveryHostTakesAGraphWithOneOutput) {
    const std::map<PortType, std::string> sources = {
        {PortType::float_, "a.result"},        {PortType::color_, "c.color"},
        {PortType::normal_, "surface.normal"}, {PortType::vec3_, "surface.position"},
        {PortType::height_, "n.height"},       {PortType::material_, "m.material"}};
    Names outputs(standard_outputs().begin(), standard_outputs().end());
    outputs.push_back("other");
    for (const std::string& output : outputs) {
        const PortType type = standard_output(output).value_or(PortType::float_);
        ASSERT_TRUE(sources.contains(type)) << output;
        const fs::path graph = folder.put(
            "rock.json", R"({"wrinkle": 1, "nodes": {"a": {"type": "add"}, "c": {"type": "color"},
            "n": {"type": "value_noise"}, "m": {"type": "material"}}, "outputs": {")" +
                             output + R"(": {"from": ")" + sources.at(type) + "\"}}}");
        for (const Host& host : hosts()) {
            const Names files = export_graph(std::string(host.name), graph);
            EXPECT_FALSE(diagnostics.has_errors()) << host.name << to_text(diagnostics);
            EXPECT_GE(files.size(), 2U) << host.name << " " << output;
        }
    }
}

TEST_F(ExportTest, AGraphWithoutOutputsIsAnError) {
    const fs::path graph = folder.put(
        "rock.json", R"({"wrinkle": 1, "nodes": {"a": {"type": "add"}}, "outputs": {}})");
    for (const Host& host : hosts()) {
        EXPECT_TRUE(export_graph(std::string(host.name), graph).empty()) << host.name;
        EXPECT_TRUE(says("rock.json: error: the graph has no outputs")) << to_text(diagnostics);
        EXPECT_FALSE(fs::exists(out())) << host.name;
    }
}

// A promise of docs/promises.md: a line is changed only with an entry in the CHANGELOG.
TEST_F(ExportTest, TheFilesOfEveryHostHaveTheseNames) {
    const std::map<std::string_view, std::string_view> wanted = {
        {"gltf", "base_and_detail.glb"},
        {"materialx", "base_and_detail.mtlx textures/rivets_normal.png textures/weave_normal.png"},
        {"three",
         "base_and_detail.js base_and_detail.webgpu.js index.html mesh.glb package.json "
         "textures/rivets_normal.exr textures/weave_normal.exr"},
        {"godot",
         "base_and_detail/base_and_detail.gdshader base_and_detail/base_and_detail_material.tres "
         "base_and_detail/textures/rivets_normal.exr "
         "base_and_detail/textures/rivets_normal.exr.import "
         "base_and_detail/textures/weave_normal.exr "
         "base_and_detail/textures/weave_normal.exr.import "
         "main.tscn mesh.glb mesh.glb.import project.godot"},
        {"godot3",
         "base_and_detail/base_and_detail.shader base_and_detail/base_and_detail_material.tres "
         "base_and_detail/textures/rivets_normal.stex base_and_detail/textures/weave_normal.stex "
         "main.tscn mesh.tres project.godot"},
        {"blender", "base_and_detail.py mesh.obj textures/base_and_detail_normal.png"},
        {"unity",
         "base_and_detail.hlsl base_and_detail.hlsl.meta base_and_detail.mat "
         "base_and_detail.mat.meta base_and_detail.shader base_and_detail.shader.meta "
         "textures/rivets_normal.exr textures/rivets_normal.exr.meta textures/weave_normal.exr "
         "textures/weave_normal.exr.meta"},
        {"unreal", "base_and_detail.py base_and_detail.ush textures/T_base_and_detail_N.png"},
    };
    for (const Host& host : hosts()) {
        std::string all;
        for (const std::string& file :
             export_graph(std::string(host.name),
                          fs::path(WRINKLE_SOURCE_DIR) / "graphs/base_and_detail.json"))
            all += " " + file;
        ASSERT_TRUE(wanted.contains(host.name)) << host.name;
        EXPECT_EQ(all, " README.txt " + std::string(wanted.at(host.name))) << host.name;
    }
}

TEST_F(ExportTest, KeepsOtherFilesAndDoesNotTouchEqualOnes) {
    folder.put("out/mine.txt", "mine");
    for (const Host& host : hosts()) {
        const std::string name(host.name);
        const Names files = export_channels(name, red);
        ASSERT_FALSE(files.empty()) << to_text(diagnostics);
        const auto written = fs::last_write_time(out() / files[0]) - std::chrono::hours(1);
        for (const std::string& file : files)
            fs::last_write_time(out() / file, written);
        EXPECT_EQ(export_channels(name, red), files);
        for (const std::string& file : files)
            EXPECT_EQ(fs::last_write_time(out() / file), written) << file;
    }
    EXPECT_EQ(bytes_of(out() / "mine.txt"), "mine");
}

TEST_F(ExportTest, AnErrorLeavesTheFolderAsItWas) {
    for (const Host& host : hosts()) {
        const std::string name(host.name);
        ASSERT_FALSE(export_channels(name, red).empty());
        const std::string readme = bytes_of(out() / "README.txt");
        EXPECT_TRUE(export_channels(name, R"("color": {"from": "missing.color"})").empty());
        EXPECT_TRUE(diagnostics.has_errors());
        EXPECT_EQ(bytes_of(out() / "README.txt"), readme);
        for (const auto& entry : fs::directory_iterator(folder.path()))
            EXPECT_FALSE(Temporary::is_name(entry.path().filename().native())) << entry.path();
    }
}

TEST_F(ExportTest, MapsNeedUvs) {
    mesh.uvs[0].clear();
    mesh.tangents.clear();
    for (const char* host : {"gltf", "blender", "unreal"}) {
        EXPECT_TRUE(export_channels(host, red).empty()) << host;
        EXPECT_TRUE(says("the mesh: error: the mesh has no uvs (set 0)")) << to_text(diagnostics);
    }
    EXPECT_FALSE(fs::exists(out()));
}

TEST_F(ExportTest, AUvSetThatTheMeshLacksIsNamed) {
    mesh.uvs[1].clear();
    const fs::path graph = WRINKLE_SOURCE_DIR "/graphs/woven_strap.json";
    for (const Host& host : hosts()) {
        const bool has_mesh = host.name != "unity";  // the others write one or bake for one
        const Names files = export_graph(std::string(host.name), graph);
        EXPECT_EQ(says("the mesh lacks 'uv1'"), has_mesh) << host.name << to_text(diagnostics);
        EXPECT_EQ(files.empty(), diagnostics.has_errors()) << host.name;
    }
}

TEST_F(ExportTest, DoesNotReplaceAnInput) {
    inputs = {folder.put("out/README.txt", "of the project").string()};
    for (const Host& host : hosts())
        EXPECT_TRUE(export_channels(std::string(host.name), red).empty());
    EXPECT_TRUE(says("would replace the input")) << to_text(diagnostics);
    EXPECT_EQ(bytes_of(out() / "README.txt"), "of the project");
}

TEST_F(ExportTest, NamesOfMaterialsAreIdentifiers) {
    for (const char* wrong : {"../rock", "a b", "1rock", "a\"b", "a\nb", "r\u00f6ck", "a/b", "."})
        for (const Host& host : hosts()) {
            name = wrong;
            EXPECT_TRUE(export_channels(std::string(host.name), red).empty()) << name;
            EXPECT_TRUE(says("an identifier is needed")) << to_text(diagnostics);
        }
    EXPECT_FALSE(fs::exists(out()));
}

// Hosts read the names of images in paths, URLs and quoted strings.
TEST_F(ExportTest, FilesOfImagesHaveNamesOfLettersDigitsAndUnderscores) {
    const char* images[] = {"a\"b'#$(x) %41.png", "a_b_x_41.png", "A_B_x_41.png"};
    std::string nodes;
    for (size_t i = 0; i < std::size(images); ++i) {
        fs::copy(WRINKLE_SOURCE_DIR "/graphs/textures/weave_normal.png", folder.path() / images[i]);
        nodes += R"("n)" + std::to_string(i) +
                 R"(": {"type": "tangent_normal_map", "in": {"image": )" + json_quoted(images[i]) +
                 "}},";
    }
    nodes += R"("sum": {"type": "gradient_add", "in": {"a": {"from": "n0.gradient"},)"
             R"( "b": {"from": "n1.gradient"}}},)"
             R"("all": {"type": "gradient_add", "in": {"a": {"from": "sum.gradient"},)"
             R"( "b": {"from": "n2.gradient"}}},)"
             R"("up": {"type": "resolve", "in": {"gradient": {"from": "all.gradient"}}},)";
    for (const char* host : {"three", "godot", "godot3", "unity"}) {
        export_channels(host, R"("normal": {"from": "up.normal"})", nodes);
        EXPECT_FALSE(diagnostics.has_errors()) << to_text(diagnostics);
        std::set<std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(out()))
            if (entry.path().parent_path().filename() == "textures")
                found.insert(lower_case(entry.path().stem().stem().string()));
        EXPECT_EQ(found, (std::set<std::string>{"a_b_x_41", "a_b_x_41_2", "a_b_x_41_3"})) << host;
        fs::remove_all(out());
    }
}

TEST_F(ExportTest, NamesAFolderThatCannotBeMade) {
    folder.put("out", "a file");
    EXPECT_TRUE(export_channels("gltf", red).empty());
    EXPECT_TRUE(says((out() / "").string().substr(0, out().string().size())));
    EXPECT_EQ(bytes_of(out()), "a file");
}

TEST_F(ExportTest, RemovesTheFilesOfAKilledExport) {
    folder.put(".wrinkle-tmp-1-0.files/big.png", "x");
    EXPECT_FALSE(export_channels("gltf", red).empty());
    EXPECT_FALSE(fs::exists(folder.path() / ".wrinkle-tmp-1-0.files"));
}

}  // namespace
}  // namespace wrinkle::test
