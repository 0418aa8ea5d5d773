// A box decal on a smooth surface, after Mikkelsen's demo: the picture's slopes along the box's
// axes are a gradient in space, which the surface takes over. Falloff of the box by its farthest
// axis; sizes and axes come ready from the program, mip levels from the chain rule.
#version 450
layout(location = 0) in vec3 v_position;
layout(location = 1) in vec3 v_position_relative;
layout(location = 2) in vec3 v_normal;
layout(location = 0) out vec3 result;
layout(binding = 0) uniform sampler2D slopes;
layout(binding = 1) uniform Decal {
    vec3 origin;
    mat3 to_box;  // its rows are the axes
    vec3 inner, inverse_fade;
    float repeats, strength;
};

vec2 slope_of(vec3 m) {
    vec3 a = abs(m);
    return -m.xy / max(a.z, max(a.x, a.y) / 128.0);
}

void main() {
    vec3 n = v_normal * (1.0 / length(v_normal));
    vec3 place = to_box * (v_position - origin);
    vec3 beyond = clamp((abs(place) - inner) * inverse_fade, 0.0, 1.0);
    float arrives = 1.0 - max(max(beyond.x, beyond.y), beyond.z);
    arrives = arrives * arrives * (3.0 - 2.0 * arrives);
    vec2 uv_x = repeats * (to_box * dFdx(v_position_relative)).xy;
    vec2 uv_y = repeats * (to_box * dFdy(v_position_relative)).xy;
    vec3 m = textureGrad(slopes, repeats * place.xy + 0.5, uv_x, uv_y).xyz * 2.0 - 1.0;
    vec2 d = slope_of(m);
    vec3 x = vec3(to_box[0].x, to_box[1].x, to_box[2].x);
    vec3 y = vec3(to_box[0].y, to_box[1].y, to_box[2].y);
    vec3 gradient = (strength * arrives) * (d.x * x + d.y * y);
    result = normalize(n - (gradient - dot(n, gradient) * n));
}
