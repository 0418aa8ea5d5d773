#include "materialx/oracle.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace wrinkle::test {
namespace {

using Numbers = std::vector<double>;

Numbers numbers_in(std::string_view text) {
    std::string spaced(text);
    std::ranges::replace(spaced, ',', ' ');
    std::istringstream stream(spaced);
    Numbers numbers;
    for (double number; stream >> number;)
        numbers.push_back(number);
    return numbers;
}

double decoded(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double lane(const Numbers& numbers, size_t i) {
    return numbers.size() == 1 ? numbers[0] : numbers[i];
}

// rotate2d: clockwise, in degrees.
Numbers turned(const Numbers& v, double degrees) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    return {std::cos(angle) * v[0] + std::sin(angle) * v[1],
            -std::sin(angle) * v[0] + std::cos(angle) * v[1]};
}

int size_of_type(std::string_view type) {
    if (type == "float" || type == "integer") return 1;
    return type.back() - '0';
}

}  // namespace

bool Oracle::is_srgb(uint32_t element) const {
    for (; element != materialx::no_element; element = document_[element].parent)
        if (document_[element].has("colorspace"))
            return document_[element].attribute("colorspace") == "srgb_texture";
    return false;
}

Numbers Oracle::input(const std::string& name, const std::string& node) const {
    const uint32_t found = document_.child(document_.child(0, node), name);
    if (found == materialx::no_element) throw std::runtime_error("no input " + name);
    return of_input(found, {});
}

Numbers Oracle::in_graph(uint32_t graph, const std::string& output, Bound bound) const {
    for (const uint32_t child : document_[graph].children)
        if (document_[child].category == "output" &&
            (output.empty() || document_[child].name == output))
            return of_input(child, bound);
    throw std::runtime_error("no output " + output);
}

Numbers Oracle::of_input(uint32_t input, Bound bound) const {
    const materialx::Element& at = document_[input];
    const std::string output(at.attribute("output"));
    if (at.has("interfacename")) {
        const std::string name(at.attribute("interfacename"));
        for (const uint32_t owner :
             {bound.instance, bound.definition, document_[at.parent].parent, at.parent})
            if (owner != materialx::no_element && document_.has_child(owner, name))
                return of_input(document_.child(owner, name), {});
        throw std::runtime_error("no interface " + name);
    }
    if (at.has("nodegraph"))
        return in_graph(document_.child(0, at.attribute("nodegraph")), output, {});
    if (at.has("nodename")) {
        const uint32_t holder = at.category == "output" ? at.parent : document_[at.parent].parent;
        return of_node(document_.child(holder, at.attribute("nodename")), output, bound);
    }
    Numbers value = numbers_in(at.attribute("value"));
    const std::string_view type = at.attribute("type");
    if (type.starts_with("color") && is_srgb(input))
        std::ranges::transform(value, value.begin(), decoded);
    return value;
}

Numbers Oracle::given(uint32_t node, const std::string& name, Numbers otherwise,
                      Bound bound) const {
    const uint32_t input = document_.child(node, name);
    return input == materialx::no_element ? otherwise : of_input(input, bound);
}

// Bilinear, periodic; (0, 0) is the lower left corner of the image, as of Image.
Numbers Oracle::sample(uint32_t node, Numbers uv) const {
    const uint32_t file = document_.child(node, "file");
    const std::string path(document_[file].attribute("value"));
    const Image& image = images_.at(path.substr(path.rfind('/') + 1));
    const auto size = static_cast<size_t>(size_of_type(document_[node].attribute("type")));
    const bool decode = document_[node].attribute("type").starts_with("color") && is_srgb(file);
    const double x = uv[0] * image.width - 0.5, y = uv[1] * image.height - 0.5;
    Numbers sum(size, 0);
    for (int corner = 0; corner < 4; ++corner) {
        const double cx = std::floor(x) + corner % 2, cy = std::floor(y) + corner / 2;
        const double weight = (1 - std::abs(x - cx)) * (1 - std::abs(y - cy));
        const int w = static_cast<int>(image.width), h = static_cast<int>(image.height);
        const int column = (static_cast<int>(cx) % w + w) % w;
        const int row = (static_cast<int>(cy) % h + h) % h;
        for (size_t i = 0; i < size; ++i) {
            const double texel =
                image.texel(static_cast<uint32_t>(column), static_cast<uint32_t>(row))[i];
            sum[i] += weight * (decode ? decoded(texel) : texel);
        }
    }
    return sum;
}

Numbers Oracle::place(uint32_t node, Bound bound) const {
    const Numbers uv = given(node, "texcoord", {0, 0}, bound);
    const Numbers pivot = given(node, "pivot", {0, 0}, bound);
    const Numbers scale = given(node, "scale", {1, 1}, bound);
    const Numbers offset = given(node, "offset", {0, 0}, bound);
    const double angle = given(node, "rotate", {0}, bound)[0];
    Numbers p = {uv[0] - pivot[0], uv[1] - pivot[1]};
    if (given(node, "operationorder", {0}, bound)[0] == 0) {
        p = turned({p[0] / scale[0], p[1] / scale[1]}, angle);
        return {p[0] - offset[0] + pivot[0], p[1] - offset[1] + pivot[1]};
    }
    p = turned({p[0] - offset[0], p[1] - offset[1]}, angle);
    return {p[0] / scale[0] + pivot[0], p[1] / scale[1] + pivot[1]};
}

Numbers Oracle::tiled(uint32_t node, const Numbers& uv0, Bound bound) const {
    const auto two = [&](const char* name, Numbers otherwise) {
        return given(node, name, std::move(otherwise), bound);
    };
    const Numbers tiling = two("uvtiling", {1, 1}), offset = two("uvoffset", {0, 0});
    const Numbers image = two("realworldimagesize", {1, 1});
    const Numbers tile = two("realworldtilesize", {1, 1});
    Numbers uv = two("texcoord", uv0);
    for (size_t i = 0; i < 2; ++i)
        uv[i] = (uv[i] * tiling[i] - offset[i]) / image[i] * tile[i];
    return sample(node, uv);
}

Numbers Oracle::normal_map(uint32_t node, Bound bound) const {
    const Numbers in = given(node, "in", {0.5, 0.5, 1}, bound);
    const Numbers scale = given(node, "scale", {1}, bound);
    Numbers n = {(2 * in[0] - 1) * lane(scale, 0), (2 * in[1] - 1) * lane(scale, 1), 2 * in[2] - 1};
    const double length = std::hypot(n[0], n[1], n[2]);
    for (double& each : n)
        each /= length;
    return n;
}

Numbers Oracle::of_node(uint32_t node, const std::string& output, Bound bound) const {
    const materialx::Element& at = document_[node];
    const std::string& category = at.category;
    const auto get = [&](const char* name, Numbers otherwise) {
        return given(node, name, std::move(otherwise), bound);
    };
    const Numbers uv0(point_.uv0.begin(), point_.uv0.end());
    if (category == "constant") return get("value", {0});
    if (category == "texcoord")
        return get("index", {0})[0] == 1 ? Numbers(point_.uv1.begin(), point_.uv1.end()) : uv0;
    if (category == "place2d") return place(node, bound);
    if (category == "normalmap") return normal_map(node, bound);
    if (category == "image") return sample(node, get("texcoord", uv0));
    if (category == "tiledimage") return tiled(node, uv0, bound);
    if (category == "extract") {
        const Numbers in = get("in", {0});
        return {in[static_cast<size_t>(get("index", {0})[0])]};
    }
    if (category == "convert" || category == "dot") {
        Numbers in = get("in", {0});
        in.resize(static_cast<size_t>(size_of_type(document_[node].attribute("type"))), in[0]);
        return in;
    }
    if (category == "dotproduct") {
        const Numbers a = get("in1", {0}), b = get("in2", {0});
        return {std::inner_product(a.begin(), a.end(), b.begin(), 0.0)};
    }
    if (category == "separate3") {
        const size_t part = output == "outx" ? 0 : output == "outy" ? 1 : 2;
        return {get("in", {0, 0, 0})[part]};
    }
    const uint32_t definition = document_.child(0, "ND_" + category);
    if (definition != materialx::no_element)
        return in_graph(document_.child(0, "NG_" + category), output, {node, definition});
    return arithmetic(node, bound);
}

Numbers Oracle::arithmetic(uint32_t node, Bound bound) const {
    const std::string& category = document_[node].category;
    const auto get = [&](const char* name, Numbers otherwise) {
        return given(node, name, std::move(otherwise), bound);
    };
    const auto size = static_cast<size_t>(size_of_type(document_[node].attribute("type")));
    const Numbers a = get(category == "mix" ? "bg" : "in1", {0});
    const Numbers b = get(category == "mix" ? "fg" : "in2", {0});
    const Numbers mask = get("mix", {0});
    Numbers result;
    for (size_t i = 0; i < size; ++i) {
        const double x = lane(a, i), y = lane(b, i), t = lane(mask, i);
        if (category == "multiply") result.push_back(x * y);
        if (category == "add") result.push_back(x + y);
        if (category == "subtract") result.push_back(x - y);
        if (category == "divide") result.push_back(x / y);
        if (category == "max") result.push_back(std::max(x, y));
        if (category == "absval") result.push_back(std::abs(lane(get("in", {0}), i)));
        if (category == "mix") result.push_back((1 - t) * x + t * y);
        if (category.starts_with("combine"))
            result.push_back(get(("in" + std::to_string(i + 1)).c_str(), {0})[0]);
    }
    if (result.empty()) throw std::runtime_error("no node " + category);
    return result;
}

}  // namespace wrinkle::test
