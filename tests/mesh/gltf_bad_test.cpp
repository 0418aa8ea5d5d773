// Tests of invalid glTF files: each is an error that names the file and a remedy.
#include <gtest/gtest.h>

#include <limits>

#include "mesh/files.h"

namespace wrinkle::test {
namespace {

void expect_refused(const std::string& bytes, const std::string& words,
                    const MeshFileOptions& options = {}) {
    const Loaded file = load(bytes, "wrong.gltf", options);
    EXPECT_FALSE(file.mesh) << words;
    EXPECT_NE(file.said.find("wrong.gltf: error: "), std::string::npos) << words << file.said;
    EXPECT_NE(file.said.find(words), std::string::npos) << words << "\n" << file.said;
    EXPECT_NE(file.said.find(')'), std::string::npos) << "no remedy: " << file.said;
    EXPECT_LT(file.said.size(), 1000U);
}

std::string with(std::string text, const std::string& find, const std::string& replacement) {
    const size_t at = text.find(find);
    EXPECT_NE(at, text.npos) << find;
    return at == text.npos ? text : text.replace(at, find.size(), replacement);
}

TEST(BadGltf, IsSaidWithItsRemedy) {
    const std::string good = square().text();
    const auto change = [&](const std::string& find, const std::string& replacement) {
        return with(good, find, replacement);
    };
    expect_refused("{", "is not valid glTF");
    expect_refused("{}", "is not valid glTF");
    expect_refused(R"({"asset": {"version": "2.0"}})", "has no triangles");
    expect_refused(change("\"POSITION\": 0", "\"POSITION\": 9"), "there is no accessor 9");
    expect_refused(change("\"POSITION\": 0", "\"POSITION\": -1"), "there is no accessor -1");
    expect_refused(change("\"POSITION\": 0,", ""), "has no positions");
    expect_refused(change("\"POSITION\": 0", "\"POSITION\": 1"), "POSITION has 2 components");
    expect_refused(change("\"indices\": 2", "\"indices\": 1"), "holds no indices");
    expect_refused(change("\"indices\": 2", "\"indices\": 99"), "is not valid glTF");
    expect_refused(change("\"count\": 6", "\"count\": 7"), "it leaves buffer view 2");
    expect_refused(change("\"count\": 4", "\"count\": 18446744073709551615"), "accessor 0 has");
    expect_refused(change("\"count\": 4", "\"count\": 4611686018427387904"), "accessor 0 has");
    expect_refused(change("\"byteLength\": 48", "\"byteLength\": 999"), "leaves its buffer");
    expect_refused(change("\"byteOffset\": 48", "\"byteOffset\": 18446744073709551615"),
                   "leaves its buffer");
    expect_refused(change("\"bufferView\": 0", "\"bufferView\": 77"), "no buffer view 77");
    expect_refused(change("\"buffer\": 0", "\"buffer\": -3"), "there is no buffer -3");
    expect_refused(change("5126", "5130"), "accessor 0 has a type");
    expect_refused(change("VEC3", "MAT4"), "accessor 0 has a type");
    expect_refused(change("base64,", "base64,!"), "is not valid glTF");
    expect_refused(change("[{\"mesh\": 0}]", "[{\"mesh\": 5}]"), "there is no mesh 5");
    expect_refused(change("\"nodes\": [0]", "\"nodes\": [4]"), "there is no node 4");
    expect_refused(change("[{\"mesh\": 0}]", "[{\"mesh\": 0, \"children\": [0]}]"),
                   "has two parents or is its own");
    expect_refused(change("\"indices\": 2", "\"indices\": 2, \"mode\": 1"), "has no triangles");
    expect_refused(
        change("\"scene\": 0", "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"]"),
        "needs the extension 'KHR_draco_mesh_compression'");
    expect_refused(change("[{\"mesh\": 0}]", "[{\"mesh\": 0, \"scale\": [0, 0, 0]}]"),
                   "no triangle with an area");
    expect_refused(change("[{\"mesh\": 0}]", "[{\"mesh\": 0, \"scale\": [1e300, 1, 1]}]"),
                   "not a finite number");
}

TEST(BadGltf, ValuesThatAreNoNumbers) {
    const float infinity = std::numeric_limits<float>::infinity();
    GltfText gltf;
    gltf.add({0, 0, 0, 1, 0, 0, 1, infinity, 0}, "VEC3");
    gltf.attributes = R"("POSITION": 0)";
    expect_refused(gltf.text(), "a position is not a finite number");
    GltfText uvs = square();
    uvs.add({0, 0, 0, 0, -infinity, infinity - infinity, 0, 0}, "VEC2");
    uvs.attributes += R"(, "TEXCOORD_2": 3)";
    expect_refused(uvs.text(), "a uv of set 2 is not a finite number");
    GltfText far = square();
    far.add_indices({0, 1, 4});
    far.primitive = R"(, "indices": 3)";
    expect_refused(far.text(), "mesh 0, primitive 0: index 4 of 4 vertices");
}

// Every truncated file is an error; none is read in part.
TEST(BadGltf, EveryTruncationIsAnError) {
    const std::string text = square().text(), glb = square().glb();
    for (size_t length = 0; length < text.size(); ++length)
        EXPECT_FALSE(load(text.substr(0, length)).mesh) << length;
    for (size_t length = 0; length < glb.size(); ++length)
        EXPECT_FALSE(load(glb.substr(0, length)).mesh) << length;
    expect_refused(glb.substr(0, glb.size() - 4), "is truncated: ");
    expect_refused(glb.substr(0, 15), "is truncated within its header");
}

// With any changed byte, the result is a mesh or an error.
TEST(BadGltf, NoByteDoesHarm) {
    for (const std::string& good : {square().text(), square().glb()})
        for (size_t at = 0; at < good.size(); ++at)
            for (const char byte : {'\0', '\xFF', '9', '{'}) {
                std::string bad = good;
                bad[at] = byte;
                const Loaded file = load(bad);
                EXPECT_EQ(file.mesh.has_value(), !file.diagnostics.has_errors()) << at;
            }
}

TEST(BadGltf, HeadersThatLie) {
    const std::string glb = square().glb();
    const auto change = [&](size_t at, const std::string& bytes) {
        std::string result = glb;
        return result.replace(at, bytes.size(), bytes);
    };
    expect_refused(change(4, "\x01"), "is glTF of version 1");
    expect_refused(change(8, "\xFF\xFF\xFF\xFF"), "is truncated: ");
    expect_refused(change(12, "\xFF\xFF\xFF\xFF"), "its JSON is longer than the file");
    expect_refused(change(16, "JUNK"), "is not valid glTF");
}

TEST(BadGltf, NestingAndSizeHaveLimits) {
    const std::string deep(100'000, '[');
    expect_refused(R"({"asset": {"version": "2.0"}, "extras": )" + deep, "deeper than 64 levels");
    MeshFileOptions small;
    small.limits.max_corners = 5;
    expect_refused(square().text(), "more than 5", small);
}

}  // namespace
}  // namespace wrinkle::test
