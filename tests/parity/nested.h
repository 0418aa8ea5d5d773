// Projects of several files for tests of functions, compiled with every use inlined and with
// functions.
#pragma once

#include <map>
#include <string>

#include "graph/subgraph.h"
#include "lower/material.h"
#include "support/files.h"

namespace wrinkle::test {

// Texts by file name; "main" is the top. IMAGE_A and IMAGE_B are replaced by image files.
using Texts = std::map<std::string, std::string>;

// {"wrinkle": 1, "inputs": {INPUTS}, "nodes": {NODES}, "outputs": {OUTPUTS}}, with ' instead of "
// and a word a.b after '<' for a wire: 'x': <a.b.
std::string graph_text(const std::string& inputs, const std::string& nodes,
                       const std::string& outputs);

class Nested {
public:
    explicit Nested(const Texts& texts);

    struct Options {
        bool functions = true;
        bool uniform = true;
        bool given = true;
        bool vertex_tangents = true;
    };
    // Reports a test failure and returns an empty module if it does not compile.
    Compiled compile(const Options& options) const;
    const Project& project() const { return project_; }

private:
    TemporaryFolder folder_;
    Project project_;
};

// This many files below the top, each of which uses the next one twice, with different heights.
Texts tower_texts(int levels);

uint32_t function_count(const Module& module);

// The number of projects; a project of five files with random nodes and wires between them.
Texts random_texts(unsigned seed);

}  // namespace wrinkle::test
