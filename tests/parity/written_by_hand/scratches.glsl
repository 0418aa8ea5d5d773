// A scratched plate.
struct WrinkleSurface_scratches {
    vec3 position_dx;  // to the next pixel in x
    vec3 position_dy;
    vec3 normal;
    vec2 uv0;
    vec2 uv0_dx;
    vec2 uv0_dy;
    float facing;  // +1 on front faces, -1 on back faces
};
struct WrinkleMaterial_scratches {
    vec3 normal;
    float height;
};

const float min_area = 1e-36;  // smaller areas are zero
const float two_24 = 16777216.0;  // the upper 24 bits to [0, 1)
const uint golden_bits = 0x9e3779b9u;  // 2^32 / golden ratio
const float two_pi = 6.2831853;  // a turn, in radians

// The PCG permutation (M. O'Neill 2014).
uint hash(uint x) {
    uint state = x * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

uint hash(vec3 cell) {
    uvec3 c = uvec3(ivec3(cell));
    return hash(c.x + hash(c.y + hash(c.z)));
}

// Numbers in [0, 1).
float random(uint bits) {
    return float(bits >> 8u) / two_24;
}
vec3 random3(uint bits) {
    uint second = hash(bits);
    return vec3(random(bits), random(second), random(hash(second)));
}

// A stroke that may begin in cell `index` of the nine around a position and of the same in further
// layers: its slope and depth. size: length and width. angles: direction and spread.
vec3 scratch(vec2 p, int index, float density, vec2 size, vec2 angles) {
    int layer = index / 9;
    vec2 moved = p + vec2(0.37, 0.61) * float(layer);
    vec2 cell = floor(moved) + vec2(float(index % 3), float(index / 3 % 3)) - 1.0;
    uint bits = hash(vec3(cell, float(layer)));
    uint more = hash(bits ^ golden_bits);
    if (random(hash(more)) >= density) return vec3(0.0);

    vec3 r = random3(bits);
    float angle = angles.x + (r.z - 0.5) * angles.y;
    vec2 along = vec2(cos(angle), sin(angle));
    vec2 across = vec2(along.y, -along.x);
    vec2 way = moved - cell - r.xy;

    // Smooth across the stroke, a parabola along it.
    float side = dot(way, across) / size.y;
    float inside = clamp(1.0 - abs(side), 0.0, 1.0);
    float profile = inside * inside * (3.0 - 2.0 * inside);
    vec2 profile_slope = -6.0 * inside * (1.0 - inside) * sign(side) / size.y * across;
    float half_length = size.x * (0.25 + 0.25 * random(more));
    float end = dot(way, along) / half_length;
    if (abs(end) > 1.0) return vec3(0.0);
    float taper = 1.0 - end * end;
    vec2 taper_slope = -2.0 * end / half_length * along;
    return vec3(profile_slope * taper + taper_slope * profile, profile * taper);
}

// The deepest stroke.
vec3 scratches(vec2 uv, float width, float scale, int layers, float density, vec2 size,
        vec2 angles) {
    vec3 deepest = vec3(0.0);
    for (int i = 0; i < 9 * layers; ++i) {
        vec3 stroke = scratch(uv * scale, i, density, size, angles);
        if (stroke.z > deepest.z) deepest = stroke;
    }
    float fade = 1.0 - smoothstep(0.25, 0.75, width * scale / (4.0 * size.y));
    float mean = min(0.5 * size.x * size.y * density * float(layers), 1.0);
    return vec3(deepest.xy * scale * fade, mix(mean, deepest.z, fade));
}

WrinkleMaterial_scratches wrinkle_scratches(WrinkleSurface_scratches s) {
    vec3 normal = normalize(s.normal);
    float width = max(length(s.uv0_dx), length(s.uv0_dy));
    vec3 relief = scratches(s.uv0, width, 5.0, 3, 0.7, vec2(1.4, 0.04), vec2(0.0, two_pi));
    float height = -0.006 * relief.z;
    vec2 slope = -0.006 * vec2(dot(relief.xy, s.uv0_dx), dot(relief.xy, s.uv0_dy));

    // The surface gradient by screen differences (Mikkelsen 2010).
    float area = dot(normal, cross(s.position_dx, s.position_dy));
    vec2 per_area = slope * sign(area) / max(abs(area), min_area);
    vec3 gradient = cross(normal, s.position_dx * per_area.y - s.position_dy * per_area.x);

    WrinkleMaterial_scratches m;
    m.normal = normalize(normal * s.facing - gradient);
    m.height = height;
    return m;
}
