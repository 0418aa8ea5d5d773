"""Surface points of pixels, computed without the host: a torus, its objects in the world, and a
camera close to its seam of mirrored uvs."""
import json
import math
import struct

SIZE, STEP = 512, 11  # of the host's image, and of the pixels that are compared
FIELD_OF_VIEW = 0.13  # radians; images are magnified: levels of mips are each host's own
TARGET, EYE = (1.3, 0.29, 0.05), (3.3, 1.5, 0.7)  # in the object
# Columns of the matrices from object to world.
TURNED = ((0.8, 0.36, -0.48), (-0.6, 0.48, -0.64), (0, 0.8, 0.6))
OBJECTS = {"plain": TURNED, "mirrored": (tuple(-x for x in TURNED[0]), *TURNED[1:]),
           "scaled": (tuple(0.7 * x for x in TURNED[0]), tuple(1.3 * x for x in TURNED[1]),
                      TURNED[2]),
           "back": TURNED}
AXES = {"position": "xyz", "normal": "xyz", "tangent": "xyzw", "uv0": "xy", "uv1": "xy",
        "view": "xyz"}
COLUMNS = [f"{way}{name}.{axis}" for way in ("", "dx.", "dy.") for name, axes in AXES.items()
           for axis in axes] + ["facing"]  # of `wrinkle eval --at`


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def unit(a):
    length = math.sqrt(dot(a, a))
    return tuple(x / length for x in a)


def applied(columns, v):
    return tuple(sum(columns[k][i] * v[k] for k in range(3)) for i in range(3))


def inverse(columns):
    rows = [cross(columns[1], columns[2]), cross(columns[2], columns[0]),
            cross(columns[0], columns[1])]
    determinant = dot(columns[0], rows[0])
    return tuple(tuple(rows[i][k] / determinant for i in range(3)) for k in range(3))


def normal_to_object(columns, n):
    """Of a normal in the world, by the transposed matrix."""
    return unit(tuple(dot(column, n) for column in columns))


class Camera:
    """In the world, in front of the seam of an object."""

    def __init__(self, columns):
        self.eye, self.target = applied(columns, EYE), applied(columns, TARGET)
        self.back = unit(sub(self.eye, self.target))
        self.right = unit(cross((0, 1, 0), self.back))
        self.up = cross(self.back, self.right)


def write_torus(path, rings=48, sides=24):
    """A torus with uv0 mirrored on one half, without overlap, and uv1 turned, sheared, tiled."""
    vertices, indices = [], []
    for half in range(2):
        first = len(vertices)
        for i in range(rings // 2 + 1):
            for j in range(sides + 1):
                a = 2 * math.pi * (i + half * rings // 2) / rings
                b = 2 * math.pi * j / sides
                normal = (math.cos(b) * math.cos(a), math.sin(b), -math.cos(b) * math.sin(a))
                position = (math.cos(a) + 0.42 * normal[0], 0.42 * normal[1],
                            -math.sin(a) + 0.42 * normal[2])
                u = i / rings if half == 0 else 1 - i / rings
                s, t = 1.5 * (i / rings + half * 0.5), j / sides
                vertices.append((*position, *normal, u, 1 - j / sides,
                                 0.8 * s + 0.3 * t, 1 - (-0.5 * s + 0.9 * t)))
        row = sides + 1
        for i in range(rings // 2):
            for j in range(sides):
                at = first + i * row + j
                indices += [at, at + row, at + row + 1, at, at + row + 1, at + 1]
    write_glb(path, vertices, indices)


def write_glb(path, vertices, indices):
    columns = [("POSITION", 0, 3), ("NORMAL", 3, 3), ("TEXCOORD_0", 6, 2), ("TEXCOORD_1", 8, 2)]
    binary, views, accessors, attributes = b"", [], [], {}
    for name, first, count in columns:
        data = b"".join(struct.pack(f"<{count}f", *v[first:first + count]) for v in vertices)
        attributes[name] = len(views)
        accessor = {"bufferView": len(views), "componentType": 5126, "count": len(vertices),
                    "type": f"VEC{count}"}
        if name == "POSITION":
            accessor |= {"min": [min(v[k] for v in vertices) for k in range(3)],
                         "max": [max(v[k] for v in vertices) for k in range(3)]}
        accessors.append(accessor)
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data)})
        binary += data
    views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": 4 * len(indices)})
    accessors.append({"bufferView": len(views) - 1, "componentType": 5125,
                      "count": len(indices), "type": "SCALAR"})
    binary += struct.pack(f"<{len(indices)}I", *indices)
    text = json.dumps({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
                       "nodes": [{"mesh": 0}], "meshes": [{"primitives": [
                           {"attributes": attributes, "indices": len(accessors) - 1}]}],
                       "accessors": accessors, "bufferViews": views,
                       "buffers": [{"byteLength": len(binary)}]}).encode()
    text += b" " * (-len(text) % 4)
    path.write_bytes(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(binary)) +
                     struct.pack("<II", len(text), 0x4E4F534A) + text +
                     struct.pack("<II", len(binary), 0x004E4942) + binary)


def read_glb(path):
    """Attributes by name, a list of tuples each, with v upwards, and the triangles."""
    data = path.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    root, binary = json.loads(data[20:20 + length]), data[28 + length:]

    def values(index):
        accessor = root["accessors"][index]
        count = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        kind = {5126: "f", 5125: "I"}[accessor["componentType"]]
        at = root["bufferViews"][accessor["bufferView"]]["byteOffset"]
        flat = struct.unpack_from(f"<{count * accessor['count']}{kind}", binary, at)
        return [flat[i:i + count] for i in range(0, len(flat), count)]

    primitive = root["meshes"][0]["primitives"][0]
    mesh = {name: values(index) for name, index in primitive["attributes"].items()}
    for name in ("TEXCOORD_0", "TEXCOORD_1"):
        mesh[name] = [(u, 1 - v) for u, v in mesh[name]]
    corners = [index[0] for index in values(primitive["indices"])]
    return mesh, [corners[i:i + 3] for i in range(0, len(corners), 3)]


ATTRIBUTES = {"position": "POSITION", "normal": "NORMAL", "tangent": "TANGENT",
              "uv0": "TEXCOORD_0", "uv1": "TEXCOORD_1"}


class Pixels:
    """rows: points of the mesh at pixels (x, y) of a square image, y from the top."""

    def __init__(self, mesh, triangles, columns, facing):
        self.mesh, self.facing = mesh, facing
        self.columns, self.inverse = columns, inverse(columns)
        self.camera = Camera(columns)
        self.eye = applied(self.inverse, self.camera.eye)
        self.half = math.tan(FIELD_OF_VIEW / 2)
        self.found = {}  # pixel: distance, triangle
        self.screen = [self.projected(p) for p in mesh["POSITION"]]
        for triangle in triangles:
            self.cover(triangle)
        self.rows = {at: self.row(at, triangle) for at, (_, triangle) in self.found.items()
                     if triangle is not None}

    def projected(self, position):
        camera = self.camera
        world = sub(applied(self.columns, position), camera.eye)
        depth = -dot(world, camera.back) * self.half
        return ((dot(world, camera.right) / depth + 1) * SIZE / 2,
                (1 - dot(world, camera.up) / depth) * SIZE / 2)

    def ray(self, x, y):
        a, b = ((2 * x + 1) / SIZE - 1) * self.half, (1 - (2 * y + 1) / SIZE) * self.half
        return applied(self.inverse, tuple(a * r + b * u - k for r, u, k in
                                           zip(self.camera.right, self.camera.up,
                                               self.camera.back)))

    def weights(self, triangle, x, y):
        """Barycentric coordinates of the pixel's ray in the triangle's plane, and the distance."""
        a, b, c = (self.mesh["POSITION"][i] for i in triangle)
        e1, e2, s, way = sub(b, a), sub(c, a), sub(self.eye, a), self.ray(x, y)
        p = cross(way, e2)
        scale = 1 / dot(e1, p)
        q = cross(s, e1)
        v, w = scale * dot(s, p), scale * dot(way, q)
        return (1 - v - w, v, w), scale * dot(e2, q)

    @staticmethod
    def steps(bounds):
        first = max(math.ceil((min(bounds) - 1) / STEP) * STEP, 0)
        return range(first, min(int(max(bounds)) + 1, SIZE), STEP)

    def cover(self, triangle):
        a, b, c = (self.mesh["POSITION"][i] for i in triangle)
        if dot(cross(sub(b, a), sub(c, a)), sub(self.eye, a)) * self.facing <= 0:
            return
        xs, ys = zip(*(self.screen[i] for i in triangle))
        for y in self.steps(ys):
            for x in self.steps(xs):
                weights, distance = self.weights(triangle, x, y)
                if min(weights) < 0:
                    continue
                known = triangle if min(weights) > 0.03 else None  # at an edge: either of two
                if (x, y) not in self.found or distance < self.found[x, y][0]:
                    self.found[x, y] = (distance, known)

    def values(self, triangle, x, y):
        """The surface where the ray of the pixel meets the triangle's plane."""
        weights = self.weights(triangle, x, y)[0]
        found = {name: tuple(sum(w * column[k] for w, column in zip(weights, corners))
                             for k in range(len(AXES[name])))
                 for name, corners in self.corners(triangle)}
        return found | {"view": unit(sub(self.eye, found["position"]))}

    def corners(self, triangle):
        return [(name, [self.mesh[attribute][i] for i in triangle])
                for name, attribute in ATTRIBUTES.items()]

    def row(self, at, triangle):
        """The point with the differentials of its quad, in the order of COLUMNS."""
        x, y = at
        quad_x, quad_y = x & ~1, y & ~1
        row = [value for values in self.values(triangle, x, y).values() for value in values]
        for one, other in (((quad_x, y), (quad_x + 1, y)), ((x, quad_y + 1), (x, quad_y))):
            first, second = self.values(triangle, *one), self.values(triangle, *other)
            row += [value for name in AXES for value in sub(second[name], first[name])]
        return row + [self.facing]
