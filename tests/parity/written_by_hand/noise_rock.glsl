// Noise rock.
struct WrinkleSurface_noise_rock {
    vec3 position;
    vec3 position_dx;  // to the next pixel in x
    vec3 position_dy;
    vec3 normal;
    float facing;  // +1 on front faces, -1 on back faces
};
struct WrinkleMaterial_noise_rock {
    vec3 normal;
    float height;
    float roughness;
};

const vec3 octave_offset = vec3(19.19, 7.43, 31.71);  // between octaves, in cells

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

// One of the twelve directions to the edges of a cube, and its product with the way to the corner.
vec4 corner(vec3 cell, vec3 f, vec3 offset) {
    uint bits = hash(cell + offset);
    uint axis = ((bits >> 8u) * 3u) >> 24u;
    float a = 1.0 - 2.0 * float(bits & 1u);
    float b = 1.0 - float(bits & 2u);
    vec3 slope = vec3(a, b, 0.0);
    if (axis == 0u) slope = vec3(0.0, a, b);
    if (axis == 1u) slope = vec3(a, 0.0, b);
    return vec4(slope, dot(slope, f - offset));
}

// Perlin's noise of 2002: its gradient and its value.
vec4 noise(vec3 p) {
    vec3 cell = floor(p);
    vec3 f = p - cell;
    vec3 t = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    vec3 dt = 30.0 * f * f * (f - 1.0) * (f - 1.0);

    vec4 c000 = corner(cell, f, vec3(0.0, 0.0, 0.0));
    vec4 c100 = corner(cell, f, vec3(1.0, 0.0, 0.0));
    vec4 c010 = corner(cell, f, vec3(0.0, 1.0, 0.0));
    vec4 c110 = corner(cell, f, vec3(1.0, 1.0, 0.0));
    vec4 c001 = corner(cell, f, vec3(0.0, 0.0, 1.0));
    vec4 c101 = corner(cell, f, vec3(1.0, 0.0, 1.0));
    vec4 c011 = corner(cell, f, vec3(0.0, 1.0, 1.0));
    vec4 c111 = corner(cell, f, vec3(1.0, 1.0, 1.0));

    vec4 c00 = mix(c000, c100, t.x);
    vec4 c10 = mix(c010, c110, t.x);
    vec4 c01 = mix(c001, c101, t.x);
    vec4 c11 = mix(c011, c111, t.x);
    c00.x += dt.x * (c100.w - c000.w);
    c10.x += dt.x * (c110.w - c010.w);
    c01.x += dt.x * (c101.w - c001.w);
    c11.x += dt.x * (c111.w - c011.w);

    vec4 c0 = mix(c00, c10, t.y);
    vec4 c1 = mix(c01, c11, t.y);
    c0.y += dt.y * (c10.w - c00.w);
    c1.y += dt.y * (c11.w - c01.w);

    vec4 c = mix(c0, c1, t.z);
    c.z += dt.z * (c1.w - c0.w);
    return c;
}

// Octaves of noise, each twice as fine as the one before; one that is finer than pixels fades out.
vec4 fbm(vec3 point, float width, float scale, int octaves, float lacunarity, float gain) {
    float frequency = scale;
    float weight = 1.0;
    float total = 0.0;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < octaves; ++i) {
        // Without the offset, every octave would be 0 at the origin.
        vec3 p = point * frequency + octave_offset * float(i);
        vec4 n = noise(p);
        float fade = 1.0 - smoothstep(0.25, 0.75, width * frequency);
        sum += vec4(n.xyz * frequency, n.w) * fade * weight;
        total += weight;
        frequency *= lacunarity;
        weight *= gain;
    }
    return sum / total;
}

WrinkleMaterial_noise_rock wrinkle_noise_rock(WrinkleSurface_noise_rock s) {
    vec3 normal = normalize(s.normal);
    float width = max(length(s.position_dx), length(s.position_dy));

    vec4 lumps = 0.06 * fbm(s.position, width, 3.0, 6, 2.0, 0.5);

    vec4 cracks = fbm(s.position, width, 7.0, 2, 2.0, 0.5);
    float depth = abs(cracks.w);
    float t = clamp(depth / 0.12, 0.0, 1.0);
    float groove = t * t * (3.0 - 2.0 * t);
    vec3 groove_slope = 6.0 * t * (1.0 - t) / 0.12 * sign(cracks.w) * cracks.xyz;

    // rock: the sum of both
    float height = lumps.w + 0.015 * groove;
    vec3 slope = lumps.xyz + 0.015 * groove_slope;
    vec3 gradient = slope - normal * dot(normal, slope);  // along the surface

    WrinkleMaterial_noise_rock m;
    m.normal = normalize(normal * s.facing - gradient);
    m.height = height;
    m.roughness = mix(0.25, 0.6, (lumps.w + 0.06) / 0.12);
    return m;
}
