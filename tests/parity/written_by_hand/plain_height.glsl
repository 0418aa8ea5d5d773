// Bricks from one height.
struct WrinkleSurface_plain_height {
    vec3 position_dx;  // to the next pixel in x
    vec3 position_dy;
    vec3 normal;
    vec2 uv0;
    vec2 uv0_dx;
    vec2 uv0_dy;
    float facing;  // +1 on front faces, -1 on back faces
};
struct WrinkleMaterial_plain_height {
    vec3 normal;
    float height;
};
uniform sampler2D plain_height_bricks_image;

const vec2 tiles = vec2(4.0, 2.0);  // copies to a uv unit
const float min_square = 9.094947e-13;  // of a footprint, in texels
const float min_area = 1e-36;  // smaller areas are zero

float read(vec2 uv, float lod) {
    return textureLod(plain_height_bricks_image, uv, lod).x;
}

// Sobel's slope of the finest level.
vec2 fine_slope(vec2 uv, vec2 texel) {
    float upper_right = read(uv + texel, 0.0);
    float lower_left = read(uv - texel, 0.0);
    float lower_right = read(uv + vec2(texel.x, -texel.y), 0.0);
    float upper_left = read(uv + vec2(-texel.x, texel.y), 0.0);
    float rising = upper_right - lower_left;
    float falling = lower_right - upper_left;
    float along_u = read(uv + vec2(texel.x, 0.0), 0.0) - read(uv - vec2(texel.x, 0.0), 0.0);
    float along_v = read(uv + vec2(0.0, texel.y), 0.0) - read(uv - vec2(0.0, texel.y), 0.0);
    return (vec2(rising + falling, rising - falling) + 2.0 * vec2(along_u, along_v)) / 8.0;
}

WrinkleMaterial_plain_height wrinkle_plain_height(WrinkleSurface_plain_height s) {
    vec3 normal = normalize(s.normal);
    vec2 uv = tiles * s.uv0;

    // The pixel in texels, and its level of detail.
    vec2 size = vec2(textureSize(plain_height_bricks_image, 0));
    vec2 texels_dx = tiles * s.uv0_dx * size;
    vec2 texels_dy = tiles * s.uv0_dy * size;
    float square = max(dot(texels_dx, texels_dx), dot(texels_dy, texels_dy));
    float lod = 0.5 * log2(max(square, min_square));
    float footprint = sqrt(max(square, 1.0));

    // Three taps a pixel apart; close up, the smooth slope of the texels.
    vec2 apart = footprint / size;
    float here = read(uv, lod);
    float right = read(uv + vec2(apart.x, 0.0), lod);
    float above = read(uv + vec2(0.0, apart.y), lod);
    vec2 coarse = (vec2(right, above) - here) / footprint;
    float magnified = clamp((0.5 - log2(footprint)) / 0.45, 0.0, 1.0);
    vec2 per_texel = mix(coarse, fine_slope(uv, 1.0 / size), magnified);
    vec2 slope = 0.04 * vec2(dot(per_texel, texels_dx), dot(per_texel, texels_dy));

    // The surface gradient by screen differences (Mikkelsen 2010).
    float area = dot(normal, cross(s.position_dx, s.position_dy));
    vec2 per_area = slope * sign(area) / max(abs(area), min_area);
    vec3 gradient = cross(normal, s.position_dx * per_area.y - s.position_dy * per_area.x);

    WrinkleMaterial_plain_height m;
    m.normal = normalize(normal * s.facing - gradient);
    m.height = 0.04 * (here - 0.5);
    return m;
}
