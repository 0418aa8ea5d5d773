// Scales between cracks.
struct WrinkleSurface_worley_noise {
    vec3 position;
    vec3 position_dx;  // to the next pixel in x
    vec3 position_dy;
    vec3 normal;
    float facing;  // +1 on front faces, -1 on back faces
};
struct WrinkleMaterial_worley_noise {
    vec3 normal;
    float height;
};

const float two_24 = 16777216.0;  // the upper 24 bits to [0, 1)

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

// S. Worley's distances to the two nearest of random points: the gradient of their difference, and
// the difference.
vec3 feature_point(vec3 cell, float jitter) {
    return (random3(hash(cell)) - 0.5) * jitter;
}
vec4 worley(vec3 point, float width, float scale, float jitter) {
    vec3 p = point * scale;
    vec3 cell = floor(p);
    vec3 from = p - cell - 0.5;
    float first = 9.0;
    float second = 9.0;
    vec3 nearest = vec3(0.0);
    vec3 next = vec3(0.0);
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                vec3 offset = vec3(float(x), float(y), float(z));
                vec3 way = from - offset - feature_point(cell + offset, jitter);
                float square = dot(way, way);
                if (square < first) {
                    second = first;
                    next = nearest;
                    first = square;
                    nearest = way;
                } else if (square < second) {
                    second = square;
                    next = way;
                }
            }
    first = sqrt(first);
    second = sqrt(second);
    vec3 first_slope = first > 0.0 ? nearest / first : vec3(0.0);
    vec3 second_slope = second > 0.0 ? next / second : vec3(0.0);
    float fade = 1.0 - smoothstep(0.25, 0.75, width * scale);
    return vec4((second_slope - first_slope) * scale * fade,
            mix(0.223 - 0.025 * jitter, second - first, fade));
}

WrinkleMaterial_worley_noise wrinkle_worley_noise(WrinkleSurface_worley_noise s) {
    vec3 normal = normalize(s.normal);
    float width = max(length(s.position_dx), length(s.position_dy));
    vec4 relief = 0.05 * worley(s.position, width, 5.0, 1.0);
    vec3 gradient = relief.xyz - normal * dot(normal, relief.xyz);  // along the surface

    WrinkleMaterial_worley_noise m;
    m.normal = normalize(normal * s.facing - gradient);
    m.height = relief.w;
    return m;
}
