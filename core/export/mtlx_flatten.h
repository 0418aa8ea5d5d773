// Writes the values of a module as nodes of MaterialX's standard library (mtlx_support.h).
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "export/mtlx_nodes.h"
#include "export/mtlx_support.h"
#include "ir/module.h"

namespace wrinkle {

class MtlxFlattener {
public:
    // `interface_of` returns the node of a graph input, `file_of` the file that the document names
    // for a resource. Precondition: every value of the module is used by an output.
    MtlxFlattener(const Module& module, MtlxNodes& nodes,
                  std::function<std::string(const Parameter&)> interface_of,
                  std::function<std::string(uint32_t resource)> file_of);

    const MtlxSupport& support() const { return support_; }

    // These return the name of a node and add it if it does not exist.
    std::string node(Id value);    // float or vectorN; precondition: support().has(value)
    std::string color(Id value);   // color3; the same precondition
    std::string normal(Id value);  // vector3, world; "": the surface's normal, unchanged.
                                   // Precondition: support().has_normal(value)

    // A color3 node has the values of this vector3 node.
    void add_color(const std::string& vector, const std::string& color) { colors_[vector] = color; }

private:
    int size_of(Id id) const { return info(module_.type(id)).lanes; }
    std::string title(Id id, const char* category) const;
    std::string add(Id id, const char* category);
    void operand(const std::string& node, const char* input, Id value, int size);
    void emit_needed(Id value);
    std::string emit(Id id);
    std::string emit_slopes(Id id);
    std::string emit_call(Id id);
    std::string emit_product(Id id);
    std::string emit_comparison(Id id, Id condition);
    std::string emit_step(Id id);
    std::string emit_select(Id id);
    std::string emit_construct(Id id);
    std::string emit_swizzle(Id id);
    bool reads_uv0(Id sample) const;
    std::string emit_sample(Id id);
    void write_sampler(const std::string& image, const TextureOptions& options);
    std::string emit_input(Id id);
    void find_components();

    std::string two(Id id, const char* category, const std::string& a, const std::string& b);
    std::string coded(Id normal);
    std::string emit_normal_slopes(Id id);
    std::string depth_of(Id id, const std::string& normal);
    std::string in_uv0(Id id, const std::string& slopes, Id frame);
    bool is_turned(Id frame) const;
    std::string normal_of_map(Id resolve, Id derivative);
    std::string normal_of_slopes(Id resolve, const std::string& slopes);

    const Module& module_;
    MtlxNodes& nodes_;
    std::function<std::string(const Parameter&)> interface_of_;
    std::function<std::string(uint32_t)> file_of_;
    MtlxSupport support_;
    std::vector<uint8_t> components_;            // that are read of a sample: bits of x, y, z, w
    std::vector<std::string> names_;             // nodes, by Id
    std::map<std::string, std::string> colors_;  // color3 nodes by their vector3 node
};

}  // namespace wrinkle
