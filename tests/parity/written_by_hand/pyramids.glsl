// Pyramids of a given density and height.
struct WrinkleSurface_pyramids {
    vec3 position_dx;  // to the next pixel in x
    vec3 position_dy;
    vec3 normal;
    vec2 uv0;
    vec2 uv0_dx;
    vec2 uv0_dy;
    float facing;  // +1 on front faces, -1 on back faces
};
struct WrinkleMaterial_pyramids {
    vec3 normal;
    float height;
};

const float min_area = 1e-36;  // smaller areas are zero

WrinkleMaterial_pyramids wrinkle_pyramids(WrinkleSurface_pyramids s) {
    vec3 normal = normalize(s.normal);

    // Way from the middle of a cell.
    vec2 p = s.uv0 * 6.0;
    vec2 way = p - floor(p) - 0.5;
    vec2 px = vec2(s.uv0_dx.x, s.uv0_dy.x) * 6.0;  // screen derivatives of p.x and p.y
    vec2 py = vec2(s.uv0_dx.y, s.uv0_dy.y) * 6.0;

    // Four sides, by the larger distance.
    vec2 side = abs(way);
    float rise = 1.0 - 2.0 * max(side.x, side.y) / 0.5;
    float value = clamp(rise, 0.0, 1.0);
    vec2 side_slope = side.x < side.y ? sign(way.y) * py : sign(way.x) * px;
    vec2 value_slope = rise < 0.0 ? vec2(0.0) : -2.0 / 0.5 * side_slope;

    // Fades to the mean where a pixel covers a pyramid.
    float pixel = max(length(s.uv0_dx), length(s.uv0_dy)) * 6.0;
    float fade = 1.0 - smoothstep(0.25, 0.75, pixel);
    float height = mix(0.5 * 0.5 / 3.0, value, fade) * 0.05;
    vec2 slope = value_slope * fade * 0.05;

    // The surface gradient by screen differences (Mikkelsen 2010).
    float area = dot(normal, cross(s.position_dx, s.position_dy));
    vec2 per_area = slope * sign(area) / max(abs(area), min_area);
    vec3 gradient = cross(normal, s.position_dx * per_area.y - s.position_dy * per_area.x);

    WrinkleMaterial_pyramids m;
    m.normal = normalize(normal * s.facing - gradient);
    m.height = height;
    return m;
}
