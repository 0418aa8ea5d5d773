// Tests of statement order, and of very large graphs.
#include <gtest/gtest.h>

#include "glslang/validate.h"
#include "graphs.h"
#include "ir/expand.h"

namespace wrinkle::test {
namespace {

size_t count(const std::string& text, const std::string& word) {
    size_t found = 0;
    for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++found;
    return found;
}

TEST(Schedule, statements_of_a_node_stand_together) {
    Module m;
    const Id x = m.swizzle(m.input(SurfaceInput::position_), "x");
    std::array<Id, 3> first{}, second{};
    for (size_t k = 0; k < 3; ++k) {  // recorded alternately
        node(m, "one", "First");
        first[k] = m.add(Op::sin_, {m.add(Op::mul_, {x, m.number(2.5 + static_cast<double>(k))})});
        node(m, "two", "Second");
        second[k] = m.add(Op::cos_, {m.add(Op::add_, {x, m.number(2.5 + static_cast<double>(k))})});
    }
    node(m, "end", "Sum");
    Id sum = x;
    for (size_t k = 0; k < 3; ++k)
        for (const Id value : {first[k], second[k]})
            sum = m.add(Op::add_, {sum, m.add(Op::mul_, {value, value})});
    output(m, "o", sum);
    const std::string text = emit(m, {}).source;
    EXPECT_EQ(count(text, "// one: First"), 1u) << text;
    EXPECT_EQ(count(text, "// two: Second"), 1u) << text;
    EXPECT_EQ(text.find("continued"), std::string::npos) << text;
    EXPECT_LT(text.find("// one"), text.find("// two"));
}

// The depth-first search visits the first statement of "one" before that of "two", which the second
// statement of "one" uses.
TEST(Schedule, a_node_waits_until_it_can_stand_whole) {
    Module m;
    const Id x = m.swizzle(m.input(SurfaceInput::position_), "x");
    const uint32_t one = node(m, "one", "First");
    const Id early = m.add(Op::sin_, {x});
    node(m, "two", "Second");
    const Id other = m.add(Op::cos_, {x});
    m.current_node = one;
    const Id late = m.add(Op::exp_, {other});
    node(m, "end", "Sum");
    const auto square = [&](Id v) { return m.add(Op::mul_, {v, v}); };
    const Id first = m.add(Op::add_, {square(early), square(late)});
    output(m, "o", m.add(Op::add_, {first, square(other)}));
    const std::string text = emit(m, {}).source;
    EXPECT_EQ(text.find("continued"), std::string::npos) << text;
    EXPECT_LT(text.find("// two"), text.find("// one")) << text;
}

TEST(Schedule, nodes_that_need_each_other_still_come_in_order) {
    Module m;
    const Id x = m.swizzle(m.input(SurfaceInput::position_), "x");
    node(m, "a", "A");
    const Id a1 = m.add(Op::sin_, {x});
    node(m, "b", "B");
    const Id b1 = m.add(Op::cos_, {a1});
    node(m, "a", "A");
    const Id a2 = m.add(Op::exp_, {b1});
    node(m, "b", "B");
    const Id b2 = m.add(Op::tan_, {a2});
    const auto square = [&](Id v) { return m.add(Op::mul_, {v, v}); };
    output(m, "o",
           m.add(Op::add_, {m.add(Op::add_, {square(a1), square(b1)}),
                            m.add(Op::add_, {square(a2), square(b2)})}));
    const Shader shader = emit(m, {});
    EXPECT_EQ(compile_errors(shader), "");
    EXPECT_NE(shader.source.find("(continued)"), std::string::npos);
}

TEST(Schedule, a_chain_of_100000_nodes) {
    Module m;
    Id value = m.swizzle(m.input(SurfaceInput::position_), "x");
    for (int k = 0; k < 100000; ++k) {
        m.nodes.push_back({"n" + std::to_string(k), m.titles.add("Sine")});
        m.current_node = static_cast<uint32_t>(m.nodes.size() - 1);
        value = m.add(Op::sin_, {m.add(Op::add_, {value, m.number(0.5)})});
        name(m, "out", value);
    }
    output(m, "o", value);
    const Shader shader = emit(m, {});
    EXPECT_EQ(count(shader.source, "sin("), 100000u);
    EXPECT_EQ(shader.reflection.node_paths[shader.reflection.lines[5000]].substr(0, 1), "n");
}

TEST(Schedule, equal_names_by_the_ten_thousand) {
    Module m;
    Id sum = m.swizzle(m.input(SurfaceInput::position_), "x");
    for (int k = 0; k < 10000; ++k) {
        m.nodes.push_back({"same", m.titles.add("Sine")});
        m.current_node = static_cast<uint32_t>(m.nodes.size() - 1);
        const Id value = m.add(Op::sin_, {m.add(Op::mul_, {sum, parameter(m, "amount", k)})});
        sum = m.add(Op::add_, {value, m.add(Op::mul_, {value, value})});
    }
    output(m, "o", sum);
    EXPECT_NE(emit(m, {}).source.find("same_amount_10000"), std::string::npos);
}

TEST(Schedule, ten_thousand_layers) {
    Module m;
    Id sum = poison;
    for (int k = 0; k < 10000; ++k) {
        m.nodes.push_back({"layer" + std::to_string(k), m.titles.add("Tangent normal map")});
        m.current_node = static_cast<uint32_t>(m.nodes.size() - 1);
        const Id uv = m.add(Op::mul_, {m.input(SurfaceInput::uv0_), m.number(1 + k)});
        const Id texel = image(m, "image", "a.png", uv);
        const Id frame = m.add(Op::frame_, {uv}, WR_FRAME(WR_FRAME_auto, WR_SCALE_unit));
        const Id derivative =
            m.add(Op::normal_derivative_, {m.swizzle(texel, "xyz"), m.number(1), frame});
        const Id gradient = m.add(Op::gradient_from_derivative_, {derivative}, poison);
        sum = sum == poison ? gradient : m.add(Op::gradient_add_, {sum, gradient});
    }
    output(m, "normal", m.add(Op::resolve_, {sum}, 1), WR_PORT_normal);
    const Shader shader = emit(expand(m, {}), {});
    EXPECT_EQ(count(shader.source, "texture("), 10000u);
}

}  // namespace
}  // namespace wrinkle::test
