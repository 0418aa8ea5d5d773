// Compiles generated graphs around a node under test, in a fixed test environment.
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>

#include "certify/harness_graph.h"
#include "certify/report.h"
#include "emit/emit.h"
#include "graph/subgraph.h"
#include "image/mips.h"
#include "lower/material.h"

namespace wrinkle::certify {

// Creates a temporary folder with files of the names that graphs use; their contents are never
// read. It is removed with the last pointer to its path. Returns null and sets `why` on failure.
std::shared_ptr<const std::filesystem::path> make_image_folder(std::string& why);

// Returns the random image that both back ends use for a file name, with mips: 16 x 8 texels for
// a.exr, 7 x 5 for any other.
const MipChain& test_image(const std::string& file);

// Environment shared by the checks of all nodes.
struct CertifyContext {
    const Registry& registry;            // the nodes under test and the built-in ones
    std::filesystem::path image_folder;  // from make_image_folder()
    bool gpu = false;                    // a context is current
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

// One compiled graph of a check.
struct Trial {
    Subject subject;
    Inputs inputs;
    const CertifyContext& context;
    Report& report;

    // Adds a finding that depends on the inputs; the message follows words(inputs).
    void add(const char* check, const std::string& port, const std::string& message,
             std::string remedy) const;
};
// Calls `check` for each kind of inputs, unless its graph does not compile.
void each_trial(const NodeType& type, std::initializer_list<Inputs> inputs, unsigned seed,
                const CertifyContext& context, Report& report, void (*check)(const Trial&));

struct Options {
    bool uniform = true;  // parameters are uniforms, else literals
    bool given = true;    // differentials are given, else from the screen
};
Compiled compile(const Project& project, const CertifyContext& context, Options options,
                 Diagnostics& diagnostics);
// Reads the JSON of a graph; the images that it names are those of the context.
Project project_of(const std::string& text, const CertifyContext& context,
                   Diagnostics& diagnostics);

// Returns the node's port of a graph output: "height" for "out_height".
std::string port_of(const std::string& output);

}  // namespace wrinkle::certify
