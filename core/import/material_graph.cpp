#include "import/material_graph.h"

#include <map>
#include <utility>

#include "base/file.h"
#include "graph/edit.h"

namespace wrinkle::textures {
namespace fs = std::filesystem;
namespace {

json::Value image_value(const std::string& file, Encoding encoding, bool is_default) {
    if (is_default) return json::Value::string(file);
    const std::pair<std::string, json::Value> members[] = {
        {"file", json::Value::string(file)}, {"encoding", json::Value::string(name_of(encoding))}};
    return json::Value::object(members);
}

Input linked(std::string port, Link link) {
    const std::pair<std::string, json::Value> from[] = {{"from", json::Value::string(link.text())}};
    return {std::move(port), Input::Kind::link, std::move(link), json::Value::object(from)};
}

Input literal(std::string port, json::Value value) {
    return {std::move(port), Input::Kind::literal, {}, std::move(value)};
}

Link exposed(const char* name) {
    return {std::string(Link::input), name};
}

json::Value pair_of(double a, double b) {
    const json::Value numbers[] = {json::Value::number(a), json::Value::number(b)};
    return json::Value::array(numbers);
}

// Rounds to four significant digits: sizes are estimates, and files are read by people.
double rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return std::strtod(text, nullptr);
}

GraphInput factor_input(const char* name, const char* label, const char* doc) {
    GraphInput input;
    input.name = name;
    input.type = "float";
    input.default_value = json::Value::number(1);
    input.slider = pair_of(0, 2);
    input.unit = "x";
    input.label = label;
    input.doc = doc;
    return input;
}

class GraphBuilder {
public:
    GraphBuilder(const TextureSet& set, const GraphOptions& options)
        : set_(set), options_(options) {
        document_.name = set.name;
        measure();
    }

    Document build() {
        add_tiling();
        add_colors();
        add_bump();
        for (const Channel channel :
             {Channel::roughness, Channel::metalness, Channel::occlusion, Channel::opacity})
            if (const Texture* texture = set_.find(channel)) add_number(*texture);
        return std::move(document_);
    }

private:
    // Sizes are those of the height map, else of the first image.
    void measure() {
        const Texture* measured = set_.find(Channel::height);
        for (size_t i = 0; !measured; ++i)
            measured = set_.find(static_cast<Channel>(i));
        const double width = measured->info.width, height = measured->info.height;
        is_size_known_ = options_.texel || options_.uv_length;
        double repeat = options_.uv_length.value_or(1);
        if (options_.texel) {
            repeat = (*options_.texel)[0] * width;
            const double uv_length = options_.uv_length.value_or(repeat);
            tiling_ = {rounded(uv_length / repeat),
                       rounded(uv_length / ((*options_.texel)[1] * height))};
        }
        const double relief = set_.relief ? *set_.relief / width : default_relief;
        amplitude_ = options_.height.value_or(rounded(relief * repeat));
    }

    void add_node(std::string id, const char* type, std::vector<Input> inputs) {
        Node node;
        node.id = std::move(id);
        node.type = type;
        node.inputs = std::move(inputs);
        document_ = wrinkle::add_node(document_, std::move(node));
    }

    void expose(GraphInput input) { document_ = set_graph_input(document_, std::move(input)); }

    void add_output(Channel channel, Link from) {
        document_ = set_output(document_, name_of(channel), from);
    }

    std::string path_of(const Texture& texture) const {
        const fs::path folder = real_path(options_.folder);
        const fs::path file = real_path(texture.file.parent_path()) / texture.file.filename();
        return file.lexically_relative(folder).generic_string();
    }

    void add_tiling() {
        GraphInput input;
        input.name = "tiling";
        input.type = "vec2";
        input.default_value = pair_of(tiling_[0], tiling_[1]);
        input.label = "Tiling";
        input.doc = "How often the textures repeat per uv unit";
        expose(std::move(input));
        add_node("tile", "uv_transform", {linked("scale", exposed("tiling"))});
    }

    Input uv() const { return linked("uv", {"tile", "uv"}); }

    // Returns the node that reads the image of a texture as stored, one for all of its channels.
    std::string data_node(const Texture& texture) {
        const auto known = data_nodes_.find(texture.file);
        if (known != data_nodes_.end()) return known->second;
        const bool is_packed = texture.role->sources.size() > 1;
        const std::string id =
            free_id(document_, is_packed ? "packed_map"
                                         : std::string(name_of(texture.source.channel)) + "_map");
        add_node(id, "image",
                 {literal("image", image_value(path_of(texture), Encoding::linear, false)), uv()});
        return data_nodes_[texture.file] = id;
    }

    void add_colors() {
        for (const Channel channel : {Channel::color, Channel::emission}) {
            const Texture* texture = set_.find(channel);
            if (!texture) continue;
            const std::string id = std::string(name_of(channel)) + "_map";
            const bool is_coded = is_integer(texture->info.source);  // floats are linear
            const Encoding encoding = is_coded ? Encoding::srgb : Encoding::linear;
            add_node(id, "image",
                     {literal("image", image_value(path_of(*texture), encoding, is_coded)), uv()});
            data_nodes_[texture->file] = id;  // alpha is never encoded
            add_output(channel, {id, "color"});
        }
    }

    void add_bump() {
        const Texture* normal = set_.find(Channel::normal);
        const Texture* height = set_.find(Channel::height);
        if (!normal && !height) return;
        expose(factor_input("bump", "Bump", "Factor of the slopes: 0 is flat"));
        Link bump;
        if (normal) {
            const Encoding encoding = set_.normal_encoding;
            add_node("normal_map", "tangent_normal_map",
                     {literal("image", image_value(path_of(*normal), encoding,
                                                   encoding == Encoding::normal_gl)),
                      uv(), linked("strength", exposed("bump"))});
            bump = {"normal_map", "gradient"};
        }
        if (height) add_height(*height);
        if (!normal) {
            add_node("scaled", "gradient_scale",
                     {linked("gradient", height_bump_), linked("amount", exposed("bump"))});
            bump = {"scaled", "gradient"};
        }
        add_node("normal", "resolve", {linked("gradient", bump)});
        add_output(Channel::normal, {"normal", "normal"});
    }

    void add_height(const Texture& texture) {
        GraphInput input;
        input.name = "height";
        input.type = "float";
        input.default_value = json::Value::number(amplitude_);
        input.label = "Height";
        input.doc = "Height of white over black";
        if (amplitude_ > 0) input.slider = pair_of(0, rounded(4 * amplitude_));
        expose(std::move(input));
        if (texture.source.component != Component::red) return add_packed_height(texture);
        std::vector<Input> inputs = {
            literal("image", image_value(path_of(texture), Encoding::linear, true)), uv(),
            linked("amplitude", exposed("height"))};
        if (!is_size_known_) inputs.push_back(literal("scale", json::Value::string("unit")));
        add_node("height_map", "height_map", std::move(inputs));
        height_bump_ = {"height_map", "gradient"};
        add_output(Channel::height, {"height_map", "height"});
    }

    // A height map reads the red channel; another one is scaled about the middle.
    void add_packed_height(const Texture& texture) {
        const std::string map = data_node(texture);
        add_node("centred", "subtract",
                 {linked("a", {map, std::string(name_of(texture.source.component))}),
                  literal("b", json::Value::number(0.5))});
        add_node("height", "height_scale",
                 {linked("height", {"centred", "result"}), linked("amount", exposed("height"))});
        height_bump_ = {"height", "height"};
        add_output(Channel::height, height_bump_);
    }

    void add_number(const Texture& texture) {
        Link value{data_node(texture), std::string(name_of(texture.source.component))};
        if (texture.source.inverted) {
            add_node("rough", "invert", {linked("value", value)});
            value = {"rough", "value"};
        }
        if (texture.source.channel == Channel::roughness) value = scaled_roughness(value);
        add_output(texture.source.channel, value);
    }

    Link scaled_roughness(const Link& value) {
        expose(factor_input("roughness", "Roughness", "Factor of the roughness"));
        add_node("rougher", "multiply", {linked("a", value), linked("b", exposed("roughness"))});
        add_node("roughness", "clamp", {linked("x", {"rougher", "result"})});
        return {"roughness", "result"};
    }

    const TextureSet& set_;
    const GraphOptions& options_;
    Document document_;
    bool is_size_known_ = false;
    std::array<double, 2> tiling_ = {1, 1};
    double amplitude_ = 0;
    std::map<fs::path, std::string> data_nodes_;  // by file
    Link height_bump_;
};

}  // namespace

Document material_graph(const TextureSet& set, const GraphOptions& options) {
    return GraphBuilder(set, options).build();
}

}  // namespace wrinkle::textures
