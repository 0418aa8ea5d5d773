// Tests of waves and gradients against means by samples, closed forms and central differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "nodes/number.h"
#include "nodes/relief.h"

namespace wrinkle::test {
namespace {

constexpr double pi_angle = 3.141592653589793;
using Curve = std::function<double(double)>;

double fraction(double x) {
    return x - std::floor(x);
}

const std::pair<const char*, Curve> waveforms[] = {
    {R"("waveform": "sine")", [](double x) { return std::pow(std::sin(pi_angle * x), 2); }},
    {R"("waveform": "triangle")",
     [](double x) { return 2 * std::min(fraction(x), 1 - fraction(x)); }},
    {R"("waveform": "square")", [](double x) { return fraction(x) < 0.5 ? 0 : 1; }},
    {R"("waveform": "square", "duty": 0.2)", [](double x) { return fraction(x) < 0.8 ? 0 : 1; }},
    {R"("waveform": "square", "duty": 0)", [](double) { return 0; }},
    {R"("waveform": "saw")", fraction},
    {R"("waveform": "bounce")",
     [](double x) { return 2 * std::sqrt(fraction(x) * (1 - fraction(x))); }}};

std::vector<double> wave_of(const std::string& in, const std::vector<double>& x, double width) {
    return numbers_through("wave", "phase", "\"scale\": 0, " + in, "value", x, width);
}

TEST(Wave, HasThePublishedMeans) {
    const auto at = [](const std::string& waveform, double width) {
        return wave_of("\"waveform\": \"" + waveform + '"', {0.37}, width)[0];
    };
    const std::tuple<const char*, double, double> means[] = {{"square", 0.175, 0.6},
                                                             {"saw", 0.37, 0.57},
                                                             {"triangle", 0.7155, 0.44523},
                                                             {"sine", 0.75904, 0.43220}};
    for (const auto& [waveform, narrow, wide] : means) {
        EXPECT_NEAR(at(waveform, 0.4), narrow, 1e-5) << waveform;
        EXPECT_NEAR(at(waveform, 1.3), wide, 1e-5) << waveform;
    }
}

TEST(Wave, IsTheMeanOverThePixel) {
    const std::vector<double> places{-2.31, -0.02, 0, 0.1, 0.37, 0.5, 0.81, 1, 40.77};
    for (const auto& [in, curve] : waveforms)
        for (const double width : {0.01, 0.11, 0.4, 1.3, 2.7}) {
            const auto got = wave_of(in, places, width);
            for (size_t i = 0; i < places.size(); ++i)
                EXPECT_NEAR(got[i], box_mean(curve, places[i], width), 4e-4)
                    << in << " at " << places[i] << " over " << width;
        }
}

// Without a footprint, and far out, where the integrals are large.
TEST(Wave, IsUnfilteredCloseUp) {
    for (const auto& [in, curve] : waveforms)
        for (const double x : {-1.7, 0.13, 0.37, 0.62, 5000.25}) {
            EXPECT_NEAR(wave_of(in, {x}, 0)[0], curve(x), 2e-4) << in << " at " << x;
        }
}

// The slope lies between the halves of a central difference. Where they differ much, the mean has a
// kink.
void expect_slopes(const std::vector<double>& before, const std::vector<double>& here,
                   const std::vector<double>& after, const std::vector<double>& slopes, double step,
                   const std::string& what) {
    size_t compared = 0;
    for (size_t i = 0; i < here.size(); ++i) {
        const double left = (here[i] - before[i]) / step, right = (after[i] - here[i]) / step;
        if (std::fabs(left - right) > 0.15) continue;
        EXPECT_NEAR(slopes[i], 0.5 * (left + right), 4e-3 + 0.5 * std::fabs(left - right))
            << what << " at " << i;
        ++compared;
    }
    EXPECT_GT(compared, here.size() / 2) << what;
}

TEST(Wave, HasTheSlopeOfItsMean) {
    constexpr double step = 2e-3;
    const auto places = random_cells(200, 8, 61);
    const auto moved = [&](double by) {
        auto points = places;
        for (Point& p : points)
            p[0] += by;
        return points;
    };
    for (const auto& [in, curve] : waveforms)
        for (const char* layout : {"bands", "rings"}) {
            const std::string all = std::string(in) + R"(, "center": [0, 0], "direction": 30,
                "layout": ")" + layout +
                                    '"';
            const Reading got = read("wave", all, places, 0.15);
            std::vector<double> along;
            for (const Point& slope : got.slope)
                along.push_back(slope[0]);
            expect_slopes(value_of("wave", all, moved(-step), 0.15), got.value,
                          value_of("wave", all, moved(step), 0.15), along, step, all);
        }
}

TEST(Wave, LiesInBandsOrRings) {
    const auto at = [](const char* in, Point p) {
        return value_of("wave", std::string(R"("waveform": "saw", )") + in, {p})[0];
    };
    const double x = std::cos(0.5235987756), y = std::sin(0.5235987756);
    const char* bands = R"("direction": 30, "phase": 0.1)";
    EXPECT_NEAR(at(bands, {0.3 * x - 7 * y, 0.3 * y + 7 * x}), 0.4, 1e-4);
    EXPECT_NEAR(at(bands, {2.3 * x, 2.3 * y}), 0.4, 1e-4);
    const char* rings = R"("layout": "rings", "center": [0, 0])";
    EXPECT_NEAR(at(rings, {1.3 * x, 1.3 * y}), 0.3, 1e-4);
    EXPECT_NEAR(at(rings, {-1.3 * y, 1.3 * x}), 0.3, 1e-4);
    EXPECT_NEAR(at(R"("softness": 1)", {0.2, 0}), 0.5, 1e-4);
}

// Positions by the documentation, with size 0.4 about (0.5, 0.5).
const std::pair<const char*, double (*)(double, double)> shapes[] = {
    {"linear", [](double x, double) { return (x + 1) / 2; }},
    {"reflected", [](double x, double) { return std::fabs(x); }},
    {"radial", [](double x, double y) { return std::hypot(x, y); }},
    {"diamond", [](double x, double y) { return std::fabs(x) + std::fabs(y); }},
    {"square", [](double x, double y) { return std::max(std::fabs(x), std::fabs(y)); }},
    {"angular", [](double x, double y) { return std::atan2(y, x) / pi_angle; }},
    {"spiral", [](double x, double y) { return std::atan2(y, x) / pi_angle + std::hypot(x, y); }}};

double extended(const std::string& shape, const std::string& extend, double t) {
    const bool around = shape == "angular" || shape == "spiral";
    if (extend == "mirror") {
        const double turned = std::fmod(std::fabs(around ? 2 * t : t), 2.0);
        return std::min(turned, 2 - turned);
    }
    return extend == "repeat" || around ? fraction(t) : std::clamp(t, 0.0, 1.0);
}

double eased(const std::string& easing, double t) {
    return easing == "linear" ? t : easing == "ease" ? (3 - 2 * t) * t * t : t * t;
}

std::string gradient_in(const std::string& shape, const std::string& extend,
                        const std::string& easing) {
    return R"("size": 0.4, "arms": 2, "rotation": 90, "shape": ")" + shape + R"(", "extend": ")" +
           extend + R"(", "easing": ")" + easing + '"';
}

TEST(GradientShape, HasTheDocumentedShapes) {
    const auto points = random_cells(60, 2, 62);
    for (const auto& [shape, position] : shapes)
        for (const std::string extend : {"clamp", "repeat", "mirror"})
            for (const std::string easing : {"linear", "ease", "quadratic"}) {
                const std::string in = gradient_in(shape, extend, easing);
                const auto got = values({one("gradient_shape", in), "n.value"}, points);
                const auto at = values({one("gradient_shape", in), "n.position"}, points);
                for (size_t i = 0; i < points.size(); ++i) {
                    // A rotation by 90 degrees: the uv (0.5, 0.9) is at (1, 0).
                    const double x = (points[i][1] - 0.5) / 0.4, y = (0.5 - points[i][0]) / 0.4;
                    const double t = position(x, y);
                    EXPECT_NEAR(at[i][0], t, 1e-5) << in;
                    if (std::fabs(fraction(t + 0.5) - 0.5) < 0.02) continue;
                    EXPECT_NEAR(got[i][0], eased(easing, extended(shape, extend, t)), 1e-3)
                        << in << " at " << t;
                }
            }
}

// Angles by the C library, in all eight octants and on their borders, and the slope of the angle.
TEST(GradientShape, TurnsByTheExactAngle) {
    const std::string nodes =
        one("gradient_shape", R"("shape": "angular", "center": [0, 0], "arms": 64)") +
        R"(, "g": {"type": "gradient_from_height", "in": {"height": {"from": "n.position"}}})";
    auto points = random_cells(200, 2, 64);
    for (const Point& p : {Point{1, 0}, Point{0, 1}, Point{-1, 1e-3}, Point{0, -1}, Point{0.5, 0.5},
                           Point{0.5, -0.5}, Point{-0.5, 0.5}, Point{-0.5, -0.5}})
        points.push_back(p);
    const auto at = values({nodes, "n.position"}, points);
    const auto slopes = values({nodes, "g.gradient"}, points);
    constexpr double arms = 64 / (2 * pi_angle);
    for (size_t i = 0; i < points.size(); ++i) {
        const auto [x, y] = points[i];
        EXPECT_NEAR(at[i][0], arms * std::atan2(y, x), 1e-6) << x << " " << y;
        const double square = x * x + y * y;
        EXPECT_NEAR(slopes[i][0] * square, arms * -y, 1e-6);
        EXPECT_NEAR(slopes[i][1] * square, arms * x, 1e-6);
    }
}

TEST(GradientShape, IsTheMeanOverThePixel) {
    for (const std::string extend : {"clamp", "repeat", "mirror"})
        for (const std::string easing : {"linear", "ease", "quadratic"})
            for (const double width : {0.1, 0.7, 2.6})
                for (const double x : {-700.3, -1.2, -0.03, 0.2, 0.97, 1.4, 900.9}) {
                    const double scale = width / pixel;
                    const std::string in = R"("uv": {"from": "t.uv"}, "extend": ")" + extend +
                                           R"(", "easing": ")" + easing + '"';
                    const std::string nodes =
                        one("gradient_shape", in) +
                        R"(, "t": {"type": "uv_transform", "in": {"scale": [)" +
                        std::to_string(scale) + ", 1]}}";
                    const auto mean = box_mean(
                        [&](double t) { return eased(easing, extended("", extend, t)); }, x, width);
                    EXPECT_NEAR(value({nodes, "n.value"}, x / scale, 0.5)[0], mean, 5e-4)
                        << extend << " " << easing << " at " << x << " over " << width;
                }
}

TEST(GradientShape, HasExactSlopesAndNoneOfInfinity) {
    constexpr double step = 1e-3;
    const auto points = random_cells(200, 1.4, 63);
    for (const auto& [shape, position] : shapes)
        for (const std::string extend : {"clamp", "repeat", "mirror"}) {
            const std::string nodes =
                one("gradient_shape", gradient_in(shape, extend, "ease")) +
                R"(, "g": {"type": "gradient_from_height", "in": {"height": {"from": "n.value"}}})";
            const auto sums = [&](double by) {
                auto moved = points;
                for (Point& p : moved)
                    p[1] += by;
                std::vector<double> sums;
                for (const auto& each : values({nodes, "n.value"}, moved))
                    sums.push_back(each[0]);
                return sums;
            };
            std::vector<double> slopes;
            for (const auto& each : values({nodes, "g.gradient"}, points))
                slopes.push_back(each[1]);
            expect_slopes(sums(-step), sums(0), sums(step), slopes, step, shape + (" " + extend));
            for (const auto& each : values({nodes, "g.gradient"}, {{0.5, 0.5}, {0.5, -3}}))
                EXPECT_TRUE(std::isfinite(each[0] + each[1])) << shape;
        }
}

}  // namespace
}  // namespace wrinkle::test
