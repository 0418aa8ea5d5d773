
// The color of a base under a coat.
const coated = wgslFn(`
fn wrinkle_coated(color: vec3f, roughness: f32, metalness: f32, weight: f32, tint: vec3f, n: f32,
                  darkening: f32) -> vec3f {
    let mean = log((10893.0 * n - 1438.2) / (-774.4 * n * n + 10212.0 * n + 1.0));
    let straight = pow((n - 1.0) / (n + 1.0), 2.0);
    let held = mix(straight, 1.0 - (1.0 - mean) / (n * n), mix(1.0, roughness, metalness));
    let darker = (1.0 - held) / (1.0 - clamp(color, vec3f(0.0), vec3f(1.0)) * held);
    return color * mix(vec3f(1.0), tint, weight) * mix(vec3f(1.0), darker, weight * darkening);
}`);
