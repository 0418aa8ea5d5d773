// Wrinkle as a library for C++: loads, checks, compiles, exports and evaluates graphs. Results and
// messages are identical to those of the program `wrinkle`. wrinkle.h is the same library for C.
//
//     using namespace wrinkle::api;
//     const Library library;
//     const Graph graph = library.load("strap.json");
//     const Shader shader = graph.compile({});
//     if (!shader.ok) std::cerr << to_text(shader.problems);
//
// Handles   Library and Graph are cheap to copy; copies share their immutable data. A graph keeps
//           its library alive. A moved-from handle may be assigned, destroyed and called: its
//           functions return a problem.
// Errors    No function throws. Each failure is a Problem with the user's file, line and node; an
//           empty file means that the caller or the environment is at fault. If there is no memory
//           for a problem, `ok` is false and `problems` is empty.
// Threads   Const members are thread-safe, on one object and on copies. The files of a graph are
//           read when it is loaded, its images by the first evaluate(); images stay in memory until
//           the last copy is destroyed. Load the graph again to read changed files.
// Plugins   Their code runs in child processes, which the library starts and waits for, when
//           plugins are found and when a graph with their nodes is compiled. A program must not
//           reap these processes with waitpid(-1).
// Versions  The soname changes with every version outside 0.2.x, because structs grow. Source
//           compatibility is kept. Requires C++17.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#define WRINKLE_API __attribute__((visibility("default")))

namespace wrinkle::api {

// Version of the loaded library: "0.2.0".
WRINKLE_API const char* version() noexcept;

struct Problem {
    bool is_error = true;                // else a warning
    std::string file;                    // as named by the caller; "": no file
    std::uint32_t line = 0, column = 0;  // from 1; 0: the file in general
    std::string pointer;                 // JSON pointer of the token
    std::string node;                    // node id, in a sub-graph "outer/inner"; may be ""
    std::string message;                 // one sentence
    std::string expected;                // hint: the valid form; may be ""
};
// At most 1,000 problems, and one more with the number of those omitted.
using Problems = std::vector<Problem>;

WRINKLE_API bool has_errors(const Problems& problems) noexcept;
// Returns one line per problem, as `wrinkle check` prints it: "strap.json:12:7: error: node ..."
WRINKLE_API std::string to_text(const Problem& problem) noexcept;
WRINKLE_API std::string to_text(const Problems& problems) noexcept;

// Valid values of CompileOptions::target: "glsl330", "glsl450", "essl300", "spirv", ...
WRINKLE_API std::vector<std::string> targets() noexcept;

struct CompileOptions {
    enum class Form { of_target, function, shader };  // of_target: functions of GLSL, else a pair
    enum class Parameters { baked, uniform };         // numbers as literals, or as uniforms
    enum class Differentials { screen, given };       // from the screen, or passed by the caller
    enum class Srgb { sampler, shader };              // decoder of images of encoding srgb
    enum class NormalSpace { of_form, object, world, view, tangent };  // of_form: object, world
    enum class UvOrigin { bottom, top };  // v = 0, and an image's first row

    std::string target = "glsl330";
    Form form = Form::of_target;
    Parameters parameters = Parameters::baked;
    Differentials differentials = Differentials::screen;
    Srgb srgb = Srgb::sampler;
    UvOrigin uv_origin = UvOrigin::bottom;
    NormalSpace normal_space = NormalSpace::of_form;
    std::string name;             // NAME in the text; "": the stem of the graph's file
    bool vertex_tangents = true;  // false: frames of uv0 are derived
    bool strict = false;          // exceeding a guaranteed limit is an error
    int descriptor_set = 0;       // 0 to 31
    int first_binding = 0;        // 0 to 4095
};

// Generated source, as documented in docs/targets.md.
struct Shader {
    bool ok = false;               // if true, `problems` may hold warnings
    std::string source;            // function form
    std::string vertex, fragment;  // shader form; for SPIR-V the bytes of the file
    std::string reflection;        // JSON: uniforms, images, attributes, node of each line
    Problems problems;
};

// Surface points as arrays of numbers: the components of the first point, of the second, ...
//
//   position normal tangent(4) uv0 ... uv3 (2) color0 (4) view, facing (1; default +1)
//   dx.NAME, dy.NAME    its differential to the next pixel (or texel)
//
// Units and spaces are those of docs/graph-format.md. A missing value that the graph needs is a
// problem that names it; unneeded values are ignored.
struct Points {
    std::size_t count = 0;
    std::map<std::string, std::vector<double>> values;
};

struct EvaluateOptions {
    bool double_precision = false;  // false: single precision, as in shaders
    bool vertex_tangents = true;
};

struct Column {
    std::string name;            // output name: "normal"
    std::size_t components = 1;  // numbers per point
    std::vector<double> values;
};

struct Evaluated {
    bool ok = false;
    std::vector<Column> outputs;  // in the graph's order
    Problems problems;
};

// A graph compiled for evaluation. Numeric inputs of the graph change without another compilation;
// other values need Graph::with(). Results are identical to those of with() and evaluate().
//
// Not thread-safe: each thread takes a copy. Copies share images, and copy the compiled program.
class WRINKLE_API Evaluator {
public:
    struct Input {
        std::string name;
        std::vector<double> value;  // one number per component
    };

    Evaluator() noexcept;  // empty handle
    Evaluator(const Evaluator&) noexcept;
    Evaluator(Evaluator&&) noexcept;
    Evaluator& operator=(const Evaluator&) noexcept;
    Evaluator& operator=(Evaluator&&) noexcept;
    ~Evaluator();

    // Problems of the graph; after an error, evaluate() returns the same ones.
    Problems problems() const noexcept;

    // Returns the numeric inputs with their current values. The index of an input does not change.
    std::vector<Input> inputs() const noexcept;

    // Returns the index of an input, which may be called by a former name; -1 if there is none.
    int find(const std::string& input) const noexcept;

    // Replaces the value of an input, clamped to its limits. On failure the value is kept.
    Problems set(int input, const std::vector<double>& value) noexcept;

    Evaluated evaluate(const Points& points, bool double_precision = false) const noexcept;

    struct Parts;

private:
    friend class Graph;
    explicit Evaluator(std::unique_ptr<Parts> parts) noexcept;
    std::unique_ptr<Parts> parts_;
};

// Hosts that a material is exported to: "three", "gltf", ... (docs/hosts.md).
WRINKLE_API std::vector<std::string> hosts() noexcept;

struct ExportOptions {
    std::string mesh = "sphere";  // a shape, or a file
    std::string name;             // an identifier; "": the stem of the graph's file
    std::uint32_t size = 1024;    // side of baked maps in texels, 1 to 8192
};

struct Exported {
    bool ok = false;
    std::vector<std::string> files;  // relative to the folder, sorted
    Problems problems;
};

struct InputFile {
    enum class Kind { graph, image, plugin, preset };
    Kind kind = Kind::graph;
    std::string path;  // relative if the path of the graph is
};

// Values of inputs of a graph under one name.
struct Preset {
    struct Value {
        std::string input;
        std::string json;  // "0.8", "[1, 0, 0]", "\"#a01818\""
    };
    std::string name;
    std::vector<Value> values;  // inputs that differ from their defaults
};

class WRINKLE_API Graph {
public:
    Graph() noexcept;  // empty handle
    Graph(const Graph&) noexcept;
    Graph(Graph&&) noexcept;
    Graph& operator=(const Graph&) noexcept;
    Graph& operator=(Graph&&) noexcept;
    ~Graph();

    // Returns all problems, including those of reading, as `wrinkle check`.
    Problems check(bool vertex_tangents = true) const noexcept;

    // Returns each file that the graph reads once, graphs first, including missing files; for build
    // systems and file watchers.
    std::vector<InputFile> inputs() const noexcept;

    // Returns the graph with other values: each "NODE.PORT=VALUE" or "input.NAME=VALUE", as for
    // --set; NAME may be a former name. An invalid value is a problem of the returned graph.
    Graph with(const std::vector<std::string>& values) const noexcept;

    // Returns the presets of the graph, in its order.
    std::vector<Preset> presets() const noexcept;

    // Returns the graph with the values of a preset as defaults of its inputs, as for --preset:
    // `name` is a preset of the graph, or a file that ends in ".json". A missing preset, another
    // graph's and a value that does not fit are problems of the returned graph.
    Graph with_preset(const std::string& name) const noexcept;

    Shader compile(const CompileOptions& options) const noexcept;
    Evaluated evaluate(const Points& points, const EvaluateOptions& options = {}) const noexcept;

    // Writes the files of a host to a folder, which is created; on failure it is as before.
    Exported export_to(const std::string& host, const std::string& folder,
                       const ExportOptions& options = {}) const noexcept;

    // Compiles for many evaluations with changing inputs.
    Evaluator evaluator(bool vertex_tangents = true) const noexcept;

    struct Parts;

private:
    friend class Library;
    explicit Graph(std::shared_ptr<const Parts> parts) noexcept;
    std::shared_ptr<const Parts> parts_;
};

struct LibraryOptions {
    std::vector<std::string> plugin_paths;  // plugins, or folders of them
    // Also searches WRINKLE_PLUGIN_PATH and the folders of the user and the installation, as the
    // program does (docs/plugins.md).
    bool default_plugins = true;
};

// Node types: built-in nodes and those of plugins.
class WRINKLE_API Library {
public:
    explicit Library(const LibraryOptions& options = {}) noexcept;
    Library(const Library&) noexcept;
    Library(Library&&) noexcept;
    Library& operator=(const Library&) noexcept;
    Library& operator=(Library&&) noexcept;
    ~Library();

    // Problems of plugins; a refused plugin does not affect the others.
    Problems problems() const noexcept;

    // Loads a graph from a file. The files that it names must be below `root`; "" is the folder of
    // `file`. On failure, the problems are those of the returned graph.
    Graph load(const std::string& file, const std::string& root = {}) const noexcept;

    // Loads a graph from text; the files that it names are relative to `folder`. Problems name it
    // FOLDER/NAME.
    Graph load_text(const std::string& text, const std::string& folder = ".",
                    const std::string& name = "text", const std::string& root = {}) const noexcept;

    struct Parts;

private:
    std::shared_ptr<const Parts> parts_;
};

}  // namespace wrinkle::api
