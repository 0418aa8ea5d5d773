#include "export/support.h"

#include <cstring>

#include "base/text.h"
#include "json/parse.h"
#include "mesh/shapes.h"
#include "support/linked_nodes.h"

namespace wrinkle::test {
namespace fs = std::filesystem;

Mesh ExportTest::plane() {
    return *make_shape("plane");
}

std::vector<std::string> ExportTest::export_graph(const std::string& host, const fs::path& graph) {
    diagnostics = Diagnostics();
    Project project = load_project(graph, {}, diagnostics);
    const ExportRequest request{std::move(project),
                                graph.filename().string(),
                                linked_nodes(),
                                name.empty() ? identifier(graph.stem().string()) : name,
                                mesh,
                                "the mesh",
                                double_sided,
                                16};
    const Host* found = find_host(host);
    EXPECT_TRUE(found) << host;
    if (!found || diagnostics.has_errors()) return {};
    return export_material(*found, request, out(), inputs, diagnostics);
}

std::vector<std::string> ExportTest::export_channels(const std::string& host, const std::string& in,
                                                     const std::string& nodes) {
    return export_graph(
        host, folder.put("rock.json", R"({"wrinkle": 1, "nodes": {)" + nodes +
                                          R"("m": {"type": "material", "in": {)" + in + R"(}}},
        "outputs": {"material": {"from": "m.material"}}})"));
}

bool ExportTest::says(const std::string& words) const {
    return to_text(diagnostics).find(words) != std::string::npos;
}

json::Value GlbFile::at(std::string_view pointer) const {
    json::Value value = root;
    for (const std::string_view step : split(pointer, '/')) {
        const bool is_index = value.is(json::Kind::array);
        value = is_index ? value.at(static_cast<size_t>(std::stoi(std::string(step))))
                         : value.find(step);
    }
    return value;
}

std::string GlbFile::image(size_t texture) const {
    const auto number = [&](const std::string& pointer) {
        return static_cast<size_t>(at(pointer).as_number());
    };
    const size_t source = number("textures/" + std::to_string(texture) + "/source");
    const std::string view =
        "bufferViews/" + std::to_string(number("images/" + std::to_string(source) + "/bufferView"));
    return binary.substr(number(view + "/byteOffset"), number(view + "/byteLength"));
}

GlbFile read_glb(const fs::path& path) {
    const std::string bytes = bytes_of(path);
    const auto word = [&](size_t at) {
        uint32_t number = 0;
        std::memcpy(&number, bytes.data() + at, sizeof number);
        return number;
    };
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(4), 2U);
    EXPECT_EQ(word(8), bytes.size());
    const uint32_t length = word(12);
    Diagnostics diagnostics;
    GlbFile file{json::parse(bytes.substr(20, length), "glb", diagnostics).root, {}};
    EXPECT_FALSE(diagnostics.has_errors()) << to_text(diagnostics);
    EXPECT_EQ(bytes.substr(20 + length + 4, 4), std::string("BIN\0", 4));
    file.binary = bytes.substr(20 + length + 8);
    EXPECT_EQ(word(20 + length), file.binary.size());
    return file;
}

}  // namespace wrinkle::test
