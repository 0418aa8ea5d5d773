// A material and a mesh to export.
#pragma once

#include <optional>
#include <string>

#include "export/export.h"
#include "json/value.h"
#include "support/files.h"

namespace wrinkle::test {

class ExportTest : public testing::Test {
protected:
    // Exports the graph to "out" in the folder of the test, on `mesh`; size 16.
    std::vector<std::string> export_graph(const std::string& host,
                                          const std::filesystem::path& graph);
    // Exports a material of the channels `in`, members of a JSON object; further nodes in `nodes`.
    std::vector<std::string> export_channels(const std::string& host, const std::string& in,
                                             const std::string& nodes = "");
    bool says(const std::string& words) const;  // in a diagnostic
    std::filesystem::path out() const { return folder.path() / "out"; }

    TemporaryFolder folder;
    Mesh mesh = plane();
    bool double_sided = false;
    std::string name;  // the material; "": from the name of the graph's file
    std::vector<std::string> inputs;
    Diagnostics diagnostics;

private:
    static Mesh plane();
};

// The JSON chunk and the binary chunk of a GLB.
struct GlbFile {
    json::Value root;
    std::string binary;

    json::Value at(std::string_view pointer) const;  // "materials/0/name"; null if absent
    std::string image(size_t texture) const;         // bytes of its PNG
};
GlbFile read_glb(const std::filesystem::path& path);

}  // namespace wrinkle::test
