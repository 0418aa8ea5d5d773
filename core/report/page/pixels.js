// Pixels of images, and the values of maps.

function pixels_of(image) {
    const canvas = element("canvas", { width: image.naturalWidth, height: image.naturalHeight });
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, canvas.width, canvas.height);
}

// Returns [red, green, blue], or null outside of the image.
function texel(pixels, x, y) {
    if (x < 0 || y < 0 || x >= pixels.width || y >= pixels.height) return null;
    const at = (y * pixels.width + x) * 4;
    return [...pixels.data.slice(at, at + 3)];
}

// Degrees between two normals of an image of 8 bits, which is off by up to 0.4 degrees.
function degrees_between(a, b) {
    const [u, v] = [a, b].map((color) => color.map((value) => value / 127.5 - 1));
    const dot = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    const cross = Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0]);
    return Math.atan2(cross, dot) * 180 / Math.PI;
}

const steps_of_colors = new Map(magma.map((color, step) => [color, step]));

// Returns 0 to 255, the step of the color of a map.
const step_of = (color) => steps_of_colors.get(color[0] << 16 | color[1] << 8 | color[2]) ?? 0;

// Returns the number of pixels of each step.
function histogram_of(pixels) {
    const counts = new Array(256).fill(0);
    for (let at = 0; at < pixels.data.length; at += 4)
        ++counts[step_of([pixels.data[at], pixels.data[at + 1], pixels.data[at + 2]])];
    return counts;
}

// Returns the value that a part of the pixels does not exceed.
function quantile(counts, part, scale) {
    const all = counts.reduce((sum, count) => sum + count, 0);
    let sum = 0;
    const step = counts.findIndex((count) => (sum += count) >= part * all);
    return step * scale / 255;
}

// Returns the scale of a map: its colors, and above them the number of pixels of each.
function scale_of_map(image, scale, unit) {
    const counts = histogram_of(pixels_of(image));
    const canvas = element("canvas", { width: 256, height: 44 });
    const context = canvas.getContext("2d");
    const highest = Math.log1p(Math.max(...counts));
    magma.forEach((color, step) => {
        context.fillStyle = "#" + color.toString(16).padStart(6, "0");
        context.fillRect(step, 34, 1, 10);
        context.fillStyle = "#808894";
        const height = Math.round(32 * Math.log1p(counts[step]) / highest);
        context.fillRect(step, 32 - height, 1, height);
    });
    canvas.setAttribute("aria-hidden", "true");
    const at = (part) => quantile(counts, part, scale).toPrecision(3);
    const ends = element("div", { className: "ends" }, element("span", { textContent: "0" }),
        element("span", { textContent: `${+scale.toPrecision(3)}${unit}` }));
    return element("div", { className: "scale" }, canvas, ends, element("p", { textContent:
        `Pixels: half up to ${at(0.5)}, 99 % up to ${at(0.99)}, all up to ${at(1)}${unit}` }));
}
