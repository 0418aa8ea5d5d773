// A node at work: a graph around it, compiled, and what it needs to run.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "certify/graph_around.h"
#include "glsl/emit.h"
#include "image/mips.h"
#include "lower/material.h"

namespace wrinkle::certify {

// A folder with files of the names that graphs use; their contents are never read. It is gone when
// this is.
class PictureFolder {
public:
    // Nothing, with the reason, when there can be no temporary folder.
    static std::optional<PictureFolder> make(std::string& why);
    PictureFolder(PictureFolder&& other) noexcept;
    PictureFolder& operator=(PictureFolder&&) = delete;
    ~PictureFolder();
    const std::filesystem::path& path() const { return path_; }

private:
    PictureFolder() = default;
    std::filesystem::path path_;
};

// What stands in for the pictures, on both back ends: floats, odd sizes, mips.
const MipChain& test_image(const std::string& file);

// What the checks of all nodes share.
struct Bench {
    const Registry& registry;        // the nodes under test and the built-in ones
    std::filesystem::path pictures;  // of a PictureFolder
    bool gpu = false;                // a context is current
    // "" when the text compiles, else why not; may be empty. Besides the driver of a GPU.
    std::function<std::string(const Shader&)> text_errors = {};
};

struct Subject {
    std::string text;
    Project project;
    Compiled compiled;    // parameters uniform, differentials given
    std::string problem;  // why there is none; "" when compiled.ok
};

// Draws graphs until one is legal (a frame must fit its scale).
Subject compile_around(const NodeType& type, Inputs inputs, unsigned seed, const Bench& bench);

// The text as a document and compiled anew. `uniform`: parameters are not written into the text.
struct Options {
    bool uniform = true;
    bool given = true;
};
Compiled compile(const Project& project, const Bench& bench, Options options,
                 Diagnostics& diagnostics);
Project project_of(const std::string& text, const Bench& bench, Diagnostics& diagnostics);

// The node's port of a graph output: "height" of "out_height".
std::string port_of(const std::string& output);

}  // namespace wrinkle::certify
