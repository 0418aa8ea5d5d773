#include "cli/scaffold.h"

#include <algorithm>
#include <utility>

namespace wrinkle::cli {
namespace {

constexpr const char* source =
    R"(// @TITLE@: a node for Wrinkle. It describes its ports and its formula; the editor's card, the JSON
// schema, the GLSL, the evaluation, the bump (the exact derivative of the height) and the reference
// page (`wrinkle nodes @NAME@`) follow from that.
#include <wrinkle/node.h>

using namespace wrinkle::sdk;

namespace {

enum class Profile { dome, cone };  // in the order of the choice's names

// What the body receives: the ports but the outputs, in their order.
struct Studs {
    vec2 uv;
    Float count, radius, height;
    Profile profile;
};

Float studs(Studs in) {
    const vec2 cell = fract(in.uv * in.count) - 0.5;
    const Float r = min(length(cell) / in.radius, 1);  // 0 in the middle of a stud, 1 outside
    const Float dome = 1 - r * r;
    return in.height * (in.profile == Profile::dome ? dome * dome : 1 - r);
}

Node @NAME@_node =
    node("@NAME@", "@TITLE@", "Round studs on a square grid.")
        .family("pattern")
        .in<vec2>("uv", surface::uv0, "Where to read it")
        .in<Float>("count", 8, "Studs per unit of uv", slider(1, 64))
        .in<Float>("radius", 0.4, "Of a stud, in parts of its cell", limits(0.01, 0.5))
        .in<Float>("height", 0.01, "Of a stud, in length units of object space", slider(0, 0.1),
                   unit("m"))
        .choice("profile", {"dome", "cone"}, "How a stud rises to its top")
        .out<Height>("height", "In length units of object space, positive outward", unit("m"))
        .body([](Studs in) { return studs(in); });

}  // namespace

WRINKLE_PLUGIN("@NAME@", "1.0", @NAME@_node)
)";

constexpr const char* build = R"(cmake_minimum_required(VERSION 3.20)
project(@NAME@ LANGUAGES CXX)

# Where Wrinkle was when this file was written; -DCMAKE_PREFIX_PATH=FOLDER names another place.
set(wrinkle [==[@PREFIX@]==])
find_package(WrinkleSDK 1 REQUIRED HINTS "${wrinkle}")
wrinkle_plugin(@NAME@ SOURCES @NAME@.cpp)

enable_testing()
find_program(WRINKLE wrinkle REQUIRED HINTS "${wrinkle}/bin")
add_test(NAME @NAME@ COMMAND ${WRINKLE} test ${CMAKE_CURRENT_SOURCE_DIR}
    --plugin-path $<TARGET_FILE:@NAME@>)
)";

constexpr const char* graph = R"({
  "wrinkle": 1,
  "name": "@TITLE@",
  "nodes": {
    "studs": {
      "type": "@NAME@",
      "in": {
        "count": 8,
        "radius": 0.4,
        "height": 0.01
      }
    },
    "normal": { "type": "resolve", "in": { "gradient": { "from": "studs.height" } } }
  },
  "outputs": {
    "normal": { "from": "normal.normal" },
    "height": { "from": "studs.height" }
  },
  "layout": {
    "studs": [0, 0],
    "normal": [260, 0]
  }
}
)";

// A flat square with position = uv: the slope there is the height's derivative by uv. In the middle
// of a stud, half way down its side (r = 1/2: (1 - 1/4)^2 of the height), and between studs.
constexpr const char* test = R"({
  "points": [
    {"position": [0.0625, 0.0625, 0], "normal": [0, 0, 1], "tangent": [1, 0, 0, 1], "uv0": [0.0625, 0.0625], "dx": {"position": [0.001, 0, 0], "uv0": [0.001, 0]}, "dy": {"position": [0, 0.001, 0], "uv0": [0, 0.001]}},
    {"position": [0.0875, 0.0625, 0], "normal": [0, 0, 1], "tangent": [1, 0, 0, 1], "uv0": [0.0875, 0.0625], "dx": {"position": [0.001, 0, 0], "uv0": [0.001, 0]}, "dy": {"position": [0, 0.001, 0], "uv0": [0, 0.001]}},
    {"position": [0.125, 0.125, 0], "normal": [0, 0, 1], "tangent": [1, 0, 0, 1], "uv0": [0.125, 0.125], "dx": {"position": [0.001, 0, 0], "uv0": [0.001, 0]}, "dy": {"position": [0, 0.001, 0], "uv0": [0, 0.001]}}
  ],
  "expect": [
    {"normal": [0, 0, 1], "height": 0.01},
    {"normal": [0.2873479, 0, 0.9578263], "height": 0.005625},
    {"normal": [0, 0, 1], "height": 0}
  ]
}
)";

constexpr const char* readme = R"(# @TITLE@

A node for Wrinkle, `@NAME@`. Its ports and its formula are in `@NAME@.cpp`.

    cmake -B build . && cmake --build build                              # makes build/@NAME@.so
    ctest --test-dir build                                               # runs @NAME@.test.json
    wrinkle nodes @NAME@ --plugin-path build/@NAME@.so                   # its reference page
    wrinkle compile @NAME@.json --plugin-path build/@NAME@.so
    wrinkle render @NAME@.json -o @NAME@.png --plugin-path build/@NAME@.so
    wrinkle-editor @NAME@.json --plugin-path build/@NAME@.so             # rebuild while it runs

Without CMake: `g++ -std=c++20 -shared -fPIC @NAME@.cpp -o @NAME@.so`, with `-I PREFIX/include` where
the headers are elsewhere than in the compiler's own folders.

`@NAME@.test.json` says what the graph `@NAME@.json` gives at three points; `wrinkle test . --update
--plugin-path build/@NAME@.so` writes new numbers after a change that you have looked at. `"glsl": true`
in it keeps the generated text in `golden/` as well.
)";

std::string filled(std::string_view form, std::string_view name, std::string_view prefix) {
    std::string title(name);
    title[0] = static_cast<char>(title[0] - 'a' + 'A');
    for (char& c : title)
        if (c == '_') c = ' ';
    const std::pair<std::string_view, std::string_view> blanks[] = {
        {"NAME", name}, {"TITLE", title}, {"PREFIX", prefix}};
    std::string text;
    for (size_t at = 0; at < form.size();) {
        const size_t open = std::min(form.find('@', at), form.size());
        text += form.substr(at, open - at);
        if (open == form.size()) break;
        const size_t close = form.find('@', open + 1);
        for (const auto& [blank, value] : blanks)
            if (form.substr(open + 1, close - open - 1) == blank) text += value;
        at = close + 1;
    }
    return text;
}

}  // namespace

std::vector<ScaffoldFile> scaffold(std::string_view name, std::string_view prefix) {
    const std::string stem(name);
    const std::pair<std::string, const char*> forms[] = {{stem + ".cpp", source},
                                                         {"CMakeLists.txt", build},
                                                         {stem + ".json", graph},
                                                         {stem + ".test.json", test},
                                                         {"README.md", readme}};
    std::vector<ScaffoldFile> files;
    for (const auto& [file, form] : forms)
        files.push_back({file, filled(form, name, prefix)});
    return files;
}

}  // namespace wrinkle::cli
