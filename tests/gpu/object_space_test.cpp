#include "gpu/object_space.h"

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "mesh/shapes.h"

namespace wrinkle::gpu {
namespace {

using glm::mat4;
using glm::vec3;
using glm::vec4;

ObjectSpace space_of(const mat4& object) {
    return *object_space(object, OrbitCamera{}, Bounds{vec3(-1), vec3(1)}, 1);
}

// A corner of a solid, by two edges and a point inside; the outward side is the one without that
// point, so the test requires no determinant or cofactor.
TEST(ObjectSpaceTest, KeepsOutsideOutsideForEveryMatrix) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> number(-1, 1);
    const auto vector = [&] { return vec3(number(random), number(random), number(random)); };
    int mirrored = 0;
    for (int i = 0; i < 200; ++i) {
        const mat4 object(vec4(vector(), 0), vec4(vector(), 0), vec4(vector(), 0),
                          vec4(vector(), 1));
        if (std::abs(glm::determinant(object)) < 0.05F) continue;
        const vec3 a = vector(), b = vector(), inside = vector();
        vec3 normal = glm::cross(a, b);
        if (glm::length(normal) < 0.1F || std::abs(glm::dot(normal, inside)) < 0.05F) continue;
        if (glm::dot(normal, inside) > 0) normal = -normal;
        const ObjectSpace space = space_of(object);
        const vec3 world = glm::normalize(space.normal_to_world * normal);
        const auto move = [&](vec3 v) { return vec3(object * vec4(v, 0)); };
        EXPECT_NEAR(glm::dot(world, glm::normalize(move(a))), 0, 1e-4);
        EXPECT_NEAR(glm::dot(world, glm::normalize(move(b))), 0, 1e-4);
        EXPECT_LT(glm::dot(world, move(inside)), 0);
        mirrored += space.mirrored ? 1 : 0;
    }
    EXPECT_GT(mirrored, 30);
}

TEST(ObjectSpaceTest, PutsTheEyeIntoTheObject) {
    const Mesh plane = *make_shape("plane");
    OrbitCamera camera = default_camera(plane, "plane");
    camera.distance = 6;
    mat4 object = glm::translate(mat4(1), vec3(1, 0, 0));
    object = glm::scale(object, vec3(2, 1, -3));
    const auto space = object_space(object, camera, bounds_of(plane), 1);
    ASSERT_TRUE(space);
    EXPECT_LT(glm::distance(space->eye, vec3(-0.5F, 0, -2)), 1e-5);
    EXPECT_TRUE(space->mirrored);
}

TEST(ObjectSpaceTest, WorksForTinyAndHugeScales) {
    for (float scale : {1e-12F, 1e12F}) {
        const ObjectSpace space = space_of(glm::scale(mat4(1), vec3(scale, 2 * scale, scale)));
        const vec3 n = glm::normalize(space.normal_to_world * glm::normalize(vec3(1, 1, 0)));
        EXPECT_LT(glm::distance(n, glm::normalize(vec3(2, 1, 0))), 1e-5);
    }
}

TEST(ObjectSpaceTest, RefusesMatricesWithoutInverse) {
    const Mesh mesh = *make_shape("plane");
    const OrbitCamera camera = default_camera(mesh, "plane");
    EXPECT_FALSE(object_space(glm::scale(mat4(1), vec3(1, 0, 1)), camera, bounds_of(mesh), 1));
    mat4 broken(1);
    broken[1][1] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(object_space(broken, camera, bounds_of(mesh), 1));
}

TEST(Camera, SeesAllOfEveryShapeAndFillsThePicture) {
    for (const Shape& shape : shapes()) {
        const Mesh mesh = shape.make();
        for (float aspect : {1.0F, 2.0F, 0.5F}) {
            const auto space =
                object_space(mat4(1), default_camera(mesh, shape.name), bounds_of(mesh), aspect);
            float reach = 0;
            for (const vec3& position : mesh.positions) {
                const vec4 clip = space->to_clip * vec4(position, 1);
                const vec3 seen = vec3(clip) / clip.w;
                const vec3 square =
                    seen * vec3(std::max(aspect, 1.0F), 1 / std::min(aspect, 1.0F), 1);
                reach = std::max({reach, std::abs(square.x), std::abs(square.y)});
                ASSERT_LT(std::abs(seen.z), 1) << shape.name;
            }
            EXPECT_LT(reach, 1) << shape.name;
            EXPECT_GT(reach, 0.8F) << shape.name;
        }
    }
}

TEST(Camera, FramesAnyMeshByItsBounds) {
    Mesh mesh = *make_shape("cube");
    for (vec3& position : mesh.positions)
        position = 100.0F * position + vec3(5000, 0, 0);
    const OrbitCamera camera = default_camera(mesh);
    EXPECT_EQ(camera.target, vec3(5000, 0, 0));
    const auto space = object_space(mat4(1), camera, bounds_of(mesh), 1);
    const vec4 clip = space->to_clip * vec4(mesh.positions[0], 1);
    EXPECT_LT(std::abs(clip.x / clip.w), 1);
}

TEST(Camera, TurnsRightAndUp) {
    OrbitCamera camera;
    camera.distance = 2;
    EXPECT_LT(glm::distance(eye_of(camera), glm::dvec3(0, 0, 2)), 1e-6);
    camera.yaw = glm::radians(90.0F);
    EXPECT_LT(glm::distance(eye_of(camera), glm::dvec3(2, 0, 0)), 1e-6);
    camera.pitch = glm::radians(30.0F);
    EXPECT_NEAR(eye_of(camera).y, 1, 1e-6);
    camera.pitch = 10;  // away from the pole, where the up direction is undefined
    EXPECT_LT(eye_of(camera).y, 2);
    EXPECT_GT(eye_of(camera).y, 1.99F);
}

}  // namespace
}  // namespace wrinkle::gpu
