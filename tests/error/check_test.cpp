// Tests of the exact message of every report of check().
#include "lower/check.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "graph/edit.h"
#include "lower/fixture.h"

namespace wrinkle {
namespace {

std::string reports(const Project& project, const CheckOptions& options = {}) {
    Diagnostics diagnostics;
    check(project, test::registry(), Types(project, test::registry()), diagnostics, options);
    return to_text(diagnostics);
}

std::string reports(const std::string& text) {
    Diagnostics diagnostics;
    const Project project = test::project(text, diagnostics);
    EXPECT_EQ(to_text(diagnostics), "") << "reading finds nothing";
    return reports(project);
}

// Checks one node n of this type with these inputs; returns the first report without location.
std::string node_report(const std::string& type, const std::string& in,
                        const std::string& more = "") {
    const std::string text = reports("{\"wrinkle\": 1,\n \"nodes\": {\"n\": {\"type\": \"" + type +
                                     "\"" + more + ", \"in\": {" + in +
                                     "}},\n \"h\": {\"type\": \"many\"}},\n \"outputs\": {\"a\": "
                                     "{\"from\": \"h.value\"}}}");
    const size_t start = text.find("node 'n': ");
    return start == text.npos ? text : text.substr(start + 10);
}

TEST(CheckTypes, UnknownOnes) {
    EXPECT_EQ(node_report("numbr", ""),
              "unknown node type 'numbr' (did you mean 'number', or is a plugin missing?)\n");
    EXPECT_EQ(node_report("entirely_other", ""),
              "unknown node type 'entirely_other' (a plugin may be missing; 'wrinkle plugins' "
              "lists those found)\n");
    EXPECT_EQ(reports(test::graph("\"x\": {\"type\": \"zzz\"}", "")),
              "g.json:1:26: error: node 'x': unknown node type 'zzz' (a plugin may be "
              "missing; 'wrinkle plugins' lists those found)\n");
}

TEST(CheckOutputs, OfTwoNamesAreOne) {
    EXPECT_EQ(reports(test::graph(R"("n": {"type": "number"})",
                                  R"("color": {"from": "n.value"},
                                     "base_color": {"from": "n.value"})")),
              "g.json:2:52: error: output 'base_color' is another name of 'color', which the graph "
              "has too (remove one of them)\n");
}

TEST(CheckTypes, Versions) {
    EXPECT_EQ(node_report("number", "", ", \"version\": 2"),
              "made for version 2 of 'number'; this program has version 1 (a newer program or "
              "plugin is needed)\n");
    EXPECT_EQ(node_report("old_name", ""),
              "made for version 1 of 'old_name'; this program has version 2 ('wrinkle upgrade' "
              "migrates it)\n");
    EXPECT_EQ(node_report("old_name", "\"length\": 2", ", \"version\": 2"),
              "unknown port 'length' (since version 2 it is 'size'; 'wrinkle upgrade' renames "
              "it)\n");
}

TEST(CheckPorts, UnknownOnes) {
    EXPECT_EQ(node_report("number", "\"valu\": 1"),
              "unknown port 'valu' (did you mean 'value'?)\n");
    EXPECT_EQ(node_report("vector", "\"qqqq\": 1"),
              "unknown port 'qqqq' (it has scale, offset, tint)\n");
}

TEST(CheckPorts, LiteralsOfTheWrongKind) {
    EXPECT_EQ(node_report("number", "\"value\": \"1\""),
              "port 'value' holds a string (expected a number)\n");
    EXPECT_EQ(node_report("number", "\"value\": null"),
              "port 'value' holds null (expected a number)\n");
    EXPECT_EQ(node_report("number", "\"value\": [1]"),
              "port 'value' holds an array of 1 (expected a number)\n");
    EXPECT_EQ(node_report("vector", "\"scale\": 2"),
              "port 'scale' holds a number (expected an array of 2 numbers)\n");
    EXPECT_EQ(node_report("vector", "\"scale\": [1, 2, 3]"),
              "port 'scale' holds an array of 3 (expected an array of 2 numbers)\n");
    EXPECT_EQ(node_report("vector", "\"tint\": [1, true, 3]"),
              "port 'tint' holds an array of 3 (expected an array of 3 numbers or "
              "\"#rrggbb\")\n");
    EXPECT_EQ(node_report("bump", "\"height\": 1e300"),
              "port 'height' holds 1e300, too large for single precision (at most 3.4e38)\n");
    EXPECT_EQ(node_report("scale", "\"gradient\": 0"),
              "port 'gradient' holds a number (a gradient comes from a wire)\n");
}

TEST(CheckPorts, ValuesOutsideTheHardRangeAreWarnings) {
    EXPECT_EQ(reports(test::graph(R"("n": {"type": "number", "in": {"value": 1.5}})",
                                  R"("a": {"from": "n.value"})")),
              "g.json:1:66: warning: node 'n': port 'value' holds 1.5, outside 0 to 1 (1 is "
              "used)\n");
    EXPECT_EQ(node_report("vector", "\"scale\": [1, -2]"),
              "port 'scale' holds -2, outside 0 to 8 (0 is used)\n");
}

TEST(CheckPorts, Options) {
    EXPECT_EQ(node_report("options", "\"mode\": \"secon\""),
              "port 'mode' has no choice \"secon\" (did you mean 'second'?)\n");
    EXPECT_EQ(node_report("options", "\"mode\": \"xyz\""),
              "port 'mode' has no choice \"xyz\" (expected first, second or third)\n");
    EXPECT_EQ(node_report("options", "\"mode\": 1"),
              "port 'mode' holds a number (expected first, second or third)\n");
    EXPECT_EQ(node_report("options", "\"octaves\": 9"),
              "port 'octaves' holds 9 (expected an integer from 1 to 8)\n");
    EXPECT_EQ(node_report("options", "\"octaves\": 2.5"),
              "port 'octaves' holds 2.5 (expected an integer from 1 to 8)\n");
    EXPECT_EQ(node_report("options", "\"tile\": 1"),
              "port 'tile' holds a number (expected true or false)\n");
    EXPECT_EQ(
        node_report("options", "\"octaves\": {\"from\": \"h.value\"}"),
        "port 'octaves' is known while compiling and takes no wire (write a value, or take an "
        "input of the graph of type count)\n");
}

TEST(CheckImages, Values) {
    EXPECT_EQ(node_report("texture", ""),
              "port 'image' is not set (it needs a path to an image)\n");
    EXPECT_EQ(node_report("texture", "\"image\": 3"),
              "port 'image' holds a number (expected a path or {\"file\": ..., \"encoding\": "
              "...})\n");
    EXPECT_EQ(node_report("texture", "\"image\": \"\""),
              "port 'image' names no file (expected a path)\n");
    EXPECT_EQ(node_report("texture", "\"image\": {\"wrap\": \"clamp\"}"),
              "port 'image' names no file (expected \"file\": a path)\n");
    EXPECT_EQ(node_report("texture", R"("image": {"file": "x", "encoding": "srgp"})"),
              "port 'image' has the unknown encoding \"srgp\" (did you mean 'srgb'?)\n");
    EXPECT_EQ(node_report("texture", R"("image": {"file": "x", "wrap": "border"})"),
              "port 'image' has the unknown wrap \"border\" (expected repeat, clamp or "
              "mirror)\n");
    EXPECT_EQ(node_report("texture", R"("image": {"file": "x", "filter": 1})"),
              "port 'image' has a number as its filter (expected linear or nearest)\n");
    EXPECT_EQ(node_report("texture", R"("image": {"file": "x", "wrab": "clamp"})"),
              "port 'image' has the unknown key \"wrab\" (did you mean 'wrap'?)\n");
}

TEST(CheckImages, Files) {
    EXPECT_EQ(node_report("texture", "\"image\": \"no/such.png\""),
              "port 'image' names \"no/such.png\", which does not exist (a path is relative to "
              "its graph's folder)\n");
    EXPECT_EQ(node_report("texture", "\"image\": \".\""),
              "port 'image' names \".\", which is a folder (expected an image file)\n");
    Diagnostics ignored;
    const Project project = test::project(test::graph("", ""), ignored);
    for (const char* name : {"../../LICENSE", "/etc/passwd"})
        EXPECT_EQ(node_report("texture", std::string("\"image\": \"") + name + "\""),
                  "port 'image' names \"" + std::string(name) +
                      "\", outside the root (keep it below " + project.root.string() +
                      ", or choose another root with --root)\n");
    EXPECT_EQ(node_report("texture", "\"image\": \"fixture.h\"").find("port"), std::string::npos);
}

TEST(CheckWires, Ends) {
    EXPECT_EQ(node_report("number", "\"value\": {\"from\": \"h.valu\"}"),
              "node 'h' has no output 'valu' (did you mean 'value'?)\n");
    EXPECT_EQ(node_report("number", "\"value\": {\"from\": \"h.qqqq\"}"),
              "node 'h' has no output 'qqqq' (it has value, height, normal, gradient, pair)\n");
}

TEST(CheckWires, Conversions) {
    EXPECT_EQ(node_report("number", "\"value\": {\"from\": \"h.pair\"}"),
              "port 'value' takes float, but 'h.pair' is vec2 (it takes float or height)\n");
    EXPECT_EQ(node_report("number", "\"value\": {\"from\": \"surface.normal\"}"),
              "port 'value' takes float, but 'surface.normal' is normal (it takes float or "
              "height)\n");
    EXPECT_EQ(node_report("scale", "\"gradient\": {\"from\": \"surface.uv0\"}"),
              "port 'gradient' takes gradient, but 'surface.uv0' is vec2 (it takes gradient, "
              "float, height, derivative or normal)\n");
    EXPECT_EQ(node_report("layer", "\"height\": {\"from\": \"h.gradient\"}"),
              "port 'height' takes height, but 'h.gradient' is gradient (it takes height or "
              "float)\n");
}

TEST(CheckGraph, Outputs) {
    const std::string node = R"("h": {"type": "many"}, "v": {"type": "vector"})";
    EXPECT_EQ(reports(test::graph(node, R"("normal": {"from": "v.offset"})")),
              "g.json:1:97: error: output 'normal' takes normal, but 'v.offset' is vec3 (it takes "
              "normal, float, height, derivative or gradient)\n");
    EXPECT_EQ(reports(test::graph(node, R"("mine": {"from": "v.offse"})")),
              "g.json:1:95: error: node 'v' has no output 'offse' (did you mean 'offset'?)\n");
    EXPECT_EQ(reports(test::graph(node, "")),
              "g.json: warning: the graph has no outputs, so nothing is made (connect a node "
              "under \"outputs\")\n");
}

std::string input_report(const std::string& input) {
    return reports(test::graph(R"("h": {"type": "many"})", R"("a": {"from": "h.value"})",
                               "\"inputs\": {\"k\": " + input + "}, "));
}

TEST(CheckGraph, Inputs) {
    EXPECT_EQ(input_report(R"({"type": "flot"})"),
              "g.json:1:27: error: input 'k' has the unknown type \"flot\" (did you mean "
              "'float'?)\n");
    EXPECT_EQ(input_report(R"({"type": "float", "default": [1]})"),
              "g.json:1:61: error: input 'k' holds an array of 1 (expected a number)\n");
    EXPECT_EQ(input_report(R"({"type": "image"})"),
              "g.json:1:27: error: input 'k' is an image and has no default (expected "
              "\"default\": a path)\n");
    EXPECT_EQ(input_report(R"({"type": "image", "default": "gone.png"})"),
              "g.json:1:27: error: input 'k' names \"gone.png\", which does not exist (a path is "
              "relative to its graph's folder)\n");
}

TEST(CheckGraph, KeysOfInputs) {
    EXPECT_EQ(input_report(R"({"type": "image", "default": "fixture.h", "slider": [0, 1]})"),
              "g.json:1:84: error: input 'k': \"slider\" does not fit the type image (float, vec2, "
              "vec3, vec4, color, height and count have it)\n");
    EXPECT_EQ(
        input_report(R"({"type": "normal", "limits": [0, 1]})"),
        "g.json:1:61: error: input 'k': \"limits\" does not fit the type normal (float, vec2, "
        "vec3, vec4, color, height and count have it)\n");
    EXPECT_EQ(
        input_report(R"({"type": "float", "widget": "dial"})"),
        "g.json:1:60: warning: input 'k': \"widget\" is \"dial\", which this program does not "
        "have (expected slider, number, angle, seed, color, position, ramp or curve)\n");
    EXPECT_EQ(input_report(R"({"type": "float", "widget": "angl"})"),
              "g.json:1:60: warning: input 'k': \"widget\" is \"angl\", which this program does "
              "not have (did you mean 'angle'?)\n");
    EXPECT_EQ(input_report(R"({"type": "float", "group": "Wear//Edges"})"),
              "g.json:1:59: error: input 'k': \"group\" has an empty part (expected \"Wear\" or "
              "\"Wear/Edges\")\n");
    EXPECT_EQ(input_report(R"({"type": "float", "when": "k > 0"})"),
              "g.json:1:58: error: input 'k': \"when\" is \"k > 0\", which is not a condition "
              "(expected \"input.NAME\", \"!input.NAME\" or \"input.NAME > 0\")\n");
    EXPECT_EQ(input_report(R"({"type": "float", "when": "input.q > 0"})"),
              "g.json:1:58: error: input 'k': \"when\" names the input 'q', which does not exist "
              "(did you mean 'k'?)\n");
    EXPECT_EQ(input_report(R"({"type": "float", "default": 3, "limits": [0, 1]})"),
              "g.json:1:61: warning: input 'k' holds 3, outside 0 to 1 (1 is used)\n");
    EXPECT_EQ(input_report(R"({"type": "float", "default": 0.5, "limits": [0, 1], "step": 0.1,
                               "slider": [0, 2], "widget": "slider", "when": "!input.k"})"),
              "");
}

// Checks inputs that are known while compiling, wired to a node "options" and to a number.
std::string option_report(const std::string& input, const std::string& port,
                          const std::string& more = "") {
    const std::string text =
        reports(test::graph("\"o\": {\"type\": \"options\", \"in\": {\"" + port +
                                "\": {\"from\": \"input.k\"}}}" + more,
                            R"("a": {"from": "o.value"})", "\"inputs\": {\"k\": " + input + "}, "));
    const size_t start = text.find("error: ");
    return start == text.npos ? text : text.substr(start + 7);
}

TEST(CheckGraph, InputsOfOptions) {
    const std::string choice = R"({"type": "choice", "default": "first"})";
    EXPECT_EQ(option_report(choice, "mode"), "");
    EXPECT_EQ(option_report(R"({"type": "choice"})", "mode"),
              "input 'k' is a choice and has no default (it is known while compiling)\n");
    EXPECT_EQ(option_report(R"({"type": "choice", "default": "forth"})", "mode"),
              "input 'k' has no choice \"forth\" (expected first, second or third)\n");
    EXPECT_EQ(
        option_report(R"({"type": "choice", "default": "old", "choices": ["old", "first"]})",
                      "mode"),
        "node 'o': port 'mode' has no choice \"old\", which input 'k' has (expected \"choices\" of "
        "first, second or third)\n");
    EXPECT_EQ(option_report(R"({"type": "flag", "default": true})", "mode"),
              "node 'o': port 'mode' is known while compiling and takes no wire (write a value, or "
              "take an input of the graph of type choice)\n");
    EXPECT_EQ(option_report(R"({"type": "float"})", "octaves"),
              "node 'o': port 'octaves' is known while compiling and takes no wire (write a value, "
              "or take an input of the graph of type count)\n");
    EXPECT_EQ(option_report(R"({"type": "count", "default": 9})", "octaves"),
              "input 'k' holds 9 (expected an integer from 1 to 8)\n");
    EXPECT_EQ(option_report(R"({"type": "count", "default": 2.5})", "octaves"),
              "input 'k' holds 2.5 (expected an integer from 1 to 8)\n");
    EXPECT_EQ(option_report(R"({"type": "count", "default": 2, "limits": [1, 20]})", "octaves"),
              "node 'o': port 'octaves' takes less than the input 'k' may be (expected \"limits\": "
              "[1, 8] at the input)\n");
    EXPECT_EQ(option_report(R"({"type": "flag", "default": 1})", "tile"),
              "input 'k' holds a number (expected true or false)\n");
    EXPECT_EQ(option_report(R"({"type": "flag", "default": true, "choices": ["a"]})", "tile"),
              "input 'k': \"choices\" does not fit the type flag (choice has it)\n");
    EXPECT_EQ(
        option_report(R"({"type": "flag", "default": true})", "tile",
                      R"(, "n": {"type": "number", "in": {"value": {"from": "input.k"}}})"),
        "node 'n': the input 'k' is a flag, which is known while compiling (connect it to such "
        "an option of a node)\n");
    EXPECT_EQ(
        option_report(R"({"type": "flag", "default": true})", "tile",
                      R"(, "r": {"type": "reroute", "in": {"in": {"from": "input.k"}}})"),
        "node 'r': the input 'k' is a flag, which is known while compiling (connect it to such "
        "an option of a node)\n");
    EXPECT_EQ(reports(test::graph("", R"("a": {"from": "input.k"})",
                                  R"("inputs": {"k": {"type": "count", "default": 1}}, )"))
                  .substr(13),
              "error: the input 'k' is a count, which is known while compiling (connect it to such "
              "an option of a node)\n");
    EXPECT_EQ(input_report(R"({"type": "choice", "default": "a"})"), "") << "no port reads it";
    const std::string twice = option_report(
        choice, "mode", R"(, "p": {"type": "options", "in": {"mode": {"from": "input.k"}}})");
    EXPECT_EQ(
        twice.substr(0, twice.find('\n')),
        "node 'o': the input 'k' is read by several ports and has no \"choices\" (expected some "
        "of first, second, third)");
}

TEST(CheckGraph, UnknownKeysAreErrors) {
    const std::string text =
        reports(test::graph(R"("h": {"type": "many", "color": 1})", R"("a": {"from": "h.value"})"));
    EXPECT_EQ(text, "g.json:1:48: error: node 'h': unknown key \"color\"\n");
}

TEST(CheckGraph, EditedDocumentsAreAskedForTheirLinks) {
    Diagnostics diagnostics;
    Project project = test::project(
        test::graph(R"("s": {"type": "scale"})", R"("normal": {"from": "s.gradient"})"),
        diagnostics);
    Document& top = project.files[0].document;
    top = connect(top, {"gone", "gradient"}, "s", "gradient");
    EXPECT_NE(reports(project).find("there is no node 'gone'"), std::string::npos);
    top = connect(top, {"surface", "uv9"}, "s", "gradient");
    EXPECT_NE(reports(project).find("the surface has no property 'uv9' (did you mean 'uv0'?)"),
              std::string::npos);
    top = connect(top, {"s", "gradient"}, "s", "gradient");
    EXPECT_NE(reports(project).find("cycle"), std::string::npos);
}

TEST(CheckGraph, UnreachedNodesCountUnlessToldOtherwise) {
    Diagnostics diagnostics;
    const Project project =
        test::project(test::graph(R"("p": {"type": "texture"}, "n": {"type": "number"})",
                                  R"("a": {"from": "n.value"})"),
                      diagnostics);
    EXPECT_NE(reports(project), "");
    EXPECT_EQ(reports(project, {.reachable_only = true}), "");
}

TEST(CheckGraph, AllProblemsComeInOneGo) {
    const std::string text = reports(test::graph(
        R"("a": {"type": "number", "in": {"value": true, "x": 1}}, "b": {"type": "nope"},
           "c": {"type": "texture"}, "d": {"type": "scale", "in": {"gradient": {"from": "surface.uv1"}}})",
        R"("normal": {"from": "a.q"})"));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 6) << text;
}

TEST(CheckSubgraphs, PortsAreCheckedFromOutside) {
    const test::Files files({
        {"main.json",
         test::graph(R"("s": {"type": "graph:s.json", "in": {"lengt": 1, "kind": "x"}})",
                     R"("a": {"from": "s.valu"})")},
        {"s.json",
         test::graph(R"("n": {"type": "number", "in": {"value": {"from": "input.kind"}}})",
                     R"("value": {"from": "n.value"})",
                     R"("inputs": {"length": {"type": "float"}, "kind": {"type": "float"},
                                             "map": {"type": "image"}}, )")},
    });
    Diagnostics diagnostics;
    const Project project = load_project(files.folder / "main.json", {}, diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
    const std::string text = reports(project);
    for (const char* part : {"unknown port 'lengt' (did you mean 'length'?)",
                             "port 'kind' holds a string (expected a number)",
                             "port 'map' is not set (it needs a path to an image)",
                             "node 's' has no output 'valu' (did you mean 'value'?)"})
        EXPECT_NE(text.find(part), text.npos) << part << "\n" << text;
}

}  // namespace
}  // namespace wrinkle
