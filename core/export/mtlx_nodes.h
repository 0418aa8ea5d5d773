// The node graph of an exported MaterialX document: adds nodes and their inputs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "materialx/document.h"

namespace wrinkle {

std::string mtlx_type(int components);  // "float", "vector2", "vector3", "vector4"
std::string mtlx_text(const std::vector<double>& numbers);  // "0.5, 1", of 32-bit floats

class MtlxNodes {
public:
    MtlxNodes(materialx::Document& document, const std::string& name);

    // Adds a node; returns its name, `name` as an identifier and unique.
    std::string add(std::string_view category, std::string_view name, std::string_view type);
    // Adds an input to a node: connected to another node, of numbers, or of any value.
    void connect(const std::string& node, const std::string& input, std::string_view type,
                 const std::string& source);
    void write(const std::string& node, const std::string& input, std::string_view type,
               const std::vector<double>& numbers);
    void write_text(const std::string& node, const std::string& input, std::string_view type,
                    const std::string& text);
    void write_file(const std::string& image, const std::string& file, bool is_srgb);
    // Adds an input to the graph and a `dot` node that reads it; returns the name of the node.
    std::string add_interface(const std::string& name, std::string_view type,
                              const std::string& value,
                              const std::vector<materialx::Attribute>& attributes);
    // Connects an input of an element outside of the graph to a node, by an output of the graph.
    void connect_outside(uint32_t input, std::string_view type, const std::string& node);

    // Adds a node that extracts component `index`; returns its name, or `source` if `size` is 1.
    std::string component(const std::string& source, int size, int index);
    // Adds a node that repeats a float in `size` components; returns its name.
    std::string filled(const std::string& source, int size);

private:
    uint32_t input_of(const std::string& node, const std::string& input, std::string_view type);
    std::string free_name(std::string_view name) const;

    materialx::Document& document_;
    uint32_t graph_;
};

}  // namespace wrinkle
