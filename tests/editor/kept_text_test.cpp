// Tests of the text delta between two snapshots, computed from their differences.
#include "editor/model/document/journaled_text.h"

#include "editor/model/document/text_delta.h"
#include "graph/edit.h"
#include "graph/read.h"
#include "graph/write.h"
#include "headless.h"
#include "random_graph.h"

namespace wrinkle::editor {
namespace {

Box note(const std::string& text) {
    Box box;
    box.id = "note";
    box.text = text;
    return box;
}

Node sum_node(const Document& document) {
    Node node;
    node.id = free_id(document, "n");
    node.type = "add";
    return node;
}

// For any two snapshots the delta converts the text of the first into that of the second.
TEST(JournaledText, FollowsAnySnapshot) {
    std::mt19937 random(11);
    Diagnostics ignored;
    std::vector<Document> all{{}, read_document(small_graph, "small.json", ignored)};
    all.push_back(
        read_document("{\"nodes\": 7, \"other\": [1], \"layout\": {\"a\": {}}}", "", ignored));
    all.push_back(set_name(all.back(), "no nodes"));
    for (int i = 0; i < 60; ++i) {
        const Document& last = all.back();
        const auto& nodes = last.nodes;
        const std::string id = nodes.empty() ? "" : nodes[random() % nodes.size()]->id;
        const Document next[] = {random_graph(random),
                                 remove_node(last, id),
                                 rename_node(last, id, free_id(last, "other")),
                                 set_value(last, id, "scale", json::Value::number(i)),
                                 move_node(last, id, i, 2),
                                 set_note(last, note(std::to_string(i))),
                                 add_node(last, sum_node(last), i, 0),
                                 set_name(last, std::to_string(i)),
                                 remove_output(last, "normal")};
        all.push_back(next[random() % std::size(next)]);
    }
    std::string text;
    JournaledText kept(all[0], text);
    for (int i = 0; i < 5000; ++i) {
        const Document& next = all[random() % all.size()];
        std::string delta;
        kept = kept.next(next, delta);
        const auto result = apply_text_delta(text, delta);
        ASSERT_TRUE(result);
        ASSERT_EQ(*result, write_document(next));
        text = *result;
    }
}

TEST(JournaledText, WritesNoMoreThanWhatDiffers) {
    std::mt19937 random(12);
    Document document = random_graph(random);
    for (int i = 0; i < 500; ++i)
        document = add_node(document, sum_node(document), i, 0);
    std::string text, delta;
    const JournaledText kept(document, text);
    const std::string id = document.nodes[200]->id;
    const auto size_after = [&](const Document& after) {
        (void)kept.next(after, delta);
        return delta.size();
    };
    EXPECT_LT(size_after(set_value(document, id, "b", json::Value::number(2))), 150U);
    EXPECT_LT(size_after(move_node(document, id, 1, 2)), 150U);
    EXPECT_LT(size_after(remove_node(document, id)), 200U);
}

}  // namespace
}  // namespace wrinkle::editor
