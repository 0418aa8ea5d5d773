#include "lower/named_images.h"

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

std::optional<ImageFault> image_fault(const NamedFiles::Found& found,
                                      const std::filesystem::path& root) {
    using std::filesystem::file_type;
    if (!found.path)
        return ImageFault{
            RuleId::outside_root, "outside the root",
            "keep it below " + root.string() + ", or choose another root with --root"};
    if (!exists(std::filesystem::file_status(found.type)))
        return ImageFault{RuleId::image_missing, "which does not exist",
                          "a path is relative to its graph's folder"};
    if (found.type == file_type::regular) return {};
    const bool folder = found.type == file_type::directory;
    return ImageFault{RuleId::image_missing,
                      folder ? "which is a folder" : "which is not a regular file",
                      "expected an image file"};
}

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
