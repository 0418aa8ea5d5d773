// Compiles one graph to the outputs of `wrinkle compile`, or loads them from the cache. Both give
// the same result, including the warnings.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/cache.h"
#include "cli/session.h"
#include "compile/inputs.h"
#include "compile/shader.h"
#include "emit/emit.h"
#include "emit/target.h"

namespace wrinkle::cli {

// Options that affect the generated source, as given on the command line.
struct TextOptions {
    std::string target = std::string(targets().front().name);
    std::string form;  // "": the target's default
    std::string params = "baked";
    std::string srgb = "sampler";
    std::string uv_origin = "bottom";
    std::string normal_space;          // "": object, or world in the shader form
    std::string differentials;         // "": screen, or none if `outputs` is the displacement
    std::vector<std::string> outputs;  // empty: all
    std::string name;                  // "": from the file name
    int set = 0, first_binding = 0;
    bool strict = false;              // exceeding limits guaranteed by the target is an error
    bool cost = false, json = false;  // report the cost, as JSON
    bool reflects = false;            // describe the interface
};

void declare_text(CLI::App& command, TextOptions& text);
// Returns the reason if the options conflict or the target does not exist; otherwise "".
std::string wrong_text(const TextOptions& text);
Form form_of(const TextOptions& options);  // precondition: the target exists

// Returns true if the output depends on the compilers of core/spirv.
bool needs_compilers(const TextOptions& options);
// Returns false and the reason in `why` if they are needed and cannot be loaded.
bool have_compilers(const TextOptions& options, std::string& why);

struct Text {
    std::string stage;   // "vertex" or "fragment"; "" in function form
    std::string suffix;  // file suffix: ".vert", ".frag.spv"; "" in function form
    std::string bytes;
};

// One Text with empty `bytes` per output file. Precondition: the target and the form exist.
std::vector<Text> blank_texts(const TextOptions& options);

struct CompiledGraph {
    std::vector<Text> texts;  // empty on error
    std::string reflection;   // JSON; "" unless requested
    std::string cost;         // report of --cost
    std::vector<InputFile> inputs;
    Diagnostics diagnostics;
    bool over_limit = false;  // the graph exceeds its share of the limits
};

struct Compilation {
    const CommonOptions& common;
    const TextOptions& options;
    const Registry& registry;
    const Overrides& overrides;  // not a sweep
    Cache* cache = nullptr;      // nullptr: no cache
    uint64_t sharing = 1;        // number of concurrent graphs that share the limits
};

ShaderOptions shader_options(const std::string& file, const Compilation& with);

// Thread-safe; several threads may share one Compilation.
CompiledGraph compile_graph(const std::string& file, const Compilation& with);

// Output of --cost: the table of one graph; for several, each table below its file name. With
// `json`: {"version": 1, "graphs": [{"file", "cost": to_json(CostReport)}]}.
struct GraphCost {
    std::string file, report;
};
std::string printed_costs(std::span<const GraphCost> costs, bool several, bool json);

}  // namespace wrinkle::cli
