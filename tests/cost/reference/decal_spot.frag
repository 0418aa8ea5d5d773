// A decal thrown from a point, on a smooth surface, after Mikkelsen's demo: uv is the place across
// the ray over the distance along it, its changes by the rule of quotients. Falloff by distance and
// by the angle from the axis, squared once more.
#version 450
layout(location = 0) in vec3 v_position;
layout(location = 1) in vec3 v_position_relative;
layout(location = 2) in vec3 v_normal;
layout(location = 0) out vec3 result;
layout(binding = 0) uniform sampler2D slopes;
layout(binding = 1) uniform Decal {
    vec3 origin, axis_x, axis_y, axis_z;  // z: where it looks
    float repeats, cosine_edge, inverse_edge, inverse_range, near, strength;
};

vec2 slope_of(vec3 m) {
    vec3 a = abs(m);
    return -m.xy / max(a.z, max(a.x, a.y) / 128.0);
}

void main() {
    vec3 n = v_normal * (1.0 / length(v_normal));
    vec3 back = origin - v_position;
    float distance_ = length(back);
    float arrives = clamp(distance_ * inverse_range + near, 0.0, 1.0);
    float inside = clamp((dot(-axis_z, back / distance_) - cosine_edge) * inverse_edge, 0.0, 1.0);
    inside = inside * inside * (3.0 - 2.0 * inside);
    arrives *= inside * inside;
    vec3 ray = -back;
    vec3 p = vec3(dot(axis_x, ray), dot(axis_y, ray), dot(axis_z, ray));
    float square = max(1.192093e-7, p.z * p.z);
    vec3 of_u = (axis_x * p.z - axis_z * p.x) / square;
    vec3 of_v = (axis_y * p.z - axis_z * p.y) / square;
    vec3 dx = dFdx(v_position_relative), dy = dFdy(v_position_relative);
    vec2 uv_x = repeats * vec2(dot(of_u, dx), dot(of_v, dx));
    vec2 uv_y = repeats * vec2(dot(of_u, dy), dot(of_v, dy));
    vec3 m = textureGrad(slopes, repeats * (p.xy / p.z) + 0.5, uv_x, uv_y).xyz * 2.0 - 1.0;
    vec2 d = slope_of(m);
    vec3 gradient = (strength * arrives) * (d.x * axis_x + d.y * axis_y);
    result = normalize(n - (gradient - dot(n, gradient) * n));
}
