#!/usr/bin/env python3
"""Build and frame times of a generated shader, of one written by hand, and of other files.

usage: forms.py BIN [--size 512] [--rounds 5] [FRAGMENT...]     BIN: wrinkle and wrinkle_form_bench

Materials: rusty_steel (36 nodes, 7 outputs), and fractal noise of 4 and 8 octaves as a bump; the
texts by hand are those of tests/parity/written_by_hand. FRAGMENTs are further forms: complete
fragment shaders (see form_bench.cpp). Processes run by turns; the figures are medians in ms, and
medians of the ratios within one round. Measure on a machine that does nothing else.
"""
import argparse
import json
import os
import re
import statistics
import subprocess
import tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
BY_HAND = os.path.join(ROOT, "tests/parity/written_by_hand")

HEAD = """#version 330 core
in vec3 position, normal;
in vec4 tangent;
in vec2 uv0;
out vec4 color;
"""

# A bump of fractal noise as a person writes it; the noise is noise_rock's.
BUMP = """struct WrinkleSurface_fbm {{ vec3 position; vec3 normal; float facing; }};
struct WrinkleMaterial_fbm {{ vec3 normal; }};
{noise}
WrinkleMaterial_fbm wrinkle_fbm(WrinkleSurface_fbm s) {{
    vec3 normal = normalize(s.normal);
    vec3 dpdx = dFdx(s.position);
    vec3 dpdy = dFdy(s.position);
    vec3 slope = 0.1 * fbm(s.position, max(length(dpdx), length(dpdy)), 3.0, {octaves}, 2.0, 0.5).xyz;
    vec3 gradient = slope - normal * dot(normal, slope);
    WrinkleMaterial_fbm m;
    m.normal = normalize(normal * s.facing - gradient);
    return m;
}}
"""


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def fragment(text, name):
    """A fragment shader that calls the function of `text` and adds up its outputs."""
    def members(struct):
        body = re.search(rf"struct {struct}_{name} {{(.*?)}};", text, re.S).group(1)
        return re.findall(r"\b(float|vec[234]) (\w+);", body)

    values = {"position_relative": "position", "facing": "1.0"}
    lines = [f"WrinkleSurface_{name} s;"]
    for _, member in members("WrinkleSurface"):
        of, _, axis = member.rpartition("_d")
        value = f"dFd{axis}({of})" if of and axis in "xy" else values.get(member, member)
        lines.append(f"s.{member} = {value};")
    lines += [f"WrinkleMaterial_{name} m = wrinkle_{name}(s);", "vec3 sum = vec3(0.0);"]
    lines += [f"sum += m.{member};" for _, member in members("WrinkleMaterial")]
    lines.append("color = vec4(sum, 1.0);")
    return HEAD + text + "void main() {\n    " + "\n    ".join(lines) + "\n}\n"


def compiled(wrinkle, graph, name):
    return subprocess.run([wrinkle, "compile", "-", "--name", name], input=graph, check=True,
                          capture_output=True, text=True, cwd=ROOT + "/graphs").stdout


def bump_graph(octaves):
    noise = {"type": "fbm", "in": {"scale": 3, "octaves": octaves, "amplitude": 0.1}}
    resolve = {"type": "resolve", "in": {"gradient": {"from": "noise.height"}}}
    return json.dumps({"wrinkle": 1, "nodes": {"noise": noise, "bump": resolve},
                       "outputs": {"normal": {"from": "bump.normal"}}})


def materials(wrinkle):
    """{title: {form: fragment shader}}"""
    steel = compiled(wrinkle, read(ROOT + "/graphs/rusty_steel.json"), "rusty_steel")
    found = {"rusty_steel": {
        "generated": fragment(steel, "rusty_steel"),
        "by hand": fragment(read(BY_HAND + "/rusty_steel.glsl"), "rusty_steel")}}
    rock = read(BY_HAND + "/noise_rock.glsl")
    noise = rock[rock.index("const vec3 octave_offset"):rock.index("WrinkleMaterial_noise_rock wr")]
    for octaves in (4, 8):
        text = compiled(wrinkle, bump_graph(octaves), "fbm")
        found[f"fbm, {octaves} octaves"] = {
            "generated": fragment(text, "fbm"),
            "by hand": fragment(BUMP.format(noise=noise, octaves=octaves), "fbm")}
    return found


def measured(program, shader, size, folder):
    path = os.path.join(folder, "form.frag")
    with open(path, "w", encoding="utf-8") as file:
        file.write(shader)
    frames = "9"
    out = subprocess.run([program, path, str(size), frames], check=True, capture_output=True,
                         text=True, env={**os.environ, "MESA_SHADER_CACHE_DISABLE": "1"}).stdout
    return [float(number) for number in out.split()]


def compare(title, forms, args, folder):
    program = os.path.join(args.bin, "wrinkle_form_bench")
    rounds = {form: [] for form in forms}
    for _ in range(args.rounds):
        for form, shader in forms.items():
            rounds[form].append(measured(program, shader, args.size, folder))
    print(f"\n{title:20} {'chars':>7} {'link':>8} {'first':>8} {'frame':>8}   generated / this:"
          f" {'link+first':>10} {'frame':>6}")
    for form, shader in forms.items():
        link, first, frame = (statistics.median(column) for column in zip(*rounds[form]))
        pairs = list(zip(rounds["generated"], rounds[form]))
        start = statistics.median((a[0] + a[1]) / (b[0] + b[1]) for a, b in pairs)
        steady = statistics.median(a[2] / b[2] for a, b in pairs)
        print(f"{form:20} {len(shader):7} {link:8.1f} {first:8.1f} {frame:8.2f}"
              f"   {'':17} {start:10.2f} {steady:6.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin", type=os.path.abspath)
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("fragments", nargs="*", metavar="FRAGMENT")
    args = parser.parse_intermixed_args()
    with tempfile.TemporaryDirectory() as folder:
        for title, forms in materials(os.path.join(args.bin, "wrinkle")).items():
            more = {os.path.basename(path): read(path) for path in args.fragments}
            compare(title, {**forms, **more}, args, folder)


if __name__ == "__main__":
    main()
