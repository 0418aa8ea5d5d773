// A compiled graph around the node under test, and its test environment.
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

// Returns the test image for a file, used on both back ends: floats, 16 x 8 or 7 x 5, with mips.
const MipChain& test_image(const std::string& file);

// Environment shared by the checks of all nodes.
struct CertifyContext {
    const Registry& registry;        // the nodes under test and the built-in ones
    std::filesystem::path pictures;  // path of a PictureFolder
    bool gpu = false;                // a context is current
    // Returns "" if the source compiles, else the error; may be empty. If it reports no error and a
    // GPU is available, the driver checks the source too.
    std::function<std::string(const Shader&)> text_errors = {};
};

struct Subject {
    std::string text;
    Project project;
    Compiled compiled;    // parameters uniform, differentials given
    std::string problem;  // why it did not compile; "" if compiled.ok
};

// Generates up to 50 random graphs until one compiles (a frame must match its scale).
Subject compile_harness(const NodeType& type, Inputs inputs, unsigned seed,
                        const CertifyContext& context);

// project_of() reads the text as a document; compile() compiles it. `uniform`: parameters are
// uniforms instead of literals. `given`: differentials are given.
struct Options {
    bool uniform = true;
    bool given = true;
};
Compiled compile(const Project& project, const CertifyContext& context, Options options,
                 Diagnostics& diagnostics);
Project project_of(const std::string& text, const CertifyContext& context,
                   Diagnostics& diagnostics);

// Returns the node's port of a graph output: "height" for "out_height".
std::string port_of(const std::string& output);

}  // namespace wrinkle::certify
