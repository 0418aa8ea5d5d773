// A decal thrown to all sides from a point, on a smooth surface, after Mikkelsen's demo: a cube map
// of normals of a ball, read by the ray; its gradient on the ball is the gradient in space.
// Falloff by distance and by the angle to the surface.
#version 450
layout(location = 0) in vec3 v_position;
layout(location = 1) in vec3 v_position_relative;
layout(location = 2) in vec3 v_normal;
layout(location = 0) out vec3 result;
layout(binding = 0) uniform samplerCube normals;
layout(binding = 1) uniform Decal {
    vec3 origin;
    mat3 to_ball;
    float inverse_range, near, strength;
};

// The change of v / |v|, `unit`, where v changes by `way`.
vec3 turned(vec3 unit, float inverse_length, vec3 way) {
    mat3 change = mat3(inverse_length * (vec3(1, 0, 0) - unit.x * unit),
                       inverse_length * (vec3(0, 1, 0) - unit.y * unit),
                       inverse_length * (vec3(0, 0, 1) - unit.z * unit));
    return to_ball * (change * way);
}

void main() {
    vec3 n = v_normal * (1.0 / length(v_normal));
    vec3 ray = v_position - origin;
    float arrives = clamp(length(ray) * inverse_range + near, 0.0, 1.0);
    arrives *= pow(clamp(dot(n, -ray), 0.0, 1.0), 0.2);
    float inverse_length = inversesqrt(max(1.192093e-15, dot(ray, ray)));
    vec3 unit = ray * inverse_length;
    vec3 out_x = turned(unit, inverse_length, dFdx(v_position_relative));
    vec3 out_y = turned(unit, inverse_length, dFdy(v_position_relative));
    vec3 outward = to_ball * unit;
    vec3 m = normalize(textureGrad(normals, outward, out_x, out_y).xyz * 2.0 - 1.0);
    float k = dot(outward, m);
    vec3 on_ball = (k * outward - m) / max(1.192093e-7, abs(k));
    vec3 gradient = (strength * arrives) * (on_ball * to_ball);
    result = normalize(n - (gradient - dot(n, gradient) * n));
}
