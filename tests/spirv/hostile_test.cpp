// Tests of code injection through names. Any string in a graph or in its files, at any position, is
// refused, or the source of every target is valid and has no additional line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>

#include "base/text.h"
#include "graph/subgraph.h"
#include "lower/material.h"
#include "spirv/judge.h"
#include "spirv/spirv.h"
#include "support/files.h"
#include "support/linked_nodes.h"

namespace wrinkle::test {
namespace {

namespace fs = std::filesystem;

// If this word occurs as a complete token, a name injected code.
constexpr std::string_view mark = "INJECTED";

struct Field {
    const char* name;
    bool is_id;  // 1 to 128 characters, none of them a control character or a dot
};
void PrintTo(const Field& field, std::ostream* out) {
    *out << field.name;
}
constexpr Field fields[] = {
    {"graph name", false},
    {"node", true},
    {"map node", true},
    {"graph input", true},
    {"input doc", false},
    {"output", true},
    {"note", false},
    {"frame", false},
    {"sub-graph's name", false},
    {"sub-graph's node", true},
    {"its input", true},
    {"its output", true},
    {"its file", false},
    {"image", false},
    {"--name", false},
};

const std::vector<std::string> strings = {
    "*/ float INJECTED(){return 1;} /*",
    "a\nfloat INJECTED;",
    "a\r\nfloat INJECTED;//",
    "a\u0085float INJECTED;",
    "a\u2028float INJECTED;",
    "a\u2029#define INJECTED",
    std::string("a\0float INJECTED;", 17),
    "ends\\",
    "ends\\\nfloat INJECTED;",
    "ends?\?/",
    "ends?\?\\",
    "gl_Position",
    "a__b",
    "float",
    "texture",
    "sampler2D",
    "größe Ж 漢 😀",
    "a\u202Eb\u2066",
    "\uFEFFa",
    std::string(100'000, 'n'),
    std::string(128, 'n'),
    "n" + std::string(126, '\'') + "n",
    std::string(158, 'n') + "😀",
    "",
    "#define vec3 INJECTED",
    "#version 100",
    "1a",
    "s",
    "WrinkleSurface_material",
    "WrinkleMaterial_material",
    "wrinkle_material",
    "WrinkleFrame",
    "position",
    "\"'`$(x) %s%n",
    "a/b",
    "a.b",
    "\x1B[31mred",
};

std::string short_form(const std::string& text) {
    return json_quoted(text.size() > 60 ? text.substr(0, 40) + "... " + std::to_string(text.size())
                                        : text);
}

// A graph of a map, a noise, an input and a sub-graph, with `text` at one of the positions.
struct Hostile {
    std::string place, text;

    // Returns `text` if `here` is the tested position, else the usual string.
    std::string at(const std::string& here, const std::string& usual) const {
        return here == place ? text : usual;
    }
    std::string quoted(const std::string& here, const std::string& usual) const {
        return json_quoted(at(here, usual));
    }
    std::string top() const {
        const auto from = [&](const std::string& what, const std::string& port) {
            return "{\"from\": " + json_quoted(what + "." + port) + "}";
        };
        const std::string node = at("node", "noise"), map = at("map node", "map");
        return "{\"wrinkle\": 1, \"name\": " + quoted("graph name", "Top") + ", \"nodes\": {" +
               json_quoted(node) + ": {\"type\": \"gradient_noise\"}, " + json_quoted(map) +
               ": {\"type\": \"tangent_normal_map\", \"in\": {\"image\": " +
               json_quoted(at("image", "map") + ".png") + "}}, " +
               "\"product\": {\"type\": \"multiply\", \"in\": {\"a\": " +
               from("input", at("graph input", "amount")) + ", \"b\": " + from(node, "height") +
               "}}, \"sum\": {\"type\": \"gradient_add\", \"in\": {\"a\": " +
               from("product", "result") + ", \"b\": " + from(map, "gradient") +
               "}}, \"end\": {\"type\": \"resolve\", \"in\": {\"gradient\": " +
               from("sum", "gradient") + "}}, \"sub\": {\"type\": " +
               json_quoted("graph:" + at("its file", "sub") + ".json") + ", \"in\": {" +
               quoted("its input", "x") + ": 2}}}, \"inputs\": {" +
               quoted("graph input", "amount") +
               ": {\"type\": \"float\", \"default\": 1, \"doc\": " + quoted("input doc", "d") +
               "}}, \"outputs\": {" + quoted("output", "normal") + ": " + from("end", "normal") +
               ", \"extra\": " + from("sub", at("its output", "y")) +
               "}, \"layout\": {\"$notes\": {\"a\": {\"rect\": [0, 0, 9, 9], \"text\": " +
               quoted("note", "a") + "}}, \"$frames\": {\"f\": {\"rect\": [0, 0, 9, 9], " +
               "\"title\": " + quoted("frame", "f") + "}}}}";
    }
    std::string sub() const {
        const std::string node = at("sub-graph's node", "m");
        return "{\"wrinkle\": 1, \"name\": " + quoted("sub-graph's name", "Sub") +
               ", \"nodes\": {\"uv\": {\"type\": \"separate_vec2\", \"in\": {\"vector\": " +
               "{\"from\": \"surface.uv0\"}}}, " + json_quoted(node) +
               ": {\"type\": \"multiply\", \"in\": {\"a\": {\"from\": " +
               json_quoted("input." + at("its input", "x")) +
               "}, \"b\": {\"from\": \"uv.x\"}}}}, \"inputs\": {" + quoted("its input", "x") +
               ": {\"type\": \"float\", \"default\": 1}}, \"outputs\": {" +
               quoted("its output", "y") + ": {\"from\": " + json_quoted(node + ".result") + "}}}";
    }
};

// Directives at the beginning of the generated sources.
constexpr std::string_view directives[] = {"#version ", "#pragma clang diagnostic ignored \"-Wm",
                                           "#include <metal_stdlib>", "#include <simd/simd.h>"};

bool is_code_of_names(const std::string& text) {
    for (const std::string_view line : split(text, '\n')) {
        const std::string_view code = line.substr(0, line.find("//"));
        if (code.starts_with('#') &&
            std::none_of(std::begin(directives), std::end(directives),
                         [&](std::string_view known) { return code.starts_with(known); }))
            return true;
        for (size_t at = code.find(mark); at != code.npos; at = code.find(mark, at + 1)) {
            const auto word = [&](size_t i) {
                return i < code.size() &&
                       (std::isalnum(static_cast<unsigned char>(code[i])) || code[i] == '_');
            };
            if ((at == 0 || !word(at - 1)) && !word(at + mark.size())) return true;
        }
    }
    return false;
}

// Returns true if no character continues or ends a line or changes the text direction.
bool is_plain(const std::string& text) {
    for (const std::string_view line : split(text, '\n'))
        if (line.ends_with('\\') || line.ends_with("?\?/")) return false;
    for (const std::string_view unseen : {"\u0085", "\u2028", "\u2029", "\u202E", "\u2066"})
        if (text.find(unseen) != text.npos) return false;
    return is_utf8(text) && std::none_of(text.begin(), text.end(), [](char c) {
               return static_cast<unsigned char>(c) < 0x20 && c != '\n';
           });
}

void judge(const Module& module, const Hostile& hostile, bool translated) {
    for (const Target& target : targets())
        for (const Form form : {Form::function, Form::shader}) {
            if (!supports(target, form) || (is_binary(target) && !translated)) continue;
            EmitOptions options;
            options.target = &target;
            options.form = form;
            options.name = hostile.at("--name", "material");
            const Shader shader = write_shader(module, options);
            const std::string where =
                hostile.place + " " + short_form(hostile.text) + " " + std::string(target.name);
            EXPECT_EQ(errors_of(shader), "") << where;
            if (target.name == "spirv") continue;
            for (const std::string* text : {&shader.source, &shader.vertex, &shader.fragment}) {
                EXPECT_FALSE(is_code_of_names(*text)) << where << *text;
                EXPECT_TRUE(is_plain(*text)) << where << *text;
            }
            EXPECT_TRUE(is_utf8(to_json(shader.reflection))) << where;
        }
}

// By the rule of docs/graph-format.md.
bool is_id(const std::string& text) {
    const bool control = std::any_of(text.begin(), text.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == '\x7F';
    });
    size_t characters = 0;
    for (const char c : text)
        characters += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    return !text.empty() && characters <= 128 && !control && text.find('.') == text.npos &&
           text.find("\u0085") == text.npos;
}

class HostileNames : public testing::TestWithParam<Field> {
protected:
    // Returns false if a file cannot have that name.
    static bool put(const fs::path& path) {
        std::error_code error;
        if (path.native().find('\0') != std::string::npos) return false;
        fs::create_directories(path.parent_path(), error);
        return std::ofstream(path).good();
    }
    static bool make_files(const Hostile& hostile, const TemporaryFolder& folder) {
        const fs::path sub = folder.path() / (hostile.at("its file", "sub") + ".json");
        if (!put(sub) || !put(folder.path() / (hostile.at("image", "map") + ".png"))) return false;
        std::ofstream(sub) << hostile.sub();
        std::ofstream(folder.path() / "top.json") << hostile.top();
        return true;
    }
};

TEST_P(HostileNames, StayInTheirPlace) {
    size_t taken = 0;
    for (const std::string& text : strings) {
        const Hostile hostile{GetParam().name, text};
        const TemporaryFolder folder;
        if (!make_files(hostile, folder)) continue;
        Diagnostics diagnostics;
        const Project project = load_project(folder.path() / "top.json", {}, diagnostics);
        for (const bool uniforms : {false, true}) {
            MaterialOptions options;
            options.uniform_parameters = uniforms;
            const Compiled compiled =
                compile_material(project, linked_nodes(), options, diagnostics);
            const bool expected = !GetParam().is_id || is_id(text);
            EXPECT_EQ(compiled.ok, expected) << short_form(text) << to_text(diagnostics);
            if (!compiled.ok) break;
            judge(compiled.module, hostile, uniforms);
            ++taken;
        }
    }
    EXPECT_GT(taken, 20u);
}

INSTANTIATE_TEST_SUITE_P(Fields, HostileNames, testing::ValuesIn(fields),
                         [](const auto& each) { return identifier(each.param.name); });

}  // namespace
}  // namespace wrinkle::test
