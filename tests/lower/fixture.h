// Nodes for tests of lowering, and graphs as JSON text instead of files.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "graph/subgraph.h"
#include "lower/material.h"
#include "registry/registry.h"
#include "support/files.h"

namespace wrinkle::test {

// number(value 0.5 in [0, 1]) -> value        pass_height(height) -> height
// bump(height) -> gradient                     scale(gradient, amount 1) -> gradient
// sum(a, b) -> gradient                        resolve(gradient) -> normal
// layer(gradient, base normal) -> gradient     texture(image srgb, uv uv0) -> color, alpha
// normal_map(image normal_gl, uv) -> derivative    times(normal, amount 1..8) -> normal
// vector(scale vec2, offset vec3, tint color) -> scale, offset, tint
// options(mode a|b|c, count 1..8, flag) -> value
// field_at(shape field of float) -> value      march(shape field of float) -> value
// many(value, height, gradient) -> value, height, normal, gradient
// old_name(size, was length until version 2; version 2) -> value
// wrong_frame, forgets, twice, wrong_type, bad_operands, guess_nowhere, vertex_somewhere,
// complains, open_region, leaks_region, lies: bodies that err
const Registry& registry();

// Files by name ("main.json" is the top), written to a temporary folder.
struct Files {
    explicit Files(const std::map<std::string, std::string>& files);
    test::TemporaryFolder temporary;
    std::filesystem::path folder = temporary.path();
};

// {"wrinkle": 1, "nodes": {NODES}, "outputs": {OUTPUTS}}
std::string graph(const std::string& nodes, const std::string& outputs,
                  const std::string& more = "");
// A project of one text, in the source tree's folder of tests.
Project project(const std::string& text, Diagnostics& diagnostics);

// The project lowered; a diagnostic is a test failure.
Lowered lowered(const Project& project, const LowerOptions& options = {});
const Inst& value(const Module& module, size_t output = 0);

}  // namespace wrinkle::test
