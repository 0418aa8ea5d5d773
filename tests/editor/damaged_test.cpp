// Tests of damaged graphs: they are opened, displayed and saved under another name without a crash;
// unknown content is retained; a file that cannot be read completely is not overwritten.
// WRINKLE_DAMAGED sets the number of graphs; default: 150.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <random>

#include "editor/model/document/files.h"
#include "editor/view/lifecycle.h"
#include "graph/edit.h"
#include "graph/read.h"
#include "graph/write.h"
#include "headless.h"
#include "json/parse.h"
#include "json/write.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> sample_texts() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(WRINKLE_SOURCE_DIR "/graphs"))
        if (entry.path().extension() == ".json" && entry.file_size() < 20'000)
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<std::string> texts;
    for (const fs::path& file : files)
        texts.push_back(text_of(file));
    return texts;
}

class Damage {
public:
    Damage(unsigned seed, std::vector<std::string> samples)
        : random_(seed), samples_(std::move(samples)) {}

    std::string next() {
        std::string text = samples_[pick(samples_.size())];
        for (size_t n = 1 + pick(3); n > 0 && !text.empty(); --n)
            once(text);
        return text;
    }

private:
    size_t pick(size_t count) { return random_() % count; }

    // Returns position and length of a complete "key" or "text" of the graph, without quotes; {0,
    // 0} if none is found.
    std::pair<size_t, size_t> some_word(const std::string& text) {
        const size_t first = text.find('"', pick(text.size()));
        const size_t last = first == text.npos ? first : text.find('"', first + 1);
        if (last == text.npos) return {0, 0};
        return {first + 1, last - first - 1};
    }
    void once(std::string& text) {
        static const std::vector<std::string> things = {"\"\"",
                                                        "null",
                                                        "1e999",
                                                        "-0",
                                                        "{}",
                                                        "[]",
                                                        "[[[[",
                                                        "\"\\u0000\"",
                                                        "\"\xFF\"",
                                                        "NaN",
                                                        "{\"from\": \"surface.normal\"}",
                                                        "\"graph:graph.json\"",
                                                        "123456789012345678901234567890",
                                                        "{\"from\": 3}",
                                                        "\"../../../../etc/passwd\"",
                                                        "\"graph:/dev/zero\""};
        const size_t at = pick(text.size());
        const auto [word, length] = some_word(text);
        switch (pick(16)) {
            case 0:
                text[at] = static_cast<char>(random_());
                return;
            case 1:
                text.erase(at, 1 + pick(40));
                return;
            case 2:
                text.insert(at, text.substr(pick(text.size()), 1 + pick(80)));
                return;
            case 3:
                if (pick(3) == 0) text.resize(at);
                return;
            case 4:
                text.insert(at, things[pick(things.size())]);
                return;
            case 5:
            case 6:
            case 7:
            case 8:  // an unknown type, key or node
                text.replace(word, length, "acme " + std::to_string(pick(9)));
                return;
            case 9:
            case 10:
            case 11: {  // one word replaced by another
                const auto [other, size] = some_word(text);
                text.replace(word, length, text.substr(other, size));
                return;
            }
            default: {  // another value after a colon
                const size_t colon = text.find(": ", at);
                const size_t end = text.find_first_of(",}\n", colon);
                if (end != text.npos)
                    text.replace(colon + 2, end - colon - 2, things[pick(things.size())]);
            }
        }
    }

    std::mt19937 random_;
    std::vector<std::string> samples_;
};

// Checks that every node of an unknown type has the same members in both texts; returns the number
// of these nodes.
size_t expect_unknown_nodes_kept(const Document& document, const std::string& saved) {
    Diagnostics ignored;
    const Document again = read_document(saved, "again.json", ignored);
    size_t unknown = 0;
    for (const NodePtr& node : document.nodes) {
        if (built_in_registry().find(node->type) || !node->source.is(json::Kind::object)) continue;
        ++unknown;
        const Node* kept = again.find(node->id);
        EXPECT_TRUE(kept) << node->id << " is lost";
        if (!kept) continue;
        EXPECT_EQ(kept->source.size(), node->source.size()) << node->id;
        for (const json::Member& member : node->source.children())
            EXPECT_EQ(json::one_line(kept->source.find(member.key)), json::one_line(member.value))
                << node->id << " " << member.key;
    }
    return unknown;
}

TEST(Document, AnEmptyTypeIsKept) {
    const std::string text = R"({ "wrinkle": 1, "nodes": { "a": { "type": "" } } })";
    Diagnostics problems;
    const Document document = read_document(text, "graph.json", problems);
    EXPECT_EQ(problems.error_count(), 1U) << to_text(problems);
    EXPECT_EQ(expect_unknown_nodes_kept(document,
                                        write_document(set_back_faces(document, BackFaces::none))),
              1U);
}

TEST_F(Headless, AGraphThatHoldsItselfIsOpened) {
    open(R"({"wrinkle": 1, "nodes": {"self": {"type": "graph:graph.json"}},
             "outputs": {"normal": {"from": "self.normal"}}})");
    EXPECT_TRUE(state.built.problems.has_errors());
    EXPECT_FALSE(state.built.uniform);
}

TEST_F(Headless, DamagedGraphsAreOpenedKeptAndNotOverwritten) {
    const char* wanted = std::getenv("WRINKLE_DAMAGED");
    const int count = wanted ? std::atoi(wanted) : 150;
    Damage damage(9, sample_texts());
    const fs::path other = folder.path() / "other.json";
    size_t unknown = 0, refused = 0, whole = 0;
    file = folder.path() / "graph.json";
    for (int i = 0; i < count; ++i) {
        const std::string text = damage.next();
        SCOPED_TRACE("number " + std::to_string(i));
        std::ofstream(folder.path() / "last.txt", std::ios::binary) << text;
        folder.write("graph.json", text);
        open_file(state, file);
        const Document document = state.document();
        frame();
        // After an edit the text is generated again.
        if (i % 2 && !document.nodes.empty())
            state.commit("Faces", set_back_faces(document, BackFaces::none));
        frame();
        const bool lossy = !state.save_refused.empty();
        (lossy ? refused : whole) += 1;
        EXPECT_NE(save_file(state), lossy) << state.status;
        if (lossy) {
            EXPECT_EQ(text_of(file), text) << "what was not read is written over";
        }
        ASSERT_TRUE(save_file_as(state, other)) << state.status;
        if (!lossy) unknown += expect_unknown_nodes_kept(document, text_of(other));
        frame();
        finish(state);
        if (HasFailure()) {
            std::printf("%s\n", text.c_str());
            return;
        }
    }
    std::printf("%d damaged graphs: %zu whole, %zu not written over, %zu unknown nodes kept\n",
                count, whole, refused, unknown);
    EXPECT_GT(refused, 0U);
    EXPECT_GT(whole, 0U);
    EXPECT_GT(unknown, 0U);
}

}  // namespace
}  // namespace wrinkle::editor
