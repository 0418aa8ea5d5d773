#include "certify/harness_graph.h"

#include "base/back_faces.h"
#include "base/text.h"
#include "base/texture_options.h"

namespace wrinkle::certify {
namespace {

class GraphWriter {
    template <class List>
    const auto& pick(const List& list) {
        return list[random_() % std::size(list)];
    }

public:
    GraphWriter(const NodeType& type, Inputs inputs, std::mt19937& random)
        : type_(type), inputs_(inputs), random_(random) {}

    std::string text() {
        std::string in;
        for (const Port& port : type_.ports) {
            if (port.kind == Port::Kind::output) {
                write_output(port);
                continue;
            }
            const std::string value = value_of(port);
            if (value.empty()) continue;
            in += (in.empty() ? "" : ", ") + json_quoted(port.name) + ": " + value;
        }
        return "{\"wrinkle\": 1, \"back_faces\": \"" + std::string(pick(back_faces_names)) +
               "\", \"nodes\": {" + nodes_ + "\"subject\": {\"type\": " + json_quoted(type_.id) +
               ", \"in\": {" + in + "}}}, \"outputs\": {" + outputs_ + "}}";
    }

private:
    double number(double low, double high) {
        return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
    }
    static std::string link(const std::string& node, const std::string& port) {
        return "{\"from\": " + json_quoted(node + "." + port) + "}";
    }
    static std::string list(const std::vector<double>& numbers) {
        const std::string text =
            joined(numbers, ", ", [](double each) { return shortest(static_cast<float>(each)); });
        return numbers.size() == 1 ? text : "[" + text + "]";
    }

    double in_range(const Port& port) {
        if (inputs_ == Inputs::zeros) return 0;
        if (port.has_soft_range()) return number(port.soft_min, port.soft_max);
        if (port.has_hard_range()) return number(port.hard_min, port.hard_max);
        return number(-2, 2);
    }

    std::string option(const Port& port) {
        if (inputs_ == Inputs::defaults) return "";
        if (port.kind == Port::Kind::choice) return json_quoted(pick(port.choices));
        if (port.kind == Port::Kind::flag) return random_() % 2 ? "true" : "false";
        const auto low = static_cast<int>(port.hard_min), high = static_cast<int>(port.hard_max);
        return std::to_string(low +
                              static_cast<int>(random_() % static_cast<unsigned>(high - low + 1)));
    }

    void write_output(const std::string& name, const std::string& from) {
        outputs_ += (outputs_.empty() ? "" : ", ") + json_quoted("out_" + name) + ": " + from;
    }
    // A material is written as some of its channels.
    void write_output(const Port& port) {
        if (port.type != PortType::material_)
            return write_output(port.name, link("subject", port.name));
        const std::string split = "split_" + port.name;
        nodes_ += json_quoted(split) + ": {\"type\": \"material_split\", \"in\": {\"material\": " +
                  link("subject", port.name) + "}}, ";
        for (const char* channel : {"normal", "color", "roughness", "height", "tangent"})
            write_output(port.name + "_" + channel, link(split, channel));
    }

    std::string image() {
        constexpr std::string_view files[] = {"a.exr", "b.exr"};
        const std::string file = json_quoted(std::string(pick(files)));
        if (inputs_ == Inputs::defaults) return file;
        return "{\"file\": " + file + ", \"encoding\": \"" + std::string(pick(encoding_names)) +
               "\", \"wrap\": \"" + std::string(pick(wrap_names)) + "\", \"filter\": \"" +
               (random_() % 4 ? "linear" : "nearest") + "\"}";
    }

    std::string value_of(const Port& port) {
        if (port.is_option()) return option(port);
        if (port.type == PortType::image_) return image();
        const bool wired = inputs_ == Inputs::wires || (inputs_ == Inputs::mixed && random_() % 2);
        // A base must be a resolved normal.
        if (port.name == "base" && port.type == PortType::normal_)
            return wired ? resolved(port) : "";
        if (wired) return wire(port);
        if (lanes_of(port.type) == 0) return inputs_ == Inputs::defaults ? "" : wire(port);
        // Ports with a surface property as default retain it.
        if (port.default_kind == Port::Default::surface) return "";
        if (port.type == PortType::normal_) return wire(port);
        if (inputs_ == Inputs::defaults) return port.is_required() ? wire(port) : "";
        std::vector<double> numbers;
        for (int i = 0; i < lanes_of(port.type); ++i)
            numbers.push_back(in_range(port));
        return list(numbers);
    }

    std::string add(const Port& port, const std::string& type, const std::string& in,
                    const std::string& output) {
        const std::string id = "to_" + port.name + "_" + std::to_string(made_++);
        nodes_ += json_quoted(id) + ": {\"type\": \"" + type + "\", \"in\": {" + in + "}}, ";
        return link(id, output);
    }
    // Applies a node of two vectors to the position and a random vector.
    std::string of_position(const Port& port, const std::string& type, const std::string& output) {
        const std::string b = list({number(-1, 1), number(-1, 1), number(-1, 1)});
        return add(port, type, "\"a\": " + link("surface", "position") + ", \"b\": " + b, output);
    }
    std::string varying_number(const Port& port) { return of_position(port, "dot", "result"); }
    // A field is evaluated at other uvs, so it must depend on uv.
    std::string varying_field(const Port& port) {
        const std::string split =
            add(port, "separate_vec2", "\"vector\": " + link("surface", "uv0"), "x");
        const std::string point = add(
            port, "combine_vec3",
            "\"x\": " + split + ", \"y\": " + split.substr(0, split.size() - 3) + "y\"}", "vector");
        return add(port, "gradient_noise",
                   "\"point\": " + point + ", \"scale\": 2, \"octaves\": 1, \"amplitude\": 0.05",
                   "height");
    }

    // Two results are not parallel, so that a pair of axes or of positions is not degenerate.
    std::string skewed_position(const Port& port) {
        return of_position(port, "vec3_multiply", "vector");
    }
    std::string bump(const Port& port) {
        if (random_() % 2)
            return add(port, "tangent_normal_map", "\"image\": \"a.exr\"", "gradient");
        return add(port, "gradient_from_height", "\"height\": " + varying_number(port), "gradient");
    }
    std::string resolved(const Port& port) {
        return add(port, "resolve", "\"gradient\": " + bump(port), "normal");
    }

    std::string material(const Port& port) {
        return add(port, "material",
                   "\"normal\": " + bump(port) + ", \"color\": " + skewed_position(port) +
                       ", \"height\": " + varying_number(port) +
                       ", \"roughness\": " + list({number(0, 1)}),
                   "material");
    }

    std::string wire(const Port& port) {
        if (port.kind == Port::Kind::field && port.type == PortType::height_)
            return varying_field(port);
        switch (port.type) {
            case PortType::float_:
            case PortType::height_:
                return varying_number(port);
            case PortType::vec2_:
                return add(port, "uv_transform",
                           "\"uv\": " + link("surface", random_() % 2 ? "uv0" : "uv1") +
                               ", \"scale\": " + list({number(0.5, 3), number(0.5, 3)}) +
                               ", \"rotation\": " + list({number(-90, 90)}),
                           "uv");
            case PortType::vec4_:
                return link("surface", "color0");
            case PortType::derivative_:
                return add(port, "derivative_map", "\"image\": \"b.exr\"", "derivative");
            case PortType::gradient_:
                return bump(port);
            case PortType::material_:
                return material(port);
            case PortType::normal_:
                return random_() % 2 ? link("surface", "normal") : resolved(port);
            default:
                return skewed_position(port);
        }
    }

    const NodeType& type_;
    Inputs inputs_;
    std::mt19937& random_;
    std::string nodes_, outputs_;
    int made_ = 0;
};

}  // namespace

std::string words(Inputs inputs) {
    constexpr const char* texts[] = {"with default inputs", "with numbers at its inputs",
                                     "with zeros at its inputs",
                                     "with inputs that vary over the surface",
                                     "with numbers at some inputs and wires at others"};
    return texts[static_cast<size_t>(inputs)];
}

std::string harness_graph(const NodeType& type, Inputs inputs, std::mt19937& random) {
    return GraphWriter(type, inputs, random).text();
}

}  // namespace wrinkle::certify
