#include "import/mtlx_importer.h"

#include <algorithm>
#include <cmath>

#include "base/file.h"
#include "base/limits.h"
#include "base/srgb.h"
#include "import/mtlx_interface.h"

namespace wrinkle::materialx {
namespace fs = std::filesystem;
namespace {

struct SpaceRow {
    std::string_view name;
    double gamma;
};

constexpr std::array color_spaces = {
    SpaceRow{"", 1},
    SpaceRow{"none", 1},
    SpaceRow{"raw", 1},
    SpaceRow{"lin_rec709", 1},
    SpaceRow{"srgb_texture", 0},
    SpaceRow{"srgb_tx", 0},
    SpaceRow{"sRGB", 0},
    SpaceRow{"g22_rec709", 2.2},
    SpaceRow{"gamma22", 2.2},
    SpaceRow{"g18_rec709", 1.8},
    SpaceRow{"gamma18", 1.8},
    SpaceRow{"rec709_display", 2.4},
    SpaceRow{"gamma24", 2.4},
    SpaceRow{"lin_rec709_scene", 1},
    SpaceRow{"srgb_rec709_scene", 0},
};

double linear(double stored, ColorSpace space) {
    if (space.is_linear()) return stored;
    return space.is_srgb() ? linear_from_srgb(stored)
                           : std::pow(std::max(stored, 0.0), space.gamma);
}

// The nearest attribute of an element or its parents; "" if none has it.
std::string_view inherited(const Document& document, uint32_t element, std::string_view name) {
    for (; element != no_element; element = document[element].parent)
        if (document[element].has(name)) return document[element].attribute(name);
    return {};
}

struct OutputPart {
    std::string_view name;
    int part;
};

constexpr std::array output_parts = {
    OutputPart{"outx", 0}, OutputPart{"outr", 0}, OutputPart{"r", 0},    OutputPart{"outy", 1},
    OutputPart{"outg", 1}, OutputPart{"g", 1},    OutputPart{"outz", 2}, OutputPart{"outb", 2},
    OutputPart{"b", 2},    OutputPart{"outw", 3}, OutputPart{"outa", 3}, OutputPart{"a", 3},
};

}  // namespace

Importer::Importer(const Document& document, fs::path source, fs::path target,
                   Diagnostics& diagnostics)
    : document_(document),
      source_(std::move(source)),
      target_(std::move(target)),
      diagnostics_(diagnostics),
      sources_(document, diagnostics) {}

void Importer::report(uint32_t element, Severity severity, RuleId rule, std::string message,
                      std::string expected) {
    const Element& at = document_[element];
    const bool is_port = at.category == "input" || at.category == "output";
    const Element& node = is_port && at.parent != no_element ? document_[at.parent] : at;
    diagnostics_.add({rule, severity, document_.location(element), "", node.name,
                      std::move(message), std::move(expected)});
}

std::optional<ColorSpace> Importer::color_space(uint32_t element) {
    const std::string_view name = inherited(document_, element, "colorspace");
    const auto row = std::ranges::find(color_spaces, name, &SpaceRow::name);
    if (row != color_spaces.end()) return ColorSpace{row->gamma};
    report(element, Severity::error, RuleId::materialx_unsupported,
           "the color space '" + std::string(name) + "' is not supported",
           "lin_rec709, srgb_texture, g22_rec709, g18_rec709 or rec709_display");
    return {};
}

std::string Importer::image_path(uint32_t input) {
    std::string name(inherited(document_, input, "fileprefix"));
    name += document_[input].attribute("value");
    std::ranges::replace(name, '\\', '/');
    if (document_[input].attribute("value").empty()) {
        report(input, Severity::error, RuleId::materialx_value, "names no file", "a file");
        return {};
    }
    if (name.find('<') != name.npos || name.find('{') != name.npos) {
        report(input, Severity::error, RuleId::materialx_unsupported,
               "'" + name + "' names several files", "the name of one image, without UDIM tiles");
        return {};
    }
    const fs::path file = source_ / name;
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
        report(input, Severity::error, RuleId::image_missing,
               "the image '" + file.lexically_normal().generic_string() + "' does not exist",
               "the file, at this path relative to the document");
        return {};
    }
    images_.push_back(file.string());
    const fs::path folder = real_path(target_);
    const fs::path found = real_path(file.parent_path()) / file.filename();
    return found.lexically_relative(folder).generic_string();
}

// Depth first, with an explicit stack.
void Importer::build(NodeKey wanted) {
    struct Open {
        NodeKey key;
        std::vector<NodeKey> needs;
        size_t next = 0;
    };
    std::vector<Open> stack;
    const auto open = [&](NodeKey key) {
        const auto [entry, is_new] = values_.try_emplace(key);
        if (is_new && within_limits(key)) stack.push_back({key, needs(key)});
        return is_new || entry->second.is_done;
    };
    open(wanted);
    while (!stack.empty()) {
        Open& top = stack.back();
        if (top.next < top.needs.size()) {
            const NodeKey need = top.needs[top.next++];
            const uint32_t element = top.key.element;
            if (!open(need))
                report(element, Severity::error, RuleId::materialx_value,
                       "is connected to itself, by way of '" + document_[need.element].name + "'",
                       "connections without a circle");
            continue;
        }
        const NodeKey key = top.key;
        stack.pop_back();
        Value value = build_node(key);
        values_[key] = {true, std::move(value)};
    }
}

bool Importer::within_limits(NodeKey key) {
    const uint64_t most = limit_of(Limit::graph_nodes);
    if (!is_over_limit_ && (values_.size() > most || graph_.size() > most)) {
        is_over_limit_ = true;
        report(key.element, Severity::error, RuleId::over_limit,
               "the graph would have more than " + std::to_string(most) + " nodes",
               std::string(row_of(Limit::graph_nodes).variable) + " sets another limit");
    }
    if (is_over_limit_) values_[key] = {true, bad_value()};
    return !is_over_limit_;
}

std::vector<NodeKey> Importer::needs(NodeKey key) {
    std::vector<NodeKey> found;
    for (const uint32_t child : document_[key.element].children) {
        if (document_[child].category != "input") continue;
        const Source source = sources_.input(key, document_[child].name);
        if (source.kind == Source::Kind::node) found.push_back(source.node);
    }
    return found;
}

Value Importer::build_node(NodeKey key) {
    const Element& element = document_[key.element];
    const Handler handler = handler_of(element.category);
    if (!handler) {
        report(key.element, Severity::error, RuleId::materialx_unsupported,
               "the node category '" + element.category + "' is not supported",
               "an image of its values, or nodes of docs/import.md");
        return bad_value();
    }
    graph_.begin(element.name);
    NodeContext context(*this, key);
    Value value = handler(context);
    return context.failed() ? bad_value() : value;
}

Value Importer::constant(uint32_t input, Type type) {
    const Element& element = document_[input];
    const Type written = element.has("type") ? type_named(element.attribute("type")) : type;
    std::optional<Value> value = parse_value(written, element.attribute("value"));
    if (!value) {
        report(input, Severity::error, RuleId::materialx_value,
               "input '" + element.name + "': '" + std::string(element.attribute("value")) +
                   "' is not a " + std::string(element.attribute("type")),
               written == Type::none ? "a type of MaterialX" : "numbers separated by commas");
        return bad_value();
    }
    if (!is_color(written)) return *value;
    const auto space = color_space(input);
    if (!space) return bad_value();
    for (size_t i = 0; i < 3; ++i)
        value->parts[i]->value = linear(value->parts[i]->value, *space);
    return *value;
}

Value Importer::exposed(uint32_t input, Type type) {
    const auto known = exposed_.find(input);
    if (known != exposed_.end()) return known->second;
    Value value = constant(input, type);
    if (!value.is_bad && is_exposable(value.type)) {
        const Type exposed_type = value.type;
        value = wire_value(exposed_type, graph_.expose(interface_input(document_[input], value)));
        if (exposed_type == Type::vector2) value.change.reset();
    }
    return exposed_[input] = value;
}

Value Importer::node_value(const Source& source) {
    const auto found = values_.find(source.node);
    if (found == values_.end() || !found->second.is_done) return bad_value();
    const Value& value = found->second.value;
    if (value.is_bad || source.output.empty() || source.output == "out") return value;
    if (source.output == "outcolor" || source.output == "rgb") {
        graph_.begin(document_[source.node.element].name);
        return graph_.from_parts(
            Type::color3, {graph_.part(value, 0), graph_.part(value, 1), graph_.part(value, 2)});
    }
    const auto row = std::ranges::find(output_parts, source.output, &OutputPart::name);
    const std::string_view category = document_[source.node.element].category;
    const bool has_parts = category.starts_with("separate") || category == "UsdUVTexture" ||
                           category == "gltf_colorimage";
    if (!has_parts || row == output_parts.end() || row->part >= size_of(value.type)) {
        report(source.input, Severity::error, RuleId::materialx_value,
               "node '" + document_[source.node.element].name + "' has no output '" +
                   source.output + "'");
        return bad_value();
    }
    graph_.begin(document_[source.node.element].name);
    Value part;
    part.type = Type::float_;
    part.parts[0] = graph_.part(value, row->part);
    if (row->part == 0) part.image = value.image;
    return part;
}

Value Importer::value(const Source& source, Type type, const Value& otherwise, bool or_number) {
    Value value = otherwise;
    switch (source.kind) {
        case Source::Kind::absent:
            return value;
        case Source::Kind::bad:
            return bad_value();
        case Source::Kind::constant:
            value = constant(source.input, type);
            break;
        case Source::Kind::exposed:
            value = exposed(source.input, type);
            break;
        case Source::Kind::node:
            build(source.node);
            value = node_value(source);
            break;
    }
    const int size = size_of(value.type);
    if (value.is_bad || size == size_of(type) || (or_number && size == 1)) return value;
    report(source.input, Severity::error, RuleId::materialx_value,
           "input '" + document_[source.input].name + "' is a " + std::string(name_of(value.type)),
           "a " + std::string(name_of(type)));
    return bad_value();
}

}  // namespace wrinkle::materialx
