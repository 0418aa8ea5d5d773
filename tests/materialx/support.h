// Documents of this folder with their images, imported by the program and evaluated.
#pragma once

#include <map>

#include "cli/support.h"
#include "materialx/oracle.h"

namespace wrinkle::test {

class MaterialXTest : public CliTest {
public:
    // A document of an open_pbr_surface with these inputs and other elements.
    static std::string surface(const std::string& elements, const std::string& inputs);

protected:
    void SetUp() override;

    // Images of 8 x 8 texels with smooth differences: color.png, data.png (one channel) and
    // normal.png with unit vectors.
    std::map<std::string, Image> images;

    static std::string document_text(const std::string& name);  // in the folder documents
    materialx::Document read(const std::string& text, const std::string& name = "a.mtlx") const;

    // Writes the text as a.mtlx; imports it to a.json.
    Ran import(const std::string& text, const std::vector<std::string>& more = {}) const;
    void save(const std::string& name, const Image& image) const;  // .png: 8 bits, .exr: half
    // Evaluates the outputs of a graph on the plane z = 0.
    json::Value values(const std::string& graph, const OraclePoint& point) const;
    static void expect_near(const json::Value& found, const std::vector<double>& expected,
                            const std::string& name, double tolerance = 1e-4);
};

std::vector<OraclePoint> some_points();

}  // namespace wrinkle::test
