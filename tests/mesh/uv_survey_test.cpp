#include "mesh/uv_survey.h"

#include <gtest/gtest.h>

#include <limits>

#include "mesh/shapes.h"

namespace wrinkle {
namespace {

TEST(UvSurvey, ShapesLieInTheFirstSquareUnmirrored) {
    for (const Shape& shape : shapes()) {
        const UvSurvey survey = survey_uvs(shape.make());
        EXPECT_EQ(survey.mirrored, 0U) << shape.name;
        EXPECT_EQ(survey.beyond_udim, 0U) << shape.name;
        EXPECT_EQ(survey.first_square + survey.without_area, survey.triangles) << shape.name;
        ASSERT_EQ(survey.squares.size(), 1U) << shape.name;
        EXPECT_EQ(udim_number(survey.squares[0]), 1001);
    }
}

TEST(UvSurvey, CountsWhatIsMirroredOutsideOrWithoutArea) {
    Mesh plane = *make_shape("plane");
    const size_t all = plane.triangle_count();
    for (glm::vec2& uv : plane.uvs[0])
        uv = glm::vec2(3 - uv.x, uv.y + 1);  // touches the squares beside, no more
    UvSurvey survey = survey_uvs(plane);
    EXPECT_EQ(survey.mirrored, all);
    EXPECT_EQ(survey.first_square, 0U);
    ASSERT_EQ(survey.squares.size(), 1U);
    EXPECT_EQ(udim_number(survey.squares[0]), 1013);
    for (glm::vec2& uv : plane.uvs[0])
        uv.x -= 2.5F;
    survey = survey_uvs(plane);
    EXPECT_GT(survey.beyond_udim, 0U);
    EXPECT_EQ(udim_number(survey.squares[0]), 1011);
    for (glm::vec2& uv : plane.uvs[0])
        uv.x = 0.5F;
    survey = survey_uvs(plane);
    EXPECT_EQ(survey.without_area, all);
    EXPECT_TRUE(survey.squares.empty());
    plane.uvs[0][plane.indices[0]].x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(survey_uvs(plane).without_area, all);
    plane.uvs[0][plane.indices[0]].x = 1e30F;
    EXPECT_GT(survey_uvs(plane).beyond_udim, 0U);
}

}  // namespace
}  // namespace wrinkle
