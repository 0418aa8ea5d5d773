#include "export/mtlx_nodes.h"

#include "base/text.h"

namespace wrinkle {

std::string mtlx_type(int components) {
    return components == 1 ? "float" : "vector" + std::to_string(components);
}

std::string mtlx_text(const std::vector<double>& numbers) {
    return joined(numbers, ", ",
                  [](double number) { return shortest(static_cast<float>(number)); });
}

MtlxNodes::MtlxNodes(materialx::Document& document, const std::string& name)
    : document_(document), graph_(document.add(0, "nodegraph", name)) {}

std::string MtlxNodes::free_name(std::string_view name) const {
    const std::string base = identifier(std::string(name));
    std::string free = base;
    for (int i = 2; document_.has_child(graph_, free); ++i)
        free = base + "_" + std::to_string(i);
    return free;
}

std::string MtlxNodes::add(std::string_view category, std::string_view name,
                           std::string_view type) {
    const uint32_t node = document_.add(graph_, std::string(category), free_name(name));
    document_.set(node, "type", std::string(type));
    return document_[node].name;
}

uint32_t MtlxNodes::input_of(const std::string& node, const std::string& input,
                             std::string_view type) {
    const uint32_t element = document_.add(document_.child(graph_, node), "input", input);
    document_.set(element, "type", std::string(type));
    return element;
}

void MtlxNodes::connect(const std::string& node, const std::string& input, std::string_view type,
                        const std::string& source) {
    document_.set(input_of(node, input, type), "nodename", source);
}

void MtlxNodes::write(const std::string& node, const std::string& input, std::string_view type,
                      const std::vector<double>& numbers) {
    write_text(node, input, type, mtlx_text(numbers));
}

void MtlxNodes::write_text(const std::string& node, const std::string& input, std::string_view type,
                           const std::string& text) {
    document_.set(input_of(node, input, type), "value", text);
}

void MtlxNodes::write_file(const std::string& image, const std::string& file, bool is_srgb) {
    const uint32_t element = input_of(image, "file", "filename");
    document_.set(element, "value", file);
    if (is_srgb) document_.set(element, "colorspace", "srgb_texture");
}

std::string MtlxNodes::add_interface(const std::string& name, std::string_view type,
                                     const std::string& value,
                                     const std::vector<materialx::Attribute>& attributes) {
    const uint32_t interface = document_.add(graph_, "input", free_name(name));
    document_.set(interface, "type", std::string(type));
    document_.set(interface, "value", value);
    for (const materialx::Attribute& each : attributes)
        document_.set(interface, each.name, each.value);
    const std::string node = add("dot", name + "_value", type);
    document_.set(input_of(node, "in", type), "interfacename", document_[interface].name);
    return node;
}

void MtlxNodes::connect_outside(uint32_t input, std::string_view type, const std::string& node) {
    const uint32_t output = document_.add(graph_, "output", free_name(document_[input].name));
    document_.set(output, "type", std::string(type));
    document_.set(output, "nodename", node);
    document_.set(input, "nodegraph", document_[graph_].name);
    document_.set(input, "output", document_[output].name);
}

std::string MtlxNodes::component(const std::string& source, int size, int index) {
    if (size == 1) return source;
    static constexpr std::string_view letters = "xyzw";
    const std::string name = source + "_" + letters[static_cast<size_t>(index)];
    const std::string node = add("extract", name, "float");
    connect(node, "in", mtlx_type(size), source);
    write_text(node, "index", "integer", std::to_string(index));
    return node;
}

std::string MtlxNodes::filled(const std::string& source, int size) {
    if (size == 1) return source;
    const std::string node = add("convert", source + "_" + mtlx_type(size), mtlx_type(size));
    connect(node, "in", "float", source);
    return node;
}

}  // namespace wrinkle
