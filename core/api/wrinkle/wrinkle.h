// Wrinkle in a program of one's own: graphs are loaded, checked, compiled to shaders and evaluated
// in numbers, as the program `wrinkle` does it, byte for byte and word for word.
//
//     using namespace wrinkle::api;
//     const Library library;
//     const Graph graph = library.load("strap.json");
//     const Shader shader = graph.compile({});
//     if (!shader.ok) std::cerr << to_text(shader.problems);
//
// Handles   Library and Graph are cheap to copy: copies share what they stand for, which never
//           changes. A graph keeps its library alive. One that was moved from may be assigned,
//           destroyed and called: it says that it holds nothing.
// Errors    No exception crosses this border. What goes wrong is a Problem, said at the user's
//           file, line and node; a problem with an empty file is the caller's or the machine's.
//           Where memory is so short that not even that can be said, `ok` is false and `problems`
//           is empty.
// Threads   Every const member may be called from any number of threads at once, of one object and
//           of copies. Results do not depend on it. A graph's files are read when it is loaded, its
//           images by the first evaluate() and kept until the last copy is gone; who wants them
//           anew loads the graph anew.
// Plugins   Their code runs in processes of its own, which this one starts and waits for, when they
//           are found and when a graph with their nodes is compiled. A program that takes the ends
//           of all its children (waitpid(-1)) leaves these to the library.
// Versions  The soname changes with every version that is not 0.1.x: structs grow. Sources go on
//           compiling. This header wants C++17.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#define WRINKLE_API __attribute__((visibility("default")))

namespace wrinkle::api {

// "0.1.0", of the library that runs.
WRINKLE_API const char* version() noexcept;

struct Problem {
    bool is_error = true;                // else a warning
    std::string file;                    // as it was named; "" for a problem that has none
    std::uint32_t line = 0, column = 0;  // from 1; 0: the file as a whole
    std::string pointer;                 // JSON pointer of the token
    std::string node;                    // its id, in a sub-graph "outer/inner"; may be ""
    std::string message;                 // what is wrong, a sentence
    std::string expected;                // what would be right; may be ""
};
// The first 1,000; beyond them one more says how many are left out.
using Problems = std::vector<Problem>;

WRINKLE_API bool has_errors(const Problems& problems) noexcept;
// A line each: "strap.json:12:7: error: node 'weave': ..."; the words of `wrinkle check`.
WRINKLE_API std::string to_text(const Problem& problem) noexcept;
WRINKLE_API std::string to_text(const Problems& problems) noexcept;

// The names that CompileOptions::target takes: "glsl330", "glsl450", "essl300", "spirv", ...
WRINKLE_API std::vector<std::string> targets() noexcept;

struct CompileOptions {
    enum class Form { of_target, function, shader };  // of_target: functions of GLSL, else a pair
    enum class Parameters { baked, uniform };         // numbers as literals, or as uniforms
    enum class Differentials { screen, given };       // from the screen, or passed by the caller

    std::string target = "glsl330";
    Form form = Form::of_target;
    Parameters parameters = Parameters::baked;
    Differentials differentials = Differentials::screen;
    std::string name;             // NAME in the text; "": the stem of the graph's file
    bool vertex_tangents = true;  // false: frames of uv0 are derived
    bool strict = false;          // what not every machine has room for is an error
    int descriptor_set = 0;       // 0 to 31
    int first_binding = 0;        // 0 to 4095
};

// What stands in the texts, and what a caller must set, is said in docs/targets.md.
struct Shader {
    bool ok = false;               // there are texts; warnings are among the problems all the same
    std::string source;            // of the form function
    std::string vertex, fragment;  // of the form shader; of SPIR-V the bytes of its file
    std::string reflection;        // JSON: uniforms, images, attributes, which line is whose
    Problems problems;
};

// Surface points as arrays of numbers: for every point as many as the value has components, one
// point after the other.
//
//   position normal tangent(4) uv0 ... uv3 (2) color0 (4) view, facing (1, +1 if nobody says)
//   dx.NAME, dy.NAME    the change of one of them to the next pixel (or texel)
//
// Units and spaces are those of docs/graph-format.md. What a graph needs and nobody gives is a
// problem that names it; what it does not need may be given.
struct Points {
    std::size_t count = 0;
    std::map<std::string, std::vector<double>> values;
};

struct EvaluateOptions {
    bool double_precision = false;  // false: as shaders compute
    bool vertex_tangents = true;
};

struct Column {
    std::string name;            // of the graph's output: "normal"
    std::size_t components = 1;  // numbers a point
    std::vector<double> values;
};

struct Evaluated {
    bool ok = false;
    std::vector<Column> outputs;  // in the graph's order
    Problems problems;
};

struct InputFile {
    enum class Kind { graph, image, plugin };
    Kind kind = Kind::graph;
    std::string path;  // relative where the graph's own is
};

class WRINKLE_API Graph {
public:
    Graph() noexcept;  // holds nothing
    Graph(const Graph&) noexcept;
    Graph(Graph&&) noexcept;
    Graph& operator=(const Graph&) noexcept;
    Graph& operator=(Graph&&) noexcept;
    ~Graph();

    // Every problem at once, as `wrinkle check` finds them; those of reading among them.
    Problems check(bool vertex_tangents = true) const noexcept;

    // Every file that the graph reads, each once, graphs first; for build systems and for programs
    // that watch files. Files that are missing are listed too.
    std::vector<InputFile> inputs() const noexcept;

    // The same graph with other values: each "NODE.PORT=VALUE" or "input.NAME=VALUE", as --set has
    // them. A value that does not fit is a problem of the graph that comes back.
    Graph with(const std::vector<std::string>& values) const noexcept;

    Shader compile(const CompileOptions& options) const noexcept;
    Evaluated evaluate(const Points& points, const EvaluateOptions& options = {}) const noexcept;

    struct Parts;

private:
    friend class Library;
    explicit Graph(std::shared_ptr<const Parts> parts) noexcept;
    std::shared_ptr<const Parts> parts_;
};

struct LibraryOptions {
    std::vector<std::string> plugin_paths;  // plugins, or folders of them
    // Also those of WRINKLE_PLUGIN_PATH and of the user's and the installation's folder, as the
    // program takes them (docs/plugins.md).
    bool default_plugins = true;
};

// The node types: the built-in ones and those of plugins.
class WRINKLE_API Library {
public:
    explicit Library(const LibraryOptions& options = {}) noexcept;
    Library(const Library&) noexcept;
    Library(Library&&) noexcept;
    Library& operator=(const Library&) noexcept;
    Library& operator=(Library&&) noexcept;
    ~Library();

    // Of plugins: a refused one takes nothing from the others.
    Problems problems() const noexcept;

    // A graph's file. What it names must lie below `root`, "" being the folder of the file. There
    // is always a graph; its check() says what is wrong with it.
    Graph load(const std::string& file, const std::string& root = {}) const noexcept;

    // A graph's text; the files that it names are relative to `folder`, and problems call it
    // FOLDER/NAME.
    Graph load_text(const std::string& text, const std::string& folder = ".",
                    const std::string& name = "text", const std::string& root = {}) const noexcept;

    struct Parts;

private:
    std::shared_ptr<const Parts> parts_;
};

}  // namespace wrinkle::api
