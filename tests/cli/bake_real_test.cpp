// Tests of bakes of a real mesh with a matched pair of normal maps baked in Blender. They need the
// data folder of real_maps_test.cpp and are skipped without it.
#include <algorithm>
#include <array>
#include <cstdlib>

#include "cli/bake_support.h"
#include "support/angle.h"

namespace wrinkle::test {
namespace {

class RealBake : public BakeTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        const char* named = std::getenv("WRINKLE_DATA");
        const fs::path data = named ? fs::path(named) : WRINKLE_SOURCE_DIR "/../shared/data";
        if (!fs::exists(data / "spot_triangulated.obj")) GTEST_SKIP() << "no folder of real maps";
        for (const char* name :
             {"spot_triangulated.obj", "spot_normal_object.png", "spot_normal_tangent_8bit.png"})
            fs::create_symlink(fs::canonical(data / name), folder / name);
    }

    // Writes a graph that samples a normal map with the nearest texel.
    void put_reader(const std::string& node, const std::string& image) {
        graph = "reader.json";
        put(graph, R"({"wrinkle": 1, "nodes": {"map": {"type": ")" + node +
                       R"(", "in": {"image": {"file": ")" + image +
                       R"(", "filter": "nearest"}}},
              "end": {"type": "resolve", "in": {"gradient": {"from": "map.gradient"}}}},
              "outputs": {"normal": {"from": "end.normal"}}})");
    }
    void bake_spot(const std::string& out, const Names& more) const {
        Names all = more;
        all.insert(all.end(), {"--root", "/", "--dilate", "0", "--samples", "1"});
        const Ran ran = bake("spot_triangulated.obj", out, all);
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_TRUE(says(ran.err, "triangles are mirrored in uv"));
    }

    // Sorted angles in degrees between the coded normals, over the texels where `a` has a normal.
    static std::vector<double> angles(const Image& a, const Image& b) {
        std::vector<double> found;
        for (size_t i = 0; i < a.data.size(); i += 3) {
            const auto decoded = [&](const Image& image) {
                return std::array<double, 3>{2.0 * image.data[i] - 1, 2.0 * image.data[i + 1] - 1,
                                             2.0 * image.data[i + 2] - 1};
            };
            const auto x = decoded(a);
            if (x[0] * x[0] + x[1] * x[1] + x[2] * x[2] < 0.5) continue;
            found.push_back(angle_deg(x, decoded(b)));
        }
        std::sort(found.begin(), found.end());
        return found;
    }
};

TEST_F(RealBake, AnObjectMapGoesToTangentSpaceAndBack) {
    put_reader("object_normal_map", "spot_normal_object.png");
    bake_spot("tangent.png", {"--type", "u16"});
    bake_spot("object.exr", {"--space", "object", "--type", "float"});
    put_reader("tangent_normal_map", "tangent.png");
    bake_spot("back.exr", {"--space", "object", "--type", "float"});
    const std::vector<double> there = angles(picture("object.exr"), picture("back.exr"));
    ASSERT_GT(there.size(), 400'000U);
    std::printf("object -> tangent -> object: median %.4f, greatest %.4f degrees\n",
                there[there.size() / 2], there.back());
    EXPECT_LT(there.back(), 0.5);
}

// Blender baked both maps from the same bump.
TEST_F(RealBake, TheTangentMapIsTheOneThatBlenderBaked) {
    put_reader("object_normal_map", "spot_normal_object.png");
    bake_spot("object.exr", {"--space", "object", "--type", "float"});
    bake_spot("tangent.exr", {"--type", "float", "--compression", "none"});
    const Image covered = picture("object.exr"), ours = picture("tangent.exr"),
                theirs = picture("spot_normal_tangent_8bit.png");
    Image seen = ours;
    for (size_t i = 0; i < seen.data.size(); i += 3)  // decodes to zero off the surface
        if (covered.data[i] == 0.5F && covered.data[i + 1] == 0.5F)
            std::fill_n(seen.data.begin() + static_cast<long>(i), 3, 0.5F);
    const std::vector<double> apart = angles(seen, theirs);
    std::printf("against Blender: median %.4f, 99 %% %.4f, greatest %.4f degrees\n",
                apart[apart.size() / 2], apart[apart.size() * 99 / 100], apart.back());
    EXPECT_LT(apart[apart.size() / 2], 0.3);
    EXPECT_LT(apart[apart.size() * 99 / 100], 1);
}

}  // namespace
}  // namespace wrinkle::test
