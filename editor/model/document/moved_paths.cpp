#include "editor/model/document/moved_paths.h"

#include <algorithm>

#include "base/file.h"
#include "editor/model/document/field.h"
#include "graph/edit.h"
#include "lower/literal.h"
#include "lower/named_images.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

class Mover {
public:
    Mover(MovedPaths& result, const fs::path& from, const fs::path& to, OutsideFiles files)
        : result_(result), from_(real_path(from)), to_(real_path(to)), files_(files) {}

    bool stays() const { return from_ == to_; }

    // Returns the name relative to the new folder.
    std::string moved(const std::string& name) {
        if (name.empty() || name.find('\0') != name.npos) return name;
        const fs::path file = (from_ / name).lexically_normal();
        if (leaves(file)) {
            auto& outside = result_.outside;
            if (std::ranges::find(outside, name) == outside.end()) outside.push_back(name);
            if (files_ == OutsideFiles::copied) return copied(file);
        }
        return fs::path(name).is_absolute() ? name : file.lexically_relative(to_).string();
    }

    json::Value moved_image(const json::Value& value) {
        const std::string name(literal_image(value).file);
        const std::string to = moved(name);
        return to == name ? value : with_file(value, to);
    }

    // Adds the sub-graphs to copy, and the images that they name.
    void copy_subgraphs(const Model& model) {
        const Project& project = *model.project;
        for (size_t i = 1; i < project.files.size() && files_ == OutsideFiles::copied; ++i) {
            const fs::path& path = project.files[i].path;
            if (!leaves(path)) continue;
            copied(path);
            for (const NamedImage& image : named_images(project, *model.types, i)) {
                const fs::path file = (path.parent_path() / image.name).lexically_normal();
                if (leaves(file)) copied(file);
            }
        }
    }

private:
    bool leaves(const fs::path& file) const { return inside(from_, file) && !inside(to_, file); }

    std::string copied(const fs::path& file) {
        const fs::path place = file.lexically_relative(from_);
        result_.copies[to_ / place] = file;
        return place.string();
    }

    MovedPaths& result_;
    const fs::path from_, to_;
    const OutsideFiles files_;
};

bool hold_the_same(const fs::path& a, const fs::path& b) {
    std::string why;
    const auto first = read_file(a, why), second = read_file(b, why);
    return first && second && *first == *second;
}

bool copy(const fs::path& from, const fs::path& to, NewPaths& made, std::string& why) {
    std::error_code error, ignored;
    if (fs::exists(to, ignored)) {
        why = "there is another " + to.filename().string();
        return hold_the_same(from, to);
    }
    made.add_missing(to.parent_path());
    fs::create_directories(to.parent_path(), error);
    if (!error) made.add(to);
    if (!error) fs::copy_file(from, to, error);
    if (error) why = to.filename().string() + " was not copied: " + disk_words(error);
    return !error;
}

}  // namespace

MovedPaths move_paths(const Document& document, const Model& model, const fs::path& from,
                      const fs::path& to, OutsideFiles files) {
    MovedPaths result{document, {}, {}};
    Mover mover(result, from, to, files);
    if (mover.stays()) return result;
    mover.copy_subgraphs(model);
    for (const NodePtr& node : document.nodes) {
        if (const auto file = node->subgraph())
            result.document =
                set_type(result.document, node->id,
                         type_of_subgraph(mover.moved(std::string(*file))), node->version);
        const NodeType* type = model.type_of(node->id);
        for (const Input& input : node->inputs) {
            const Port* port = input_port(type, input.port);
            if (port && port->type == PortType::image_ && input.kind == Input::Kind::literal)
                result.document = set_value(result.document, node->id, input.port,
                                            mover.moved_image(input.value));
        }
    }
    for (GraphInput input : document.inputs) {
        if (port_type_named(input.type) != PortType::image_) continue;
        input.default_value = mover.moved_image(input.default_value);
        result.document = set_graph_input(result.document, std::move(input));
    }
    for (Preset preset : document.presets) {
        for (Extra& value : preset.values) {
            const GraphInput* input = document.inputs.find(value.key);
            if (input && port_type_named(input->type) == PortType::image_)
                value.value = mover.moved_image(value.value);
        }
        result.document = set_preset(result.document, std::move(preset));
    }
    return result;
}

bool copy_files(const std::map<fs::path, fs::path>& copies, NewPaths& made, std::string& why) {
    std::error_code ignored;
    return std::ranges::all_of(copies, [&](const auto& each) {
        return !fs::exists(each.second, ignored) || copy(each.second, each.first, made, why);
    });
}

}  // namespace wrinkle::editor
