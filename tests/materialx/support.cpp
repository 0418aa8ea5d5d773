#include "materialx/support.h"

#include <cmath>

#include "image/load.h"

namespace wrinkle::test {
namespace {

double step_of_8_bits(double value) {
    return std::round(value * 255) / 255;
}

}  // namespace

void MaterialXTest::SetUp() {
    CliTest::SetUp();
    Image color = make_image(8, 8, 3), data = make_image(8, 8, 1), normal = make_image(8, 8, 3);
    for (uint32_t y = 0; y < 8; ++y)
        for (uint32_t x = 0; x < 8; ++x) {
            const double wave = std::sin(0.7 * x + 0.3 * y), other = std::cos(0.4 * x - 0.6 * y);
            const double slopes[] = {0.4 * wave, 0.5 * other, 1};
            const double length = std::hypot(slopes[0], slopes[1], 1.0);
            for (size_t i = 0; i < 3; ++i) {
                const double shade = 0.5 + 0.35 * (i == 0 ? wave : i == 1 ? other : wave * other);
                color.texel(x, y)[i] = static_cast<float>(step_of_8_bits(shade));
                normal.texel(x, y)[i] =
                    static_cast<float>(step_of_8_bits(0.5 + 0.5 * slopes[i] / length));
            }
            data.texel(x, y)[0] = static_cast<float>(step_of_8_bits(0.5 + 0.4 * other));
        }
    images = {{"color.png", color}, {"data.png", data}, {"normal.png", normal}};
    for (const auto& [name, image] : images)
        save(name, image);
}

void MaterialXTest::save(const std::string& name, const Image& image) const {
    WriterOptions options;
    options.type = name.ends_with(".png") ? PixelType::u8 : PixelType::half;
    Diagnostics problems;
    ASSERT_TRUE(save_image(image, folder / name, options, problems)) << to_text(problems);
}

std::string MaterialXTest::surface(const std::string& elements, const std::string& inputs) {
    return R"(<materialx version="1.39" colorspace="lin_rec709">)" + elements +
           R"(<open_pbr_surface name="Surface" type="surfaceshader">)" + inputs +
           R"(</open_pbr_surface><surfacematerial name="Material" type="material">
      <input name="surfaceshader" type="surfaceshader" nodename="Surface"/></surfacematerial>
      </materialx>)";
}

std::string MaterialXTest::document_text(const std::string& name) {
    return bytes_of(fs::path(WRINKLE_SOURCE_DIR "/tests/materialx/documents") / (name + ".mtlx"));
}

materialx::Document MaterialXTest::read(const std::string& text, const std::string& name) const {
    Diagnostics problems;
    auto document = materialx::read_document(text, name, problems);
    EXPECT_TRUE(document) << to_text(problems);
    return document ? *document : materialx::Document();
}

Ran MaterialXTest::import(const std::string& text, const std::vector<std::string>& more) const {
    put("a.mtlx", text);
    std::vector<std::string> words = {"import", "a.mtlx", "-o", "a.json"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
}

json::Value MaterialXTest::values(const std::string& graph, const OraclePoint& point) const {
    const auto pair = [](const std::array<double, 2>& uv) {
        return "[" + std::to_string(uv[0]) + ", " + std::to_string(uv[1]) + "]";
    };
    const std::string at = R"({"normal": [0, 0, 1], "tangent": [1, 0, 0, 1], "uv0": )" +
                           pair(point.uv0) + R"(, "uv1": )" + pair(point.uv1) +
                           R"(, "position": [0, 0, 0], "dx": {"position": [1, 0, 0], "uv0": )"
                           R"([1e-4, 0], "uv1": [1e-4, 0]}, "dy": {"position": [0, 1, 0], )"
                           R"("uv0": [0, 1e-4], "uv1": [0, 1e-4]}})";
    const Ran ran = run({"eval", graph, "--at", at});
    EXPECT_EQ(ran.code, 0) << ran.err;
    return parsed(ran.out).find("points").at(0);
}

void MaterialXTest::expect_near(const json::Value& found, const std::vector<double>& expected,
                                const std::string& name, double tolerance) {
    if (expected.size() == 1) {
        ASSERT_TRUE(found.is(json::Kind::number)) << name;
        EXPECT_NEAR(found.as_number(), expected[0], tolerance) << name;
        return;
    }
    ASSERT_EQ(found.size(), expected.size()) << name;
    for (size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(found.at(i).as_number(), expected[i], tolerance) << name << " " << i;
}

std::vector<OraclePoint> some_points() {
    return {{{0.1875, 0.8125}, {0.4, 0.3}}, {{0.63, 0.27}, {0.9, 0.71}}, {{0.02, 0.97}, {0.5, 0}}};
}

}  // namespace wrinkle::test
