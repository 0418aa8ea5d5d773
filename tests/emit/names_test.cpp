#include "emit/names.h"

#include <gtest/gtest.h>

#include "emit/language.h"
#include "glslang/validate.h"
#include "graphs.h"

namespace wrinkle::test {
namespace {

TEST(Names, are_legal_and_unique) {
    NameSet names(&glsl().reserved);
    EXPECT_EQ(names.unique("weave.normal"), "weave_normal");
    EXPECT_EQ(names.unique("weave normal"), "weave_normal_2");
    EXPECT_EQ(names.unique("weave_normal_2"), "weave_normal_2_2");
    EXPECT_EQ(names.unique("texture"), "texture_2");
    EXPECT_EQ(names.unique("gl_Position").find("gl_"), 1u);
    EXPECT_EQ(names.unique("2nd"), "n2nd");
    const std::string umlauts = names.unique("Ä__Ö__");
    EXPECT_EQ(umlauts.find("__"), std::string::npos);
    EXPECT_FALSE(names.unique("").empty());
    EXPECT_LT(names.unique(std::string(5000, 'a')).size(), 200u);
}

TEST(Names, of_inner_scopes_differ_from_outer_ones) {
    NameSet globals(&glsl().reserved);
    globals.unique("weave_image");
    NameSet locals(&globals);
    EXPECT_EQ(locals.unique("weave_image"), "weave_image_2");
    EXPECT_EQ(locals.unique("other"), "other");
}

// The table is rehashed many times; names that were returned stay valid.
TEST(Names, of_which_there_are_many_keep_their_texts) {
    NameSet globals(&glsl().reserved);
    globals.unique("map_7");
    NameSet names(&globals);
    std::vector<std::pair<std::string_view, std::string>> given;
    const auto add = [&](const NameHint& wanted, std::string expected) {
        given.emplace_back(names.add(wanted), std::move(expected));
    };
    for (int i = 0; i < 3000; ++i) {
        const std::string number = std::to_string(i);
        add({"map", number}, i == 7 ? "map_7_2" : "map_" + number);
        add({{}, "texel"}, i == 0 ? "texel" : "texel_" + std::to_string(i + 1));
    }
    for (const auto& [name, text] : given)
        EXPECT_EQ(name, text);
    EXPECT_EQ((NameHint{"map", "uv"}.size()), 6u);
    EXPECT_EQ((NameHint{{}, "uv"}.size()), 2u);
}

TEST(Names, comments_cannot_be_left) {
    EXPECT_EQ(comment_text("a\nfloat x;\r\\"), "a float x; /");
    EXPECT_EQ(comment_text("a\u0085b\u2028c\u2029d"), "a b c d");
    EXPECT_EQ(comment_text("a\u202Eb\u2066c\u200Ed"), "a b c d");
    EXPECT_EQ(comment_text("\u00E4 \u2030 \u2067 \u00A0"), "\u00E4 \u2030   \u00A0");
    EXPECT_EQ(comment_text("ends?\?/"), "ends?? ");
    EXPECT_EQ(comment_text("ends?\?\\"), "ends?? ");
    EXPECT_EQ(comment_text("\xC2"), " ");
    EXPECT_EQ(comment_text("a\u061Cb\xC2\x1B[2J\x7F"), "a b  [2J ");
    const std::string long_text(158, 'n');
    EXPECT_EQ(comment_text(long_text + "\U0001F600"), long_text);
    EXPECT_EQ(comment_text(long_text + "\u00E4\u00E4"), long_text + "\u00E4");
    EXPECT_LE(comment_text(std::string(1000, 'x')).size(), 200u);
}

// All reserved words, and other invalid names, as names of nodes, ports and outputs.
TEST(Names, hostile_graphs_still_compile) {
    Module m;
    m.nodes[0].title = m.titles.add("Title\n#error broken \\");
    const std::vector<std::string> bad = {
        "texture",  "sample",    "input",      "gl_x",         "a__b",
        "a..b",     "s",         "main",       "normal",       "ä",
        "1",        "_",         "mix",        "float",        "vec3",
        "i",        "result",    "utexture2D", "subpassInput", "webgl_x",
        "_webgl_y", "precision", "highp",      "WrinkleFrame"};
    Id sum = m.number(0);
    for (const std::string& word : bad) {
        node(m, word, "ends\nhere \\");
        Id value =
            m.add(Op::mul_, {m.swizzle(image(m, word, word, m.input(SurfaceInput::uv0_)), "x"),
                             parameter(m, word, 2)});
        name(m, word, value);
        sum = m.add(Op::add_, {sum, m.add(Op::sin_, {value})});
        output(m, word, value);
    }
    output(m, "sum", sum);
    for (const char* target : {"glsl330", "glsl450", "essl300"})
        for (const std::string& word : bad)
            for (const Form form : {Form::function, Form::shader}) {
                EmitOptions options;
                options.name = word;
                options.form = form;
                options.target = find_target(target);
                EXPECT_EQ(compile_errors(emit(m, options)), "");
            }
}

// Uniforms of a node called "wrinkle" may clash with names of the shader form.
TEST(Names, of_the_shader_form_are_taken) {
    Module m;
    node(m, "wrinkle", "");
    Id sum = m.swizzle(m.input(SurfaceInput::normal_), "x");
    for (const char* port :
         {"normal", "uv0", "eye", "object_to_clip", "object_to_world", "normal_to_world",
          "position_relative", "position", "frame", "parameters"})
        sum = m.add(Op::add_, {sum, parameter(m, port, 2)});
    output(m, "height", sum);
    for (const char* target : {"glsl330", "glsl450", "essl300"})
        for (const Form form : {Form::function, Form::shader}) {
            EmitOptions options;
            options.form = form;
            options.target = find_target(target);
            EXPECT_EQ(compile_errors(emit(m, options)), "");
        }
}

TEST(Names, equal_after_cleaning_follow_graph_order) {
    Module m;
    Id sum = m.number(0);
    for (const std::string path : {"a b", "a-b"}) {
        node(m, path, "Value");
        const Id value = m.add(Op::sin_, {parameter(m, "amount", 1)});
        name(m, "out", value);
        sum = m.add(Op::add_, {sum, m.add(Op::mul_, {value, value})});
    }
    output(m, "o", sum);
    const Shader shader = emit(m, {});
    EXPECT_EQ(compile_errors(shader), "");
    EXPECT_NE(shader.source.find("float a_b_out = sin(material_a_b_amount);"), std::string::npos);
    EXPECT_NE(shader.source.find("float a_b_out_2 = sin(material_a_b_amount_2);"),
              std::string::npos);
}

// Nodes that pass a value through name it as well; the name by its producer is used.
TEST(Names, the_first_output_that_a_value_is_names_it) {
    Module m;
    node(m, "maker", "Maker");
    const Id value = m.add(Op::sin_, {parameter(m, "amount", 1)});
    m.name(value, m.current_node, "inner");
    name(m, "made", value);
    for (const std::string path : {"passes", "passes_too"}) {
        node(m, path, "Pass");
        name(m, "passed", value);
    }
    output(m, "o", m.add(Op::mul_, {value, value}));
    const Shader shader = emit(m, {});
    EXPECT_EQ(compile_errors(shader), "");
    EXPECT_NE(shader.source.find("float maker_made = sin(material_maker_amount);"),
              std::string::npos)
        << shader.source;
}

}  // namespace
}  // namespace wrinkle::test
