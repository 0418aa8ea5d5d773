// Tests of each edit by the document it writes; parts that must not change are compared line by
// line.
#include "graph/edit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/text.h"
#include "graph/order.h"
#include "sample.h"

namespace wrinkle {
namespace {

using json::Value;

// Lines that differ, as "-old" and "+new"; for texts that differ in one contiguous range.
std::string diff(const std::string& before, const std::string& after) {
    const auto a = split(before, '\n');
    const auto b = split(after, '\n');
    size_t head = 0, tail = 0;
    while (head < a.size() && head < b.size() && a[head] == b[head])
        ++head;
    while (tail + head < std::min(a.size(), b.size()) &&
           a[a.size() - 1 - tail] == b[b.size() - 1 - tail])
        ++tail;
    std::string text;
    for (size_t i = head; i + tail < a.size(); ++i)
        text += "-" + std::string(a[i]) + "\n";
    for (size_t i = head; i + tail < b.size(); ++i)
        text += "+" + std::string(b[i]) + "\n";
    return text;
}

class Edit : public testing::Test {
protected:
    std::string after(const Document& edited) {
        EXPECT_EQ(write_document(sample), sample_text()) << "the original has changed";
        EXPECT_TRUE(edited.edited);
        return diff(sample_text(), write_document(edited));
    }
    void expect_unchanged(const Document& edited) {
        EXPECT_FALSE(edited.edited);
        EXPECT_TRUE(edited.nodes.same(sample.nodes));
        EXPECT_TRUE(edited.outputs.same(sample.outputs));
        EXPECT_TRUE(edited.positions.same(sample.positions));
        EXPECT_TRUE(edited.inputs.same(sample.inputs));
        EXPECT_EQ(write_document(edited), sample_text());
    }
    const Document sample = read_quietly(sample_text());
};

TEST_F(Edit, AValueIsOneLine) {
    EXPECT_EQ(after(set_value(sample, "weave", "scale", Value::string("surface"))),
              "-        \"scale\": \"unit\"\n+        \"scale\": \"surface\"\n");
    const std::string long_name(300, 'x');
    const std::string lines =
        after(set_value(sample, "base", "image", Value::string(long_name + ".png")));
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 2);
}

TEST_F(Edit, UntouchedNumbersKeepTheirSpelling) {
    EXPECT_EQ(after(set_value(sample, "tile", "scale",
                              Value::array(std::vector{Value::number(8), Value::number(2.5)}))),
              "-    \"tile\": { \"type\": \"uv_transform\", \"in\": { \"uv\": { \"from\": "
              "\"surface.uv1\" }, \"scale\": [8.0, 8] } },\n"
              "+    \"tile\": { \"type\": \"uv_transform\", \"in\": { \"uv\": { \"from\": "
              "\"surface.uv1\" }, \"scale\": [8.0, 2.5] } },\n");
}

TEST_F(Edit, AMoveTouchesOnlyLayout) {
    const Document moved = move_node(sample, "weave", 220, -3.25);
    EXPECT_EQ(after(moved), "-    \"weave\": [220.0, 140],\n+    \"weave\": [220.0, -3.25],\n");
    EXPECT_TRUE(moved.nodes.same(sample.nodes));
    EXPECT_TRUE(moved.outputs.same(sample.outputs));
    EXPECT_EQ(after(move_node(sample, "plain", 1, 2)), "+    \"plain\": [1, 2],\n");
}

TEST_F(Edit, OtherNodesAreShared) {
    const Document edited = mute_nodes(sample, {"sum"}, true);
    for (size_t i = 0; i < sample.nodes.size(); ++i)
        EXPECT_EQ(edited.nodes[i] == sample.nodes[i], sample.nodes[i]->id != "sum");
    EXPECT_TRUE(edited.positions.same(sample.positions));
}

TEST_F(Edit, NothingChangedIsTheSameDocument) {
    expect_unchanged(set_value(sample, "tile", "scale",
                               Value::array(std::vector{Value::number(8), Value::number(8)})));
    expect_unchanged(set_value(sample, "nobody", "scale", Value::number(1)));
    expect_unchanged(set_value(sample, "weave", "uv", sample.find("tile")->find("uv")->value));
    expect_unchanged(connect(sample, {"tile", "uv"}, "weave", "uv"));
    expect_unchanged(connect(sample, {"a.b", "uv"}, "weave", "uv"));
    expect_unchanged(disconnect(sample, "weave", "scale"));
    expect_unchanged(reset_value(sample, "weave", "absent"));
    expect_unchanged(mute_nodes(sample, {"weave"}, true));
    expect_unchanged(set_type(sample, "weave", "tangent_normal_map", 2));
    expect_unchanged(move_node(sample, "base", 0, 0));
    expect_unchanged(move_node(sample, "nobody", 1, 1));
    expect_unchanged(rename_node(sample, "base", "tile"));
    expect_unchanged(rename_node(sample, "base", "a.b"));
    expect_unchanged(remove_node(sample, "nobody"));
    expect_unchanged(add_node(sample, *sample.find("base")));
    expect_unchanged(set_output(sample, "normal", {"normal", "normal"}));
    expect_unchanged(remove_output(sample, "height"));
    expect_unchanged(set_graph_input(sample, *sample.inputs.find("amount")));
    expect_unchanged(set_box(sample, &Document::frames, *sample.frames.find("f1")));
    expect_unchanged(remove_box(sample, &Document::notes, "n2"));
    expect_unchanged(set_back_faces(sample, {}));
}

TEST_F(Edit, UndoIsTheOldSnapshot) {
    const Document edited = mute_nodes(sample, {"sum"}, true);
    EXPECT_NE(write_document(edited), sample_text());
    EXPECT_EQ(write_document(mute_nodes(edited, {"sum"}, false)), sample_text());
}

TEST_F(Edit, ConnectAndDisconnect) {
    const std::string line =
        "    \"normal\": { \"type\": \"resolve\", \"in\": { \"gradient\": { "
        "\"from\": \"";
    const Document connected = connect(sample, {"base", "gradient"}, "normal", "gradient");
    EXPECT_EQ(after(connected),
              "-" + line + "sum.gradient\" } } },\n" + "+" + line + "base.gradient\" } } },\n");
    EXPECT_EQ(after(disconnect(sample, "normal", "gradient")),
              "-" + line + "sum.gradient\" } } },\n+    \"normal\": { \"type\": \"resolve\" },\n");
    EXPECT_EQ(connected.find("normal")->find("gradient")->link, (Link{"base", "gradient"}));
}

TEST_F(Edit, LinksKeepTheirUnknownKeys) {
    const Document document = read_quietly(graph_of(
        R"("a": {"type": "t"}, "b": {"type": "t", "in": {"x": {"note": 1.0, "from": "a.y"}}})"));
    EXPECT_NE(
        write_document(rename_node(document, "a", "c")).find(R"({ "from": "c.y", "note": 1.0 })"),
        std::string::npos);
}

TEST_F(Edit, RemovingANodeTakesItsWires) {
    const Document edited = remove_node(sample, sample.find("normal")->id);
    EXPECT_EQ(edited.find("normal"), nullptr);
    EXPECT_TRUE(edited.outputs.empty());
    const Document more = remove_node(edited, "base");
    EXPECT_EQ(more.find("sum")->inputs.size(), 1u);
    EXPECT_EQ(more.positions.find("base"), nullptr);
    EXPECT_EQ(problems_of(write_document(more)), "");
    EXPECT_EQ(problems_of(write_document(edited)), "");
}

TEST_F(Edit, RenamingIsSeenEverywhere) {
    const Document edited = rename_node(sample, "normal", "bent");
    EXPECT_EQ(edited.nodes[5]->id, "bent");
    EXPECT_EQ(edited.outputs.find("normal")->from.link.text(), "bent.normal");
    const Document weave = rename_node(sample, "weave", "cloth");
    EXPECT_EQ(weave.find("softer")->find("gradient")->link.text(), "cloth.gradient");
    EXPECT_EQ(weave.positions.find("cloth")->x, 220);
    std::string text = write_document(weave);
    EXPECT_EQ(text.find("weave."), text.find("weave.png"));
    for (size_t at = text.find("cloth"); at != text.npos; at = text.find("cloth"))
        text.replace(at, 5, "weave");
    EXPECT_EQ(text, sample_text());
}

TEST_F(Edit, AddingNodes) {
    Node node;
    node.id = free_id(sample, "base");
    EXPECT_EQ(node.id, "base2");
    EXPECT_EQ(free_id(sample, "a.b"), "node");
    node.type = "noise";
    const Document edited = add_node(sample, node, 10, 20.5);
    EXPECT_EQ(edited.nodes[7]->id, "base2");
    EXPECT_EQ(edited.positions.find("base2")->y, 20.5);
    const Document wired = connect(set_value(edited, "base2", "scale", Value::single(0.1f)),
                                   {"base2", "height"}, "sum", "c");
    EXPECT_NE(write_document(wired).find(
                  "    \"base2\": { \"type\": \"noise\", \"in\": { \"scale\": 0.1 } }\n"),
              std::string::npos);
    EXPECT_EQ(problems_of(write_document(wired)), "");
}

TEST_F(Edit, Outputs) {
    EXPECT_EQ(after(set_output(sample, "normal", {"base", "normal"})),
              "-    \"normal\": { \"from\": \"normal.normal\" }\n"
              "+    \"normal\": { \"from\": \"base.normal\" }\n");
    EXPECT_EQ(after(set_output(sample, "height", {"input", "amount"})),
              "-    \"normal\": { \"from\": \"normal.normal\" }\n"
              "+    \"normal\": { \"from\": \"normal.normal\" },\n"
              "+    \"height\": { \"from\": \"input.amount\" }\n");
    EXPECT_TRUE(remove_output(sample, "normal").outputs.empty());
}

TEST_F(Edit, GraphInputs) {
    GraphInput input = *sample.inputs.find("amount");
    input.doc = "Less";
    EXPECT_EQ(
        after(set_graph_input(sample, input)),
        "-    \"amount\": { \"type\": \"float\", \"default\": 0.50, \"doc\": \"How strong\" }\n"
        "+    \"amount\": { \"type\": \"float\", \"default\": 0.50, \"doc\": \"Less\" }\n");
    Diagnostics diagnostics;
    Document without = sample;
    without.inputs = sample.inputs.without("amount");
    check_links(without, diagnostics);
    EXPECT_EQ(
        to_text(diagnostics),
        "g.json:20:103: error: node 'softer': the graph has no input 'amount' (declare it under "
        "\"inputs\")\n");
}

TEST_F(Edit, FramesAndNotes) {
    Box frame = *sample.frames.find("f1");
    frame.rect.width = 512;
    EXPECT_EQ(after(set_box(sample, &Document::frames, frame)),
              "-      \"f1\": { \"title\": \"Detail\", \"rect\": [0, 0, 400, 3e2] }\n"
              "+      \"f1\": { \"title\": \"Detail\", \"rect\": [0, 0, 512, 3e2] }\n");
    EXPECT_TRUE(set_box(sample, &Document::frames, frame).nodes.same(sample.nodes));
    EXPECT_TRUE(remove_box(sample, &Document::frames, "f1").frames.empty());
    Box note;
    note.id = "n2";
    note.text = "New";
    EXPECT_EQ(set_box(sample, &Document::notes, note).notes.size(), 2u);
    EXPECT_TRUE(remove_box(sample, &Document::notes, "n1").notes.empty());
}

TEST_F(Edit, NameAndBackFaces) {
    Document renamed = sample;
    renamed.name = "Strap";
    renamed.edited = true;
    EXPECT_EQ(after(renamed),
              "-  \"name\": \"Woven strap over a baked shape\",\n+  \"name\": \"Strap\",\n");
    EXPECT_EQ(after(set_back_faces(sample, BackFaces::none)), "+  \"back_faces\": \"none\",\n");
    EXPECT_EQ(after(set_back_faces(sample, BackFaces::mirror)), "+  \"back_faces\": \"mirror\",\n");
}

TEST_F(Edit, BrokenThingsAreReplacedByTheEdit) {
    const Document broken = read_quietly(
        R"({"wrinkle": 1, "name": 3, "outputs": 4, "nodes": {"a": {"type": 5, "in": 6}, "b": 7}})");
    Document edited = set_type(broken, "a", "t", 1);
    edited = set_value(edited, "a", "x", Value::number(1));
    edited = set_type(edited, "b", "u", 1);
    edited.name = "n";
    edited = set_output(edited, "o", {"a", "y"});
    EXPECT_EQ(problems_of(write_document(edited)), "");
}

TEST_F(Edit, WouldCycle) {
    EXPECT_TRUE(would_cycle(sample, {"normal", "normal"}, "base"));
    EXPECT_TRUE(would_cycle(sample, {"base", "gradient"}, "base"));
    EXPECT_FALSE(would_cycle(sample, {"base", "gradient"}, "normal"));
    EXPECT_FALSE(would_cycle(sample, {"surface", "uv0"}, "base"));
    EXPECT_FALSE(would_cycle(sample, {"nobody", "x"}, "base"));
    using Ids = std::set<std::string>;
    EXPECT_EQ(reachable(sample, {"softer"}, Direction::upstream), (Ids{"softer", "weave", "tile"}));
    EXPECT_EQ(reachable(sample, {"softer"}, Direction::downstream),
              (Ids{"softer", "sum", "normal"}));
    EXPECT_EQ(reachable(sample, {"nobody"}, Direction::upstream), Ids{"nobody"});
}

TEST_F(Edit, SeveralNodesAreOneEdit) {
    const Document removed = remove_nodes(sample, {"base", "weave", "surface", "nobody"});
    EXPECT_EQ(write_document(removed),
              write_document(remove_node(remove_node(sample, "weave"), "base")));
    EXPECT_TRUE(removed.find("tile")->find("uv")) << "what reads the surface stays";
    const Document moved = move_nodes(sample, {{"base", 0, 0}, {"sum", 3, 4}, {"weave", 1, 2}});
    EXPECT_EQ(after(moved), after(move_node(move_node(sample, "sum", 3, 4), "weave", 1, 2)));
    EXPECT_EQ(write_document(mute_nodes(sample, {"base", "weave"}, true)),
              write_document(mute_nodes(sample, {"base"}, true)));
    Node twice = *sample.find("plain");
    twice.id = free_id(sample, "plain", {"plain2"});
    EXPECT_EQ(twice.id, "plain3");
    const Document added = add_nodes(sample, {twice, twice}, {{"plain3", 8, 8}});
    EXPECT_EQ(write_document(added), write_document(add_node(sample, twice, 8, 8)));
    EXPECT_FALSE(remove_nodes(sample, {"surface", "nobody"}).edited);
    EXPECT_FALSE(move_nodes(sample, {{"base", 0, 0}}).edited);
    EXPECT_FALSE(mute_nodes(sample, {"weave"}, true).edited);
    EXPECT_FALSE(add_nodes(sample, {*sample.find("base")}, {}).edited);
}

TEST_F(Edit, UpgradesRenameEachSideAlone) {
    // An input and an output share the name: only the renamed side changes.
    const NodeUpgrade inputs{"tile", 2, {{"uv", "coordinates"}}, {}};
    const Document in = upgrade_nodes(sample, {inputs});
    EXPECT_EQ(in.find("tile")->inputs[0].port, "coordinates");
    EXPECT_EQ(in.find("tile")->version, 2);
    EXPECT_EQ(in.find("weave")->find("uv")->link.text(), "tile.uv");
    const NodeUpgrade outputs{"tile", 2, {}, {{"uv", "result"}, {"result", "tiled"}}};
    const Document out = upgrade_nodes(sample, {outputs});
    EXPECT_EQ(out.find("tile")->inputs[0].port, "uv");
    EXPECT_EQ(out.find("weave")->find("uv")->link.text(), "tile.tiled");
    const NodeUpgrade last{"normal", 1, {}, {{"normal", "bent"}}};
    EXPECT_EQ(upgrade_nodes(sample, {last}).outputs.find("normal")->from.link.text(),
              "normal.bent");
    // A missing port, a new name that is in use, and a missing node type.
    EXPECT_FALSE(upgrade_nodes(sample, {{"sum", 1, {{"c", "d"}, {"a", "b"}}, {}}}).edited);
    EXPECT_FALSE(upgrade_nodes(sample, {{"nobody", 9, {}, {}}}).edited);
}

// With one document per node this would take hours.
TEST_F(Edit, ManyNodesTakeOnePass) {
    std::vector<Node> nodes(100'000);
    std::vector<NodeUpgrade> upgrades;
    std::set<std::string> ids;
    for (size_t i = 0; i < nodes.size(); ++i) {
        nodes[i].id = "n" + std::to_string(i);
        ids.insert(nodes[i].id);
        upgrades.push_back({nodes[i].id, 2, {}, {}});
    }
    Document document = upgrade_nodes(add_nodes({}, std::move(nodes), {}), upgrades);
    EXPECT_EQ(document.nodes[99'999]->version, 2);
    document = mute_nodes(document, ids, true);
    EXPECT_TRUE(document.find("n50000")->muted);
    EXPECT_TRUE(remove_nodes(document, ids).nodes.empty());
}

}  // namespace
}  // namespace wrinkle
