#include "compile/textures.h"

#include "graph/document.h"

namespace wrinkle {
namespace {

// Returns the image's problem at the port that names the file.
Diagnostic at_reader(const Diagnostic& problem, const Resource& resource, const Compiled& compiled,
                     const Project& project) {
    if (resource.readers.empty()) return problem;
    const Resource::Reader& reader = resource.readers.front();
    const NodePlace place = compiled.places[reader.node];
    if (place.node == NodePlace::none) return problem;
    const Document& document = project.files[place.file].document;
    Diagnostic result = diagnose_port(document, *document.nodes[place.node], reader.port,
                                      problem.message, problem.expected);
    result.severity = problem.severity;
    result.node = compiled.module.nodes[reader.node].path;
    return result;
}

}  // namespace

void read_textures(TextureStore& textures, const Compiled& compiled, const Project& project,
                   Diagnostics& diagnostics) {
    for (const Resource& resource : compiled.module.resources) {
        Diagnostics own;
        textures.read(resource.file, own);
        for (const Diagnostic& problem : own.list())
            diagnostics.add(at_reader(problem, resource, compiled, project));
    }
}

}  // namespace wrinkle
