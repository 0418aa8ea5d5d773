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
        EXPECT_EQ(survey.in_square + survey.without_area, survey.triangles) << shape.name;
        EXPECT_EQ(survey.square, glm::ivec2(0)) << shape.name;
        ASSERT_EQ(survey.udim_tiles.size(), 1U) << shape.name;
        EXPECT_EQ(udim_number(survey.udim_tiles[0]), 1001);
    }
}

TEST(UvSurvey, CountsWhatIsMirroredOutsideOrWithoutArea) {
    Mesh plane = *make_shape("plane");
    const size_t all = plane.triangle_count();
    for (glm::vec2& uv : plane.uvs[0])
        uv = glm::vec2(3 - uv.x, uv.y + 1);  // only touches the adjacent UDIM tiles
    UvSurvey survey = survey_uvs(plane);
    EXPECT_EQ(survey.mirrored, all);
    EXPECT_EQ(survey.in_square, all);
    EXPECT_EQ(survey.square, glm::ivec2(2, 1));
    ASSERT_EQ(survey.udim_tiles.size(), 1U);
    EXPECT_EQ(udim_number(survey.udim_tiles[0]), 1013);
    for (glm::vec2& uv : plane.uvs[0])
        uv.x -= 2.5F;
    survey = survey_uvs(plane);
    EXPECT_GT(survey.beyond_udim, 0U);
    EXPECT_EQ(udim_number(survey.udim_tiles[0]), 1011);
    for (glm::vec2& uv : plane.uvs[0])
        uv.x = 0.5F;
    survey = survey_uvs(plane);
    EXPECT_EQ(survey.without_area, all);
    EXPECT_TRUE(survey.udim_tiles.empty());
    plane.uvs[0][plane.indices[0]].x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(survey_uvs(plane).without_area, all);
    plane.uvs[0][plane.indices[0]].x = 1e30F;
    EXPECT_GT(survey_uvs(plane).beyond_udim, 0U);
}

// For each corner, a plane that covers `side` x `side` unit squares from there.
UvSurvey survey_at(const std::vector<glm::vec2>& corners, float side = 1) {
    Mesh mesh;
    const Mesh plane = *make_shape("plane");
    for (const glm::vec2 corner : corners) {
        const auto first = static_cast<uint32_t>(mesh.vertex_count());
        mesh.positions.insert(mesh.positions.end(), plane.positions.begin(), plane.positions.end());
        for (const glm::vec2 uv : plane.uvs[0])
            mesh.uvs[0].push_back(corner + uv * side);
        for (const uint32_t index : plane.indices)
            mesh.indices.push_back(first + index);
    }
    return survey_uvs(mesh);
}

std::vector<int> numbers(const UvSurvey& survey) {
    std::vector<int> result;
    for (const glm::ivec2 square : survey.udim_tiles)
        result.push_back(udim_number(square));
    return result;
}

TEST(UvSurvey, RowsCountDownwardWhereTheLayoutLiesBelowOne) {
    EXPECT_EQ(numbers(survey_at({{0, 0}, {3, 2}})), (std::vector{1001, 1024}));
    EXPECT_EQ(numbers(survey_at({{0, 0}, {3, -2}})), (std::vector{1001, 1024}));
    EXPECT_EQ(numbers(survey_at({{9, -898}})), std::vector{9990});
    EXPECT_EQ(numbers(survey_at({{9, 898}})), std::vector{9990});
    const UvSurvey both = survey_at({{0, 1}, {0, -1}, {-1, 0}, {10, 0}, {0, 899}});
    EXPECT_EQ(numbers(both), std::vector{1011});
    EXPECT_EQ(both.beyond_udim, both.triangles * 4 / 5);
    // The range is clamped to the squares that have UDIM numbers.
    const UvSurvey wide = survey_at({{-3, 0}}, 5);
    EXPECT_EQ(numbers(wide).front(), 1001);
    EXPECT_EQ(numbers(wide).back(), 1042);
}

TEST(UvSurvey, ALayoutInOneOtherSquareIsBakedThere) {
    EXPECT_EQ(survey_at({{-4, 7}}).square, glm::ivec2(-4, 7));
    EXPECT_EQ(survey_at({{0, -1}}).in_square, survey_at({{0, -1}}).triangles);
    EXPECT_EQ(survey_at({{0, -1}, {0, -2}}).square, glm::ivec2(0));
    EXPECT_EQ(survey_at({{0, -1}, {0, -2}}).in_square, 0U);
}

// Sides of length 2 over squares of side 1 and of side 1/3.
TEST(UvSurvey, TheLengthOfAUvUnitIsThatOfTheSurface) {
    Mesh plane = *make_shape("plane");
    EXPECT_NEAR(uv_length(plane), 2, 1e-6);
    EXPECT_NEAR(uv_length(*make_shape("cube")), 6, 1e-5);
    for (glm::vec2& uv : plane.uvs[0])
        uv = glm::vec2(-10 * uv.y, 10 * uv.x);
    EXPECT_NEAR(uv_length(plane), 0.2, 1e-6);
    for (glm::vec2& uv : plane.uvs[0])
        uv = glm::vec2(0.5F);
    EXPECT_EQ(uv_length(plane), 0);
    plane.uvs[0].clear();
    EXPECT_EQ(uv_length(plane), 0);
}

}  // namespace
}  // namespace wrinkle
