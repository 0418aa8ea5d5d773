// Values of MaterialX documents by the definitions of the specification, one point at a time: the
// oracle of import and export, without code of either.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "image/image.h"
#include "materialx/document.h"

namespace wrinkle::test {

struct OraclePoint {
    std::array<double, 2> uv0{}, uv1{};
};

// On the plane z = 0: T = x, B = y, N = z.
class Oracle {
public:
    Oracle(const materialx::Document& document, const std::map<std::string, Image>& images,
           OraclePoint point)
        : document_(document), images_(images), point_(point) {}

    // The value of an input of the node `Surface` at the root, or of another node.
    std::vector<double> input(const std::string& name, const std::string& node = "Surface") const;

private:
    struct Bound {  // a use of a definition
        uint32_t instance = materialx::no_element;
        uint32_t definition = materialx::no_element;
    };
    std::vector<double> of_input(uint32_t input, Bound bound) const;
    std::vector<double> of_node(uint32_t node, const std::string& output, Bound bound) const;
    std::vector<double> given(uint32_t node, const std::string& name, std::vector<double> otherwise,
                              Bound bound) const;
    std::vector<double> sample(uint32_t node, std::vector<double> uv) const;
    std::vector<double> arithmetic(uint32_t node, Bound bound) const;
    std::vector<double> place(uint32_t node, Bound bound) const;
    std::vector<double> tiled(uint32_t node, const std::vector<double>& uv0, Bound bound) const;
    std::vector<double> normal_map(uint32_t node, Bound bound) const;
    std::vector<double> in_graph(uint32_t graph, const std::string& output, Bound bound) const;
    bool is_srgb(uint32_t element) const;

    const materialx::Document& document_;
    const std::map<std::string, Image>& images_;
    OraclePoint point_;
};

}  // namespace wrinkle::test
