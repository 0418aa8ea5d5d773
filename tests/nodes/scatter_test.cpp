// Tests of scattered copies against a search over 9 x 9 cells, central differences and means.
#include <gtest/gtest.h>

#include <algorithm>

#include "nodes/relief.h"
#include "support/angle.h"

namespace wrinkle::test {
namespace {

// The hashes that sdk/math.h and nodes/random.h document.
std::array<double, 3> numbers_of(int x, int y, uint32_t id, uint32_t seed) {
    std::array<double, 3> numbers{};
    uint32_t bits = pcg(x, y, static_cast<int>(id + pcg(seed)));
    for (double& each : numbers) {
        each = unit_number(bits);
        bits = pcg(bits);
    }
    return numbers;
}

// A dome at a point of uv: its height there, 0 around it.
struct Dome {
    double x, y, width, height, angle, tall;
    double at(const Point& p) const {
        const double dx = p[0] - x, dy = p[1] - y;
        const double u = (std::cos(angle) * dx + std::sin(angle) * dy) / width;
        const double v = (std::cos(angle) * dy - std::sin(angle) * dx) / height;
        return tall * std::max(0.0, 1 - 4 * (u * u + v * v));
    }
};

constexpr char tiles[] =
    R"("amount": [8, 5], "scale": [1.5, 1.0], "scale_random": 0.5, "position_random": 0.7,
       "row_offset": 0.3, "rotation": 10, "rotation_random": 90, "height_random": 0.6,
       "density": 0.8, "seed": 4)";

Dome dome_of(const std::array<double, 3>& lie, const std::array<double, 3>& look) {
    return {0, 0, 0, 1 - 0.5 * look[0], degree * (10 + 90 * (2 * lie[2] - 1)), 1 - 0.6 * look[1]};
}

std::vector<Dome> tiles_around(const Point& p) {
    std::vector<Dome> domes;
    const int row = static_cast<int>(std::floor(p[1] * 5));
    for (int y = row - 4; y <= row + 4; ++y) {
        const int column = static_cast<int>(std::floor(p[0] * 8 - 0.3 * y));
        for (int x = column - 4; x <= column + 4; ++x) {
            const auto lie = numbers_of(x, y, 1, 4), look = numbers_of(x, y, 2, 4);
            if (look[2] >= 0.8) continue;
            Dome dome = dome_of(lie, look);
            dome.width = 1.5 / 8 * dome.height;
            dome.height *= 1.0 / 5;
            dome.x = (x + 0.5 + 0.3 * y + 0.7 * (lie[0] - 0.5)) / 8;
            dome.y = (y + 0.5 + 0.7 * (lie[1] - 0.5)) / 5;
            domes.push_back(dome);
        }
    }
    return domes;
}

constexpr char drops[] =
    R"("count": 24, "size": [0.4, 0.3], "size_random": 0.5, "rotation": 10, "rotation_random": 90,
       "height_random": 0.6, "density": 0.8, "seed": 4)";

std::vector<Dome> drops_around(const Point& p) {
    std::vector<Dome> domes;
    for (int k = 0; k < 24; ++k) {
        const auto lie = numbers_of(k, 0, 1, 4), look = numbers_of(k, 0, 2, 4);
        if (look[2] >= 0.8) continue;
        for (int x = -2; x <= 2; ++x)
            for (int y = -2; y <= 2; ++y) {
                Dome dome = dome_of(lie, look);
                dome.width = 0.4 * dome.height;
                dome.height *= 0.3;
                dome.x = lie[0] + x + std::floor(p[0]);
                dome.y = lie[1] + y + std::floor(p[1]);
                domes.push_back(dome);
            }
    }
    return domes;
}

std::vector<double> scattered(const std::string& type, const std::string& in,
                              const std::string& output, const std::vector<Point>& points) {
    std::vector<double> first;
    for (const auto& lanes : values({one(type, in), "n." + output}, points))
        first.push_back(lanes[0]);
    return first;
}

template <class Around>
void expect_domes(const std::string& type, const std::string& in, Around around) {
    const auto points = random_cells(3000, 6, 71);
    const auto max = scattered(type, in, "value", points);
    const auto sum = scattered(type, in + R"(, "order": "add")", "value", points);
    size_t overlaps = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        double highest = 0, total = 0;
        for (const Dome& dome : around(points[i])) {
            highest = std::max(highest, dome.at(points[i]));
            total += dome.at(points[i]);
        }
        EXPECT_NEAR(max[i], highest, 2e-4) << type << " at " << i;
        EXPECT_NEAR(sum[i], total, 4e-4) << type << " at " << i;
        overlaps += total > highest + 0.01;
    }
    EXPECT_GT(overlaps, 100U);
}

TEST(Scatter, IsThatOfALargeSearch) {
    expect_domes("tile_sampler", tiles, tiles_around);
    expect_domes("tile_sampler", std::string(tiles) + R"(, "wide": true)", tiles_around);
    expect_domes("splatter", drops, drops_around);
}

// The copy on top covers the point, and has the greatest random number of all that do.
TEST(Scatter, HasOneCopyOnTop) {
    const auto points = random_cells(2000, 6, 72);
    const std::string in = std::string(tiles) + R"(, "order": "random")";
    const auto got = scattered("tile_sampler", in, "value", points);
    const auto tall = scattered("tile_sampler", std::string(tiles) + R"(, "order": "by_height")",
                                "value", points);
    const auto cells = values({one("tile_sampler", in), "n.cell"}, points);
    const auto uvs = values({one("tile_sampler", in), "n.uv"}, points);
    size_t hidden = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        const auto domes = tiles_around(points[i]);
        // Each value is that of one copy, or of none.
        const auto is = [&](double value) {
            return [&, value](const Dome& dome) {
                return std::fabs(dome.at(points[i]) - value) < 2e-4;
            };
        };
        EXPECT_TRUE(std::any_of(domes.begin(), domes.end(), is(got[i]))) << i;
        double highest = 0, of_tallest = 0, tallest = 0;
        for (const Dome& dome : domes) {
            const double here = dome.at(points[i]);
            highest = std::max(highest, here);
            if (here > 0.02 && dome.tall > tallest) {
                tallest = dome.tall;
                of_tallest = here;
            }
        }
        hidden += got[i] < highest - 0.01;
        if (of_tallest > 0.1 && tall[i] > 0.1) {
            EXPECT_NEAR(tall[i], of_tallest, 2e-4) << i;
        }
        if (got[i] < 0.02) continue;
        const int x = static_cast<int>(cells[i][0]), y = static_cast<int>(cells[i][1]);
        const double own = 1 - 0.6 * numbers_of(x, y, 2, 4)[1];
        const double u = uvs[i][0] - 0.5, v = uvs[i][1] - 0.5;
        EXPECT_NEAR(got[i], own * (1 - 4 * (u * u + v * v)), 2e-4) << i;
    }
    EXPECT_GT(hidden, 30U);
}

// The uv of a copy grows along its direction and not across it, by central differences.
TEST(Scatter, HasTheDirectionInWhichItsUvGrows) {
    constexpr double step = 1e-5;
    for (const auto& [type, in] : {std::pair{"tile_sampler", tiles}, {"splatter", drops}}) {
        const Scene directions{one(type, in), "n.direction"}, uvs{one(type, in), "n.uv"};
        size_t turned = 0;
        for (const Point& p : random_cells(60, 3, 92)) {
            const auto direction = value(directions, p[0], p[1]);
            const double x = direction[0], y = direction[1];
            const auto moved = [&](double dx, double dy) {
                const auto low = value(uvs, p[0] - step * dx, p[1] - step * dy),
                           high = value(uvs, p[0] + step * dx, p[1] + step * dy);
                return std::array{(high[0] - low[0]) / (2 * step), (high[1] - low[1]) / (2 * step)};
            };
            EXPECT_NEAR(std::hypot(x, y), 1, 1e-9) << type;
            const auto along = moved(x, y), across = moved(-y, x);
            if (std::fabs(along[0]) > 1e3) continue;  // another copy begins there
            EXPECT_GT(along[0], 0.5) << type;
            EXPECT_NEAR(along[1], 0, 1e-6) << type;
            EXPECT_NEAR(across[0], 0, 1e-6) << type;
            turned += std::fabs(y) > 0.3;
        }
        EXPECT_GT(turned, 10U) << type;
    }
}

// Copies of any size are complete: the greatest value of domes has no jump.
TEST(Scatter, IsNeverCut) {
    const std::pair<const char*, const char*> cases[] = {
        {"tile_sampler", R"("scale": [9, 9], "rotation_random": 180, "position_random": 1)"},
        {"tile_sampler", R"("scale": [0.2, 4], "rotation": 45, "row_offset": 0.37, "wide": true)"},
        {"splatter", R"("size": [2, 0.4], "rotation_random": 180)"}};
    std::vector<Point> line;
    for (int i = 0; i < 20000; ++i)
        line.push_back({-0.3 + i * 8e-5, 0.2 + i * 5e-5});
    for (const auto& [type, in] : cases) {
        const auto value = scattered(type, in, "value", line);
        double most = 0;
        for (size_t i = 1; i < line.size(); ++i) {
            ASSERT_LE(std::fabs(value[i] - value[i - 1]), 0.02) << type << in << " at " << i;
            most = std::max(most, value[i]);
        }
        EXPECT_GT(most, 0.8) << type << in;
    }
}

TEST(Splatter, RepeatsWithoutSeams) {
    const auto points = random_cells(500, 1, 73);
    auto moved = points;
    for (Point& p : moved)
        p = {p[0] + 2, p[1] - 1};
    const auto here = scattered("splatter", drops, "value", points),
               there = scattered("splatter", drops, "value", moved);
    for (size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(here[i], there[i], 1e-5);
}

TEST(Scatter, HasExactSlopes) {
    constexpr double step = 1e-3;
    const auto points = random_cells(400, 3, 74);
    for (const char* shape : {"dome", "box", "disc"})
        for (const char* order : {"max", "add", "random"})
            for (const auto& [type, in] : {std::pair{"tile_sampler", tiles}, {"splatter", drops}}) {
                const std::string all = std::string(in) +
                                        R"(, "bevel": 0.4, "amplitude": 1, "shape": ")" + shape +
                                        R"(", "order": ")" + order + '"';
                const std::string nodes =
                    one(type, all) +
                    R"(, "g": {"type": "gradient_from_height", "in": {"height": {"from": "n.height"}}})";
                const auto at = [&, type = type](double by) {
                    auto moved = points;
                    for (Point& p : moved)
                        p[0] += by;
                    return scattered(type, all, "value", moved);
                };
                const auto left = at(-step), here = at(0), right = at(step);
                const auto slopes = values({nodes, "g.gradient"}, points);
                size_t compared = 0;
                for (size_t i = 0; i < points.size(); ++i) {
                    const double before = (here[i] - left[i]) / step,
                                 after = (right[i] - here[i]) / step;
                    if (std::fabs(before - after) > 0.6) continue;
                    EXPECT_NEAR(slopes[i][0], 0.5 * (before + after),
                                0.05 + 0.6 * std::fabs(before - after))
                        << all << " at " << i;
                    ++compared;
                }
                EXPECT_GT(compared, 200U) << all;
            }
}

// Copies that do not overlap fade to their mean, and so do their masks.
TEST(Scatter, FadesToTheMean) {
    const auto points = random_cells(20000, 40, 75);
    const std::string less = R"("height_random": 0.5, "density": 0.7, "seed": 2)";
    const std::string grid = less + R"(, "scale": [0.9, 0.6], "scale_random": 0.4)";
    for (const char* shape : {"dome", "disc", "box"})
        for (const std::string output : {"value", "mask"})
            for (const auto& [type, in, tolerance] :
                 {std::tuple{"tile_sampler", grid, 0.01},
                  std::tuple{"tile_sampler", grid + R"(, "order": "add")", 0.01},
                  std::tuple{"splatter",
                             less + R"(, "count": 64, "size": [0.1, 0.1], "order": "random")",
                             0.06}}) {
                const std::string all = in + R"(, "shape": ")" + shape + '"';
                const auto mean = [&, type = type](const std::string& scale) {
                    const std::string nodes =
                        one(type, all + R"(, "uv": {"from": "t.uv"})") +
                        R"(, "t": {"type": "uv_transform", "in": {"scale": [)" + scale + ", " +
                        scale + "]}}";
                    double sum = 0;
                    for (const auto& each : values({nodes, "n." + output}, points))
                        sum += each[0];
                    return sum / static_cast<double>(points.size());
                };
                EXPECT_NEAR(mean("1"), mean("4000"), tolerance) << all << output;
                // Smaller than a pixel, but farther apart.
                if (type == std::string("tile_sampler")) {
                    EXPECT_NEAR(mean("1"), mean("25"), 0.03) << all << output;
                }
            }
}

TEST(Scatter, DrawsTheDensityOfItsMask) {
    const auto points = random_cells(4000, 40, 76);
    const auto share = [&](const std::string& in) {
        const std::string nodes =
            one("tile_sampler", R"("shape": "box", "bevel": 0, )" + in) +
            R"(, "w": {"type": "wave", "in": {"scale": 0.05, "waveform": "square", "duty": 0.25}})";
        double sum = 0;
        for (const auto& each : values({nodes, "n.value"}, points))
            sum += each[0] / static_cast<double>(points.size());
        return sum;
    };
    EXPECT_NEAR(share(R"("density": 1)"), 1, 0.01);
    EXPECT_NEAR(share(R"("density": 1, "order": "add")"), 1, 1e-3);  // no seam
    EXPECT_NEAR(share(R"("density": 0)"), 0, 1e-6);
    EXPECT_NEAR(share(R"("density": 0.3)"), 0.3, 0.03);
    EXPECT_NEAR(share(R"("density": 0.6, "mask": 0.5)"), 0.3, 0.03);
    EXPECT_NEAR(share(R"("density": 0.6, "mask": {"from": "w.value"})"), 0.15, 0.02);
}

// A pattern is read across each copy, with the footprint of the copy.
TEST(Scatter, ReadsAGraph) {
    const std::string wave = R"(, "w": {"type": "wave", "in": {"scale": %, "waveform": "saw"}})";
    const auto pattern = [&](const std::string& in, const std::string& scale) {
        std::string text = wave;
        text.replace(text.find('%'), 1, scale);
        return one("tile_sampler",
                   R"("pattern": {"from": "w.value"}, "shape": "pattern", "amount": [1, 1])" + in) +
               text;
    };
    const auto points = random_cells(200, 1, 77);
    const auto got = values({pattern("", "1"), "n.value"}, points);
    for (size_t i = 0; i < points.size(); ++i) {
        const double u = points[i][0] - std::floor(points[i][0]);
        if (std::fabs(u - 0.5) > 0.49) continue;
        EXPECT_NEAR(got[i][0], u, 0.01);
    }
    // Half of a period is a pixel of a copy of a twentieth, and a hundredth of one of the plane.
    for (const char* order : {"max", "add", "random"}) {
        const std::string in = R"(, "scale": [0.05, 0.05], "order": ")" + std::string(order) + '"';
        for (int k = 0; k < 20; ++k) {
            const double x = 0.49 + k * 1e-3;
            const double v = value({pattern(in, "51.2"), "n.value"}, x, 0.5)[0];
            EXPECT_NEAR(v, 0.5, 0.02) << order << " at " << x;
        }
    }
}

}  // namespace
}  // namespace wrinkle::test
