// Tests that replace every string of a graph and of its sub-graph by every payload. In the code of
// the generated source, the payload must become an identifier or be absent.
#include <algorithm>
#include <cctype>
#include <map>

#include "base/text.h"
#include "hostile/payloads.h"
#include "hostile/support.h"

namespace wrinkle::hostile {
namespace {

const std::string graph = R"({
  "$schema": "schema.json",
  "wrinkle": 1,
  "name": "A material",
  "inputs": { "strength": { "type": "float", "default": 1, "doc": "How strong", "renamed": ["force"] } },
  "presets": { "Strong": { "force": 2 } },
  "nodes": {
    "base": { "type": "tangent_normal_map", "in": { "image": "base.png" } },
    "detail": {
      "type": "height_map",
      "in": {
        "image": { "file": "base.png", "encoding": "linear", "wrap": "repeat", "filter": "linear" },
        "uv": { "from": "surface.uv1" },
        "amplitude": 2,
        "scale": "surface"
      }
    },
    "inner": { "type": "graph:inner.json", "in": { "size": { "from": "input.strength" } } },
    "noise": { "type": "gradient_noise", "version": 1, "in": { "scale": 12 } },
    "sum": { "type": "gradient_add", "in": { "a": { "from": "base.gradient" }, "b": { "from": "detail.gradient" } } },
    "more": { "type": "gradient_add", "in": { "a": { "from": "sum.gradient" }, "b": { "from": "inner.bump" } } },
    "last": { "type": "gradient_add", "in": { "a": { "from": "more.gradient" }, "b": { "from": "noise.height" } } },
    "normal": { "type": "resolve", "in": { "gradient": { "from": "last.gradient" } } }
  },
  "outputs": { "normal": { "from": "normal.normal" }, "own": { "from": "noise.height" } },
  "back_faces": "mirror",
  "layout": {
    "base": [0, 0],
    "$frames": { "frame": { "title": "Layers", "rect": [0, 0, 10, 10] } },
    "$notes": { "note": { "text": "A note", "rect": [0, 0, 10, 10] } }
  }
}
)";

const std::string inner = R"({
  "wrinkle": 1,
  "name": "Inside",
  "inputs": { "amount": { "type": "float", "default": 1, "doc": "Its amount", "renamed": ["size"] } },
  "nodes": {
    "dots": { "type": "domes", "in": { "amplitude": { "from": "input.amount" } } }
  },
  "outputs": { "bump": { "from": "dots.height" } }
}
)";

// A string of a JSON text without escapes: first character after the quote, and closing quote.
struct Range {
    size_t begin = 0, end = 0;
};
std::vector<Range> strings_of(const std::string& text) {
    std::vector<Range> found;
    for (size_t at = text.find('"'); at != text.npos; at = text.find('"', at + 1)) {
        const size_t end = text.find('"', at + 1);
        found.push_back({at + 1, end});
        at = end;
    }
    return found;
}

// Returns the payload as written between quotes: escaped, or raw if it is not UTF-8.
std::string inside_quotes(const std::string& payload) {
    if (!is_utf8(payload)) return payload;
    const std::string quoted = json_quoted(payload);
    return quoted.substr(1, quoted.size() - 2);
}

std::string replaced(std::string text, const Range& range, const std::string& payload) {
    return text.replace(range.begin, range.end - range.begin, inside_quotes(payload));
}

// Replaces every use of a name, so that the graph remains consistent.
std::string renamed(const std::string& text, const std::string& name, const std::string& payload) {
    std::string result;
    for (size_t at = 0; at < text.size();) {
        const bool quoted = text.compare(at, name.size() + 1, "\"" + name) == 0;
        const char after = quoted ? text[at + name.size() + 1] : 0;
        if (quoted && (after == '"' || after == '.')) {
            result += "\"" + inside_quotes(payload);
            at += name.size() + 1;
        } else {
            result += text[at++];
        }
    }
    return result;
}

void skip_comment(const std::string& text, size_t& at) {
    if (text.compare(at, 2, "/*") == 0) {
        at = std::min(text.find("*/", at + 2), text.size() - 2) + 2;
        return;
    }
    // A backslash at the end of a line continues the comment.
    while (at < text.size() && (text[at] != '\n' || text[at - 1] == '\\'))
        ++at;
}

std::string without_comments(const std::string& text) {
    std::string result;
    for (size_t at = 0; at < text.size();) {
        if (text.compare(at, 2, "//") == 0 || text.compare(at, 2, "/*") == 0)
            skip_comment(text, at);
        else
            result += text[at++];
    }
    return result;
}

std::set<std::string> words_of(const std::string& text) {
    std::set<std::string> words;
    std::string word;
    for (const char c : text + " ") {
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') {
            word += c;
        } else {
            if (!word.empty()) words.insert(word);
            word.clear();
        }
    }
    return words;
}

// Returns the first element in the code of `text` that comes from the payload and is not an
// identifier made of the complete payload; "" if there is none. `harmless` is the source generated
// with that identifier. Comments may move line breaks, and thus temporaries, but not braces,
// directives or foreign words.
std::string injected(const std::string& text, const std::string& harmless,
                     const std::string& payload) {
    const std::string code = without_comments(text), expected = without_comments(harmless);
    for (const char c : std::string_view("{}#\\$@\"'`"))
        if (std::count(code.begin(), code.end(), c) !=
            std::count(expected.begin(), expected.end(), c))
            return std::string("another number of ") + c;
    const auto found = words_of(code), known = words_of(expected);
    for (const std::string& word : words_of(payload))
        if (word != identifier(payload) && found.contains(word) && !known.contains(word))
            return "the word " + word;
    return "";
}

class HostileStrings : public HostileTest {
protected:
    void SetUp() override {
        HostileTest::SetUp();
        put("inner.json", inner);
        put("graph.json", graph);
        fs::copy_file(WRINKLE_SOURCE_DIR "/graphs/textures/weave_normal.png", folder / "base.png");
        fs::create_symlink("../outside", folder / "link_out");
        fs::create_symlink("../outside/secret.json", folder / "secret_link.json");
        fs::create_directory(folder / "out");
        baseline();
        ASSERT_NE(compiled("the graph itself", "glsl330"), "");
    }

    // Returns the generated source; "" if compilation failed.
    std::string compiled(const std::string& label, const std::string& target) {
        clean();
        const Ran ran = attack(label,
                               {"compile", "graph.json", "-o", "out/text.glsl", "--target", target,
                                "--reflect", "out/reflection.json", "-MD", "-MF", "out/text.d",
                                "--diagnostics", cases % 2 == 0 ? "json" : "text"},
                               {"out"});
        if (ran.code != 0) return "";
        test::parsed(get("out/reflection.json"));
        return get("out/text.glsl");
    }

    // Runs another command; successive calls cycle through the list. A third of the payloads of a
    // position run one: each position is run with each command twice.
    void run_another(const std::string& label) {
        static const std::vector<std::vector<std::string>> commands = {
            {"check", "graph.json"},
            {"check", "graph.json", "--diagnostics", "json"},
            {"inputs", "graph.json", "--json"},
            {"inputs", "graph.json"},
            {"compile", "graph.json", "--cost"},
            {"compile", "graph.json", "--cost", "--json"},
            {"compile", "graph.json", "-o", "out/text.glsl", "--form", "shader", "--params",
             "uniform"},
            {"eval", "graph.json", "--mesh", "sphere", "--uv", "0.3,0.4"},
            {"format", "graph.json", "--check"},
            {"upgrade", "graph.json", "--check"},
        };
        clean();
        attack(label, commands[turn_++ % commands.size()], {"out"});
    }

    // `write` stores one payload at the position.
    template <class Write>
    void attack_position(const std::string& position, const Write& write) {
        static const std::vector<std::string> targets = {"glsl330", "glsl450", "essl300"};
        const std::string& target = targets[position_++ % targets.size()];
        std::map<std::string, std::string> harmless;  // source by identifier
        for (size_t i = position_ % stride; i < payloads().size(); i += stride) {
            const std::string label = position + ": payload " + std::to_string(i);
            write(payloads()[i]);
            const std::string text = compiled(label, target);
            if ((i + position_) % 3 == 0) run_another(label);
            if (text.empty()) continue;
            const std::string name = identifier(payloads()[i]);
            if (!harmless.contains(name)) {
                write(name);
                harmless[name] = compiled(position + ": harmless", target);
            }
            if (harmless[name].empty()) continue;
            ++compared_;
            EXPECT_EQ(injected(text, harmless[name], payloads()[i]), "") << label << text;
        }
    }

    static constexpr size_t stride = WRINKLE_PAYLOAD_STRIDE;

    size_t compared_ = 0;

private:
    size_t turn_ = 0, position_ = 0;
};

TEST_F(HostileStrings, InEveryPositionOfAGraphChangeOnlyCommentsAndIdentifiers) {
    for (const Range& range : strings_of(graph)) {
        const std::string position = graph.substr(range.begin, range.end - range.begin);
        attack_position("graph \"" + position + "\"", [&](const std::string& payload) {
            put("graph.json", replaced(graph, range, payload));
        });
    }
    put("graph.json", graph);
    EXPECT_GE(cases, 6000 / stride);
    EXPECT_GE(compared_, 600 / stride);
}

TEST_F(HostileStrings, InEveryPositionOfASubGraphChangeOnlyCommentsAndIdentifiers) {
    for (const Range& range : strings_of(inner)) {
        const std::string position = inner.substr(range.begin, range.end - range.begin);
        attack_position("inner \"" + position + "\"", [&](const std::string& payload) {
            put("inner.json", replaced(inner, range, payload));
        });
    }
}

TEST_F(HostileStrings, AsNamesThatAreUsedEverywhereChangeOnlyCommentsAndIdentifiers) {
    for (const std::string name : {"base", "detail", "inner", "noise", "sum", "normal", "own"})
        attack_position("name " + name, [&](const std::string& payload) {
            put("graph.json", renamed(graph, name, payload));
        });
    put("graph.json", graph);
    for (const std::string name : {"amount", "size", "dots", "bump"})
        attack_position("inner name " + name, [&](const std::string& payload) {
            put("inner.json", renamed(inner, name, payload));
            put("graph.json", renamed(graph, name, payload));
        });
}

}  // namespace
}  // namespace wrinkle::hostile
