// One graph to what `wrinkle compile` writes and prints, made or taken from the cache: what comes
// out is the same, down to the warnings.
#pragma once

#include <string>
#include <vector>

#include "cli/cache.h"
#include "cli/session.h"
#include "compile/inputs.h"
#include "compile/shader.h"
#include "glsl/emit.h"
#include "glsl/target.h"

namespace wrinkle::cli {

// What decides the texts besides the graph, as the command line spells it.
struct TextOptions {
    std::string target = std::string(targets().front().name);
    std::string form, params = "baked", differentials = "screen";  // form "": the target's own
    std::string name;                                              // "": from the file's
    int set = 0, first_binding = 0;
    bool strict = false;              // what not every machine has is an error
    bool cost = false, json = false;  // what it costs is counted, as JSON
};

void declare_text(CLI::App& command, TextOptions& text);
// Why these cannot go together, or what does not exist; "" when all is well.
std::string wrong_text(const TextOptions& text);
Form form_of(const TextOptions& options);  // of a target that exists

struct Text {
    std::string stage;   // "vertex" or "fragment"; "" of the function form
    std::string suffix;  // of its file: ".vert", ".frag.spv"; of the function form ""
    std::string bytes;
};

// One text for each file that a target and form that exist have, `bytes` still empty.
std::vector<Text> blank_texts(const TextOptions& options);

struct CompiledGraph {
    std::vector<Text> texts;  // none with an error
    std::string reflection;   // JSON
    std::string cost;         // as --cost prints it
    std::vector<InputFile> inputs;
    Diagnostics diagnostics;
    bool over_limit = false;  // it is too large for its share of the limits
};

struct Compilation {
    const CommonOptions& common;
    const TextOptions& options;
    const Registry& registry;
    const Overrides& overrides;  // no sweep
    Cache* cache = nullptr;      // none: everything is made
    uint64_t sharing = 1;        // so many graphs at a time share the limits of one
};

ShaderOptions shader_options(const std::string& file, const Compilation& with);

// Safe to be called from several threads with one Compilation.
CompiledGraph compile_graph(const std::string& file, const Compilation& with);

}  // namespace wrinkle::cli
