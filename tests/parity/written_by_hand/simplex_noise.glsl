// Simplex noise.
struct WrinkleSurface_simplex_noise {
    vec3 position;
    vec3 position_dx;  // to the next pixel in x
    vec3 position_dy;
    vec3 normal;
    float facing;  // +1 on front faces, -1 on back faces
};
struct WrinkleMaterial_simplex_noise {
    vec3 normal;
    float height;
};

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

// One of the twelve directions to the edges of a cube.
vec3 direction(uint bits) {
    uint axis = ((bits >> 8u) * 3u) >> 24u;
    float a = 1.0 - 2.0 * float(bits & 1u);
    float b = 1.0 - float(bits & 2u);
    if (axis == 0u) return vec3(0.0, a, b);
    if (axis == 1u) return vec3(a, 0.0, b);
    return vec3(a, b, 0.0);
}

// The slope and height of a corner's linear ramp, which falls off as (1/2 - d^2)^4.
vec4 corner(vec3 cell, vec3 way) {
    vec3 slope = direction(hash(cell));
    float height = dot(slope, way);
    float near = max(0.5 - dot(way, way), 0.0);
    float cube = near * near * near;
    return vec4(cube * (near * slope - 8.0 * height * way), cube * near * height);
}

// K. Perlin's simplex noise of 2001: its gradient and its value.
vec4 simplex_noise(vec3 p) {
    const float unskew = 1.0 / 6.0;
    vec3 skewed = p + (p.x + p.y + p.z) / 3.0;
    vec3 cell = floor(skewed);
    vec3 f = skewed - cell;
    vec3 way = f - (f.x + f.y + f.z) * unskew;

    // The steps from the first corner to the last go along the greatest component first.
    float xy = float(f.x >= f.y);
    float xz = float(f.x >= f.z);
    float yz = float(f.y >= f.z);
    vec3 rank = vec3(xy + xz, 1.0 - xy + yz, 2.0 - xz - yz);
    vec3 one = clamp(rank - 1.0, 0.0, 1.0);
    vec3 two = clamp(rank, 0.0, 1.0);

    vec4 sum = corner(cell, way);
    sum += corner(cell + one, way - one + unskew);
    sum += corner(cell + two, way - two + 2.0 * unskew);
    sum += corner(cell + 1.0, way - 0.5);
    return 76.0 * sum;
}

WrinkleMaterial_simplex_noise wrinkle_simplex_noise(WrinkleSurface_simplex_noise s) {
    vec3 normal = normalize(s.normal);
    float width = max(length(s.position_dx), length(s.position_dy));

    vec4 noise = simplex_noise(8.0 * s.position);
    float fade = 1.0 - smoothstep(0.25, 0.75, 8.0 * width);
    float height = 0.02 * fade * noise.w;
    vec3 slope = 0.02 * fade * 8.0 * noise.xyz;
    vec3 gradient = slope - normal * dot(normal, slope);  // along the surface

    WrinkleMaterial_simplex_noise m;
    m.normal = normalize(normal * s.facing - gradient);
    m.height = height;
    return m;
}
