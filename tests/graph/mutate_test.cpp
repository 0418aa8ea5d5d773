// Tests of reading and editing with corrupted texts and random edits, with fixed seeds.
#include <gtest/gtest.h>

#include <random>

#include "graph/edit.h"
#include "graph/order.h"
#include "sample.h"

namespace wrinkle {
namespace {

using Random = std::mt19937;

size_t below(Random& random, size_t limit) {
    return limit == 0 ? 0 : random() % limit;
}

const char* token(Random& random) {
    static constexpr const char* tokens[] = {"{",           "}",
                                             "[",           "]",
                                             ",",           ":",
                                             "\"",          "null",
                                             "true",        "-1e5",
                                             "1e999",       "NaN",
                                             "\\",          "\\ud800",
                                             "\"from\"",    "\"type\"",
                                             "\"in\"",      "\"base\"",
                                             "\"a.b\"",     "\xFF",
                                             "\xC3",        "\"nodes\"",
                                             "\"$frames\"", "\"rect\"",
                                             "\"input.x\"", "\"weave\": {}",
                                             "[[[[",        "\n"};
    return tokens[below(random, std::size(tokens))];
}

// Cuts, copies, swaps or inserts one token at a random offset.
void mutate(std::string& text, Random& random) {
    const size_t at = below(random, text.size());
    const size_t length = below(random, 40);
    switch (below(random, 4)) {
        case 0:
            text.erase(at, length);
            break;
        case 1:
            text.insert(at, text.substr(below(random, text.size()), length));
            break;
        case 2:
            text.insert(at, token(random));
            break;
        default:
            text.replace(at, length, text.substr(below(random, text.size()), length));
    }
}

TEST(Mutate, TextsAreReadOrReportedAndNeverLost) {
    Random random(1);
    size_t good = 0;
    for (int round = 0; round < 20000; ++round) {
        std::string text = sample_text();
        for (size_t k = below(random, 4) + 1; k > 0; --k)
            mutate(text, random);
        Diagnostics diagnostics;
        const Document document = read_document(text, "g.json", diagnostics);
        ASSERT_EQ(write_document(document), text);
        const std::string canonical = canonical_text(document);
        for (const Diagnostic& diagnostic : diagnostics.list())
            ASSERT_GE(diagnostic.where.line, 1u) << text;
        if (diagnostics.has_errors()) continue;
        ++good;
        ASSERT_EQ(problems_of(canonical), "") << text;
        ASSERT_EQ(canonical_text(read_quietly(canonical)), canonical) << text;
    }
    EXPECT_GT(good, 500u);
    EXPECT_LT(good, 19000u);
}

Link some_link(const Document& document, Random& random) {
    if (document.nodes.empty() || below(random, 8) == 0) return {"surface", "uv0"};
    return {document.nodes[below(random, document.nodes.size())]->id, "out"};
}

Document edit_somehow(const Document& d, Random& random) {
    const std::string port = "p" + std::to_string(below(random, 4));
    if (d.nodes.size() < 3) {
        Node node;
        node.id = free_id(d, "new");
        node.type = "t";
        return add_node(d, node, 1, 2);
    }
    const std::string id = d.nodes[below(random, d.nodes.size())]->id;
    const Link link = some_link(d, random);
    switch (below(random, 9)) {
        case 0:
            return remove_node(d, id);
        case 1:
            return rename_node(d, id, free_id(d, "named"));
        case 2:
            return would_cycle(d, link, id) ? d : connect(d, link, id, port);
        case 3:
            return disconnect(d, id, port);
        case 4:
            return set_value(d, id, port, json::Value::number(static_cast<double>(random())));
        case 5:
            return mute_nodes(d, {id}, below(random, 2) == 0);
        case 6:
            return move_node(d, id, static_cast<double>(below(random, 100)), 0.5);
        case 7:
            return set_output(d, "o" + port, link);
        default: {
            Node node;
            node.id = free_id(d, "node");
            node.type = "t";
            return add_node(d, node);
        }
    }
}

TEST(Mutate, EditsKeepDocumentsValidAndOldSnapshotsAsTheyWere) {
    Random random(2);
    std::vector<Document> history{read_quietly(sample_text())};
    std::vector<std::string> texts{write_document(history[0])};
    for (int round = 0; round < 2000; ++round) {
        history.push_back(edit_somehow(history.back(), random));
        texts.push_back(write_document(history.back()));
        ASSERT_EQ(problems_of(texts.back()), "") << texts.back();
        Diagnostics diagnostics;
        check_links(history.back(), diagnostics);
        ASSERT_EQ(to_text(diagnostics), "");
    }
    for (size_t i = 0; i < history.size(); ++i)
        ASSERT_EQ(write_document(history[i]), texts[i]);
}

}  // namespace
}  // namespace wrinkle
