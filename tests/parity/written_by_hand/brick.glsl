// A brick wall.
struct WrinkleSurface_brick {
    vec3 position_dx;  // to the next pixel in x
    vec3 position_dy;
    vec3 normal;
    vec2 uv0;
    vec2 uv0_dx;
    vec2 uv0_dy;
    float facing;  // +1 on front faces, -1 on back faces
};
struct WrinkleMaterial_brick {
    vec3 normal;
    float height;
};

const float min_area = 1e-36;  // smaller areas are zero

WrinkleMaterial_brick wrinkle_brick(WrinkleSurface_brick s) {
    const float mortar = 0.06, bevel = 0.15, groove = mortar + bevel, aspect = 2.5;
    vec3 normal = normalize(s.normal);

    // Position in the brick, from its middle.
    vec2 p = s.uv0 * 6.0;
    float row = floor(p.y);
    float x = fract(p.x / aspect - 0.5 * row) - 0.5;
    float y = p.y - row - 0.5;
    vec2 px = vec2(s.uv0_dx.x, s.uv0_dy.x) * 6.0;  // screen derivatives of p.x and p.y
    vec2 py = vec2(s.uv0_dx.y, s.uv0_dy.y) * 6.0;

    // Distance to the middle of the mortar: the nearer of the two directions.
    float along = (0.5 - abs(x)) * aspect;
    float across = 0.5 - abs(y);
    float inside = min(along, across);
    vec2 inside_slope = across < along ? -sign(y) * py : -sign(x) * px;

    // A slope as wide as the bevel, or as a pixel.
    float pixel = max(length(s.uv0_dx), length(s.uv0_dy)) * 6.0;
    float width = max(bevel, pixel);
    float deepest = min(1.0, groove / width);
    float covered = (0.5 * (width + groove) - inside) / width;
    float value = 1.0 - clamp(covered, 0.0, deepest);
    vec2 value_slope = inside_slope / width;
    if (covered < 0.0 || covered > deepest) value_slope = vec2(0.0);

    // Fades to the mean where a pixel covers a brick.
    float fade = 1.0 - smoothstep(0.25, 0.75, pixel);
    float mean = (1.0 - groove) * (1.0 - groove / aspect);
    float height = mix(mean, value, fade) * 0.02;
    vec2 slope = value_slope * fade * 0.02;

    // The surface gradient by screen differences (Mikkelsen 2010).
    float area = dot(normal, cross(s.position_dx, s.position_dy));
    vec2 per_area = slope * sign(area) / max(abs(area), min_area);
    vec3 gradient = cross(normal, s.position_dx * per_area.y - s.position_dy * per_area.x);

    WrinkleMaterial_brick m;
    m.normal = normalize(normal * s.facing - gradient);
    m.height = height;
    return m;
}
