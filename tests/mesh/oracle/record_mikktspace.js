// Records the tangents that the npm package mikktspace 1.1.1 makes for a few meshes:
//
//   npm install --prefix /tmp/mikktspace mikktspace@1.1.1
//   NODE_PATH=/tmp/mikktspace/node_modules node record_mikktspace.js > mikktspace.json
//
// A mesh is {"name", "vertices": [[x, y, z, nx, ny, nz, u, v], ...], "indices": [...],
// "tangents": [[x, y, z, w], ...]}, a tangent per index. Numbers are 32-bit floats.
const { generateTangents } = require('mikktspace');

const tau = 2 * Math.PI;
const unit = (v) => {
  const length = Math.hypot(...v);
  return v.map((x) => x / length);
};

// columns * rows quads of two triangles; vertex(i, j) gives a vertex's eight numbers.
function grid(columns, rows, vertex) {
  const vertices = [], indices = [];
  for (let j = 0; j <= rows; ++j)
    for (let i = 0; i <= columns; ++i) vertices.push(vertex(i, j));
  for (let j = 0; j < rows; ++j)
    for (let i = 0; i < columns; ++i) {
      const a = j * (columns + 1) + i, b = a + columns + 1;
      indices.push(a, a + 1, b + 1, a, b + 1, b);
    }
  return { vertices, indices };
}

// u runs forth and back; the poles are collapsed quads.
function mirroredSphere() {
  const columns = 10, rows = 6;
  return grid(columns, rows, (i, j) => {
    const pole = j === 0 || j === rows;
    const lon = (tau * (i % columns)) / columns, lat = Math.PI * (j / rows - 0.5);
    const r = pole ? 0 : Math.cos(lat);
    const n = [r * Math.sin(lon), pole ? Math.sign(lat) : Math.sin(lat), r * Math.cos(lon)];
    return [...n, ...n, Math.abs((2 * i) / columns - 1), j / rows];
  });
}

function torus() {
  const columns = 10, rows = 8;
  return grid(columns, rows, (i, j) => {
    const a = (tau * (i % columns)) / columns, b = (tau * (j % rows)) / rows;
    const n = [-Math.cos(b) * Math.sin(a), -Math.sin(b), -Math.cos(b) * Math.cos(a)];
    const p = [0.7 * Math.sin(a) + 0.3 * n[0], 0.3 * n[1], 0.7 * Math.cos(a) + 0.3 * n[2]];
    return [...p, ...n, i / columns, j / rows];
  });
}

function cube() {
  const vertices = [], indices = [];
  for (let axis = 0; axis < 3; ++axis)
    for (const side of [-1, 1]) {
      const n = [0, 0, 0], t = [0, 0, 0], b = [0, 0, 0];
      n[axis] = side;
      t[(axis + 1) % 3] = side;
      b[(axis + 2) % 3] = 1;
      const first = vertices.length;
      for (const [s, r] of [[0, 0], [1, 0], [1, 1], [0, 1]]) {
        const p = n.map((x, k) => x + (2 * s - 1) * t[k] + (2 * r - 1) * b[k]);
        vertices.push([...p, ...n, s, r * (axis + 1)]);
      }
      indices.push(first, first + 1, first + 2, first, first + 2, first + 3);
    }
  return { vertices, indices };
}

// A bumpy sheet. `uv(i, j)` may do anything.
function sheet(n, uv) {
  const height = (x, y) => 0.3 * Math.sin(3 * x) * Math.cos(2 * y);
  return grid(n, n, (i, j) => {
    const x = (2 * i) / n - 1, y = (2 * j) / n - 1;
    const normal = unit([-0.9 * Math.cos(3 * x) * Math.cos(2 * y),
      0.6 * Math.sin(3 * x) * Math.sin(2 * y), 1]);
    return [x, y, height(x, y), ...normal, ...uv(i, j)];
  });
}

// Some triangles have no area in uv, some none in space, one stands alone with neither.
function degenerate() {
  const mesh = sheet(5, (i, j) => [i < 3 ? 0.25 : i / 5, j === 4 ? 0.6 : j / 5]);
  const first = mesh.vertices.length;
  mesh.vertices.push([3, 0, 0, 0, 0, 1, 0.5, 0.5], [4, 0, 0, 0, 0, 1, 0.5, 0.5],
    [3, 1, 0, 0, 0, 1, 0.5, 0.5], [4, 1, 0, 0, 0, 1, 0.5, 0.5]);
  mesh.indices.push(first, first + 1, first + 2);
  mesh.indices.push(28, 28, 29, 0, 1, 1, first + 3, first + 3, first + 3);
  return mesh;
}

// Flips, skews and rotations from one quad to the next.
function wild() {
  let state = 12345;
  const random = () => (state = (state * 1103515245 + 12345) % 2147483648) / 2147483648;
  return sheet(7, (i, j) => [i / 7 + 0.4 * random(), j / 7 + 0.4 * random()]);
}

// Five triangles on one edge, some of them turned round.
function fins() {
  const vertices = [[0, 0, 0], [0, 0, 1]].map((p) => [...p, 0, 1, 0, 0.5, p[2]]);
  const indices = [];
  for (let k = 0; k < 5; ++k) {
    const a = (tau * k) / 7 + 0.2;
    vertices.push([Math.cos(a), Math.sin(a), 0.5, 0, 1, 0, 0.5 + 0.5 * Math.cos(a + 1), 0.5]);
    indices.push(...(k % 2 === 0 ? [0, 1, k + 2] : [1, 0, k + 2]));
  }
  return { vertices, indices };
}

function recorded(name, mesh) {
  const vertices = mesh.vertices.map((v) => v.map(Math.fround));
  const pick = (from, to) =>
    new Float32Array(mesh.indices.flatMap((index) => vertices[index].slice(from, to)));
  const tangents = generateTangents(pick(0, 3), pick(3, 6), pick(6, 8));
  const short = (x) => Number(x.toPrecision(9));
  const rows = (list) => '[\n    ' + list.map((row) => JSON.stringify(row)).join(',\n    ') + ']';
  const corners = mesh.indices.map((_, i) => Array.from(tangents.slice(4 * i, 4 * i + 4), short));
  return `  {"name": "${name}",\n   "vertices": ${rows(vertices.map((v) => v.map(short)))},\n` +
    `   "indices": ${JSON.stringify(mesh.indices).replace(/((\d+,){18})/g, '$1\n    ')},\n` +
    `   "tangents": ${rows(corners)}}`;
}

const meshes = { mirrored_sphere: mirroredSphere(), torus: torus(), cube: cube(),
  degenerate: degenerate(), wild: wild(), fins: fins() };
const texts = Object.entries(meshes).map(([name, mesh]) => recorded(name, mesh));
process.stdout.write(`{"source": "mikktspace 1.1.1 (npm)", "meshes": [\n${texts.join(',\n')}\n]}\n`);
