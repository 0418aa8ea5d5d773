// Compiles generated graphs around a node under test, in a fixed test environment.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "certify/harness_graph.h"
#include "glsl/emit.h"
#include "graph/subgraph.h"
#include "image/mips.h"
#include "lower/material.h"

namespace wrinkle::certify {

// Temporary folder with files of the names that graphs use; their contents are never read. Removed
// by the destructor.
class PictureFolder {
public:
    // Returns std::nullopt and sets `why` if the folder or its files cannot be created.
    static std::optional<PictureFolder> make(std::string& why);
    PictureFolder(PictureFolder&& other) noexcept;
    PictureFolder& operator=(PictureFolder&&) = delete;
    ~PictureFolder();
    const std::filesystem::path& path() const { return path_; }

private:
    PictureFolder() = default;
    std::filesystem::path path_;
};

// Returns the random image that both back ends use for a file name, with mips: 16 x 8 texels for
// a.exr, 7 x 5 for any other.
const MipChain& test_image(const std::string& file);

// Environment shared by the checks of all nodes.
struct CertifyContext {
    const Registry& registry;        // the nodes under test and the built-in ones
    std::filesystem::path pictures;  // path of a PictureFolder
    bool gpu = false;                // a context is current
    // Optional: compiles the source; returns "" or the error. Without an error, the driver checks
    // the source too if `gpu` is set.
    std::function<std::string(const Shader&)> text_errors = {};
};

struct Subject {
    std::string text;  // JSON of the graph
    Project project;
    Compiled compiled;    // parameters uniform, differentials given
    std::string problem;  // why it did not compile; "" if compiled.ok
};

// Returns the first of up to 50 random graphs that compiles, else the last with its `problem`: a
// random choice may be invalid, such as a method that does not match its scale.
Subject compile_harness(const NodeType& type, Inputs inputs, unsigned seed,
                        const CertifyContext& context);

struct Options {
    bool uniform = true;  // parameters are uniforms, else literals
    bool given = true;    // differentials are given, else from the screen
};
Compiled compile(const Project& project, const CertifyContext& context, Options options,
                 Diagnostics& diagnostics);
// Reads the JSON of a graph; the images that it names are in the context's PictureFolder.
Project project_of(const std::string& text, const CertifyContext& context,
                   Diagnostics& diagnostics);

// Returns the node's port of a graph output: "height" for "out_height".
std::string port_of(const std::string& output);

}  // namespace wrinkle::certify
