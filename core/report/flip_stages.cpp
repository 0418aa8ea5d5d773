#include "report/flip_stages.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace wrinkle::report {
namespace {

using Matrix = std::array<Color, 3>;

constexpr Matrix xyz_from_rgb = {{
    {10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
    {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
    {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382},
}};
constexpr Matrix rgb_from_xyz = {{
    {3.241003275, -1.537398934, -0.498615861},
    {-0.969224334, 1.875930071, 0.041554224},
    {0.055639423, -0.204011202, 1.057148933},
}};
constexpr Color white = {0.950428545, 1, 1.088900371};

constexpr double color_exponent = 0.7;
constexpr double break_distance = 0.4, break_error = 0.95;  // p_c and p_t of 4.1.3

Color product(const Matrix& matrix, const Color& v) {
    Color result;
    for (size_t i = 0; i < 3; ++i)
        result[i] = matrix[i][0] * v[0] + matrix[i][1] * v[1] + matrix[i][2] * v[2];
    return result;
}

// X, Y and Z relative to white.
Color relative_xyz(const Color& rgb) {
    Color xyz = product(xyz_from_rgb, rgb);
    for (size_t i = 0; i < 3; ++i)
        xyz[i] /= white[i];
    return xyz;
}

double lab_curve(double t) {
    constexpr double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

Color lab_from_linear(const Color& rgb) {
    const Color t = relative_xyz(rgb);
    const double x = lab_curve(t[0]), y = lab_curve(t[1]), z = lab_curve(t[2]);
    const double lightness = 116 * y - 16;
    return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

// Distance of Abasi et al. 2020, to the power of 0.7.
float compressed_distance(const Color& a, const Color& b) {
    const double da = a[1] - b[1], db = a[2] - b[2];
    const double hyab = std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db);
    return std::pow(static_cast<float>(hyab), static_cast<float>(color_exponent));
}

std::array<Plane, 3> planes_of(const Image& image, int64_t first_row, uint32_t rows) {
    std::array<Plane, 3> planes;
    for (Plane& plane : planes)
        plane = make_image(image.width, rows, 1);
    for (uint32_t y = 0; y < rows; ++y) {
        const auto row = std::clamp<int64_t>(first_row + y, 0, int64_t{image.height} - 1);
        for (uint32_t x = 0; x < image.width; ++x) {
            const auto texel = expand_texel(image.texel(x, static_cast<uint32_t>(row)),
                                            image.channels, image.has_alpha);
            Color rgb;
            for (size_t c = 0; c < 3; ++c)
                rgb[c] = std::clamp(texel[c], 0.0F, 1.0F);
            const Color color = ycxcz_from_linear(rgb);
            for (size_t c = 0; c < 3; ++c)
                *planes[c].texel(x, y) = static_cast<float>(color[c]);
        }
    }
    return planes;
}

template <class Combine>
Plane combined(Plane a, const Plane& b, const Combine& combine) {
    for (size_t i = 0; i < a.data.size(); ++i)
        a.data[i] = combine(a.data[i], b.data[i]);
    return a;
}

float length_of(float x, float y) {
    return std::sqrt(x * x + y * y);
}

}  // namespace

Color ycxcz_from_linear(const Color& rgb) {
    const Color t = relative_xyz(rgb);
    return {116 * t[1] - 16, 500 * (t[0] - t[1]), 200 * (t[1] - t[2])};
}

Color lab_from_ycxcz(const Color& ycxcz) {
    const double y = (ycxcz[0] + 16) / 116;
    const Color xyz = {(y + ycxcz[1] / 500) * white[0], y, (y - ycxcz[2] / 200) * white[2]};
    Color rgb = product(rgb_from_xyz, xyz);
    for (double& value : rgb)
        value = std::clamp(value, 0.0, 1.0);
    return lab_from_linear(rgb);
}

Stages make_stages(const Image& image, const Filters& filters, uint32_t first_row, uint32_t rows) {
    const uint32_t margin = filters.margin();
    auto planes = planes_of(image, int64_t{first_row} - margin, rows + 2 * margin);
    Plane& luma = planes[0];
    const auto both = [&](const Plane& plane, const Kernel& along_x, const Kernel& along_y) {
        return filter_y(filter_x(plane, along_x), along_y, margin);
    };
    Stages stages;
    stages.ycxcz[0] = both(luma, filters.luma, filters.luma);
    stages.ycxcz[1] = both(planes[1], filters.cx, filters.cx);
    stages.ycxcz[2] = combined(both(planes[2], filters.cz[0], filters.cz[0]),
                               both(planes[2], filters.cz[1], filters.cz[1]), std::plus());
    for (float& value : luma.data)
        value = (value + 16) / 116;
    const Plane smooth = filter_x(luma, filters.smooth);
    const auto feature = [&](const Kernel& kernel) {
        return combined(both(luma, kernel, filters.smooth), filter_y(smooth, kernel, margin),
                        length_of);
    };
    stages.edge = feature(filters.edge);
    stages.point = feature(filters.point);
    return stages;
}

float color_error(const Color& lab_a, const Color& lab_b) {
    static const float most =
        compressed_distance(lab_from_linear({0, 1, 0}), lab_from_linear({0, 0, 1}));
    const float distance = compressed_distance(lab_a, lab_b);
    const auto middle = static_cast<float>(break_distance) * most;
    const auto error = static_cast<float>(break_error);
    if (distance < middle) return error * distance / middle;
    return std::min(error + (1 - error) * (distance - middle) / (most - middle), 1.0F);
}

float feature_error(float edge_difference, float point_difference) {
    const float most = std::max(std::abs(edge_difference), std::abs(point_difference));
    return std::min(std::sqrt(most * 0.70710678F), 1.0F);
}

float flip_error(float color, float feature) {
    return color == 0 ? 0 : std::pow(color, 1 - feature);
}

float flip_error(const Stages& a, const Stages& b, uint32_t x, uint32_t y) {
    const auto lab = [&](const Stages& stages) {
        Color color;
        for (size_t c = 0; c < 3; ++c)
            color[c] = *stages.ycxcz[c].texel(x, y);
        return lab_from_ycxcz(color);
    };
    const float color = color_error(lab(a), lab(b));
    return flip_error(color, feature_error(*a.edge.texel(x, y) - *b.edge.texel(x, y),
                                           *a.point.texel(x, y) - *b.point.texel(x, y)));
}

}  // namespace wrinkle::report
