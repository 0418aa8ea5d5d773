// Tests of conversions against a second copy of the table of design §5: every pair of types.
#include "lower/conversion.h"

#include <gtest/gtest.h>

#include <map>

#include "lower/fixture.h"

namespace wrinkle {
namespace {

TEST(Conversion, AllPairs) {
    // From a row's type into a column's port: . same, r rename, g gray, d differentiate, a apply
    // frame, t take normal, n resolve, D and A the same and then resolve, - illegal.
    const std::map<std::string, std::string> table = {
        //             f234chDgnim
        {"float", /**/ ".---gr-dD--"},  {"vec2", /*     */ "-.---------"},
        {"vec3", /* */ "--.-r------"},  {"vec4", /*     */ "---.-------"},
        {"color", /**/ "--r-.------"},  {"height", /*   */ "r---g.-dD--"},
        {"derivative", "------.aA--"},  {"gradient", /* */ "-------.n--"},
        {"normal", /**/ "-------t.--"}, {"image", /*    */ "---------.-"},
        {"material", "----------."},
    };
    const std::vector<std::string> order = {"float",  "vec2",   "vec3",       "vec4",
                                            "color",  "height", "derivative", "gradient",
                                            "normal", "image",  "material"};
    const std::map<char, Conversion> meaning = {
        {'.', Conversion::same},
        {'r', Conversion::rename},
        {'g', Conversion::gray},
        {'d', Conversion::differentiate},
        {'a', Conversion::apply_frame},
        {'t', Conversion::take_normal},
        {'n', Conversion::resolve},
        {'D', Conversion::differentiate_and_resolve},
        {'A', Conversion::apply_frame_and_resolve},
        {'-', Conversion::illegal},
    };
    ASSERT_EQ(table.size(), size_t{port_type_count});
    for (const auto& [from, row] : table)
        for (size_t i = 0; i < order.size(); ++i)
            EXPECT_EQ(conversion(*port_type_named(from), *port_type_named(order[i])),
                      meaning.at(row[i]))
                << from << " -> " << order[i];
}

TEST(Conversion, NamesWhatIsAccepted) {
    using enum PortType;
    EXPECT_EQ(accepted_by(gradient_),
              (std::vector<PortType>{gradient_, float_, height_, derivative_, normal_}));
    EXPECT_EQ(accepted_by(vec2_), std::vector<PortType>{vec2_});
}

TEST(Conversion, NamesTheNearestAlternative) {
    EXPECT_EQ(alternative(PortType::vec2_, PortType::float_, {}), "it takes float or height");
    EXPECT_EQ(alternative(PortType::image_, PortType::color_, test::registry()),
              "it takes color, float, vec3 or height; node 'texture' makes color from image");
}

}  // namespace
}  // namespace wrinkle
