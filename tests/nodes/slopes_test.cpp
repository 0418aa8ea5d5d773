// Tests that the bump of every number of every node is the slope of that number, by central
// differences in double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "nodes/plane.h"

namespace wrinkle::test {
namespace {

constexpr double slope_step = 1e-5;
// The integral of the half circles of a wave is within 2e-8, which its narrowest box multiplies.
double slope_tolerance(const NodeType& type) {
    return type.id == "wave" ? 1e-5 : 1e-6;
}
constexpr size_t slope_points = 64;

std::string link_to(const std::string& source) {
    return R"({"from": ")" + source + R"("})";
}

// Inputs without a slope where they vary, as docs/procedural-heights.md has it.
bool is_constant(const NodeType& type, const Port& port) {
    const std::string name = type.id + "." + port.name;
    return name == "voronoi.jitter" || name == "wave.softness" || name == "wave.duty";
}

// A graph around the node "n": every input has a random number of its range, or varies linearly
// over the plane within it. Each number of each output is an output, and so is its bump.
class SlopeGraph {
public:
    SlopeGraph(const NodeType& type, const std::map<std::string, std::string>& options, bool wired,
               unsigned seed)
        : random_(seed) {
        std::string in;
        for (const Port& port : type.ports) {
            if (port.kind == Port::Kind::output) continue;
            const auto option = options.find(port.name);
            wired_ = wired && !is_constant(type, port);
            const std::string value = option == options.end() ? value_of(port) : option->second;
            if (!value.empty()) in += (in.empty() ? "\"" : ", \"") + port.name + "\": " + value;
        }
        text_ = "\"n\": {\"type\": \"" + type.id + "\", \"in\": {" + in + "}}";
        nodes_ += (nodes_.empty() ? "" : ", ") + text_;
        for (const Port& port : type.ports)
            if (port.kind == Port::Kind::output) take(port);
    }

    Scene scene() const { return {nodes_, ""}; }
    const std::string& text() const { return text_; }
    // "node.port" of each number, each followed by that of its bump; and the port that has it.
    const std::vector<std::string>& outputs() const { return outputs_; }
    const std::string& port(size_t output) const { return ports_[output / 2]; }

private:
    double number(double low, double high) {
        return low + (high - low) * (random_() / 4294967296.0);
    }
    std::string add(const std::string& type, const std::string& in, const std::string& output) {
        const std::string id = "k" + std::to_string(made_++);
        nodes_ += (nodes_.empty() ? "\"" : ", \"") + id + "\": {\"type\": \"" + type +
                  "\", \"in\": {" + in + "}}";
        return id + "." + output;
    }

    std::string number_of(const Port& port) {
        const bool soft = port.has_soft_range(), hard = port.has_hard_range();
        const double low = soft ? port.soft_min : hard ? port.hard_min : -2;
        const double high = soft ? port.soft_max : hard ? port.hard_max : 2;
        if (!wired_) return std::to_string(number(low, high));
        const double middle = 0.5 * (low + high), x = number(-0.9, 0.9), half = 0.5 * (high - low);
        const std::string slopes =
            std::to_string(half * x) + ", " + std::to_string(half * (0.95 - std::fabs(x))) + ", 0]";
        const std::string varying =
            add("dot", R"("a": {"from": "surface.position"}, "b": [)" + slopes, "result");
        return link_to(add(
            "add", "\"a\": " + link_to(varying) + ", \"b\": " + std::to_string(middle), "result"));
    }
    std::string numbers_of(const Port& port, size_t lanes) {
        const char* names[] = {"x", "y", "z", "w"};
        std::string list, members;
        for (size_t lane = 0; lane < lanes; ++lane) {
            const std::string each = number_of(port);
            list += (lane ? ", " : "") + each;
            members += std::string(lane ? ", \"" : "\"") + names[lane] + "\": " + each;
        }
        if (!wired_) return "[" + list + "]";
        return link_to(add("combine_vec" + std::to_string(lanes), members, "vector"));
    }
    // Smooth heights of uv0.
    std::string relief() {
        return link_to(add("fbm", R"("scale": 2, "octaves": 1, "amplitude": 0.3)", "height"));
    }
    std::string option_of(const Port& port) {
        if (port.kind != Port::Kind::count) return "";
        // A step is too coarse for more octaves.
        const double most = std::min(port.hard_max, port.hard_min + 2);
        return std::to_string(static_cast<int>(number(port.hard_min, most + 1)));
    }
    std::string value_of(const Port& port) {
        if (port.is_option()) return option_of(port);
        if (port.kind == Port::Kind::field) return relief();
        if (port.default_kind == Port::Default::surface) return "";
        switch (port.type) {
            case PortType::float_:
            case PortType::height_:
                return number_of(port);
            case PortType::vec2_:
                return numbers_of(port, 2);
            case PortType::vec3_:
            case PortType::color_:
                return numbers_of(port, 3);
            case PortType::vec4_:
                return numbers_of(port, 4);
            case PortType::gradient_:
                return link_to(add("gradient_from_height", "\"height\": " + relief(), "gradient"));
            case PortType::material_:
                return link_to(add("material", "\"height\": " + relief(), "material"));
            default:
                return "";
        }
    }

    void take(const std::string& source, const std::string& port) {
        ports_.push_back(port);
        outputs_.push_back(source);
        outputs_.push_back(
            add("gradient_from_height", "\"height\": " + link_to(source), "gradient"));
    }
    void take(const Port& port) {
        const std::string source = "n." + port.name;
        size_t lanes = 0;
        switch (port.type) {
            case PortType::float_:
            case PortType::height_:
                return take(source, port.name);
            case PortType::vec2_:
                lanes = 2;
                break;
            case PortType::vec3_:
            case PortType::color_:
                lanes = 3;
                break;
            case PortType::vec4_:
                lanes = 4;
                break;
            case PortType::material_:
                return take(add("material_split", "\"material\": " + link_to(source), "height"),
                            port.name);
            default:
                return;
        }
        const std::string split =
            add("separate_vec" + std::to_string(lanes), "\"vector\": " + link_to(source), "");
        for (size_t lane = 0; lane < lanes; ++lane)
            take(split + "xyzw"[lane], port.name);
    }

    std::mt19937 random_;
    bool wired_ = false;
    int made_ = 0;
    std::string nodes_, text_;
    std::vector<std::string> outputs_, ports_;
};

// Every point, then moved by a step and by half of one, to both sides along both axes.
constexpr std::array<std::array<double, 2>, 9> slope_moves = {{{0, 0},
                                                               {slope_step, 0},
                                                               {-slope_step, 0},
                                                               {slope_step / 2, 0},
                                                               {-slope_step / 2, 0},
                                                               {0, slope_step},
                                                               {0, -slope_step},
                                                               {0, slope_step / 2},
                                                               {0, -slope_step / 2}}};

// Pixels are between `narrow` and 64 times as wide.
PointSet around_points(const Scene& scene, double narrow) {
    std::mt19937 random(17);
    std::vector<std::array<double, 2>> points;
    std::vector<double> widths;
    for (size_t i = 0; i < slope_points; ++i) {
        const double x = random() / 2147483648.0 - 1, y = random() / 2147483648.0 - 1;
        for (const auto& move : slope_moves) {
            points.push_back({x + move[0], y + move[1]});
            widths.push_back(narrow * std::exp2(static_cast<double>(i % 7)));
        }
    }
    PointSet set = plane_points(scene, points);
    for (auto& input : set.values)
        for (const Variant variant : {Variant::dx, Variant::dy}) {
            auto& values = input[static_cast<size_t>(variant)];
            const size_t lanes = values.size() / points.size();
            for (size_t i = 0; i < values.size(); ++i)
                values[i] *= widths[i / lanes];
        }
    return set;
}

struct Compared {
    size_t slopes = 0, kinks = 0;
    double largest = 0;  // difference, in parts of the steepest slope or of 1
    std::string where;
};

// Compares the bumps of one number with its differences.
Compared compare_slopes(const std::vector<std::vector<double>>& number,
                        const std::vector<std::vector<double>>& bump) {
    double steepest = 1;
    for (const auto& each : bump)
        steepest = std::max({steepest, std::fabs(each[0]), std::fabs(each[1])});
    Compared all;
    for (size_t i = 0; i < slope_points; ++i)
        for (size_t axis = 0; axis < 2; ++axis) {
            const auto at = [&](size_t k) { return number[i * slope_moves.size() + k][0]; };
            const size_t first = 1 + 4 * axis;
            const double right = (at(first) - at(0)) / slope_step,
                         left = (at(0) - at(first + 1)) / slope_step;
            const double wide = 0.5 * (left + right),
                         narrow = (at(first + 2) - at(first + 3)) / slope_step;
            if (!(std::fabs(left - right) <= 0.02 * steepest &&
                  std::fabs(wide - narrow) <= 1e-5 * steepest)) {
                ++all.kinks;
                continue;
            }
            ++all.slopes;
            const double found = bump[i * slope_moves.size()][axis];
            const double off = std::fabs(found - (4 * narrow - wide) / 3) / steepest;
            if (off <= all.largest) continue;
            all.largest = off;
            all.where = "at point " + std::to_string(i) + " along " + "xy"[axis] + ": slope " +
                        std::to_string(found) + ", differences " +
                        std::to_string((4 * narrow - wide) / 3);
        }
    return all;
}

// The slopes of images are filtered, and derivatives come from images.
bool reads_slopes(const NodeType& type) {
    return std::any_of(type.ports.begin(), type.ports.end(), [](const Port& port) {
        return port.is_value() &&
               (port.type == PortType::image_ || port.type == PortType::derivative_);
    });
}

using Options = std::map<std::string, std::string>;

// Each choice with each of its values, each flag both ways; the others as they are.
std::vector<Options> options_of(const NodeType& type) {
    std::vector<Options> all{{}};
    for (const Port& port : type.ports) {
        if (port.kind == Port::Kind::flag)
            all.push_back({{port.name, port.default_value[0] == 0 ? "true" : "false"}});
        // A frame goes with a scale, and has slopes only.
        if (port.kind != Port::Kind::choice || port.name == "frame") continue;
        for (size_t i = 0; i < port.choices.size(); ++i)
            if (static_cast<double>(i) != port.default_value[0])
                all.push_back({{port.name, '"' + port.choices[i] + '"'}});
    }
    return all;
}

// The same for one node in each standard library.
unsigned seed_of(const NodeType& type) {
    unsigned seed = 1;
    for (const char c : type.id)
        seed = 31 * seed + static_cast<unsigned char>(c);
    return seed;
}

// Returns the first difference of each "type.port" with other bumps than its differences.
std::map<std::string, std::string> other_slopes(bool wired) {
    std::map<std::string, std::string> found;
    for (const NodeType& type : registry().list()) {
        if (reads_slopes(type)) continue;
        unsigned seed = seed_of(type);
        for (const Options& options : options_of(type)) {
            const SlopeGraph graph(type, options, wired, ++seed);
            if (graph.outputs().empty()) continue;
            const auto got = values(graph.scene(), graph.outputs(),
                                    around_points(graph.scene(), wired ? 1e-4 : 0.5));
            EXPECT_EQ(got.size(), graph.outputs().size()) << graph.text();
            for (size_t k = 0; k < got.size(); k += 2) {
                const Compared one = compare_slopes(got[k], got[k + 1]);
                EXPECT_GE(one.slopes, one.kinks) << graph.port(k) << " of " << graph.text();
                if (one.largest > slope_tolerance(type))
                    found.emplace(type.id + "." + graph.port(k), one.where + " of " + graph.text());
            }
        }
    }
    return found;
}

// The slope of a slope is not known, the bump of a relief is that of the visible point, and
// weights by the normal have no slope.
const std::set<std::string> without_slopes = {
    "bump_roughness.tangent", "gradient_tilt.tilt",       "gradient_tilt.slope",
    "slope_mask.value",       "slope_mask.flat",          "parallax_occlusion.detail_uv",
    "parallax_occlusion.lod", "decal_sphere.attenuation", "parallax_occlusion.position"};

void expect_other_slopes(bool wired, const std::set<std::string>& more) {
    const auto found = other_slopes(wired);
    for (const auto& [name, where] : found)
        EXPECT_TRUE(without_slopes.count(name) || more.count(name)) << name << " " << where;
    for (const std::string& name : more)
        EXPECT_TRUE(found.count(name)) << name << " has its slope";
}

// With numbers at the inputs and pixels up to 1/32 wide. The width of a filter has no slope: it
// varies if the extent of a pixel in the pattern or the mask varies.
TEST(EveryNode, HasTheSlopesOfItsDifferences) {
    expect_other_slopes(
        false, {"weave.over", "tile_sampler.height", "tile_sampler.value", "tile_sampler.mask",
                "splatter.height", "splatter.value", "splatter.mask"});
}

// With inputs that vary too, in small pixels. The middle of a cell and the direction of a copy are
// constant in it.
TEST(EveryNode, HasTheSlopesOfItsInputs) {
    expect_other_slopes(
        true,
        {"bricks.center", "checker.center", "domes.center", "hexagons.center", "splatter.direction",
         "tile_sampler.center", "tile_sampler.direction", "voronoi.center", "weave.center",
         "decal_box.attenuation", "decal_capsule.attenuation", "planar_uv.weight"});
}

}  // namespace
}  // namespace wrinkle::test
