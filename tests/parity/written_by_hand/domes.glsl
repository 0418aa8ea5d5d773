// Studs in staggered rows.
struct WrinkleSurface_domes {
    vec3 position_dx;  // to the next pixel in x
    vec3 position_dy;
    vec3 normal;
    vec2 uv0;
    vec2 uv0_dx;
    vec2 uv0_dy;
    float facing;  // +1 on front faces, -1 on back faces
};
struct WrinkleMaterial_domes {
    vec3 normal;
    float height;
};

const float min_area = 1e-36;  // smaller areas are zero
const float mean = 0.20845777;  // height from far away
const float radius = 0.35;  // of a stud, in cells

WrinkleMaterial_domes wrinkle_domes(WrinkleSurface_domes s) {
    vec3 normal = normalize(s.normal);

    // Six cells to a uv unit; each row is moved by half a cell.
    vec2 p = 6.0 * s.uv0;
    vec2 dx = 6.0 * s.uv0_dx;
    vec2 dy = 6.0 * s.uv0_dy;
    float row = floor(p.y);
    float x = p.x - 0.5 * row;
    vec2 local = vec2(x, p.y) - vec2(floor(x), row) - 0.5;

    // The cap of a sphere, on a disc: sqrt(1 - 0.64 (distance / radius)^2), 0.6 at the rim.
    float apart = dot(local, local) / (radius * radius);
    float cap = sqrt(1.0 - 0.64 * min(apart, 1.0));
    float value = (cap - 0.6) / 0.4;
    vec2 slope = vec2(0.0);
    if (apart < 1.0)
        slope = -0.64 / (radius * radius * 0.4 * cap) * vec2(dot(local, dx), dot(local, dy));

    float detail = 1.0 - smoothstep(0.25, 0.75, max(length(dx), length(dy)));

    // The surface gradient by screen differences (Mikkelsen 2010).
    float area = dot(normal, cross(s.position_dx, s.position_dy));
    vec2 per_area = 0.05 * detail * slope * sign(area) / max(abs(area), min_area);
    vec3 gradient = cross(normal, s.position_dx * per_area.y - s.position_dy * per_area.x);

    WrinkleMaterial_domes m;
    m.normal = normalize(normal * s.facing - gradient);
    m.height = 0.05 * mix(mean, value, detail);
    return m;
}
