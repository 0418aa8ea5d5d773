// Rusty steel.
struct WrinkleSurface_rusty_steel {
    vec3 position;
    vec3 position_dx;  // to the next pixel in x
    vec3 position_dy;
    vec3 normal;
    vec2 uv0;
    vec2 uv0_dx;
    vec2 uv0_dy;
    float facing;  // +1 on front faces, -1 on back faces
};
struct WrinkleMaterial_rusty_steel {
    vec3 normal;
    float height;
    vec3 color;
    float roughness;
    float metalness;
    float occlusion;
    vec3 emission;
};

const float min_area = 1e-36;  // smaller areas are zero
const vec3 octave_offset = vec3(19.19, 7.43, 31.71);  // between octaves, in cells
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

// S. Worley's distance to the nearest of random points: its gradient and its value.
vec3 feature_point(vec3 cell, float jitter) {
    return (random3(hash(cell)) - 0.5) * jitter;
}
vec4 worley(vec3 point, float width, float scale, float jitter) {
    vec3 p = point * scale;
    vec3 cell = floor(p);
    vec3 from = p - cell - 0.5;
    float least = 9.0;
    vec3 nearest = vec3(0.0);
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                vec3 offset = vec3(float(x), float(y), float(z));
                vec3 way = from - offset - feature_point(cell + offset, jitter);
                float square = dot(way, way);
                if (square < least) {
                    least = square;
                    nearest = way;
                }
            }
    float distance = sqrt(least);
    vec3 slope = distance > 0.0 ? nearest / distance * scale : vec3(0.0);
    float fade = 1.0 - smoothstep(0.25, 0.75, width * scale);
    return vec4(slope * fade, mix(0.48 + 0.04 * jitter, distance, fade));
}

// The derivative of smoothstep(low, high, x).
float smoothstep_slope(float low, float high, float x) {
    float t = clamp((x - low) / (high - low), 0.0, 1.0);
    return 6.0 * t * (1.0 - t) / (high - low);
}

WrinkleMaterial_rusty_steel wrinkle_rusty_steel(WrinkleSurface_rusty_steel s) {
    vec3 normal = normalize(s.normal);
    vec3 dpdx = s.position_dx - normal * dot(normal, s.position_dx);  // along the surface
    vec3 dpdy = s.position_dy - normal * dot(normal, s.position_dy);
    float width = max(length(s.position_dx), length(s.position_dy));
    float uv_width = max(length(s.uv0_dx), length(s.uv0_dy));

    // Each relief has its height and its differentials along screen x and y.
    // bends
    vec4 bends = fbm(s.position, width, 2.0, 8, 2.0, 0.5);
    float bends_height = 0.03 * bends.w;
    vec2 bends_slope = 0.03 * vec2(dot(bends.xyz, dpdx), dot(bends.xyz, dpdy));

    // long_scratches
    vec3 long_scratches = scratches(s.uv0, uv_width, 3.0, 3, 0.7, vec2(1.5, 0.04),
            vec2(0.0, 0.6981317));
    vec2 long_slope = vec2(dot(long_scratches.xy, s.uv0_dx), dot(long_scratches.xy, s.uv0_dy));

    // fine_scratches
    vec3 fine_scratches = scratches(s.uv0, uv_width, 11.0, 2, 0.5, vec2(1.4, 0.05),
            vec2(0.0, two_pi));
    vec2 fine_slope = vec2(dot(fine_scratches.xy, s.uv0_dx), dot(fine_scratches.xy, s.uv0_dy));

    // steel: bends with scratches
    float steel = bends_height - 0.003 * long_scratches.z;
    vec2 steel_slope = bends_slope - 0.003 * long_slope;

    // scratched
    float scratched = steel - 0.001 * fine_scratches.z;
    vec2 scratched_slope = steel_slope - 0.001 * fine_slope;

    // polished
    float polished = 0.5 * scratched;
    vec2 polished_slope = 0.5 * scratched_slope;

    // blisters
    vec4 blisters = fbm(s.position, width, 9.0, 4, 2.0, 0.5);
    vec2 blisters_slope = vec2(dot(blisters.xyz, dpdx), dot(blisters.xyz, dpdy));

    // grain
    vec4 grain = fbm(s.position, width, 60.0, 2, 2.0, 0.5);
    vec2 grain_slope = vec2(dot(grain.xyz, dpdx), dot(grain.xyz, dpdy));

    // flakes
    vec4 flakes = worley(s.position, width, 14.0, 1.0);
    vec2 flakes_slope = vec2(dot(flakes.xyz, dpdx), dot(flakes.xyz, dpdy));

    // pores
    vec4 pores = fbm(s.position, width, 25.0, 3, 2.0, 0.5);
    vec2 pores_slope = vec2(dot(pores.xyz, dpdx), dot(pores.xyz, dpdy));

    // patches
    vec4 patches = fbm(s.position, width, 1.5, 3, 2.0, 0.5);
    vec2 patches_slope = vec2(dot(patches.xyz, dpdx), dot(patches.xyz, dpdy));

    // crust
    float crust = 0.015 * blisters.w + 0.002 * grain.w;
    vec2 crust_slope = 0.015 * blisters_slope + 0.002 * grain_slope;

    // crusty
    float crusty = crust + 0.01 * flakes.w;
    vec2 crusty_slope = crust_slope + 0.01 * flakes_slope;

    // mottled: pores in the flakes
    float mottled = mix(crusty, 0.004 * pores.w, flakes.w);
    vec2 mottled_slope = mix(crusty_slope, 0.004 * pores_slope, flakes.w) +
            flakes_slope * (0.004 * pores.w - crusty);

    // rusty: the mask
    float worn = patches.w + blisters.w;
    float rusty = smoothstep(-0.1, 0.35, worn + 0.1);
    vec2 rusty_slope = (patches_slope + blisters_slope) * smoothstep_slope(-0.1, 0.35, worn + 0.1);

    // rusted
    float rusted = mix(polished, mottled, rusty);
    vec2 rusted_slope = mix(polished_slope, mottled_slope, rusty) +
            rusty_slope * (mottled - polished);

    // dust_mask
    float dust = 0.6 * smoothstep(0.3, 0.9, flakes.w);
    vec2 dust_slope = 0.6 * flakes_slope * smoothstep_slope(0.3, 0.9, flakes.w);

    // dusty
    float dusty = mix(rusted, 0.004, dust);
    vec2 dusty_slope = rusted_slope * (1.0 - dust) + dust_slope * (0.004 - rusted);

    // The surface gradient by screen differences (Mikkelsen 2010).
    float area = dot(normal, cross(s.position_dx, s.position_dy));
    vec2 per_area = dusty_slope * sign(area) / max(abs(area), min_area);
    vec3 gradient = cross(normal, s.position_dx * per_area.y - s.position_dy * per_area.x);

    // Colors
    float tone = (bends.w + 0.6) / 1.2;
    vec3 steel_color = mix(vec3(0.45, 0.46, 0.48), vec3(0.6, 0.6, 0.62), tone);
    float rust_tone = (grain.w + 1.0) / 2.0;
    vec3 rust_color = mix(vec3(0.28, 0.09, 0.03), vec3(0.45, 0.2, 0.07), rust_tone);

    WrinkleMaterial_rusty_steel m;
    m.normal = normalize(normal * s.facing - gradient);
    m.height = dusty;
    m.color = mix(steel_color, rust_color, rusty);
    m.roughness = mix(0.3, 0.85, rusty) + 0.2 * fine_scratches.z;
    m.metalness = 1.0 - rusty;
    m.occlusion = clamp(mix(0.6, 1.0, pores.w + 0.5), 0.0, 1.0);
    m.emission = 0.2 * dust * vec3(1.0, 0.4, 0.1);
    return m;
}
