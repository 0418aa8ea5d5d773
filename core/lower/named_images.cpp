#include "lower/named_images.h"

#include "graph/named_files.h"
#include "lower/literal.h"

namespace wrinkle {
namespace {

bool takes_image(const NodeType& type, const Input& input) {
    const uint32_t index = type.find_input(input.port);
    if (index == NodeType::none || input.kind != Input::Kind::literal) return false;
    const Port& port = type.ports[index];
    return port.type == PortType::image_ && port.is_value();
}

}  // namespace

std::vector<NamedImage> named_images(const Project& project, const Types& types, size_t file) {
    std::vector<NamedImage> images;
    NamedFiles files(project);
    const auto add = [&](const json::Value& value) {
        const std::string_view name = literal_image(value).file;
        if (name.empty()) return;
        images.push_back({std::string(name), files.find(file, name).path});
    };
    const Document& document = project.files[file].document;
    for (size_t i = 0; i < document.nodes.size(); ++i) {
        const NodeType* type = types.of(file, i);
        if (!type) continue;
        for (const Input& input : document.nodes[i]->inputs)
            if (takes_image(*type, input)) add(input.value);
    }
    for (const GraphInput& input : document.inputs)
        if (port_type_named(input.type) == PortType::image_) add(input.default_value);
    return images;
}

}  // namespace wrinkle
