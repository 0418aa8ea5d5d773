// Tests of the code panel: it shows the source of `wrinkle compile` and maps each line to a node.
#include <algorithm>

#include "base/text.h"
#include "editor/model/code/tokens.h"
#include "editor/model/document/files.h"
#include "graph/edit.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {
namespace fs = std::filesystem;

std::vector<fs::path> sample_graphs() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(fs::path(WRINKLE_SOURCE_DIR) / "graphs"))
        if (entry.path().extension() == ".json" && !entry.path().stem().string().ends_with(".test"))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    EXPECT_GT(files.size(), 20U);
    return files;
}

TEST(Tokens, CoverALineAndKnowItsPieces) {
    const std::string_view line = "    vec3 n = wrinkle_f(s.uv0, 1e-06) * .5;  // base: Add";
    std::string seen;
    size_t at = 0;
    for (const Piece& piece : pieces_of(line)) {
        EXPECT_EQ(piece.begin, at);
        at = piece.end;
        const std::string_view text = line.substr(piece.begin, piece.end - piece.begin);
        if (piece.token != Token::text)
            seen += std::to_string(static_cast<int>(piece.token)) + std::string(text) + "|";
    }
    EXPECT_EQ(at, line.size());
    EXPECT_EQ(seen, "2vec3|3wrinkle_f|41e-06|4.5|5// base: Add|");
    EXPECT_EQ(pieces_of("#version 330 core").front().token, Token::keyword);
    EXPECT_EQ(pieces_of("uniform float x2;").front().token, Token::keyword);
    EXPECT_TRUE(pieces_of("").empty());
}

TEST(Tokens, TakeAnyBytes) {
    std::string bytes;
    for (int i = 1; i < 256; ++i)
        bytes += static_cast<char>(i);
    size_t at = 0;
    for (const Piece& piece : pieces_of(bytes)) {
        EXPECT_EQ(piece.begin, at);
        EXPECT_GT(piece.end, at);
        at = piece.end;
    }
    EXPECT_EQ(at, bytes.size());
}

TEST_F(Headless, AGraphWithoutAFileHasANameInItsText) {
    open(small_graph);
    state.path.clear();
    const std::string text = make_code(job_of(state)).source;
    EXPECT_NE(text.find("struct WrinkleMaterial_untitled {"), std::string::npos) << text;
    EXPECT_EQ(usual_export(state).filename(), "untitled.glsl");
}

TEST_F(Headless, ExportsWhatTheProgramWrites) {
    std::string all;
    for (const fs::path& graph : sample_graphs())
        all += " " + graph.string();
    for (const std::string params : {"baked", "uniform"})
        for (const std::string form : {"function", "shader"}) {
            const fs::path made = folder.path() / (params + form);
            EXPECT_EQ(program_output("compile --params " + params + " --form " + form + " -o " +
                                     made.string() + all),
                      "");
            for (const fs::path& graph : sample_graphs()) {
                open_file(state, graph);
                frame();
                state.code.options.uniforms = params == "uniform";
                state.code.options.form = form == "shader" ? Form::shader : Form::function;
                const fs::path file = folder.path() / "out" / graph.stem();
                fs::create_directories(file.parent_path());
                start_code_export(state, file);
                const TaskOutcome outcome = state.tasks.running->outcome();
                ASSERT_TRUE(outcome.good) << graph << outcome.sentence;
                poll_tasks(state);
                const auto compare = [&](const std::string& ours, const std::string& theirs) {
                    const std::string text = text_of(ours);
                    EXPECT_FALSE(text.empty());
                    EXPECT_EQ(text, text_of(theirs)) << graph;
                };
                if (form == "function") {
                    compare(file, (made / graph.stem()).string() + ".glsl");
                    frame();
                    EXPECT_EQ(state.code.text.source, text_of(file)) << "the panel shows another";
                } else {
                    compare(file.string() + ".vert", (made / graph.stem()).string() + ".vert");
                    compare(file.string() + ".frag", (made / graph.stem()).string() + ".frag");
                }
            }
        }
}

TEST_F(Headless, ExportsEveryTargetAsTheProgramDoes) {
    const fs::path graph = fs::path(WRINKLE_SOURCE_DIR) / "graphs/base_and_detail.json";
    open_file(state, graph);
    frame();
    for (const Target& target : targets()) {
        if (!supports(target, Form::shader)) continue;
        const std::string name(target.name), end(target.suffix);
        const std::string made = (folder.path() / ("made-" + name)).string();
        const std::string file = (folder.path() / name).string();
        const std::string command = "compile --form shader --target " + name + " -o ";
        EXPECT_EQ(program_output(command + made + " " + graph.string()), "");
        state.code.options.target = name;
        state.code.options.form = is_binary(target) ? Form::function : Form::shader;
        start_code_export(state, file);
        const TaskOutcome outcome = state.tasks.running->outcome();
        ASSERT_TRUE(outcome.good) << outcome.sentence;
        EXPECT_NE(outcome.sentence.find(".frag" + end + "."), std::string::npos);
        poll_tasks(state);
        for (const char* stage : {".vert", ".frag"})
            EXPECT_EQ(text_of(file + stage + end), text_of(made + stage + end)) << name;
        frame();
        EXPECT_EQ(state.code.problem, "");
        if (name == "spirv")
            EXPECT_NE(state.code.text.source.find("OpEntryPoint Fragment"), std::string::npos);
        else
            EXPECT_EQ(state.code.text.source, text_of(file + ".frag" + end));
    }
}

size_t indent_of(std::string_view line) {
    return std::min(line.find_first_not_of(' '), line.size());
}

// Returns the longest node id that a name begins with: "tile_uv" rather than "tile".
std::string id_before(const State& state, std::string_view name) {
    std::string found;
    for (const NodePtr& node : state.document().nodes)
        if (name.starts_with(identifier(node->id) + "_") && node->id.size() > found.size())
            found = node->id;
    return found;
}

// Returns the id of the node that a line belongs to, found from the source only; "" if there is
// none. The target of an assignment has a name that begins with the node's id; so has a
// temporary that is an output. The end of a loop belongs to the node of its beginning. For any
// other line, the line itself or the last one that has a comment names the node: "id: Title".
std::string node_by_text(const State& state, size_t line) {
    const CodeText& code = state.code.text;
    const std::string_view own = code.line(line);
    const std::string_view words = own.substr(indent_of(own));
    if (words == "}")
        for (size_t i = line; i-- > 0;)
            if (indent_of(code.line(i)) == indent_of(own) && code.line(i).ends_with(" {"))
                return node_by_text(state, i);
    constexpr std::string_view image = "uniform sampler2D ";
    if (words.starts_with(image)) {
        constexpr std::string_view material = "struct WrinkleMaterial_";
        const size_t from = code.source.find(material) + material.size();
        const size_t prefix = code.source.find(" {", from) - from + 1;  // "NAME_"
        return id_before(state, words.substr(image.size() + prefix));
    }
    const std::string_view value = words.substr(std::min(words.find(" = ") + 3, words.size()));
    if (words.starts_with("m.") && value.find(' ') == value.npos)
        if (const std::string id = id_before(state, value); !id.empty()) return id;
    if (const size_t name = words.find(" = "); name != words.npos && words.find(' ') == name)
        for (const NodePtr& node : state.document().nodes)
            if (words.starts_with(identifier(node->id) + "_")) return node->id;
    for (size_t i = line + 1; i-- > 0;) {
        const std::string_view text = code.line(i);
        const size_t mark = text.find("// ");
        if (mark == text.npos) continue;
        std::string_view id = text.substr(mark + 3);
        id = id.substr(0, std::min(id.find(": "), id.size()));
        const std::string top(id.substr(0, id.find('/')));
        if (state.document().find(top)) return top;
    }
    return {};
}

TEST_F(Headless, EveryLineLeadsToTheNodeThatItsTextNames) {
    size_t lines = 0, wrong = 0;
    for (const fs::path& graph : sample_graphs()) {
        open_file(state, graph);
        frame();
        const CodeText& text = state.code.text;
        ASSERT_EQ(text.nodes.size(), text.starts.size()) << graph;
        for (size_t i = 0; i < text.nodes.size(); ++i) {
            if (text.node(i).empty()) continue;
            ++lines;
            const std::string named = node_by_text(state, i);
            wrong += named != text.node(i);
            EXPECT_EQ(named, text.node(i))
                << graph.filename() << ":" << i + 1 << ": " << text.line(i);
        }
    }
    std::printf("%zu lines of %zu samples belong to nodes, %zu of them wrongly\n", lines,
                sample_graphs().size(), wrong);
}

TEST_F(Headless, AClickOnALineSelectsItsNodeAndHoveringMarksIt) {
    open(small_graph);
    ImGui::GetIO().DisplaySize.y = 5000;
    state.panes.preview = 0.15F;
    frame();
    frame();
    for (size_t i = 0; i < state.code.text.starts.size(); ++i) {
        const std::string node = state.code.text.node(i);
        state.view.selected.clear();
        play("click line:" + std::to_string(i + 1));
        EXPECT_EQ(state.code.hovered, node);
        EXPECT_EQ(state.view.selected,
                  node.empty() ? std::set<std::string>() : std::set<std::string>{node});
    }
}

TEST_F(Headless, ALineOfAUniformLeadsToItsNode) {
    open_file(state, fs::path(WRINKLE_SOURCE_DIR) / "graphs/everything.json");
    for (const char* target : {"glsl330", "glsl450"}) {
        state.code.options.uniforms = true;
        state.code.options.target = target;
        frame();
        frame();
        const CodeText& text = state.code.text;
        size_t uniforms = 0, images = 0;
        bool block = false;
        for (size_t i = 0; i < text.starts.size(); ++i) {
            const std::string line(text.line(i));
            block = (block || line.find("uniform Wrinkle") != line.npos) && line != "};";
            const bool image = line.find("uniform sampler2D ") != line.npos;
            const bool number = line.starts_with("uniform float ") ||
                                line.starts_with("uniform vec") ||
                                (block && line.starts_with("    "));
            if (!image && !number) continue;
            const std::string node = text.node(i);
            EXPECT_NE(line.find(" everything_" + node + "_"), line.npos) << node << ": " << line;
            EXPECT_TRUE(state.document().find(node)) << line;
            image ? ++images : ++uniforms;
        }
        EXPECT_GE(uniforms, 10U) << target;
        EXPECT_EQ(images, 3U) << target;
    }
}

TEST_F(Headless, ANodeWithoutALineSaysWhy) {
    open(small_graph);
    play("click canvas+0,330\nassert no-target code:why\nclick node:normal\nwait");
    EXPECT_EQ(why_no_line(state, state.view.selected), "");
    play("assert no-target code:why\nclick node:number\nassert target code:why");
    EXPECT_EQ(why_no_line(state, state.view.selected),
              "number has no line: no output of the graph reads it.");
    play("click canvas+0,330\nassert no-target code:why");
    size_t without = 0;
    for (const fs::path& graph : sample_graphs()) {
        open_file(state, graph);
        frame();
        const auto& nodes = state.code.text.nodes;
        for (const NodePtr& node : state.document().nodes) {
            state.view.selected = {node->id};
            const bool has = std::find(nodes.begin(), nodes.end(), node->id) != nodes.end();
            const std::string why = why_no_line(state, state.view.selected);
            EXPECT_EQ(why.empty(), has) << graph << " " << node->id;
            EXPECT_TRUE(has || why.starts_with(node->id + " has no line")) << why;
            without += !has;
        }
    }
    EXPECT_GT(without, 5U);
}

TEST_F(Headless, TheFormIsChosenAndTheTextCopied) {
    open(small_graph);
    state.panes.side = 0.4F;  // wide enough to show the choices
    frame();
    frame();
    play(R"(
        click code:form
        click code:form:Vertex
        wait)");
    EXPECT_NE(state.code.text.source.find("gl_Position"), std::string::npos);
    play("click code:form\nclick code:form:Fragment\nwait");
    EXPECT_NE(state.code.text.source.find("#version 330"), std::string::npos);
    play(
        "click code:form\nclick code:form:Function\nclick code:parameters\n"
        "click code:parameters:Uniforms\nclick code:copy");
    EXPECT_NE(state.code.text.source.find("uniform float graph_softer_amount"), std::string::npos);
    const char* copied = ImGui::GetClipboardText();
    EXPECT_EQ(std::string(copied ? copied : ""), state.code.text.source);
}

// Nodes that no output needs, each with a different error.
const char* const junk = R"(
    "a": { "type": "sine", "in": { "angle": { "from": "b.result" } } },
    "b": { "type": "sine", "in": { "angle": { "from": "a.result" } } },
    "unknown": { "type": "no_such_node" },
    "lost": { "type": "height_map", "in": { "image": "not_there.png" } },
    "part": { "type": "graph:not_there.json" },
    "wire": { "type": "sine", "in": { "angle": { "from": "nowhere.result" } } },
    "unread": { "type": "sine", "in": { "angle": { "from": 7 } } },
)";

TEST_F(Headless, WhatNoOutputNeedsIsAProblemAndBlocksNeitherTextNorPreview) {
    const std::string graph = small_graph;
    const size_t nodes = graph.find("\"nodes\": {") + 10;
    open(small_graph);
    const std::string text = state.built.uniform.value().source, code = state.code.text.source;
    ASSERT_FALSE(code.empty());
    open(graph.substr(0, nodes) + junk + graph.substr(nodes));
    for (const char* node : {"unknown", "lost", "part", "wire", "unread"}) {
        bool said = false;
        for (const Diagnostic& problem : state.built.problems.list())
            said |= problem.node == node && problem.severity == Severity::error;
        EXPECT_TRUE(said) << node;
    }
    EXPECT_NE(to_text(state.built.problems).find("cycle"), std::string::npos);
    EXPECT_FALSE(state.built.live.has_errors()) << to_text(state.built.live);
    ASSERT_TRUE(state.built.uniform);
    EXPECT_EQ(state.built.uniform->source, text);
    EXPECT_EQ(state.code.text.source, code);
    EXPECT_EQ(state.code.problem, "");
    EXPECT_NE(program_output("check " + file.string()).find("no_such_node"), std::string::npos);
    // Problems of an edited document take another code path.
    state.commit("Move", move_node(state.document(), "noise", 5, 7));
    state.commit("Wire", connect(state.document(), {"number", "result"}, "softer", "amount"));
    frame();
    frame();
    EXPECT_TRUE(state.built.uniform) << to_text(state.built.live);
    EXPECT_FALSE(state.code.text.source.empty());
    EXPECT_EQ(state.code.problem, "");
}

TEST_F(Headless, WhatAnOutputNeedsBlocksTheText) {
    for (const char* wrong : {"\"noise\": { \"type\": \"no_such_node\" }",
                              "\"noise\": { \"type\": \"graph:not_there.json\" }"}) {
        std::string graph = small_graph;
        const size_t at = graph.find("\"noise\": {");
        graph.replace(at, graph.find('\n', at) - 1 - at, wrong);
        open(graph);
        EXPECT_FALSE(state.built.uniform);
        EXPECT_TRUE(state.built.problems.has_errors());
        EXPECT_NE(state.code.problem, "") << wrong;
    }
}

TEST_F(Headless, TheLastTextStaysWhenTheGraphBreaks) {
    open(small_graph);
    const std::string text = state.code.text.source;
    EXPECT_FALSE(text.empty());
    state.commit("Break", read_document(R"({ "wrinkle": 1, "nodes": { "a": { "type": "no_such" } },
        "outputs": { "normal": { "from": "a.b" } } })",
                                        "x.json", *std::make_unique<Diagnostics>()));
    frame();
    frame();
    EXPECT_EQ(state.code.text.source, text);
    EXPECT_FALSE(state.code.problem.empty());
    start_code_export(state, folder.path() / "broken.glsl");
    play("finish\nassert status broken.glsl was not written, because the graph has errors.");
    EXPECT_FALSE(fs::exists(folder.path() / "broken.glsl"));
}

TEST_F(Headless, OfALongTextOnlyWhatIsSeenIsDrawn) {
    open(small_graph);
    std::string text;
    for (int i = 0; i < 10'000; ++i)
        text += "    vec3 value_" + std::to_string(i) + " = vec3(0.0);\n";
    state.code.text = lines_of(text);
    EXPECT_EQ(state.code.text.starts.size(), 10'000U);
    frame();
    size_t drawn = 0;
    for (const auto& [name, rect] : state.targets.all())
        drawn += name.starts_with("line:");
    EXPECT_GT(drawn, 10U);
    EXPECT_LT(drawn, 100U);
}

}  // namespace
}  // namespace wrinkle::editor
