// Tests of wrinkle import with documents that cannot be imported, in part or at all.
#include "materialx/support.h"

namespace wrinkle::test {
namespace {

class MaterialXBad : public MaterialXTest {
protected:
    void is_error(const std::string& text, const std::string& words) const {
        SCOPED_TRACE(text.substr(0, 300));
        const Ran ran = import(text);
        EXPECT_EQ(ran.code, 1) << ran.err;
        EXPECT_TRUE(says(ran.err, words));
        EXPECT_FALSE(exists("a.json"));
    }
    void is_warning(const std::string& text, const std::string& words) const {
        SCOPED_TRACE(text.substr(0, 300));
        const Ran ran = import(text);
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_TRUE(says(ran.err, words));
        EXPECT_EQ(run({"check", "a.json"}).code, 0);
    }
};

std::string colored(const std::string& elements) {
    return MaterialXTest::surface(elements,
                                  R"(<input name="base_color" type="color3" nodename="a"/>)");
}

TEST_F(MaterialXBad, TextsThatAreNoDocuments) {
    is_error("", "not XML");
    is_error("<materialx>", "a.mtlx:1:");
    is_error("<gltf/>", "the root element is <gltf>");
    is_error("<materialx version=\"1.39\"\xff/>", "not UTF-8");
    is_error("<materialx version=\"1.39\"/>", "has no surfacematerial");
    is_error("<materialx version=\"1.36\"/>", "the version '1.36'");
    is_error(R"(<!DOCTYPE m [<!ENTITY a "b"><!ENTITY c "&a;&a;">]><materialx>&c;</materialx>)",
             "document type declarations are not read");
    is_error(R"(<materialx version="1.39"><xi:include href="/etc/passwd"/></materialx>)",
             "includes '/etc/passwd'");
    std::string deep = "<materialx version=\"1.39\">";
    for (int i = 0; i < 100'000; ++i)
        deep += "<a>";
    for (int i = 0; i < 100'000; ++i)
        deep += "</a>";
    is_error(deep + "</materialx>", "more than 64 deep");
}

TEST_F(MaterialXBad, SizesHaveLimits) {
    put("a.mtlx", document_text("image"));
    const auto limited = [&](const char* limit) {
        const Ran ran = run({"import", "a.mtlx", "-o", "a.json"}, "", {limit});
        EXPECT_EQ(ran.code, 1);
        return ran.err;
    };
    EXPECT_TRUE(says(limited("WRINKLE_MATERIALX_MAX_BYTES=100"), "sets another limit"));
    EXPECT_TRUE(says(limited("WRINKLE_GRAPH_MAX_NODES=3"), "sets another limit"));
}

TEST_F(MaterialXBad, Connections) {
    is_error(colored(""), "connected to the node 'a', which does not exist");
    is_error(colored(R"(<add name="a" type="color3"><input name="in1" type="color3" nodename="b"/>
      </add><add name="b" type="color3"><input name="in1" type="color3" nodename="a"/></add>)"),
             "connected to itself");
    is_error(colored(R"(<add name="a" type="float"/>)"), "is a float");
    is_error(colored(R"(<add name="a" type="color3"><input name="in1" type="color3" value="1"/>
      </add>)"),
             "'1' is not a color3");
    is_error(colored(R"(<constant name="a" type="color3">
      <input name="value" type="color3" value="1e999, 0, 0"/></constant>)"),
             "is not a color3");
    is_error(colored(R"(<add name="a" type="color3"/><add name="a" type="color3"/>)"),
             "'a' is the name of two elements");
    is_error(R"(<materialx version="1.39"><nodegraph name="N">
      <input name="x" type="color3" nodegraph="N" output="o"/>
      <output name="o" type="color3" interfacename="x"/></nodegraph>
      <open_pbr_surface name="Surface" type="surfaceshader">
      <input name="base_color" type="color3" nodegraph="N" output="o"/></open_pbr_surface>
      </materialx>)",
             "in a circle");
}

TEST_F(MaterialXBad, NodesWithoutAnEquivalent) {
    is_error(colored(R"(<blur name="a" type="color3"/>)"), "the node category 'blur'");
    is_error(colored(R"(<image name="a" type="color3">
      <input name="file" type="filename" value="gone.png"/></image>)"),
             "'gone.png' does not exist");
    is_error(colored(R"(<image name="a" type="color3">
      <input name="file" type="filename" value="a.&lt;UDIM&gt;.png"/></image>)"),
             "names several files");
    is_error(colored(R"(<image name="a" type="color3">
      <input name="file" type="filename" value="color.png" colorspace="acescg"/></image>)"),
             "the color space 'acescg'");
    is_warning(surface("", R"(<input name="wetness" type="float" value="0.5"/>)"),
               "input 'wetness'");
    is_warning(surface(R"(<look name="l"/>)", ""), "does not use 1 'look'");
    is_warning(colored(R"(<noise2d name="a" type="color3"/>)"), "other random numbers");
}

TEST_F(MaterialXBad, ThousandsOfNodesAreImported) {
    std::string nodes = R"(<constant name="n0" type="float"/>)";
    for (int i = 1; i <= 10'000; ++i)
        nodes += R"(<sin name="n)" + std::to_string(i) +
                 R"(" type="float"><input name="in" type="float" nodename="n)" +
                 std::to_string(i - 1) + R"("/></sin>)";
    const Ran ran =
        import(surface(nodes, R"(<input name="base_metalness" type="float" nodename="n10000"/>)"));
    EXPECT_EQ(ran.code, 0) << ran.err.substr(0, 1000);
}

TEST_F(MaterialXBad, Choices) {
    const std::string two = R"(<materialx version="1.39">
      <open_pbr_surface name="s" type="surfaceshader"/>
      <surfacematerial name="wood" type="material">
      <input name="surfaceshader" type="surfaceshader" nodename="s"/></surfacematerial>
      <surfacematerial name="iron" type="material">
      <input name="surfaceshader" type="surfaceshader" nodename="s"/></surfacematerial>
      </materialx>)";
    is_error(two, "--material: wood, iron");
    EXPECT_TRUE(says(import(two, {"--material", "irn"}).err, "did you mean 'iron'?"));
    EXPECT_EQ(run({"import", ".", "-o", "a.json", "--material", "iron"}).code, 2);
    EXPECT_EQ(import(two, {"--height", "1"}).code, 2);
}

}  // namespace
}  // namespace wrinkle::test
