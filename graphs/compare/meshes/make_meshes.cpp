// Writes the meshes of the comparisons into the folder it is given:
//
//   make_meshes FOLDER
//
//   bent_cylinder.glb  an open tube of radius 0.35 and length 2 along y, its upper half turned by
//                      70 degrees about z: skinned as engines do it, with positions, normals and
//                      tangents through the weighted mean of two bones' matrices, the latter two
//                      made unit. u runs round it, v along it.
//
// Sines are those of core/base, the rest is correctly rounded: the file in the repository is what
// this program makes anywhere (a test compares them).
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "base/file.h"
#include "base/transcendental.h"

namespace wrinkle::meshes {
namespace {

using Vector = std::array<double, 3>;

constexpr int around = 48, along = 40;
constexpr double radius = 0.35, bend = 70 * math::detail::pi / 180;

struct Bytes {
    std::string text;

    void word(uint32_t value) {
        for (int shift = 0; shift < 32; shift += 8)
            text += static_cast<char>(value >> shift & 0xFF);
    }
    void number(double value) { word(std::bit_cast<uint32_t>(static_cast<float>(value))); }
    void vector(const Vector& v) {
        for (const double lane : v)
            number(lane);
    }
};

// The second bone's share at height y of the straight tube.
double weight(double y) {
    const double t = std::fmin(std::fmax(y / 0.9 + 0.5, 0), 1);
    return t * t * (3 - 2 * t);
}

Vector skinned(const Vector& v, double share) {
    const double s = math::sin(bend), c = math::cos(bend);
    const Vector turned{c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
    Vector mean{};
    for (size_t i = 0; i < 3; ++i)
        mean[i] = (1 - share) * v[i] + share * turned[i];
    return mean;
}

Vector unit(const Vector& v) {
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return {v[0] / length, v[1] / length, v[2] / length};
}

// Per vertex: position, normal, tangent with its sign, and uv, v as glTF has it, downwards.
void put_vertex(Bytes& bytes, int i, int j) {
    const double u = static_cast<double>(i) / around, v = static_cast<double>(j) / along;
    const double turn = math::detail::pi * (2 * u - 1), y = 2 * v - 1, share = weight(y);
    const double s = i % around == 0 ? 0 : math::sin(turn), c = math::cos(turn);
    bytes.vector(skinned({radius * s, y, radius * c}, share));
    bytes.vector(unit(skinned({s, 0, c}, share)));
    bytes.vector(unit(skinned({c, 0, -s}, share)));
    bytes.number(1);
    bytes.number(u);
    bytes.number(1 - v);
}

constexpr int vertices = (around + 1) * (along + 1), corners = around * along * 6, stride = 48;

std::string data() {
    Bytes bytes;
    for (int j = 0; j <= along; ++j)
        for (int i = 0; i <= around; ++i)
            put_vertex(bytes, i, j);
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < around; ++i) {
            const int a = j * (around + 1) + i, b = a + around + 1;
            for (const int corner : {a, a + 1, b + 1, a, b + 1, b})
                bytes.word(static_cast<uint32_t>(corner));
        }
    return bytes.text;
}

std::string accessor(int offset, const char* type) {
    return R"({"bufferView":0,"componentType":5126,"count":)" + std::to_string(vertices) +
           R"(,"type":")" + type + R"(","byteOffset":)" + std::to_string(offset);
}

std::string description() {
    const std::string split = std::to_string(vertices * stride);
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TANGENT":2,)"
           R"("TEXCOORD_0":3},"indices":4}]}],"accessors":[)" +
           accessor(0, "VEC3") + R"(,"min":[-2,-2,-2],"max":[2,2,2]},)" + accessor(12, "VEC3") +
           "}," + accessor(24, "VEC4") + "}," + accessor(40, "VEC2") +
           R"(},{"bufferView":1,"componentType":5125,"count":)" + std::to_string(corners) +
           R"(,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":)" + split +
           R"(,"byteStride":)" + std::to_string(stride) + R"(},{"buffer":0,"byteOffset":)" + split +
           R"(,"byteLength":)" + std::to_string(corners * 4) + R"(}],"buffers":[{"byteLength":)" +
           std::to_string(vertices * stride + corners * 4) + "}]}";
}

// A .glb: a header of 12 bytes, then the description and the data, each behind length and kind.
std::string bent_cylinder() {
    std::string text = description();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::string binary = data();
    Bytes file;
    file.text = "glTF";
    file.word(2);
    file.word(static_cast<uint32_t>(12 + 8 + text.size() + 8 + binary.size()));
    file.word(static_cast<uint32_t>(text.size()));
    file.text += "JSON" + text;
    file.word(static_cast<uint32_t>(binary.size()));
    file.text += std::string("BIN\0", 4) + binary;
    return file.text;
}

}  // namespace
}  // namespace wrinkle::meshes

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("usage: make_meshes FOLDER\n", stderr);
        return 2;
    }
    std::string why;
    const std::string path = std::string(arguments[1]) + "/bent_cylinder.glb";
    if (wrinkle::write_file(path, wrinkle::meshes::bent_cylinder(), why)) return 0;
    std::fprintf(stderr, "%s: %s\n", path.c_str(), why.c_str());
    return 3;
}
